//! The search for parameters inside and outside.

use super::excluded::{excluded, first_words, included};
use super::parametric::{PolynomialMatrix, bernstein, multiplied};
use crate::exact::{
    Enclosed as _, Interval, IntervalSet, Rational, RationalPolynomial, RealAlgebraic,
};
use crate::joint::{
    Closing, MatrixSet, MatrixSetError, contracts, expanding_product, hull_when_balanced,
};
use std::collections::BTreeSet;
use std::ops::Bound;

/// A gap beside an interval inside is narrow enough at this part of the length of that interval …
const NARROW: (i64, i64) = (1, 16_384);

/// … and at this one where only hulls of matrices in the middle make it narrower, which take many short intervals.
const RATHER_NARROW: (i64, i64) = (1, 2_048);

/// As many intervals as such a hull counts for.
const DEAR: usize = 15;

/// A gap is divided into pieces of this part of its length at least, before it is looked at anew.
const PART: i64 = 8;

/// The line between the ends of what is known is first divided into pieces of this part at least.
const FIRST_PART: i64 = 32;

/// The largest matrices whose determinants are taken as functions of the parameter.
const MAX_SIZE: usize = 12;

/// The most factors of a product, times the size and the degree of the entries: the degree of its determinants.
const MAX_DEGREE: usize = 48;

/// The most products.
const MAX_WORDS: usize = 48;

/// Parameters of up to 4 to this power are looked at.
const FAR: i32 = 8;

/// The most intervals that are looked at.
const MAX_PIECES: usize = 1_500;

/// The same where each hull is looked for in a basis of its own.
const MAX_LARGE_PIECES: usize = 200;

/// What is known of a line of parameters.
#[derive(Clone, Debug)]
pub(crate) struct Search {
    matrices: Vec<PolynomialMatrix>,
    /// The greatest degree of an entry, at least 1.
    degree: usize,
    pub(crate) inside: IntervalSet,
    pub(crate) outside: IntervalSet,
    words: BTreeSet<Vec<usize>>,
    pieces: usize,
    /// Whether each hull is looked for in a basis of its own.
    balanced: bool,
}

impl Search {
    pub(crate) fn new(matrices: Vec<PolynomialMatrix>) -> Result<Search, MatrixSetError> {
        let entries = matrices.iter().flatten().flatten();
        let degree = entries.filter_map(RationalPolynomial::degree).max().unwrap_or(0).max(1);
        let mut search = Search {
            matrices,
            degree,
            inside: IntervalSet::default(),
            outside: IntervalSet::default(),
            words: BTreeSet::new(),
            pieces: 0,
            balanced: false,
        };
        search.set_at(&Rational::zero())?;
        for word in first_words(search.matrices.len()) {
            search.exclude(&word);
        }
        Ok(search)
    }

    /// The same, where each hull is looked for in a basis of its own: for matrices that are no windows of a mask.
    pub(crate) fn balanced(matrices: Vec<PolynomialMatrix>) -> Result<Search, MatrixSetError> {
        Ok(Search { balanced: true, ..Search::new(matrices)? })
    }

    fn set_at(&self, value: &Rational) -> Result<MatrixSet, MatrixSetError> {
        let row = |row: &Vec<RationalPolynomial>| row.iter().map(|p| p.value_at(value)).collect();
        let matrix = |matrix: &PolynomialMatrix| matrix.iter().map(row).collect();
        MatrixSet::new(self.matrices.iter().map(matrix).collect())
    }

    /// Adds to the outside where this product shows it.
    fn exclude(&mut self, word: &[usize]) {
        let size = self.matrices.first().map_or(0, Vec::len);
        let degree = word.len() * self.degree;
        let large = size > MAX_SIZE || size * degree > MAX_DEGREE;
        if large || self.words.len() == MAX_WORDS || self.words.contains(word) {
            return;
        }
        let factors = word.iter().map(|&i| self.matrices[i].clone());
        let product = factors.reduce(|product, matrix| multiplied(&product, &matrix));
        let Some(product) = product else { return };
        self.words.insert(word.to_vec());
        self.outside = self.outside.union(&excluded(&product, degree));
    }

    /// Divides the line between the ends of what is known, and then the gaps, as long as they become narrower.
    pub(crate) fn run(&mut self, known: &IntervalSet) -> Result<(), MatrixSetError> {
        self.look_far(known)?;
        let ends: Vec<Rational> = known
            .ends()
            .chain(self.outside.ends())
            .flat_map(|(end, _)| <[Rational; 2]>::from(end.bounds()))
            .collect();
        let (one, zero) = (Rational::one(), Rational::zero());
        let low = Rational::from((ends.iter().min().unwrap_or(&zero) - &one).floor());
        let high = Rational::from((ends.iter().max().unwrap_or(&zero) + &one).ceil());
        let width = (&high - &low) / Rational::from(FIRST_PART);
        self.divide((low, high), known, (&width, Closing::All))?;
        if self.balanced {
            return self.narrow(known, RATHER_NARROW, Closing::All);
        }
        self.narrow(known, NARROW, Closing::All)?;
        self.narrow(known, RATHER_NARROW, Closing::Middle)
    }

    /// Divides the gaps that are wider than this part of an interval inside beside them, as long as they become
    /// narrower.
    fn narrow(
        &mut self,
        known: &IntervalSet,
        part: (i64, i64),
        closing: Closing,
    ) -> Result<(), MatrixSetError> {
        // A gap that a round has left as it was is not looked at again.
        let mut before = Vec::new();
        loop {
            let gaps = self.wide_gaps(known, part);
            let mut open = gaps.iter().filter(|gap| !before.contains(*gap)).peekable();
            if open.peek().is_none() || self.is_spent() {
                return Ok(());
            }
            for (a, b) in open {
                let width = (b - a) / Rational::from(PART);
                self.divide((a.clone(), b.clone()), known, (&width, closing))?;
            }
            before = gaps;
        }
    }

    /// The bounded gaps, with rational ends a little outside, but those that are narrow beside an interval inside.
    fn wide_gaps(&self, known: &IntervalSet, (part, of): (i64, i64)) -> Vec<(Rational, Rational)> {
        let inside = self.inside.union(known);
        let gaps = IntervalSet::everything().without(&inside).without(&self.outside);
        let lengths = inside.intervals().iter().filter_map(|interval| {
            let (low, high) = outer_ends(interval)?;
            Some((&high - &low, low, high))
        });
        let lengths: Vec<(Rational, Rational, Rational)> = lengths.collect();
        let total: Rational = lengths.iter().map(|(length, ..)| length.clone()).sum();
        let is_narrow = |(a, b): &(Rational, Rational)| {
            let beside = lengths.iter().filter(|(_, low, high)| low <= b && a <= high);
            let length = beside.map(|(length, ..)| length).min();
            let length = length.map(|length| if self.balanced { &total } else { length });
            length.is_some_and(|length| (b - a) <= length * Rational::new(part, of))
        };
        let ends = gaps.intervals().iter().filter_map(outer_ends);
        ends.filter(|gap| !is_narrow(gap)).map(rounded).collect()
    }

    /// Divides an interval until all is decided, or narrower than `width`.
    pub(super) fn divide(
        &mut self,
        interval: (Rational, Rational),
        known: &IntervalSet,
        (width, closing): (&Rational, Closing),
    ) -> Result<(), MatrixSetError> {
        let mut waiting = vec![interval];
        while let Some((a, b)) = waiting.pop() {
            let piece = closed(&a, &b);
            if self.outside.covers(&piece) || known.covers(&piece) || self.is_spent() {
                continue;
            }
            // Hulls of matrices in the middle are invariant on intervals only that are short against the gap.
            let tried = closing == Closing::All || &b - &a <= width * Rational::from(2);
            self.pieces += if closing == Closing::Middle && tried { DEAR } else { 1 };
            if tried && self.is_inside(&a, &b, closing)? {
                self.inside = self.inside.union(&IntervalSet::from(piece));
                continue;
            }
            if &b - &a <= *width {
                continue;
            }
            let middle = (&a + &b) / Rational::from(2);
            self.look_at(&middle, known)?;
            waiting.push((a, middle.clone()));
            waiting.push((middle, b));
        }
        Ok(())
    }

    /// Whether as many intervals were looked at as may be.
    fn is_spent(&self) -> bool {
        self.pieces >= if self.balanced { MAX_LARGE_PIECES } else { MAX_PIECES }
    }

    /// Allows for as many pieces as at first.
    pub(super) fn refresh(&mut self) {
        self.pieces = 0;
    }

    /// Looks for products that exclude parameters far away.
    fn look_far(&mut self, known: &IntervalSet) -> Result<(), MatrixSetError> {
        for exponent in -1..FAR {
            for sign in [1, -1] {
                let value = Rational::from(4).pow(exponent) * Rational::from(sign);
                self.look_at(&value, known)?;
            }
        }
        Ok(())
    }

    /// Looks for a product that excludes a parameter which is not decided yet.
    fn look_at(&mut self, value: &Rational, known: &IntervalSet) -> Result<(), MatrixSetError> {
        let decided = self.outside.contains(value) || known.contains(value);
        if decided || self.words.len() == MAX_WORDS {
            return Ok(());
        }
        if let Some(word) = expanding_product(&self.set_at(value)?) {
            self.exclude(&word);
        }
        Ok(())
    }

    /// Whether the radius is below 1 on the whole interval.
    fn is_inside(
        &self,
        a: &Rational,
        b: &Rational,
        closing: Closing,
    ) -> Result<bool, MatrixSetError> {
        let middle = (a + b) / Rational::from(2);
        if self.outside.contains(a) || self.outside.contains(b) || self.outside.contains(&middle) {
            return Ok(false);
        }
        let parts = self.matrices.iter().flat_map(|matrix| bernstein(matrix, self.degree, (a, b)));
        let set = MatrixSet::new(parts.collect())?;
        let ends = [self.set_at(a)?, self.set_at(b)?];
        let middle = self.set_at(&middle)?;
        Ok(if self.balanced {
            hull_when_balanced(&set, &middle, &ends, closing).is_some()
        } else {
            contracts(&set, &middle, &ends, closing)
        })
    }
}

/// Ends that are not inside, and multiples of a power of two that is small against the length.
fn rounded((a, b): (Rational, Rational)) -> (Rational, Rational) {
    let length = &b - &a;
    let mut unit = Rational::one();
    while &unit * Rational::from(2 * PART) > length {
        unit /= Rational::from(2);
    }
    let low = Rational::from((a / &unit).floor()) * &unit;
    (low, Rational::from((b / &unit).ceil()) * unit)
}

/// Rational numbers next to the ends of a bounded interval, not inside it.
pub(crate) fn outer_ends(interval: &Interval) -> Option<(Rational, Rational)> {
    let place = |end: &Bound<RealAlgebraic>| match end {
        Bound::Unbounded => None,
        Bound::Included(place) | Bound::Excluded(place) => Some(place.enclosure(0)),
    };
    let (low, high) = (place(&interval.low)?, place(&interval.high)?);
    Some((low.lower().clone(), high.upper().clone()))
}

fn closed(a: &Rational, b: &Rational) -> Interval {
    let end = |x: &Rational| included(&RealAlgebraic::from(x.clone()));
    Interval { low: end(a), high: end(b) }
}
