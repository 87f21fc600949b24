//! For which parameters the limits are C^m, from both sides.

use super::independence::independent;
use super::parametric::{
    ParametricSymbol, PolynomialMatrix, bernstein, multiplied, unit_determinants,
};
use crate::bound::{ParameterRange, RangeError};
use crate::exact::{
    Interval, IntervalSet, PiecewisePolynomial, Rational, RationalPolynomial, RealAlgebraic,
};
use crate::joint::{MatrixSet, MatrixSetError, contracts, expanding_product};
use crate::scheme::Rules;
use std::collections::BTreeSet;
use std::ops::Bound;

/// Intervals that are not wider than this are not divided.
const WIDTH: (i64, i64) = (1, 16_384);

/// The most factors of a product whose eigenvalues are taken as functions of the parameter.
const MAX_FACTORS: usize = 6;

/// The most products.
const MAX_WORDS: usize = 48;

/// Parameters of up to 4 to this power are looked at.
const FAR: i32 = 8;

/// The most intervals that are looked at.
const MAX_PIECES: usize = 1_500;

/// Why there is no range.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SmoothRangeError {
    /// C^m needs sum rules of a higher order than hold for all parameters.
    #[error(
        "C^{m} needs sum rules of order {needed}, and those of order {found} hold for all parameters, but no \
         more: on no interval are the limits C^{m}"
    )]
    SumRules {
        /// m.
        m: usize,
        /// m + 1.
        needed: usize,
        /// The order that holds.
        found: usize,
    },
    /// The rules are too long.
    #[error("the rules are too long for a proof of smoothness: {0}")]
    TooLong(#[from] MatrixSetError),
    /// The contraction is beyond a cap.
    #[error(transparent)]
    Range(#[from] RangeError),
}

/// Where the limits are C^m.
#[derive(Clone, Debug)]
pub struct SmoothRange {
    /// For c = 1, 2, … the set where ‖(n^mS_{m+1})^c‖ < 1, as of [`ParameterRange`].
    pub contraction: ParameterRange,
    /// There all limits are C^m.
    pub inside: IntervalSet,
    /// There not all limits are C^m, or the scheme diverges.
    pub outside: IntervalSet,
    /// Whether finitely many parameters of `outside` may be exceptions: those where the shifts of the basic
    /// limit function are linearly dependent.
    pub but_finitely_many: bool,
    /// The length of what is in neither, rounded upwards; `None` where that is unbounded.
    pub gap: Option<Rational>,
}

/// Where the limits of a mask in one parameter are C^m.
///
/// Inside by contraction, up to `levels` levels, and by hulls that are invariant on whole intervals: for
/// the matrices of which those of the interval are the mean (`proofs/THEOREMS.md`, 111). Outside where a
/// product of n^mS_K has the eigenvalue 1 or more in absolute value, by the sign of det(I ∓ P) (112).
///
/// # Errors
/// When the sum rules do not hold, or the work is beyond a cap.
///
/// # Panics
/// Never.
pub fn smooth_range(
    rules: &Rules<RationalPolynomial>,
    m: usize,
    levels: u32,
) -> Result<SmoothRange, SmoothRangeError> {
    let whole = ParametricSymbol::of(rules);
    let orders = std::iter::successors(Some(whole.clone()), ParametricSymbol::over_sigma);
    let orders: Vec<ParametricSymbol> = orders.collect();
    let found = orders.len() - 1;
    if found < m + 1 {
        return Err(SmoothRangeError::SumRules { m, needed: m + 1, found });
    }
    let n = Rational::from(whole.arity());
    let factor = (0..m).fold(Rational::one(), |power, _| power * &n);
    let contraction = ParameterRange::new(&orders[m + 1].scaled(&factor).rules(), levels)?;
    let matrices = orders[found].scaled(&factor).matrices();
    let mut search = Search::new(matrices)?;
    search.run(&contraction.union)?;
    let inside = search.inside.union(&contraction.union);
    let sure = m == 0 || whole.is_interpolating();
    let outside = if sure { search.outside } else { generically(&whole, &search.outside) };
    let gap = gap(&inside.union(&outside));
    Ok(SmoothRange { contraction, inside, outside, but_finitely_many: !sure, gap })
}

/// The intervals in which some parameter has independent shifts: then all but finitely many of each have.
fn generically(symbol: &ParametricSymbol, outside: &IntervalSet) -> IntervalSet {
    let proper = |interval: &&Interval| {
        interval.rational().is_some_and(|value| {
            let at = symbol.at(&value);
            independent(&at) == at
        })
    };
    let proper = outside.intervals().iter().filter(proper).cloned().map(IntervalSet::from);
    proper.fold(IntervalSet::default(), |union, set| union.union(&set))
}

/// The length of the complement, if it is bounded.
fn gap(known: &IntervalSet) -> Option<Rational> {
    let intervals = known.intervals();
    let bounded = matches!(intervals.first()?.low, Bound::Unbounded)
        && matches!(intervals.last()?.high, Bound::Unbounded);
    let place = |end: &Bound<RealAlgebraic>| match end {
        Bound::Unbounded => None,
        Bound::Included(place) | Bound::Excluded(place) => Some(place.clone()),
    };
    let length = |pair: &[Interval]| {
        use crate::exact::Enclosed as _;
        let (low, high) = (place(&pair[0].high)?, place(&pair[1].low)?);
        Some(high.enclosure(0).upper() - low.enclosure(0).lower())
    };
    if !bounded {
        return None;
    }
    intervals.windows(2).map(length).sum()
}

struct Search {
    matrices: Vec<PolynomialMatrix>,
    /// The greatest degree of an entry, at least 1.
    degree: usize,
    inside: IntervalSet,
    outside: IntervalSet,
    words: BTreeSet<Vec<usize>>,
    pieces: usize,
}

impl Search {
    fn new(matrices: Vec<PolynomialMatrix>) -> Result<Search, SmoothRangeError> {
        let entries = matrices.iter().flatten().flatten();
        let degree = entries.filter_map(RationalPolynomial::degree).max().unwrap_or(0).max(1);
        let mut search = Search {
            matrices,
            degree,
            inside: IntervalSet::default(),
            outside: IntervalSet::default(),
            words: BTreeSet::new(),
            pieces: 0,
        };
        search.set_at(&Rational::zero())?;
        for word in first_words(search.matrices.len()) {
            search.exclude(word);
        }
        Ok(search)
    }

    fn set_at(&self, value: &Rational) -> Result<MatrixSet, MatrixSetError> {
        let row = |row: &Vec<RationalPolynomial>| row.iter().map(|p| p.value_at(value)).collect();
        let matrix = |matrix: &PolynomialMatrix| matrix.iter().map(row).collect();
        MatrixSet::new(self.matrices.iter().map(matrix).collect())
    }

    /// Adds to the outside where this product has a real eigenvalue of 1 or more in absolute value.
    fn exclude(&mut self, word: Vec<usize>) {
        if word.len() > MAX_FACTORS || self.words.len() == MAX_WORDS || self.words.contains(&word) {
            return;
        }
        let factors = word.iter().map(|&i| self.matrices[i].clone());
        let product = factors.reduce(|product, matrix| multiplied(&product, &matrix));
        self.words.insert(word);
        let Some(product) = product else { return };
        for determinant in unit_determinants(&product) {
            let reached = PiecewisePolynomial::from(determinant).at_most(&Rational::zero());
            self.outside = self.outside.union(&reached);
        }
    }

    /// Divides the line between the ends of what is known until all is decided, or too narrow.
    fn run(&mut self, known: &IntervalSet) -> Result<(), SmoothRangeError> {
        self.look_far(known)?;
        let ends = known.ends().chain(self.outside.ends()).flat_map(|(end, _)| {
            let (low, high) = end.bounds();
            [low, high]
        });
        let ends: Vec<Rational> = ends.collect();
        let one = Rational::one();
        let zero = Rational::zero();
        let low = (ends.iter().min().unwrap_or(&zero) - &one).floor();
        let high = (ends.iter().max().unwrap_or(&zero) + &one).ceil();
        let mut waiting = vec![(Rational::from(low), Rational::from(high))];
        let width = Rational::new(WIDTH.0, WIDTH.1);
        while let Some((a, b)) = waiting.pop() {
            let piece = closed(&a, &b);
            if self.outside.covers(&piece) || known.covers(&piece) || self.pieces == MAX_PIECES {
                continue;
            }
            self.pieces += 1;
            if self.is_inside(&a, &b)? {
                self.inside = self.inside.union(&IntervalSet::from(piece));
                continue;
            }
            if &b - &a <= width {
                continue;
            }
            let middle = (&a + &b) / Rational::from(2);
            self.look_at(&middle, known)?;
            waiting.push((a, middle.clone()));
            waiting.push((middle, b));
        }
        Ok(())
    }

    /// Looks for products that exclude parameters far away.
    fn look_far(&mut self, known: &IntervalSet) -> Result<(), SmoothRangeError> {
        for exponent in -1..FAR {
            for sign in [1, -1] {
                let value = Rational::from(4).pow(exponent) * Rational::from(sign);
                self.look_at(&value, known)?;
            }
        }
        Ok(())
    }

    /// Looks for a product that excludes a parameter which is not decided yet.
    fn look_at(&mut self, value: &Rational, known: &IntervalSet) -> Result<(), SmoothRangeError> {
        let decided = self.outside.contains(value) || known.contains(value);
        if decided || self.words.len() == MAX_WORDS {
            return Ok(());
        }
        if let Some(word) = expanding_product(&self.set_at(value)?) {
            self.exclude(word);
        }
        Ok(())
    }

    /// Whether the radius is below 1 on the whole interval.
    fn is_inside(&self, a: &Rational, b: &Rational) -> Result<bool, SmoothRangeError> {
        let middle = (a + b) / Rational::from(2);
        if self.outside.contains(a) || self.outside.contains(b) || self.outside.contains(&middle) {
            return Ok(false);
        }
        let parts = self.matrices.iter().flat_map(|matrix| bernstein(matrix, self.degree, (a, b)));
        let set = MatrixSet::new(parts.collect())?;
        Ok(contracts(&set, &self.set_at(&middle)?))
    }
}

/// Words of up to four letters, as long as there are few, one of each set of rotations.
fn first_words(letters: usize) -> Vec<Vec<usize>> {
    let longest = match letters {
        2 => 4,
        3 => 3,
        4..=6 => 2,
        _ => 1,
    };
    let (mut all, mut level) = (Vec::new(), vec![Vec::new()]);
    for _ in 0..longest {
        let longer = |word: &Vec<usize>| (0..letters).map(|i| [&word[..], &[i]].concat()).collect();
        let next: Vec<Vec<usize>> = level.iter().flat_map::<Vec<_>, _>(longer).collect();
        let first = |word: &&Vec<usize>| {
            (1..word.len()).all(|i| [&word[i..], &word[..i]].concat() > **word)
        };
        all.extend(next.iter().filter(first).cloned());
        level = next;
    }
    all
}

fn closed(a: &Rational, b: &Rational) -> Interval {
    let end = |x: &Rational| Bound::Included(RealAlgebraic::from(x.clone()));
    Interval { low: end(a), high: end(b) }
}
