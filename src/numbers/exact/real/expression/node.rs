//! The number type, and the field that a number is known to be in.

use super::isolated::Isolated;
use super::size::Size;
use crate::exact::{Enclosure, Rational, RealCyclotomic};
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
    /// How many operations and roots are nested in it.
    depth: u32,
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

impl Operation {
    fn depth(&self) -> u32 {
        let inner = match self {
            Operation::Number(_) => return 0,
            Operation::Sum(a, b)
            | Operation::Difference(a, b)
            | Operation::Product(a, b)
            | Operation::Quotient(a, b) => a.depth().max(b.depth()),
            Operation::Root(generator) => match &**generator {
                Generator::Square(radicand) => radicand.depth(),
                Generator::Isolated(_) => 0,
            },
        };
        inner.saturating_add(1)
    }
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
    pub(super) fn cyclotomic(conductor: u64) -> Field {
        Field { conductor, generators: Vec::new() }
    }

    pub(super) fn with(&self, other: &Field) -> Field {
        let mut joined = self.clone();
        let factor = other.conductor / num_integer::gcd(self.conductor, other.conductor);
        joined.conductor = joined.conductor.saturating_mul(factor);
        other.generators.iter().for_each(|generator| joined.adjoin(generator));
        joined
    }

    pub(super) fn adjoin(&mut self, generator: &Arc<Generator>) {
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
    pub(super) fn node(operation: Operation, size: Size, field: Field) -> RealExpression {
        let (enclosures, rational) = Default::default();
        let depth = operation.depth();
        RealExpression(Arc::new(Node { operation, size, field, depth, enclosures, rational }))
    }

    /// How many operations and roots are nested in this expression: 0 for a number of a field Q(2cos(2π/n)).
    #[must_use]
    pub fn depth(&self) -> u32 {
        self.0.depth
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
}
