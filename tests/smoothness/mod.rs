mod algebraic;
mod known;
mod laws;
mod map;
mod range;
