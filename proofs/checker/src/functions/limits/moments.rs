//! The moments of a limit φ.

#![warn(clippy::arithmetic_side_effects)]

use crate::functions::call::number;
use crate::functions::masks::Mask;
use crate::functions::steps::{add, over, plus, times};
use crate::numbers::{Meter, Q, Value};
use crate::text::Stop;
use num_bigint::BigInt;
use num_traits::One as _;

/// ∫ x^m φ(x) dx. From the refinement, n^{m+1}M_m = Σ_{i≤m} binomial(m, i) M_i Σ_k a_k k^{m−i}.
pub fn moment(meter: &Meter, mask: &Mask, degree: usize) -> Result<Value, Stop> {
    let (n, mut sums) = (number(mask.arity), Vec::new());
    let places: Vec<Value> = (mask.first..).zip(&mask.values).map(|(k, _)| Value::int(k)).collect();
    let mut terms = mask.values.clone();
    for _ in 0..=degree {
        let mut sum = Value::int(0);
        for (term, k) in terms.iter_mut().zip(&places) {
            plus(meter, &mut sum, term)?;
            *term = times(meter, term, k)?;
        }
        sums.push(sum);
    }
    // The row m of Pascal's triangle, and n^{m+1}.
    let (mut row, mut power) = (vec![BigInt::one()], n.clone());
    let mut moments = vec![Value::int(1)];
    while moments.len() <= degree {
        let pairs = row.windows(2).map(|pair| &pair[0] + &pair[1]);
        row = [BigInt::one()].into_iter().chain(pairs).chain([BigInt::one()]).collect();
        power = times(meter, &power, &n)?;
        let mut sum = Value::int(0);
        // The sums of the powers m, m − 1, …, 1.
        let sums = sums[1..=moments.len()].iter().rev();
        for ((choices, known), of_powers) in row.iter().zip(&moments).zip(sums) {
            let factor = times(meter, known, &Q::from_integer(choices.clone()).into())?;
            add(meter, &mut sum, &factor, of_powers)?;
        }
        moments.push(over(meter, &sum, &power.minus(&n)?)?);
    }
    moments.pop().ok_or(Stop::Capped("the degree of a moment"))
}
