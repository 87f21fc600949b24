//! The walk over all residue classes of a power of an operator.

use super::power::MAX_LEVELS;
use crate::exact::{Integer, IntegerPolynomial, Rational, Real, common_denominator};
use crate::scheme::Rules;
use crate::stop::check;

/// The operations on numbers that the walk needs.
pub(super) trait Kernel: Clone {
    fn nothing() -> Self;
    fn unit() -> Self;
    /// Whether this is certainly 0, so that its products can be left out. Always `false`
    /// for [`Any`], whose type may round: all types take the same steps.
    fn is_certainly_zero(&self) -> bool {
        false
    }
    /// self += x·y.
    fn accumulate(&mut self, x: &Self, y: &Self);
}

/// A number with an absolute value.
pub(super) trait Magnitude: Kernel {
    /// self += |x|.
    fn accumulate_magnitude(&mut self, x: &Self);
}

impl Kernel for i128 {
    fn nothing() -> i128 {
        0
    }
    fn unit() -> i128 {
        1
    }
    fn is_certainly_zero(&self) -> bool {
        *self == 0
    }
    fn accumulate(&mut self, x: &i128, y: &i128) {
        *self += x * y;
    }
}

impl Magnitude for i128 {
    fn accumulate_magnitude(&mut self, x: &i128) {
        *self += x.abs();
    }
}

impl Kernel for Integer {
    fn nothing() -> Integer {
        Integer::zero()
    }
    fn unit() -> Integer {
        Integer::one()
    }
    fn is_certainly_zero(&self) -> bool {
        self.is_zero()
    }
    fn accumulate(&mut self, x: &Integer, y: &Integer) {
        self.add_product(x, y);
    }
}

impl Magnitude for Integer {
    fn accumulate_magnitude(&mut self, x: &Integer) {
        if x.sign() < 0 {
            *self -= x;
        } else {
            *self += x;
        }
    }
}

/// A number of any type of [`Real`].
#[derive(Clone)]
pub(super) struct Any<S>(pub(super) S);

impl<S: Real> Kernel for Any<S> {
    fn nothing() -> Any<S> {
        Any(S::zero())
    }
    fn unit() -> Any<S> {
        Any(S::from_rational(&Rational::one()))
    }
    fn accumulate(&mut self, Any(x): &Any<S>, Any(y): &Any<S>) {
        self.0 = self.0.plus(&x.times(y));
    }
}

impl<S: Real> Magnitude for Any<S> {
    fn accumulate_magnitude(&mut self, Any(x): &Any<S>) {
        self.0 = self.0.plus(&x.magnitude());
    }
}

impl Kernel for IntegerPolynomial {
    fn nothing() -> IntegerPolynomial {
        IntegerPolynomial::default()
    }
    fn unit() -> IntegerPolynomial {
        IntegerPolynomial::from([1])
    }
    fn is_certainly_zero(&self) -> bool {
        self.is_zero()
    }
    fn accumulate(&mut self, x: &IntegerPolynomial, y: &IntegerPolynomial) {
        if !x.is_zero() {
            *self = &*self + &(x * y);
        }
    }
}

/// One term of a transition: the entry at `from`, times the coefficient, is added to the
/// entry at `to`.
#[derive(Clone, Debug)]
pub(super) struct Edge<T> {
    pub(super) from: usize,
    pub(super) to: usize,
    pub(super) coefficient: T,
}

/// The transitions of a row vector by one level, one list for each digit d.
///
/// A row of Rᵐ is stored as its entries at the positions base, …, base + L − 1. Let d =
/// base mod n and base′ = ⌊base/n⌋ + o. The entry at base + p is multiplied by the
/// coefficients j of rule (d+p) mod n, and added at base′ + ⌊(d+p)/n⌋ + j. As r runs
/// through the residues mod n^c, (d_1, …, d_c) runs through all words, for every offset
/// o.
#[derive(Clone, Debug)]
pub(super) struct Transitions<T> {
    pub(super) length: usize,
    pub(super) edges: Vec<Vec<Edge<T>>>,
}

/// The number L of entries of a row vector that are stored.
fn row_length(arity: usize, width: usize) -> usize {
    let mut length = 1;
    loop {
        let reach = (arity - 1 + length - 1) / arity + width;
        if reach <= length {
            return length;
        }
        length = reach;
    }
}

/// The cost of a visit of all classes, in products of words, for at most
/// [`MAX_CLASSES`](super::MAX_CLASSES) classes.
pub(super) fn price(rules: &Rules, levels: u32) -> u64 {
    let (arity, width) = (rules.arity(), rules.width());
    let denominator = common_denominator(rules.rows().iter().flatten());
    let scaled = |entry: &Rational| (entry.abs() * Rational::from(denominator.clone())).ceil();
    let largest = rules.rows().iter().map(|row| row.iter().map(scaled).sum::<Integer>().bits());
    let words = largest.max().unwrap_or(0).saturating_mul(u64::from(levels)) / 64 + 2;
    steps_of_visit(arity, width, levels).saturating_mul(words)
}

/// The greatest c, at most [`MAX_LEVELS`], for which a visit of all classes of c levels takes at most `work` products of words.
///
/// ```
/// use subcert::bound::levels_within;
/// use subcert::scheme::parse_scheme;
///
/// let levels = |scheme: &str| -> Result<u32, Box<dyn std::error::Error>> {
///     Ok(levels_within(&parse_scheme(scheme)?.masks()[0].difference(), 1 << 20))
/// };
/// assert!(levels("b-spline:degree=100")? < levels("b-spline:degree=3")?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn levels_within(rules: &Rules, work: u64) -> u32 {
    (1..=MAX_LEVELS).take_while(|&levels| price(rules, levels) <= work).last().unwrap_or(0)
}

/// The number of products in a visit of all classes, in any arithmetic.
pub(crate) fn steps_of_visit(arity: usize, width: usize, levels: u32) -> u64 {
    // All levels together have at most twice as many rows as the last level.
    let rows = 2_u64.saturating_mul((arity as u64).saturating_pow(levels));
    rows.saturating_mul((row_length(arity, width) * width) as u64)
}

impl<T: Kernel> Transitions<T> {
    pub(super) fn new(rows: &[Vec<T>]) -> Transitions<T> {
        let (arity, width) = (rows.len(), rows[0].len());
        let length = row_length(arity, width);
        let edges_of = |digit: usize| {
            let mut edges = Vec::new();
            for from in 0..length {
                let (carry, rule) = ((digit + from) / arity, (digit + from) % arity);
                for (column, coefficient) in rows[rule].iter().enumerate() {
                    if !coefficient.is_certainly_zero() {
                        let coefficient = coefficient.clone();
                        edges.push(Edge { from, to: carry + column, coefficient });
                    }
                }
            }
            edges
        };
        Transitions { length, edges: (0..arity).map(edges_of).collect() }
    }

    pub(super) fn advance(&self, digit: usize, from: &[T], to: &mut [T]) {
        to.fill(T::nothing());
        for edge in &self.edges[digit] {
            to[edge.to].accumulate(&from[edge.from], &edge.coefficient);
        }
    }
}

/// Calls `visit` for every residue class mod n^c, with the absolute row sums of the c-th
/// powers of K operators of the same arity and width, and the class.
pub(super) fn walk<T: Magnitude, const K: usize>(
    rows: &[Vec<Vec<T>>; K],
    offset: i64,
    levels: u32,
    visit: &mut impl FnMut(&[T; K], u64),
) {
    walk_rows(rows, offset, levels, &mut |rows: &[Vec<T>; K], class| {
        let norms = rows.each_ref().map(|row| {
            row.iter().fold(T::nothing(), |mut sum, entry| {
                sum.accumulate_magnitude(entry);
                sum
            })
        });
        visit(&norms, class);
    });
}

/// Calls `visit` for every residue class mod n^c, with the rows themselves, including
/// zeros at their ends, and the class.
pub(super) fn walk_rows<T: Kernel, const K: usize>(
    rows: &[Vec<Vec<T>>; K],
    offset: i64,
    levels: u32,
    visit: &mut impl FnMut(&[Vec<T>; K], u64),
) {
    let arity = rows[0].len();
    let transitions = rows.each_ref().map(|rows| Transitions::new(rows));
    let levels = levels as usize;
    let start = transitions.each_ref().map(|transitions| {
        let mut start = vec![T::nothing(); transitions.length];
        start[0] = T::unit();
        start
    });
    // One vector for each level and operator, which is overwritten in every step.
    let mut stack = vec![start; levels + 1];
    let mut digits = vec![0_usize; levels];
    let mut depth = 0;
    loop {
        check();
        while depth < levels {
            let (upper, lower) = stack.split_at_mut(depth + 1);
            let pairs = upper[depth].iter().zip(&mut lower[0]);
            for (transitions, (from, to)) in transitions.iter().zip(pairs) {
                transitions.advance(digits[depth], from, to);
            }
            depth += 1;
        }
        visit(&stack[levels], class_of(&digits, arity, offset));
        loop {
            if depth == 0 {
                return;
            }
            depth -= 1;
            digits[depth] += 1;
            if digits[depth] < arity {
                break;
            }
            digits[depth] = 0;
        }
    }
}

/// The residue class r mod n^c with these digits: base_{m−1} = n·(base_m − o) + d_m, and
/// r = base_0.
fn class_of(digits: &[usize], arity: usize, offset: i64) -> u64 {
    let classes = (arity as i128).pow(u32::try_from(digits.len()).unwrap_or(u32::MAX));
    let class = digits.iter().rev().fold(0_i128, |base, &digit| {
        ((base - i128::from(offset)) * arity as i128 + digit as i128).rem_euclid(classes)
    });
    u64::try_from(class).expect("a residue is not negative")
}
