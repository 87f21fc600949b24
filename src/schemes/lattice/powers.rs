//! Several steps of a mask on Z^d in one.

use crate::exact::{Rational, Scalar};
use crate::scheme::{LatticeMask, Point, difference, sum};
use std::collections::BTreeMap;

/// A functional on data: the sum of its coefficients times the values at their places.
pub type Functional<S> = BTreeMap<Point, S>;

/// The sums of the products x·y at the sums of their places.
pub fn convolved<'x, S: Scalar + 'x>(
    first: impl Iterator<Item = (Point, &'x S)>,
    second: &Functional<S>,
) -> Functional<S> {
    let mut all: Functional<S> = BTreeMap::new();
    for (place, x) in first {
        for (at, y) in second {
            all.entry(sum(place, *at)).or_insert_with(S::zero).accumulate(&y.times(x));
        }
    }
    all
}

/// S^c: (S^c p)_α = Σ_β a_c(α − M^cβ) p_β, with the rows of one α of each class of Z^d/M^cZ^d.
#[derive(Clone, Debug)]
pub struct Steps<'m, S> {
    mask: &'m LatticeMask<S>,
    /// c.
    count: u32,
    /// a_c, by places.
    coefficients: Functional<S>,
}

impl<'m, S: Scalar + PartialEq> Steps<'m, S> {
    /// No step: the data themselves.
    #[must_use]
    pub fn none(mask: &'m LatticeMask<S>) -> Steps<'m, S> {
        let one = S::from_rational(&Rational::one());
        Steps { mask, count: 0, coefficients: BTreeMap::from([([0; 3], one)]) }
    }

    /// One step more: a_{c+1}(γ) = Σ_β a(γ − Mβ) a_c(β).
    #[must_use]
    pub fn next(&self) -> Steps<'m, S> {
        let dilation = self.mask.dilation();
        let images = self.coefficients.iter().map(|(place, c)| (dilation.times(*place), c));
        let mut coefficients = convolved(images, self.mask.coefficients());
        let zero = S::zero();
        coefficients.retain(|_, c| *c != zero);
        Steps { mask: self.mask, count: self.count + 1, coefficients }
    }

    /// The mask.
    #[must_use]
    pub fn mask(&self) -> &'m LatticeMask<S> {
        self.mask
    }

    /// c.
    #[must_use]
    pub fn count(&self) -> u32 {
        self.count
    }

    /// a_c.
    #[must_use]
    pub fn coefficients(&self) -> &Functional<S> {
        &self.coefficients
    }

    /// The class of a place γ and κ, γ = ε + M^cκ: a number for each of the m^c digits ε, which are those of one step in the order ε_0 + M(ε_1 + M(…)).
    fn split(&self, place: Point) -> (usize, Point) {
        let dilation = self.mask.dilation();
        let (mut class, mut scale, mut rest) = (0, 1, place);
        for _ in 0..self.count {
            let (digit, quotient) = dilation.split(rest);
            class += scale * digit;
            scale *= dilation.class_count();
            rest = quotient;
        }
        (class, rest)
    }

    /// The digit with this number.
    fn digit(&self, class: usize) -> Point {
        let dilation = self.mask.dilation();
        let m = dilation.class_count();
        let digits: Vec<usize> = (0..self.count)
            .scan(class, |rest, _| {
                let digit = *rest % m;
                *rest /= m;
                Some(digit)
            })
            .collect();
        digits
            .into_iter()
            .rev()
            .fold([0; 3], |point, digit| sum(dilation.times(point), dilation.digits()[digit]))
    }

    /// The rows: for each digit ε of M^c the functional p ↦ (S^c p)_ε.
    #[must_use]
    pub fn rows(&self) -> Vec<(Point, Functional<S>)> {
        let classes = self.mask.dilation().class_count().pow(self.count);
        let mut rows: Vec<(Point, Functional<S>)> =
            (0..classes).map(|class| (self.digit(class), BTreeMap::new())).collect();
        for (place, c) in &self.coefficients {
            // ε − M^cβ = γ for β = −κ.
            let (class, quotient) = self.split(*place);
            rows[class].1.insert(difference([0; 3], quotient), c.clone());
        }
        rows
    }

    /// A functional of the data of level c at the places that it has, moved by a vector, as a functional of the data of level 0.
    ///
    /// # Panics
    /// When the rows are not [those](Self::rows) of these steps.
    #[must_use]
    pub fn pulled(
        &self,
        rows: &[(Point, Functional<S>)],
        functional: &Functional<S>,
        by: Point,
    ) -> Functional<S> {
        let mut pulled: Functional<S> = BTreeMap::new();
        for (place, weight) in functional {
            let (class, shift) = self.split(sum(*place, by));
            for (at, c) in &rows[class].1 {
                let entry = pulled.entry(sum(*at, shift)).or_insert_with(S::zero);
                entry.accumulate(&c.times(weight));
            }
        }
        let zero = S::zero();
        pulled.retain(|_, c| *c != zero);
        pulled
    }

    /// For each digit ε and each edge u, the functional p ↦ (S^c p)_{ε+u} − (S^c p)_ε.
    #[must_use]
    pub fn differences(&self) -> Vec<(Point, Point, Functional<S>)> {
        let rows = self.rows();
        let mut all = Vec::with_capacity(rows.len() * self.mask.edges().len());
        for (digit, _) in &rows {
            for edge in self.mask.edges() {
                let one = S::from_rational(&Rational::one());
                let minus = S::from_rational(&-Rational::one());
                let ends = BTreeMap::from([(*edge, one), ([0; 3], minus)]);
                all.push((*digit, *edge, self.pulled(&rows, &ends, *digit)));
            }
        }
        all
    }
}
