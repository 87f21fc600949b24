mod algebraic;
mod basic;
mod known;
mod laws;
mod map;
mod range;
mod values;
