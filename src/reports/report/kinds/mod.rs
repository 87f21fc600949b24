//! What reports say of each kind of claim: one file for each.

mod equation;
mod function;
mod range;
mod smoothness;
mod table;
mod theorem;
