//! Numbers of the field Q(α) of a real algebraic number α.

use super::{Enclosed, Enclosure, IntegerPolynomial, Rational, RationalPolynomial};
use super::{Real, RealAlgebraic, Scalar, solve};
use std::cmp::Ordering;
use std::sync::{Arc, OnceLock};

/// The field Q(α).
#[derive(Debug)]
struct Field {
    root: RealAlgebraic,
    minimal: IntegerPolynomial,
    /// The first enclosures of α, which take many halvings.
    enclosures: [OnceLock<Enclosure>; 4],
}

impl Field {
    fn enclosure(&self, level: u32) -> Enclosure {
        match self.enclosures.get(level as usize) {
            Some(known) => known.get_or_init(|| self.root.enclosure(level)).clone(),
            None => self.root.enclosure(level),
        }
    }
}

/// A number p(α), p a polynomial over the rationals of lower degree than the minimal polynomial of
/// α.
///
/// Numbers of two different fields must not meet in one operation; a rational number is in all.
///
/// ```
/// use subcert::exact::{FieldElement, IntegerPolynomial, Rational, Real, RealAlgebraic, Scalar};
///
/// let golden = &RealAlgebraic::roots_of(&IntegerPolynomial::from([-1, -1, 1]))[1];
/// let x = FieldElement::generator(golden).expect("a short polynomial");
/// let one = FieldElement::from_rational(&Rational::one());
/// assert_eq!(x.times(&x), x.plus(&one));
/// assert_eq!(one.over(&x), x.minus(&one));
/// ```
#[derive(Clone, Debug)]
pub struct FieldElement {
    value: RationalPolynomial,
    /// `None` of a rational number that has met no other.
    field: Option<Arc<Field>>,
}

impl FieldElement {
    /// α as a number of Q(α); `None` where the minimal polynomial is out of reach, as of
    /// [`RealAlgebraic::minimal_polynomial`].
    #[must_use]
    pub fn generator(root: &RealAlgebraic) -> Option<FieldElement> {
        if let Some(value) = root.as_rational() {
            return Some(FieldElement::from_rational(value));
        }
        let minimal = root.minimal_polynomial()?;
        let field =
            Some(Arc::new(Field { root: root.clone(), minimal, enclosures: Default::default() }));
        Some(FieldElement { value: RationalPolynomial::variable(), field })
    }

    /// −1, 0 or 1.
    ///
    /// # Panics
    /// Never.
    #[must_use]
    pub fn sign(&self) -> i8 {
        if let Some(value) = self.value.as_constant() {
            return value.sign();
        }
        // p(α) is not 0, as p has a lower degree than the minimal polynomial.
        (0..).find_map(|level| self.enclosure(level).sign()).expect("a number other than 0")
    }

    fn of(value: RationalPolynomial, field: Option<&Arc<Field>>) -> FieldElement {
        FieldElement { value, field: field.cloned() }
    }

    fn field<'a>(&'a self, other: &'a FieldElement) -> Option<&'a Arc<Field>> {
        self.field.as_ref().or(other.field.as_ref())
    }

    /// 1/self. Its coefficients solve the linear system q·p = 1 modulo the minimal polynomial.
    fn reciprocal(&self) -> FieldElement {
        if let Some(value) = self.value.as_constant() {
            return FieldElement::of(
                RationalPolynomial::constant(value.recip()),
                self.field.as_ref(),
            );
        }
        let field = self.field.as_ref().expect("an irrational number");
        let degree = field.minimal.degree().expect("an irreducible polynomial");
        let mut columns = Vec::with_capacity(degree);
        let mut power = self.value.clone();
        for _ in 0..degree {
            let mut column = power.coefficients();
            column.resize(degree, Rational::zero());
            columns.push(column);
            power = power.times(&RationalPolynomial::variable()).modulo(&field.minimal);
        }
        let row = |i: usize| {
            let unit = if i == 0 { Rational::one() } else { Rational::zero() };
            columns.iter().map(|column| column[i].clone()).chain([unit]).collect()
        };
        let rows: Vec<Vec<Rational>> = (0..degree).map(row).collect();
        let solution = solve(&rows).expect("a number other than 0 has an inverse");
        FieldElement::of(RationalPolynomial::new(&solution), Some(field))
    }
}

impl PartialEq for FieldElement {
    fn eq(&self, other: &FieldElement) -> bool {
        self.value == other.value
    }
}

impl Eq for FieldElement {}

impl PartialOrd for FieldElement {
    fn partial_cmp(&self, other: &FieldElement) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for FieldElement {
    fn cmp(&self, other: &FieldElement) -> Ordering {
        self.minus(other).sign().cmp(&0)
    }
}

impl Scalar for FieldElement {
    fn from_rational(value: &Rational) -> Self {
        FieldElement { value: RationalPolynomial::constant(value.clone()), field: None }
    }
    fn plus(&self, other: &Self) -> Self {
        FieldElement::of(self.value.plus(&other.value), self.field(other))
    }
    fn minus(&self, other: &Self) -> Self {
        FieldElement::of(self.value.minus(&other.value), self.field(other))
    }
    fn times(&self, other: &Self) -> Self {
        let product = self.value.times(&other.value);
        let field = self.field(other);
        let value = field.map_or_else(|| product.clone(), |field| product.modulo(&field.minimal));
        FieldElement::of(value, field)
    }
}

impl Real for FieldElement {
    fn magnitude(&self) -> Self {
        if self.sign() < 0 {
            FieldElement::of(self.value.negated(), self.field.as_ref())
        } else {
            self.clone()
        }
    }
    fn greater(&self, other: &Self) -> Self {
        if self < other { other.clone() } else { self.clone() }
    }
    fn over(&self, other: &Self) -> Self {
        self.times(&other.reciprocal())
    }
}

impl Enclosed for FieldElement {
    /// By Horner's rule on the enclosure of α.
    fn enclosure(&self, level: u32) -> Enclosure {
        let constant = |value: Rational| Enclosure::exact(value);
        match (self.value.as_constant(), &self.field) {
            (Some(value), _) => constant(value),
            (None, None) => unreachable!("a polynomial in α knows its field"),
            (None, Some(field)) => {
                let at = field.enclosure(level);
                let coefficients = self.value.coefficients();
                let start = constant(Rational::zero());
                let terms = coefficients.into_iter().rev();
                terms.fold(start, |value, c| &(&value * &at) + &constant(c))
            }
        }
    }
}
