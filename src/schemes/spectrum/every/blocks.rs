//! The Fourier blocks for all valences.

use crate::exact::{IntegerFunction, Rational, Scalar as _, Turned, characteristic_coefficients};
use crate::scheme::{EveryRing, EveryWeight};

/// The most orbits of a ring of which polynomials are computed.
const MAX_ORBITS: usize = 5;

/// A Fourier block k.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Block {
    /// One of k = 0, …, 6.
    Number(i64),
    /// Any of 6 < k ≤ t/2, by cos(2πk/t).
    Beyond,
}

/// A ring with the least of its valences.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Blocks {
    pub(super) ring: EveryRing,
    pub(super) first: i64,
}

impl Blocks {
    pub(super) fn index(&self) -> IntegerFunction {
        IntegerFunction::index(self.first)
    }

    /// The m_d − w(d), d = −6, …, 6, and the b_r of w(d) = Σ_r b_r cos(2πrd/t).
    fn differences(
        &self,
        near: &[IntegerFunction],
        waves: &[IntegerFunction],
    ) -> Vec<(i64, IntegerFunction)> {
        let wave = |d: i64| {
            let terms = (0..).zip(waves).map(|(r, b): (i64, _)| {
                b.times(&IntegerFunction::half_cosine(self.first, 2 * r * d))
            });
            terms.fold(IntegerFunction::zero(), |sum, term| sum.plus(&term))
        };
        let places = (-IntegerFunction::NEAR..).zip(near);
        let differences = places.map(|(d, weight)| (d, weight.minus(&wave(d))));
        differences.filter(|(_, x)| x.as_constant().is_none_or(|x| !x.is_zero())).collect()
    }

    /// M_0, of all orbits.
    pub(super) fn still(&self) -> Vec<Vec<IntegerFunction>> {
        let orbits = &self.ring.orbits;
        let entry = |weight: &EveryWeight, is_full: bool| match weight {
            EveryWeight::Same(weight) if is_full => weight.times(&self.index()),
            EveryWeight::Same(weight) => weight.clone(),
            EveryWeight::Turning { near, waves } => {
                let all = self
                    .index()
                    .times(&waves.first().cloned().unwrap_or_else(IntegerFunction::zero));
                let near = self.differences(near, waves);
                near.iter().fold(all, |sum, (_, difference)| sum.plus(difference))
            }
        };
        let row = |row: &Vec<EveryWeight>| {
            row.iter().zip(orbits).map(|(weight, (_, is_full))| entry(weight, *is_full)).collect()
        };
        self.ring.weights.iter().map(row).collect()
    }

    /// M_k for k ≠ 0, of the orbits of t points, and 2cos(2πk/t).
    pub(super) fn turning(&self, block: Block) -> Option<(Vec<Vec<Turned>>, IntegerFunction)> {
        let two = IntegerFunction::from(2);
        let double = match block {
            Block::Number(k) => two.times(&IntegerFunction::half_cosine(self.first, 2 * k)),
            Block::Beyond => two.times(&IntegerFunction::free(self.first)),
        };
        let wave = |waves: &[IntegerFunction]| match block {
            Block::Number(k) => {
                let b = usize::try_from(k).ok().and_then(|k| waves.get(k));
                let half = IntegerFunction::from_rational(&Rational::new(1, 2));
                b.map_or_else(IntegerFunction::zero, |b| b.times(&half).times(&self.index()))
            }
            Block::Beyond => IntegerFunction::zero(),
        };
        let entry = |weight: &EveryWeight| {
            let EveryWeight::Turning { near, waves } = weight else { return None };
            let terms = self.differences(near, waves);
            Some(terms.into_iter().fold(Turned::from(wave(waves)), |sum, (d, difference)| {
                sum.plus(&Turned::power(&double, d).times(&Turned::from(difference)))
            }))
        };
        let rows = self.ring.orbits.iter().zip(&self.ring.weights);
        let rows = rows.filter(|((_, is_full), _)| *is_full).map(|(_, row)| {
            let entries = self.ring.orbits.iter().zip(row).filter(|((_, is_full), _)| *is_full);
            entries.map(|(_, weight)| entry(weight)).collect::<Option<Vec<Turned>>>()
        });
        let matrix = rows.collect::<Option<Vec<_>>>()?;
        (!matrix.is_empty()).then_some((matrix, double))
    }

    /// The coefficients of det(x − M_k), from the constant one on, which are real; of rings with few orbits.
    pub(super) fn characteristic(&self, block: Block) -> Option<Vec<IntegerFunction>> {
        if self.ring.orbits.len() > MAX_ORBITS {
            return None;
        }
        if block == Block::Number(0) {
            return Some(characteristic_coefficients(&self.still()));
        }
        let (matrix, _) = self.turning(block)?;
        characteristic_coefficients(&matrix).iter().map(|c| c.real().cloned()).collect()
    }
}
