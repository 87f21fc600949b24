//! Products, powers and quotients of Laurent polynomials in a symbol.

use super::laurent::{Laurent, Powers, add, constant, ends, sum};
use super::symbol::{Expansion, wrong};
use crate::numbers::Value;
use crate::text::Stop;

/// The greatest |exponent| of what has variables in it.
const MAX_EXPONENT: u64 = 64;

impl<P: Powers> Expansion<'_, P> {
    /// The product.
    pub(super) fn times(&self, left: &Laurent<P>, right: &Laurent<P>) -> Result<Laurent<P>, Stop> {
        let mut product = Laurent::new();
        for (p, a) in left {
            for (q, b) in right {
                self.scope.spend(a.cost(b))?;
                add(&mut product, p.plus(1, *q)?, &a.times(b)?)?;
            }
        }
        Ok(product)
    }

    /// The power.
    pub(super) fn power(&self, base: &Laurent<P>, exponent: i64) -> Result<Laurent<P>, Stop> {
        if let Some(constant) = constant(base) {
            let power = constant.power(exponent)?;
            self.scope.spend(power.cost(&power))?;
            return sum([(P::zero(), power)]);
        }
        if exponent.unsigned_abs() > MAX_EXPONENT {
            return Err(Stop::Capped("the exponent of a symbol"));
        }
        let one = sum([(P::zero(), Value::int(1))])?;
        let mut power = one.clone();
        for _ in 0..exponent.unsigned_abs() {
            power = self.times(&power, base)?;
        }
        if exponent < 0 { self.over(&one, &power) } else { Ok(power) }
    }

    /// The quotient, which leaves no remainder. By a number or one power each coefficient is divided; otherwise the terms of
    /// one end of the dividend are taken away, one after the other, in lexicographic order.
    ///
    /// The least exponents of a variable in two factors add up to that of their product, since the terms with these exponents
    /// have a product that is not 0; so do the greatest ones. Hence the terms of a quotient are known to be in a box. Each
    /// one is beyond those before it, and there are finitely many.
    pub(super) fn over(&self, left: &Laurent<P>, divisor: &Laurent<P>) -> Result<Laurent<P>, Stop> {
        let (Some((first, low)), Some((last, high))) =
            (divisor.first_key_value(), divisor.last_key_value())
        else {
            return Err(Stop::Undefined("division by zero"));
        };
        if first == last {
            let each = |(k, c): (&P, &Value)| {
                self.scope.spend(c.cost_of_quotient(low))?;
                Ok((k.plus(-1, *first)?, c.over(low)?))
            };
            return sum(left.iter().map(each).collect::<Result<Vec<_>, Stop>>()?);
        }
        let (Some(whole), Some(part)) = (ends(left), ends(divisor)) else {
            return Ok(Laurent::new());
        };
        let [least, most] = [whole[0].plus(-1, part[0])?, whole[1].plus(-1, part[1])?];
        let (from_above, end, lead) =
            if high.number().is_ok() { (true, last, high) } else { (false, first, low) };
        let (mut rest, mut quotient) = (left.clone(), Laurent::new());
        while let Some((at, top)) =
            if from_above { rest.last_key_value() } else { rest.first_key_value() }
        {
            let k = at.plus(-1, *end)?;
            let places = k.parts().iter().zip(least.parts().iter().zip(most.parts()));
            if places.into_iter().any(|(k, (least, most))| k < least || k > most) {
                return Err(wrong("a division leaves a remainder"));
            }
            let c = top.over(lead)?;
            self.scope.spend(top.cost_of_quotient(lead))?;
            for (power, d) in divisor {
                self.scope.spend(c.cost(d))?;
                let power = power.plus(1, k)?;
                let known = rest.remove(&power).unwrap_or_else(|| Value::int(0));
                let value = known.minus(&c.times(d)?)?;
                if !value.is_zero() {
                    rest.insert(power, value);
                }
            }
            quotient.insert(k, c);
        }
        sum(quotient)
    }
}
