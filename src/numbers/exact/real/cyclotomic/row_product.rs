//! wᵀM in integers over common denominators. Each sum is reduced once, rather than each
//! of its terms.
//!
//! Twice each number is written as Σ_k a_k·2cos(2πk/n), k = 0, …, ⌊n/2⌋. Then one rule
//! holds for all products, also with k = 0: 2cos(s)·2cos(t) = 2cos(s + t) + 2cos(s − t).

use super::field::Field;
use super::number::{Form, RealCyclotomic};
use crate::exact::{Integer, Rational};
use crate::stop::check;
use std::sync::Arc;

/// Σ a_k·2cos(2πk/n) as the pairs (k, a_k).
type Terms<C> = Vec<(usize, C)>;

/// An integer type for the factors, and one for the sums of their products.
trait Arithmetic {
    type Factor;
    type Sum: Clone;
    fn zero() -> Self::Sum;
    fn product(x: &Self::Factor, y: &Self::Factor) -> Self::Sum;
    fn add(sum: &mut Self::Sum, value: &Self::Sum);
}

/// Machine integers, used where every sum fits.
struct Words;

/// Integers of any size, used otherwise.
struct Integers;

impl Arithmetic for Words {
    type Factor = i64;
    type Sum = i128;
    fn zero() -> i128 {
        0
    }
    fn product(x: &i64, y: &i64) -> i128 {
        i128::from(*x) * i128::from(*y)
    }
    fn add(sum: &mut i128, value: &i128) {
        *sum += value;
    }
}

impl Arithmetic for Integers {
    type Factor = Integer;
    type Sum = Integer;
    fn zero() -> Integer {
        Integer::zero()
    }
    fn product(x: &Integer, y: &Integer) -> Integer {
        x * y
    }
    fn add(sum: &mut Integer, value: &Integer) {
        *sum += value;
    }
}

/// wᵀM, for m_{a,b} = values\[names_{a,b}\].
pub(super) fn left_product(
    w: &[RealCyclotomic],
    values: &[RealCyclotomic],
    names: &[Vec<u32>],
) -> Vec<RealCyclotomic> {
    let numbers = w.iter().chain(values);
    let conductor = numbers.map(|x| x.conductor() as usize).fold(1, num_integer::lcm);
    let field = (conductor > 1).then(|| Field::of(conductor));
    let (w, values) = (Common::of(w, field.as_ref()), Common::of(values, field.as_ref()));
    let result = Finish { field, denominator: &w.denominator * &values.denominator };
    // Each product is added at two places, so no sum exceeds twice the bound.
    let most = values.terms.iter().map(magnitude).max().unwrap_or_else(Integer::zero);
    let bound: Integer = w.terms.iter().map(|x| magnitude(x) * &most).sum();
    match (w.words(), values.words()) {
        (Some(w), Some(values)) if bound.bits() < 126 => {
            let sums = sums::<Words>(&w, &values, names, conductor);
            sums.map(|sum| result.number(sum.into_iter().map(Integer::from).collect())).collect()
        }
        _ => {
            let sums = sums::<Integers>(&w.terms, &values.terms, names, conductor);
            sums.map(|sum| result.number(sum)).collect()
        }
    }
}

/// For each b, the coefficients of Σ_a w_a m_{a,b} at 2cos(2πk/n), k = 0, …, ⌊n/2⌋.
fn sums<A: Arithmetic>(
    w: &[Terms<A::Factor>],
    values: &[Terms<A::Factor>],
    names: &[Vec<u32>],
    n: usize,
) -> impl Iterator<Item = Vec<A::Sum>> {
    let columns = names.first().map_or(0, Vec::len);
    (0..columns).map(move |b| {
        let mut sum = vec![A::zero(); n / 2 + 1];
        for (w, names) in w.iter().zip(names) {
            check();
            for (j, y) in &values[names[b] as usize] {
                for (i, x) in w {
                    let value = A::product(x, y);
                    A::add(&mut sum[(i + j).min(n.wrapping_sub(i + j))], &value);
                    A::add(&mut sum[i.abs_diff(*j)], &value);
                }
            }
        }
        sum
    })
}

/// Numbers over one common denominator.
struct Common {
    denominator: Integer,
    terms: Vec<Terms<Integer>>,
}

impl Common {
    /// Writes `numbers` over one denominator. They lie in `field`; without a field they
    /// are rational.
    fn of(numbers: &[RealCyclotomic], field: Option<&Arc<Field>>) -> Common {
        let denominator = RealCyclotomic::denominator(numbers);
        let terms = |number: &RealCyclotomic| match (&number.0, field) {
            (Form::Irrational(element), Some(field)) => {
                let scale = denominator.div_floor(&element.denominator);
                field
                    .sparse(&element.lifted(field))
                    .into_iter()
                    .map(|(k, a)| {
                        let a = a * &scale;
                        (k, if k == 0 { a } else { &a + &a })
                    })
                    .collect()
            }
            (Form::Rational(value), _) if value.is_zero() => Vec::new(),
            (Form::Rational(value), _) => {
                vec![(0, value.numerator() * denominator.div_floor(&value.denominator()))]
            }
            (Form::Irrational(_), None) => unreachable!("an irrational number has a conductor"),
        };
        let terms = numbers.iter().map(terms).collect();
        Common { denominator: &denominator + &denominator, terms }
    }

    /// The terms as machine words, if all fit.
    fn words(&self) -> Option<Vec<Terms<i64>>> {
        let word = |(k, a): &(usize, Integer)| Some((*k, a.to_i64()?));
        self.terms.iter().map(|terms| terms.iter().map(word).collect()).collect()
    }
}

/// Σ |a_k|.
fn magnitude(terms: &Terms<Integer>) -> Integer {
    terms.iter().map(|(_, a)| a.abs()).sum()
}

/// Turns sums of products back into numbers.
struct Finish {
    field: Option<Arc<Field>>,
    denominator: Integer,
}

impl Finish {
    fn number(&self, mut sum: Vec<Integer>) -> RealCyclotomic {
        // 2cos 0 = 2, but C_0 = 1.
        sum[0] = &sum[0] + &sum[0];
        match &self.field {
            None => Rational::new(sum.swap_remove(0), self.denominator.clone()).into(),
            Some(field) => {
                let numerators = field.reduce(sum);
                RealCyclotomic::normal(Arc::clone(field), numerators, self.denominator.clone())
            }
        }
    }
}
