mod algebraic;
mod known;
mod laws;
