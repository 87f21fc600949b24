//! Linear functionals of sequences, with finitely many coefficients.

use crate::exact::Rational;
use crate::scheme::Rules;
use std::collections::BTreeMap;

/// A linear functional y ↦ Σ_i c_i y_i of sequences (y_i) indexed by the integers, with
/// finitely many c_i ≠ 0.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::limit::Functional;
///
/// // (y_{−1} + 4y_0 + y_1)/6 − y_0 is (Δ_0 − Δ_{−1})/6, where Δ_i = y_{i+1} − y_i.
/// let sixth = |p| Rational::new(p, 6);
/// let functional = Functional::new(-1, [sixth(1), sixth(-2), sixth(1)]);
/// let differences = functional.on_differences().ok_or("its coefficients sum to 0")?;
/// assert_eq!(differences, Functional::new(-1, [sixth(-1), sixth(1)]));
/// assert_eq!(differences.norm(), Rational::new(1, 3));
/// # Ok::<(), &str>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Functional {
    /// The nonzero c_i.
    coefficients: BTreeMap<i64, Rational>,
}

impl Functional {
    /// y ↦ Σ_j c_j y_{first+j}.
    #[must_use]
    pub fn new(first: i64, coefficients: impl IntoIterator<Item = Rational>) -> Functional {
        (first..).zip(coefficients).collect()
    }

    /// y ↦ y_i.
    #[must_use]
    pub fn point(i: i64) -> Functional {
        Functional::new(i, [Rational::one()])
    }

    /// y ↦ (1 − s) y_i + s y_{i+1} for u = i + s, 0 ≤ s < 1: the value at u of the piecewise
    /// linear interpolant of y.
    pub(super) fn on_line(u: &Rational) -> Functional {
        let part = u.fract();
        let index = u.floor().to_i64().expect("shifts are capped with the offsets");
        Functional::new(index, [Rational::one() - &part, part])
    }

    /// The pairs (i, c_i) with c_i ≠ 0, in the order of i.
    #[must_use]
    pub fn terms(&self) -> impl DoubleEndedIterator<Item = (i64, &Rational)> {
        self.coefficients.iter().map(|(i, c)| (*i, c))
    }

    /// c_i.
    #[must_use]
    pub fn coefficient(&self, i: i64) -> Rational {
        self.coefficients.get(&i).cloned().unwrap_or_else(Rational::zero)
    }

    /// The least and the greatest i with c_i ≠ 0.
    #[must_use]
    pub fn support(&self) -> Option<(i64, i64)> {
        Some((*self.coefficients.first_key_value()?.0, *self.coefficients.last_key_value()?.0))
    }

    /// Σ_i |c_i|: the greatest value on sequences with |y_i| ≤ 1.
    #[must_use]
    pub fn norm(&self) -> Rational {
        self.coefficients.values().map(Rational::abs).sum()
    }

    /// The value at the sequence y.
    #[must_use]
    pub fn apply(&self, y: impl Fn(i64) -> Rational) -> Rational {
        self.terms().map(|(i, c)| c * y(i)).sum()
    }

    /// y ↦ Σ_i c_i y_{i+by}.
    #[must_use]
    pub fn shifted(&self, by: i64) -> Functional {
        self.terms().map(|(i, c)| (i + by, c.clone())).collect()
    }

    /// self + factor·other.
    #[must_use]
    pub fn plus(&self, factor: &Rational, other: &Functional) -> Functional {
        let own = self.terms().map(|(i, c)| (i, c.clone()));
        own.chain(other.terms().map(|(i, c)| (i, factor * c))).collect()
    }

    /// The functional x ↦ self(y), where y_{ni+α} = Σ_j r_{α,j} x_{i+o+j}.
    #[must_use]
    pub fn after(&self, rules: &Rules) -> Functional {
        self.terms()
            .flat_map(|(i, c)| rule_at(rules, i).map(move |(column, r)| (column, c * r)))
            .collect()
    }

    /// This functional, written as a functional of the differences Δ_i = y_{i+1} − y_i,
    /// with the coefficients Σ_{h>i} c_h. `None` unless Σ_i c_i = 0.
    #[must_use]
    pub fn on_differences(&self) -> Option<Functional> {
        let Some((first, last)) = self.support() else { return Some(self.clone()) };
        let mut rest = Rational::zero();
        let tails = (first..=last).rev().map(|i| {
            rest += &self.coefficient(i);
            (i - 1, rest.clone())
        });
        let differences: Functional = tails.collect();
        // The coefficient of Δ_{first−1} is Σ_i c_i.
        differences.coefficient(first - 1).is_zero().then_some(differences)
    }

    /// For a functional of differences, the polygon with Δ_i = ±1 at which it
    /// attains its [`norm`](Functional::norm): Δ_i = −1 where c_i < 0, else 1.
    #[must_use]
    pub fn extremal_polygon(&self) -> ExtremalPolygon {
        let (first, last) = self.support().unwrap_or((0, -1));
        let mut points = vec![0];
        let mut point = 0;
        for i in first..=last {
            point += if self.coefficient(i).sign() < 0 { -1 } else { 1 };
            points.push(point);
        }
        ExtremalPolygon { first, points }
    }
}

impl FromIterator<(i64, Rational)> for Functional {
    /// The sum of the functionals y ↦ c·y_i.
    fn from_iter<I: IntoIterator<Item = (i64, Rational)>>(terms: I) -> Functional {
        let mut coefficients = BTreeMap::new();
        for (i, c) in terms {
            *coefficients.entry(i).or_insert_with(Rational::zero) += &c;
        }
        coefficients.retain(|_, c| !c.is_zero());
        Functional { coefficients }
    }
}

/// A piece x_first, x_{first+1}, … of a control polygon of integers. The functional for
/// which it is extremal depends on these points only, so the polygon may be continued in
/// any way.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ExtremalPolygon {
    /// The index of the first point.
    pub first: i64,
    /// The points; the first one is 0.
    pub points: Vec<i64>,
}

/// Row i of the operator of these rules: the pairs (m, r) with y_i = Σ r x_m.
///
/// # Panics
/// Never: the arity is capped.
pub fn rule_at(rules: &Rules, i: i64) -> impl Iterator<Item = (i64, &Rational)> {
    let arity = i64::try_from(rules.arity()).expect("the arity is capped");
    let rule = usize::try_from(i.rem_euclid(arity)).expect("a residue is not negative");
    (i.div_euclid(arity) + rules.offset()..).zip(&rules.rows()[rule])
}
