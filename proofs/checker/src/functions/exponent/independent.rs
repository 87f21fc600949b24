//! Whether the shifts of φ are linearly independent, for masks of any numbers.

#![warn(clippy::arithmetic_side_effects)]

use crate::functions::masks::Mask;
use crate::numbers::{Meter, Number, Q, Value, field, int};
use crate::radius::has_independent_shifts_over;
use crate::text::Stop;
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::One as _;

/// The binary digits that keep 2cos(2π/n) apart from its conjugates, n ≤ 1000.
const DIGITS: u64 = 40;

/// Whether they are, by the condition of THEOREMS.md, 121.
pub fn has_independent_shifts(meter: &Meter, mask: &Mask) -> Result<bool, Stop> {
    let numbers = mask.values.iter().map(Value::number).collect::<Result<Vec<&Number>, Stop>>()?;
    let n = numbers.iter().fold(1_u32, |n, number| n.lcm(&number.coordinates().0));
    if n > 1_000 {
        return Err(Stop::Capped("the field of the cosines"));
    }
    if n < 3 {
        // Any field will do for fractions.
        let symbol: Vec<Vec<Q>> = numbers.iter().map(|a| a.coordinates().1).collect();
        let root = (vec![int(-2), int(0), int(1)], int(1), int(2));
        return has_independent_shifts_over(&symbol, mask.arity, root, meter);
    }
    // Other forms of a number have the coordinates of its own field.
    let x = Number::cosine(&Q::new(BigInt::one(), n.into()))?.times(&Number::Small(2, 1))?;
    let lifted = |a: &&Number| Ok(a.plus(1, &x)?.plus(-1, &x)?.coordinates().1);
    let symbol = numbers.iter().map(lifted).collect::<Result<Vec<Vec<Q>>, Stop>>()?;
    let field = field(n);
    let polynomial = field.minimal().iter().map(|c| Q::from_integer(c.clone())).collect();
    let low = Q::new(field.enclose(DIGITS), BigInt::one() << DIGITS);
    has_independent_shifts_over(&symbol, mask.arity, (polynomial, low, int(2)), meter)
}
