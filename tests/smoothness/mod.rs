mod algebraic;
mod basic;
mod known;
mod laws;
mod map;
mod plane;
mod range;
mod values;
