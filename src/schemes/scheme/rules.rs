//! Refinement rules: what masks and difference masks have in common.

use crate::cap::Cap;
use crate::exact::{Rational, Scalar};
use std::ops::Range;

/// The largest arity n.
pub const MAX_ARITY: usize = 64;

/// The largest number N of coefficients in a rule.
pub const MAX_WIDTH: usize = 256;

/// n rules of N coefficients each: y_{ni+α} = Σ_j r_{α,j} x_{i+o+j}, with
/// α = 0, …, n−1 and j = 0, …, N−1.
#[derive(Clone, Debug, PartialEq)]
pub struct Rules<S = Rational> {
    rows: Vec<Vec<S>>,
    offset: i64,
}

/// Why a table of numbers is not a set of rules.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum RulesError {
    /// Fewer than 2 or more than [`MAX_ARITY`] rules.
    #[error("a scheme of arity {0}; the arity must be from 2 to {MAX_ARITY}")]
    Arity(usize),
    /// No coefficient, or more than [`MAX_WIDTH`].
    #[error("rules of {0} coefficients; there must be from 1 to {MAX_WIDTH}")]
    Width(usize),
    /// Rules of different lengths.
    #[error(
        "rule {rule} has {found} coefficients, and rule 0 has {expected}; \
         pad the shorter rules with 0"
    )]
    Ragged {
        /// The number of the rule, counted from 0.
        rule: usize,
        /// Its length.
        found: usize,
        /// The length of rule 0.
        expected: usize,
    },
}

impl RulesError {
    /// The cap that the rules are beyond, if this is what is wrong.
    #[must_use]
    pub fn cap(&self) -> Option<Cap> {
        let (what, found, most) = match self {
            RulesError::Arity(found) => ("the arity", found, MAX_ARITY),
            RulesError::Width(found) => ("the width", found, MAX_WIDTH),
            RulesError::Ragged { .. } => return None,
        };
        (*found > most).then(|| Cap::new(what, most as u64))
    }
}

impl<S: Scalar> Rules<S> {
    /// The rules with these coefficients, one row for each α, and offset o.
    ///
    /// # Errors
    /// When the rows are ragged, or the arity or the width is out of range.
    pub fn new(rows: Vec<Vec<S>>, offset: i64) -> Result<Rules<S>, RulesError> {
        if !(2..=MAX_ARITY).contains(&rows.len()) {
            return Err(RulesError::Arity(rows.len()));
        }
        let expected = rows[0].len();
        if !(1..=MAX_WIDTH).contains(&expected) {
            return Err(RulesError::Width(expected));
        }
        match rows.iter().enumerate().find(|(_, row)| row.len() != expected) {
            Some((rule, row)) => Err(RulesError::Ragged { rule, found: row.len(), expected }),
            None => Ok(Rules { rows, offset }),
        }
    }

    /// The rows and the offset of the symbol Σ_k a_k z^k with powers from `low` to `high`: rule α has a_{α − n(o + j)} at place j, and o is
    /// the least number for which some rule has a coefficient at place 0, −⌊high/n⌋.
    pub(crate) fn rows_of_symbol(
        n: i64,
        (low, high): (i64, i64),
        coefficient: impl Fn(i64) -> S,
    ) -> (Vec<Vec<S>>, i64) {
        let places = -high.div_euclid(n)..=-low.div_euclid(n);
        let row = |alpha| places.clone().map(|at| coefficient(alpha - n * at)).collect();
        ((0..n).map(row).collect(), *places.start())
    }

    /// The arity n.
    #[must_use]
    pub fn arity(&self) -> usize {
        self.rows.len()
    }

    /// The width N.
    #[must_use]
    pub fn width(&self) -> usize {
        self.rows[0].len()
    }

    /// The offset o.
    #[must_use]
    pub fn offset(&self) -> i64 {
        self.offset
    }

    /// The coefficients, one row for each α.
    #[must_use]
    pub fn rows(&self) -> &[Vec<S>] {
        &self.rows
    }

    /// The same coefficients at another offset.
    #[must_use]
    pub fn with_offset(&self, offset: i64) -> Rules<S> {
        Rules { rows: self.rows.clone(), offset }
    }

    /// The rules with the coefficients r_{α,N−1−j}: each rule in reverse order.
    #[must_use]
    pub fn reversed(&self) -> Rules<S> {
        let reverse = |row: &Vec<S>| row.iter().rev().cloned().collect();
        Rules { rows: self.rows.iter().map(reverse).collect(), offset: self.offset }
    }

    /// The rules of the same points with other numbers: point i gets the number i − `first`, for
    /// 0 ≤ `first` < n. So rule α becomes rule α − `first`; a rule before `first` becomes rule
    /// α + n − `first`, whose coefficients stand one place later.
    ///
    /// Powers of the rules have the same norms, as points keep their values. This is not so for
    /// [`reversed`](Self::reversed) rules.
    ///
    /// # Panics
    /// When `first` is not below n.
    ///
    /// ```
    /// use subcert::scheme::parse_scheme;
    ///
    /// let scheme = parse_scheme("ternary-three-point:a=2/9")?;
    /// let rules = scheme.masks()[0].rules().numbered_from(2);
    /// // The point that stays is the second now.
    /// assert!(rules.rows()[1].iter().filter(|entry| !entry.is_zero()).count() == 1);
    /// # Ok::<(), subcert::scheme::SchemeError>(())
    /// ```
    #[must_use]
    pub fn numbered_from(&self, first: usize) -> Rules<S> {
        assert!(first < self.arity(), "there are as many rules as the arity says");
        if first == 0 {
            return self.clone();
        }
        let later = self.rows[first..].iter().map(|row| row.iter().cloned().chain([S::zero()]));
        let rows = later.map(Iterator::collect);
        let wrapped =
            self.rows[..first].iter().map(|row| [S::zero()].into_iter().chain(row.iter().cloned()));
        let rows = rows.chain(wrapped.map(Iterator::collect)).collect();
        Rules { rows, offset: self.offset }
    }

    /// The rules with every coefficient mapped by `map`.
    #[must_use]
    pub fn map<T>(&self, mut map: impl FnMut(&S) -> T) -> Rules<T> {
        let rows = self.rows.iter().map(|row| row.iter().map(&mut map).collect()).collect();
        Rules { rows, offset: self.offset }
    }

    /// The rules applied once to a closed polygon x_0, …, x_{m−1}, x_m = x_0:
    /// the n·m values y_0, …, y_{nm−1}.
    ///
    /// # Panics
    /// Never: a polygon that fits in memory has fewer than 2^63 points.
    ///
    /// ```
    /// use subcert::exact::Rational;
    /// use subcert::scheme::parse_scheme;
    ///
    /// let chaikin = parse_scheme("chaikin")?;
    /// let square: Vec<Rational> = [0, 4, 4, 0].map(Rational::from).to_vec();
    /// let refined = chaikin.masks()[0].rules().refine_closed(&square);
    /// assert_eq!(refined, [1, 3, 4, 4, 3, 1, 0, 0].map(Rational::from));
    /// # Ok::<(), subcert::scheme::SchemeError>(())
    /// ```
    #[must_use]
    pub fn refine_closed(&self, points: &[S]) -> Vec<S> {
        let count = i64::try_from(points.len()).expect("a polygon fits in memory");
        let at = |index: i64| &points[usize::try_from(index.rem_euclid(count)).expect("0 ≤ it")];
        let mut refined = Vec::with_capacity(points.len() * self.arity());
        for i in 0..count {
            refined.extend(self.rows.iter().map(|row| {
                (i + self.offset..).zip(row).fold(S::zero(), |sum, (index, coefficient)| {
                    sum.plus(&coefficient.times(at(index)))
                })
            }));
        }
        refined
    }
}

impl<S: Scalar + PartialEq> Rules<S> {
    /// The indices ni + α of the values Σ_j r_{α,j} x_{i+j} that an open polygon x_0, …, x_{m−1} determines, where m is `count`: those
    /// whose x_{i+j} with r_{α,j} ≠ 0 are all there, without a gap. With l_α and u_α, the first and the last j for which r_{α,j} ≠ 0, they go
    /// from max_α (α − n l_α) − n + 1 to min_α (α + n (m − 1 − u_α)) + n − 1. A rule of zeros needs
    /// x_i. The offset plays no role. Empty where m is too small.
    ///
    /// ```
    /// use subcert::scheme::parse_scheme;
    ///
    /// // The first rule keeps a point, the second one needs four.
    /// let scheme = parse_scheme("four-point")?;
    /// let rules = scheme.masks()[0].rules();
    /// assert_eq!((rules.open_range(6), rules.open_range(2).is_empty()), (0..7, true));
    /// # Ok::<(), subcert::scheme::SchemeError>(())
    /// ```
    #[must_use]
    pub fn open_range(&self, count: usize) -> Range<i64> {
        // No polygon in memory has so many points.
        let small = |number: usize| i64::try_from(number).unwrap_or(i64::MAX).min(1 << 48);
        let (arity, count, zero) = (small(self.arity()), small(count), S::zero());
        let (mut first, mut last) = (i64::MIN, i64::MAX);
        for (row, alpha) in self.rows.iter().zip(0..) {
            let used = |(_, entry): &(usize, &S)| **entry != zero;
            let of = |place: Option<(usize, &S)>| small(place.map_or(0, |(place, _)| place));
            first = first.max(alpha - arity * of(row.iter().enumerate().find(used)));
            let end = of(row.iter().enumerate().rfind(used));
            last = last.min(alpha + arity * (count - 1 - end));
        }
        first - arity + 1..last + arity
    }

    /// The rules applied once to an open polygon x_0, …, x_{m−1}: the values Σ_j r_{α,j}
    /// x_{i+j} for the indices ni + α of [`open_range`](Rules::open_range), one after the other.
    ///
    /// # Panics
    /// Never: the points of these indices are there.
    #[must_use]
    pub fn refine_open(&self, points: &[S]) -> Vec<S> {
        let (arity, zero) = (i64::try_from(self.arity()).expect("few rules"), S::zero());
        let value = |index: i64| {
            let (i, alpha) = (index.div_euclid(arity), index.rem_euclid(arity));
            let row = &self.rows[usize::try_from(alpha).expect("0 ≤ it")];
            (i..).zip(row).filter(|(_, coefficient)| **coefficient != zero).fold(
                S::zero(),
                |sum, (at, coefficient)| {
                    sum.plus(&coefficient.times(&points[usize::try_from(at).expect("0 ≤ it")]))
                },
            )
        };
        self.open_range(points.len()).map(value).collect()
    }
}
