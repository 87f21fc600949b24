//! Spectra of a ring for all valences t from one on (`proofs/THEOREMS.md`, 145).
//!
//! | file | subject |
//! |---|---|
//! | `blocks` | the Fourier blocks, and their characteristic polynomials |
//! | `roots` | the roots of polynomials of degree 2 |

mod blocks;
mod roots;

use crate::exact::{Adjugate, IntegerFunction, Scalar as _, Turned};
use crate::scheme::EveryRing;
use blocks::{Block, Blocks};
use roots::Roots;
use std::cmp::Ordering;

/// The greatest number of a point of which the weight in a tangent is computed.
const MAX_POINT: i64 = 30;

/// Which eigenvalues are compared with the square of the subdominant one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CurvaturePart {
    /// All others.
    Both,
    /// Those of block 0.
    Elliptic,
    /// Those of block 2.
    Hyperbolic,
}

/// The spectrum of a ring for all valences t ≥ `first`. What is not decided for all of them is `None`.
///
/// ```
/// use subcert::exact::IntegerFunction;
/// use subcert::scheme::find_in_catalogue;
/// use subcert::spectrum::EverySpectrum;
///
/// let rules = find_in_catalogue("doo-sabin")?.every_ring(&[].into(), 27).expect("known weights");
/// let spectrum = EverySpectrum::new(rules, 27).expect("weights of the sum 1");
/// let subdominant = spectrum.subdominant().and_then(|value| value.as_constant());
/// assert_eq!(subdominant, Some(subcert::exact::Rational::new(1, 2)));
/// # Ok::<(), subcert::scheme::SchemeError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct EverySpectrum(Blocks);

impl EverySpectrum {
    /// The spectrum of a ring at the valences t ≥ `first`; `None` if its weights do not sum to 1.
    #[must_use]
    pub fn new(ring: EveryRing, first: i64) -> Option<EverySpectrum> {
        let spectrum = EverySpectrum(Blocks { ring, first });
        let one = IntegerFunction::from(1);
        let sums = spectrum.0.still().into_iter().all(|row| {
            let sum = IntegerFunction::total(&row);
            sum.minus(&one).sign().is_some_and(Ordering::is_eq)
        });
        sums.then_some(spectrum)
    }

    fn roots(&self, block: i64) -> Option<Roots> {
        Roots::of(&self.0.characteristic(Block::Number(block))?)
    }

    /// The roots of block 0 but for a simple root 1.
    fn others_of_still(&self) -> Option<Roots> {
        let one = IntegerFunction::from(1);
        let roots = Roots::of(&roots::without(&self.0.characteristic(Block::Number(0))?, &one)?)?;
        let differs = |root: &IntegerFunction| root.minus(&one).sign().is_some_and(Ordering::is_ne);
        roots.real.iter().all(differs).then_some(roots)
    }

    /// The `place`-th greatest real eigenvalue of a block from 0 to 6.
    #[must_use]
    pub fn eigenvalue(&self, block: i64, place: usize) -> Option<IntegerFunction> {
        let mut real = match block {
            0 => self.others_of_still()?.real,
            1..=IntegerFunction::NEAR => self.roots(block)?.real,
            _ => return None,
        };
        if block == 0 {
            real.push(IntegerFunction::from(1));
            real = roots::ordered(real)?;
        }
        real.into_iter().nth(place.checked_sub(1)?)
    }

    /// The greatest eigenvalue λ of block 1, if it is positive and simple there, less than 1, which is simple in block 0, and greater than the absolute values
    /// of all others.
    #[must_use]
    pub fn subdominant(&self) -> Option<IntegerFunction> {
        let first = self.roots(1)?;
        let (lambda, others) = first.real.split_first()?;
        let is_positive = |x: &IntegerFunction| x.sign().is_some_and(Ordering::is_gt);
        let is_within = |root: &IntegerFunction| {
            is_positive(&lambda.minus(root)) && is_positive(&lambda.plus(root))
        };
        if !is_positive(lambda)
            || !is_positive(&IntegerFunction::from(1).minus(lambda))
            || first.complex.is_some()
            || !others.iter().all(is_within)
        {
            return None;
        }
        self.are_below(lambda, 2)?.then(|| lambda.clone())
    }

    /// Whether all eigenvalues but a 1 of block 0 are shown to be less than a positive function in absolute value; those of the blocks between 0 and `from` do not count.
    fn are_below(&self, limit: &IntegerFunction, from: i64) -> Option<bool> {
        let still = self.0.characteristic(Block::Number(0))?;
        let still = roots::without(&still, &IntegerFunction::from(1))?;
        let numbered =
            (from..=IntegerFunction::NEAR).map(|k| self.0.characteristic(Block::Number(k)));
        let numbered = numbered.collect::<Option<Vec<_>>>()?;
        let all = std::iter::once(&still).chain(&numbered);
        Some(all.chain(&self.ends()?).all(|p| roots::are_within(p, limit, Ordering::is_gt)))
    }

    /// The polynomials of the blocks k from 7 on at the ends of an interval with all cos(2πk/t), if they are linear in it.
    fn ends(&self) -> Option<[Vec<IntegerFunction>; 2]> {
        let beyond = self.0.characteristic(Block::Beyond)?;
        let lines = beyond.iter().map(IntegerFunction::line_in_free);
        let lines = lines.collect::<Option<Vec<_>>>()?;
        let greatest = IntegerFunction::half_cosine(self.0.first, 2 * (IntegerFunction::NEAR + 1));
        let at = |c: &IntegerFunction| lines.iter().map(|[a, b]| a.plus(&b.times(c))).collect();
        Some([at(&IntegerFunction::from(-1)), at(&greatest)])
    }

    /// The greatest absolute value of the other eigenvalues over λ².
    #[must_use]
    pub fn curvature(&self, part: CurvaturePart) -> Option<IntegerFunction> {
        let lambda = self.subdominant()?;
        let mut sizes = Vec::new();
        if part != CurvaturePart::Elliptic {
            sizes.extend(self.roots(2)?.sizes()?);
        }
        if part != CurvaturePart::Hyperbolic {
            sizes.extend(self.others_of_still()?.sizes()?);
        }
        if part == CurvaturePart::Both {
            sizes.extend(self.roots(1)?.sizes()?.into_iter().skip(1));
            for k in 3..=IntegerFunction::NEAR {
                sizes.extend(self.roots(k)?.sizes()?);
            }
        }
        let greatest = roots::greatest(&sizes)?;
        if part == CurvaturePart::Both
            && !self.ends()?.iter().all(|p| roots::are_within(p, greatest, Ordering::is_ge))
        {
            return None;
        }
        let square = lambda.times(&lambda);
        match greatest.minus(&square).sign() {
            Some(Ordering::Equal) => Some(IntegerFunction::from(1)),
            _ => Some(greatest.times(&square.inverse()?)),
        }
    }

    fn orbit(&self, name: Option<&str>) -> Option<usize> {
        match name {
            None => Some(0),
            Some(name) => self.0.ring.orbits.iter().position(|(known, _)| known == name),
        }
    }

    /// The weight of each point of an orbit, the first one without a name, in the limit of all points; all eigenvalues but a simple 1 are less than 1 in
    /// absolute value.
    ///
    /// The rows of adj(1 − M_0) are left eigenvectors; that their sum is not 0 makes 1 a simple eigenvalue.
    #[must_use]
    pub fn limit_weight(&self, orbit: Option<&str>) -> Option<IntegerFunction> {
        let orbit = self.orbit(orbit)?;
        self.are_below(&IntegerFunction::from(1), 1)?.then_some(())?;
        let adjugate = Adjugate::of(&self.0.still()).adjugate;
        let size = self.0.ring.orbits.len();
        let entry = |b: usize| IntegerFunction::total(adjugate.iter().map(|power| &power[0][b]));
        let row: Vec<IntegerFunction> = (0..size).map(entry).collect();
        let weight = row[orbit].times(&IntegerFunction::total(&row).inverse()?);
        let (_, is_full) = self.0.ring.orbits[orbit];
        let count = if is_full { self.0.index() } else { IntegerFunction::from(1) };
        Some(weight.times(&count.inverse()?))
    }

    /// The weight of a point of an orbit, the first one without a name, in the first tangent.
    #[must_use]
    pub fn tangent_weight(&self, point: i64, orbit: Option<&str>) -> Option<IntegerFunction> {
        let orbit = self.orbit(orbit)?;
        if !(0..=MAX_POINT).contains(&point) {
            return None;
        }
        let lambda = self.subdominant()?;
        let (matrix, double) = self.0.turning(Block::Number(1))?;
        let full = self.0.ring.orbits.iter().enumerate().filter(|(_, (_, is_full))| *is_full);
        let Some(place) = full.map(|(place, _)| place).position(|place| place == orbit) else {
            return Some(IntegerFunction::zero());
        };
        let adjugate = Adjugate::of(&matrix).adjugate;
        let lambda = Turned::from(lambda);
        let entry = |a: usize| {
            let powers = adjugate.iter().rev();
            powers
                .fold(Turned::from_rational(&0.into()), |sum, b| sum.times(&lambda).plus(&b[0][a]))
        };
        let scale = entry(0).real()?.inverse()?;
        let turned = entry(place).times(&Turned::from(scale));
        Some(turned.times(&Turned::power(&double, -point)).real_part())
    }
}
