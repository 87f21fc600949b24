//! The program `subcert`.
fn main() {}
