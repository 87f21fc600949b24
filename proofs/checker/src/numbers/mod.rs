//! Numbers, polynomials and their signs, and decimals as they are printed.

mod characteristic;
mod decimal;
mod echelon;
mod element;
mod field;
mod integers;
mod irrational;
pub mod linear;
mod magnitude;
mod meter;
mod number;
mod piece;
mod polynomial;
mod root;
mod rounding;
mod show;
mod value;

pub use characteristic::{Ring, characteristic};
pub use decimal::{
    Decimal, Q, bits, capped, common_multiple, count, int, is_blank, is_fraction,
    over_one_denominator, read_rational,
};
pub use echelon::{Echelon, Row};
pub use field::{cyclotomic, field};
pub use integers::Integers;
pub use linear::{solve, unit};
pub use magnitude::compare;
pub use meter::{Meter, product_steps};
pub use number::Number;
pub use piece::{Ends, MAX_CUTS, Piece};
pub use polynomial::{
    at, beyond_roots, divide, gcd, multiplied, roots_between, signum, steps_between, steps_of_gcd,
    trimmed,
};
pub use root::Root;
pub use rounding::{
    differing, gives, has_digits, interval, is_exchanged, is_one_unit, is_rounded, rounding,
    rounding_on, slips, telling, telling_part,
};
pub use show::shown;
pub use value::Value;
