//! The number type: constructors and accessors.

use super::error::{MAX_ROOT_DEGREE, RootError};
use super::isolated::{Found, Isolated, trimmed};
use super::size::Size;
use super::square::square_part;
use crate::exact::{
    CosineError, Enclosure, Integer, Rational, Real, RealCyclotomic, Scalar, common_conductor,
    format::short,
};
use std::sync::{Arc, OnceLock};

/// A real number given by an expression: numbers of the fields Q(2cos(2π/n)), the four operations,
/// square roots, and roots of polynomials with coefficients in such a field.
///
/// Equality, order and sign are exact. Enclosures decide almost every comparison. Where two numbers are
/// equal, that follows from a bound: a difference other than 0 of numbers of these sizes cannot be
/// smaller (see `proofs/THEOREMS.md`).
///
/// An operation on numbers of the fields Q(2cos(2π/n)) whose common field is within the cap is done in
/// that field, so that such numbers stay what they are.
///
/// ```
/// use subcert::exact::{Rational, Real, RealCyclotomic, RealExpression, Scalar, format::fixed};
///
/// // The subdominant eigenvalue of Catmull–Clark at valence 5: (c + 5 + √((c + 9)(c + 1)))/16.
/// let number = |value: i64| RealExpression::from(RealCyclotomic::from(value));
/// let c = RealExpression::from(RealCyclotomic::cosine(&Rational::new(1, 5))?);
/// let root = c.plus(&number(9)).times(&c.plus(&number(1))).sqrt()?;
/// let eigenvalue = c.plus(&number(5)).plus(&root).over(&number(16));
/// assert_eq!(fixed(&eigenvalue, 12), "0.549988354518");
///
/// // √2·√3 = √6, though no term of the expressions is the same.
/// let root = |n: i64| number(n).sqrt().expect("a positive number");
/// assert_eq!(root(2).times(&root(3)), root(6));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone)]
pub struct RealExpression(pub(super) Arc<Node>);

/// A number, and what is known of it.
pub(super) struct Node {
    pub(super) operation: Operation,
    pub(super) size: Size,
    pub(super) field: Field,
    /// The first enclosures.
    pub(super) enclosures: [OnceLock<Enclosure>; 4],
    /// Whether the number is rational.
    pub(super) rational: OnceLock<Option<Rational>>,
}

/// How a number is made.
pub(super) enum Operation {
    Number(RealCyclotomic),
    Sum(RealExpression, RealExpression),
    Difference(RealExpression, RealExpression),
    Product(RealExpression, RealExpression),
    Quotient(RealExpression, RealExpression),
    Root(Arc<Generator>),
}

/// A root that is adjoined.
pub(super) enum Generator {
    /// Of a positive number.
    Square(RealExpression),
    Isolated(Isolated),
}

impl Generator {
    fn degree(&self) -> u64 {
        match self {
            Generator::Square(_) => 2,
            Generator::Isolated(root) => root.given.len() as u64 - 1,
        }
    }

    /// Whether the other is made in the same way from the same numbers.
    pub(super) fn same(&self, other: &Generator) -> bool {
        match (self, other) {
            (Generator::Square(a), Generator::Square(b)) => match (a.as_number(), b.as_number()) {
                (Some(a), Some(b)) => a == b,
                _ => Arc::ptr_eq(&a.0, &b.0),
            },
            (Generator::Isolated(a), Generator::Isolated(b)) => {
                a.index == b.index && a.given == b.given
            }
            _ => false,
        }
    }
}

/// The field that a number is known to be in: that of 2cos(2π/n) with these roots adjoined.
#[derive(Clone)]
pub(super) struct Field {
    pub(super) conductor: u64,
    /// Each after those that its radicand needs.
    pub(super) generators: Vec<Arc<Generator>>,
}

impl Field {
    fn cyclotomic(conductor: u64) -> Field {
        Field { conductor, generators: Vec::new() }
    }

    fn with(&self, other: &Field) -> Field {
        let mut joined = self.clone();
        joined.conductor = joined
            .conductor
            .checked_mul(other.conductor / num_integer::gcd(self.conductor, other.conductor))
            .unwrap_or(u64::MAX);
        other.generators.iter().for_each(|generator| joined.adjoin(generator));
        joined
    }

    fn adjoin(&mut self, generator: &Arc<Generator>) {
        let known = |one: &Arc<Generator>| Arc::ptr_eq(one, generator) || one.same(generator);
        if !self.generators.iter().any(known) {
            self.generators.push(Arc::clone(generator));
        }
    }

    /// A bound of the degree over Q: that of Q(2cos(2π/n)) is at most n/2, or 1.
    pub(super) fn degree(&self) -> u64 {
        let roots = self.generators.iter().map(|generator| generator.degree());
        roots.fold((self.conductor / 2).max(1), u64::saturating_mul)
    }
}

impl From<RealCyclotomic> for RealExpression {
    fn from(value: RealCyclotomic) -> RealExpression {
        let (bound, denominator) = value.conjugate_bound();
        let size = Size::of(&bound, denominator);
        let field = Field::cyclotomic(u64::from(value.conductor()));
        RealExpression::node(Operation::Number(value), size, field)
    }
}

impl From<Rational> for RealExpression {
    fn from(value: Rational) -> RealExpression {
        RealExpression::from(RealCyclotomic::from(value))
    }
}

impl RealExpression {
    fn node(operation: Operation, size: Size, field: Field) -> RealExpression {
        let (enclosures, rational) = Default::default();
        RealExpression(Arc::new(Node { operation, size, field, enclosures, rational }))
    }

    /// This, if it is written as a number of a field Q(2cos(2π/n)).
    #[must_use]
    pub fn as_number(&self) -> Option<&RealCyclotomic> {
        match &self.0.operation {
            Operation::Number(value) => Some(value),
            _ => None,
        }
    }

    /// A bound of the degree of this number over Q.
    #[must_use]
    pub fn degree_bound(&self) -> u64 {
        self.0.field.degree()
    }

    /// √self.
    ///
    /// # Errors
    /// When this is negative.
    ///
    /// ```
    /// use subcert::exact::{Rational, RealExpression};
    ///
    /// let root = RealExpression::from(Rational::new(12, 25)).sqrt()?;
    /// assert_eq!(root.to_string(), "2/5*sqrt(3)");
    /// assert!(RealExpression::from(Rational::from(-2)).sqrt().is_err());
    /// # Ok::<(), subcert::exact::RootError>(())
    /// ```
    pub fn sqrt(&self) -> Result<RealExpression, RootError> {
        match self.sign() {
            0 => return Ok(RealExpression::from(Rational::zero())),
            1 => {}
            _ => {
                let (value, decimal) = (self.to_string(), short(self, 6));
                return Err(RootError::Negative { value, decimal });
            }
        }
        let Some(value) = self.as_number() else { return Ok(self.root_of_positive()) };
        let (factor, rest) = RealExpression::root_parts(value);
        if rest == RealCyclotomic::from(1) {
            return Ok(RealExpression::from(factor));
        }
        let root = RealExpression::from(rest).root_of_positive();
        Ok(RealExpression::from(factor).times(&root))
    }

    /// A rational s and y with √x = s√y, for x > 0: √(c·z) = s√(t·z) for the content c = s²t of x = c·z.
    /// y = 1 for the square of a rational.
    pub(crate) fn root_parts(value: &RealCyclotomic) -> (Rational, RealCyclotomic) {
        let content = value.content();
        let (s, t) = square_part(&content);
        let rest = value.over(&content.into()).times(&RealCyclotomic::from(Rational::from(t)));
        (s, rest)
    }

    /// √self as a new number.
    fn root_of_positive(&self) -> RealExpression {
        let mut field = self.0.field.clone();
        let generator = Arc::new(Generator::Square(self.clone()));
        field.adjoin(&generator);
        RealExpression::node(Operation::Root(generator), self.0.size.square_root(), field)
    }

    /// The real root number `index` of Σ c_k x^k, for coefficients c_0, c_1, … The distinct real roots
    /// are numbered in ascending order, from 1.
    ///
    /// # Errors
    /// When the polynomial is a constant, its degree is above [`MAX_ROOT_DEGREE`], or it has no such root.
    ///
    /// # Panics
    /// When the coefficients have no [`common_conductor`].
    ///
    /// ```
    /// use subcert::exact::{RealCyclotomic, RealExpression, format::fixed};
    ///
    /// // x³ − 3x + 1 has the roots 2cos 160°, 2cos 80° and 2cos 40°.
    /// let polynomial = [1, -3, 0, 1].map(RealCyclotomic::from);
    /// let root = RealExpression::root(&polynomial, 2)?;
    /// assert_eq!(fixed(&root, 8), "0.34729636");
    /// assert_eq!(root.to_string(), "root([1, -3, 0, 1], 2)");
    /// assert!(RealExpression::root(&polynomial, 4).is_err());
    /// # Ok::<(), subcert::exact::RootError>(())
    /// ```
    pub fn root(
        coefficients: &[RealCyclotomic],
        index: usize,
    ) -> Result<RealExpression, RootError> {
        let given = trimmed(coefficients.to_vec());
        let degree = given.len().saturating_sub(1);
        if degree == 0 {
            return Err(RootError::Constant);
        }
        if degree > MAX_ROOT_DEGREE {
            return Err(RootError::Degree(degree));
        }
        if degree == 1 && index == 1 {
            return Ok(RealExpression::from(-&given[0].over(&given[1])));
        }
        let root = match Isolated::find(given, index) {
            Found::Missing(count) => return Err(RootError::Index { index, count }),
            Found::Rational(value) => return Ok(RealExpression::from(value)),
            Found::Irrational(root) => root,
        };
        let bounds = integral_bounds(&root.given);
        let conductor = root.given.iter().fold(1, |n, c| num_integer::lcm(n, c.conductor()));
        let mut field = Field::cyclotomic(u64::from(conductor));
        let generator = Arc::new(Generator::Isolated(root));
        field.adjoin(&generator);
        Ok(RealExpression::node(Operation::Root(generator), Size::root(&bounds), field))
    }

    /// The number in one field Q(2cos(2π/n)), if both are in one within the cap.
    fn in_field(
        &self,
        other: &RealExpression,
        operate: impl FnOnce(&RealCyclotomic, &RealCyclotomic) -> RealCyclotomic,
    ) -> Option<RealExpression> {
        let (a, b) = (self.as_number()?, other.as_number()?);
        let fits: Result<u32, CosineError> = common_conductor(a.conductor(), b.conductor());
        fits.ok().map(|_| RealExpression::from(operate(a, b)))
    }

    fn is(&self, value: i64) -> bool {
        let number = self.as_number().and_then(RealCyclotomic::as_rational);
        number.is_some_and(|number| *number == Rational::from(value))
    }

    fn radicand(&self) -> Option<&RealExpression> {
        match &self.0.operation {
            Operation::Root(generator) => match &**generator {
                Generator::Square(radicand) => Some(radicand),
                Generator::Isolated(_) => None,
            },
            _ => None,
        }
    }

    /// self·other, written as a product also where both are in one field Q(2cos(2π/n)): the product of two
    /// sums of cosines may be a much longer sum.
    #[must_use]
    pub fn times_apart(&self, other: &RealExpression) -> RealExpression {
        let plain = |one: &RealExpression| {
            one.as_number().is_none_or(|number| number.as_rational().is_some())
        };
        if plain(self) || plain(other) {
            return self.times(other);
        }
        let size = self.0.size.times(&other.0.size);
        self.joined(other, Operation::Product(self.clone(), other.clone()), size)
    }

    fn joined(&self, other: &RealExpression, operation: Operation, size: Size) -> RealExpression {
        RealExpression::node(operation, size, self.0.field.with(&other.0.field))
    }
}

/// Bounds of the conjugates of q c_0, …, q c_d, for a common denominator q.
fn integral_bounds(coefficients: &[RealCyclotomic]) -> Vec<Integer> {
    let bounds: Vec<(Integer, Integer)> =
        coefficients.iter().map(RealCyclotomic::conjugate_bound).collect();
    let common = bounds.iter().fold(Integer::one(), |common, (_, q)| common.lcm(q));
    bounds.iter().map(|(bound, q)| bound * common.div_floor(q)).collect()
}

impl Scalar for RealExpression {
    fn from_rational(value: &Rational) -> Self {
        RealExpression::from(value.clone())
    }
    fn plus(&self, other: &Self) -> Self {
        if self.is(0) {
            return other.clone();
        }
        if other.is(0) {
            return self.clone();
        }
        self.in_field(other, |a, b| a + b).unwrap_or_else(|| {
            let size = self.0.size.plus(&other.0.size);
            self.joined(other, Operation::Sum(self.clone(), other.clone()), size)
        })
    }
    fn minus(&self, other: &Self) -> Self {
        if other.is(0) {
            return self.clone();
        }
        self.in_field(other, |a, b| a - b).unwrap_or_else(|| {
            let size = self.0.size.plus(&other.0.size);
            self.joined(other, Operation::Difference(self.clone(), other.clone()), size)
        })
    }
    fn times(&self, other: &Self) -> Self {
        if self.is(0) || other.is(1) {
            return self.clone();
        }
        if other.is(0) || self.is(1) {
            return other.clone();
        }
        if let Some(radicand) = self.radicand().filter(|_| Arc::ptr_eq(&self.0, &other.0)) {
            return radicand.clone();
        }
        self.in_field(other, |a, b| a * b).unwrap_or_else(|| {
            let size = self.0.size.times(&other.0.size);
            self.joined(other, Operation::Product(self.clone(), other.clone()), size)
        })
    }
}

impl Real for RealExpression {
    fn magnitude(&self) -> Self {
        if self.sign() < 0 { RealExpression::zero().minus(self) } else { self.clone() }
    }
    fn greater(&self, other: &Self) -> Self {
        if self < other { other.clone() } else { self.clone() }
    }
    /// # Panics
    /// When `other` is 0.
    fn over(&self, other: &Self) -> Self {
        assert_ne!(other.sign(), 0, "division by zero");
        if other.is(1) {
            return self.clone();
        }
        self.in_field(other, |a, b| a / b).unwrap_or_else(|| {
            let size = self.0.size.over(&other.0.size);
            self.joined(other, Operation::Quotient(self.clone(), other.clone()), size)
        })
    }
}
