//! The coefficients of numbers, and how large they and the conjugates are.

use super::field::Field;
use super::number::{Form, RealCyclotomic};
use crate::exact::{Integer, Rational};

impl RealCyclotomic {
    /// (b, q) with q > 0 such that q times this number is an algebraic integer, none of whose
    /// conjugates exceeds b in absolute value. For (Σ a_k C_k)/q with C_0 = 1 and C_k = 2cos(2πk/n)
    /// it is b = |a_0| + 2 Σ_{k≥1} |a_k|, since the conjugates of C_k are C_j.
    pub(crate) fn conjugate_bound(&self) -> (Integer, Integer) {
        match &self.0 {
            Form::Rational(value) => (value.numerator().abs(), value.denominator()),
            Form::Irrational(element) => {
                let sum: Integer = element.terms().map(|(_, a)| a.abs()).sum();
                (&sum + &sum - element.numerators[0].abs(), element.denominator.clone())
            }
        }
    }

    /// The rational g/q > 0 such that this number is (g/q) Σ b_k C_k, with integers b_k without a
    /// common factor; 0 for the number 0.
    pub(crate) fn content(&self) -> Rational {
        match &self.0 {
            Form::Rational(value) => value.abs(),
            Form::Irrational(element) => {
                let gcd = element.terms().fold(Integer::zero(), |gcd, (_, a)| gcd.gcd(a));
                Rational::new(gcd, element.denominator.clone())
            }
        }
    }

    /// Rational c_{i,k} such that number i is Σ_k c_{i,k} b_k, with b_k that are linearly independent over
    /// the rationals and the same for all of these numbers: b_0 = 1 and b_k = 2cos(2πk/n), for a common conductor n.
    ///
    /// # Panics
    /// When the numbers have no [`common_conductor`](super::common_conductor).
    #[must_use]
    pub fn coordinates(values: &[RealCyclotomic]) -> Vec<Vec<Rational>> {
        let conductor = values.iter().fold(1, |n, value| num_integer::lcm(n, value.conductor()));
        if conductor == 1 {
            let rational = |value: &RealCyclotomic| value.as_rational().cloned();
            return values.iter().map(|value| rational(value).into_iter().collect()).collect();
        }
        let field = Field::of(conductor as usize);
        let of = |value: &RealCyclotomic| match &value.0 {
            Form::Rational(value) => {
                let mut coordinates = vec![Rational::zero(); field.degree()];
                coordinates[0] = value.clone();
                coordinates
            }
            Form::Irrational(element) => {
                let lifted = element.lifted(&field);
                let over = |a: &Integer| Rational::new(a.clone(), element.denominator.clone());
                lifted.iter().map(over).collect()
            }
        };
        values.iter().map(of).collect()
    }
}
