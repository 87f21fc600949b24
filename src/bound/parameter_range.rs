//! Where in a parameter a contraction constant is below 1.

use super::power::{Order, oriented};
use super::walk::walk_rows;
use crate::exact::{
    Integer, IntegerPolynomial, IntervalSet, PiecewisePolynomial, Polynomial, Rational,
    RationalPolynomial, RealAlgebraic, SturmSequence,
};
use crate::scheme::Rules;
use std::collections::{BTreeMap, BTreeSet, HashSet};

/// The most work of one norm as a function of a parameter: n^c·N·(cd)², for masks of
/// degree d in it.
pub const MAX_RANGE_WORK: u64 = 1 << 19;

/// Why there is no range of a parameter.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum RangeError {
    /// A coefficient that is no rational polynomial in the parameter.
    #[error(
        "the coefficient {coefficient} of rule {rule} is no polynomial in `{parameter}` with \
         rational coefficients; only such masks have their ranges computed"
    )]
    NotPolynomial {
        /// The coefficient.
        coefficient: String,
        /// Its rule, counted from 0.
        rule: usize,
        /// The parameter.
        parameter: String,
    },
    /// The work is beyond [`MAX_RANGE_WORK`].
    #[error(
        "{arity}^{levels} residue classes with rules of {width} coefficients and degree {degree} \
         in the parameter are too many: their number, times {width}*{degree}^2, may be at most \
         {MAX_RANGE_WORK}; take a smaller number of levels"
    )]
    Work {
        /// n.
        arity: usize,
        /// c.
        levels: u32,
        /// N.
        width: usize,
        /// cd.
        degree: usize,
    },
}

/// Rules with coefficients in one parameter, as polynomials in it.
///
/// # Errors
/// When a coefficient is none.
pub fn polynomial_rules(
    rules: &Rules<Polynomial>,
    parameter: &str,
) -> Result<Rules<RationalPolynomial>, RangeError> {
    for (rule, row) in rules.rows().iter().enumerate() {
        if let Some(coefficient) = row.iter().find(|entry| entry.in_variable(parameter).is_none()) {
            let (coefficient, parameter) = (coefficient.to_string(), parameter.to_owned());
            return Err(RangeError::NotPolynomial { coefficient, rule, parameter });
        }
    }
    let zero = || RationalPolynomial::constant(Rational::zero());
    Ok(rules.map(|entry| entry.in_variable(parameter).unwrap_or_else(zero)))
}

/// T_c < 1 as a condition on a parameter, for c = 1, 2, ….
#[derive(Clone, Debug, PartialEq)]
pub struct ParameterRange {
    /// The sets of the parameters with T_c < 1, from c = 1.
    pub levels: Vec<IntervalSet>,
    /// Their union: there the scheme converges.
    pub union: IntervalSet,
}

impl ParameterRange {
    /// The sets for c = 1, …, `levels` of these difference rules.
    ///
    /// Since T_{cd} ≤ T_c^d, the set of c is a part of that of cd; sets of other
    /// levels need not contain each other.
    ///
    /// # Errors
    /// When the work is beyond [`MAX_RANGE_WORK`].
    ///
    /// ```
    /// use subcert::bound::{ParameterRange, polynomial_rules};
    /// use subcert::scheme::parse_parametric;
    ///
    /// let mask = parse_parametric("four-point", "w")?;
    /// let range = ParameterRange::new(&polynomial_rules(&mask.difference(), "w")?, 2)?;
    /// assert_eq!(range.levels[0].describe("w"), "-1/4 < w < 1/4");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(
        difference: &Rules<RationalPolynomial>,
        levels: u32,
    ) -> Result<ParameterRange, RangeError> {
        check(difference, levels)?;
        let one = Rational::one();
        let set = |c| norm_below(difference, c, Order::Adjoint, &one);
        let levels = (1..=levels).map(set).collect::<Result<Vec<IntervalSet>, RangeError>>()?;
        let union = levels.iter().fold(IntervalSet::default(), |union, set| union.union(set));
        Ok(ParameterRange { levels, union })
    }
}

/// The set of the parameters at which ‖Rᶜ‖_∞ < `limit`, the norm of
/// [`power_norm`](super::power_norm).
///
/// The norm is the greatest of the sums Σ_s ε_s (Rᶜ)_{r,s} with signs ε_s, and it is so
/// over those signs alone that occur in the set: of each, a polynomial, the set is cut
/// by the parameters at which it is below the limit. No maximum is formed.
/// `proofs/THEOREMS.md`, 50.
///
/// # Errors
/// When the work is beyond [`MAX_RANGE_WORK`].
pub fn norm_below(
    rules: &Rules<RationalPolynomial>,
    levels: u32,
    order: Order,
    limit: &Rational,
) -> Result<IntervalSet, RangeError> {
    let mut set = IntervalSet::everything();
    // sum/q < limit as sum·b − a·q < 0, for the limit a/b.
    let factor = IntegerPolynomial::new(vec![limit.denominator()]);
    let mut seen = HashSet::new();
    for [row] in distinct_rows([rules], levels, order)? {
        let most = IntegerPolynomial::new(vec![limit.numerator() * &row.denominator]);
        for sum in signed_sums(&row.terms, &set) {
            let excess = &(&sum * &factor) - &most;
            if !set.is_empty() && seen.insert(excess.clone()) {
                set = cut(set, &excess);
            }
        }
    }
    Ok(set)
}

/// The part of a set where a polynomial is negative.
fn cut(set: IntervalSet, excess: &IntegerPolynomial) -> IntervalSet {
    let settled = set.hull().is_some_and(|(low, high)| {
        excess.sign_at(&low) < 0 && !excess.may_vanish_between(&low, &high)
    });
    if settled {
        return set;
    }
    let negative = RationalPolynomial::over(excess, &Integer::one());
    let negative = PiecewisePolynomial::from(negative).below(&Rational::zero());
    set.intersection(&negative)
}

/// Σ_j ε_j p_j for the signs ε_j of the p_j that occur between the ends of a set.
fn signed_sums(row: &[IntegerPolynomial], set: &IntervalSet) -> Vec<IntegerPolynomial> {
    let (low, high) = set.hull().unzip();
    let roots = row.iter().filter(|p| p.degree().unwrap_or(0) > 0).flat_map(|p| {
        let away = match (&low, &high) {
            (Some(low), Some(high)) => !p.may_vanish_between(low, high),
            _ => false,
        };
        if away {
            return Vec::new();
        }
        SturmSequence::new(p).roots_between(low.clone(), high.clone())
    });
    let ends = low.iter().chain(&high).cloned().map(RealAlgebraic::from);
    let points: BTreeSet<RealAlgebraic> = roots.chain(ends).collect();
    let points: Vec<RealAlgebraic> = points.into_iter().collect();
    let sum = |x: &Rational| {
        row.iter().fold(IntegerPolynomial::default(), |sum, p| {
            if p.sign_at(x) < 0 { &sum - p } else { &sum + p }
        })
    };
    // Beyond the ends of a bounded set no signs are needed.
    match (&low, &points[..]) {
        (Some(only), [_]) => vec![sum(only)],
        (Some(_), points) => {
            points.windows(2).map(|pair| sum(&pair[0].rational_below(&pair[1]))).collect()
        }
        (None, points) => RealAlgebraic::rationals_between(points).iter().map(sum).collect(),
    }
}

/// ‖Rᶜ‖_∞ as a function of the parameter.
///
/// # Errors
/// When the work is beyond [`MAX_RANGE_WORK`].
pub fn norm_function(
    rules: &Rules<RationalPolynomial>,
    levels: u32,
    order: Order,
) -> Result<PiecewisePolynomial, RangeError> {
    let rows = distinct_rows([rules], levels, order)?;
    Ok(greatest(rows.iter().map(|[row]| row.function(None)).collect(), None))
}

/// A function that is ‖Rᶜ‖_∞ from `low` to `high`, at less cost where these are near
/// each other.
///
/// # Errors
/// When the work is beyond [`MAX_RANGE_WORK`].
pub fn norm_function_on(
    rules: &Rules<RationalPolynomial>,
    levels: u32,
    order: Order,
    window: &(Rational, Rational),
) -> Result<PiecewisePolynomial, RangeError> {
    let rows = distinct_rows([rules], levels, order)?;
    Ok(greatest(rows.iter().map(|[row]| row.function(Some(window))).collect(), Some(window)))
}

/// A function that is the value of [`joint_norm`](super::joint_norm) from `low` to
/// `high`.
///
/// # Errors
/// When the work is beyond [`MAX_RANGE_WORK`].
///
/// # Panics
/// When arity or width differ.
pub fn joint_norm_function_on(
    rules: [&Rules<RationalPolynomial>; 2],
    levels: u32,
    order: Order,
    window: &(Rational, Rational),
) -> Result<PiecewisePolynomial, RangeError> {
    let [first, second] = rules;
    assert_eq!(first.arity(), second.arity(), "joint suprema need equal arities");
    assert_eq!(first.width(), second.width(), "joint suprema need equal widths");
    let rows = distinct_rows([first, second], levels, order)?;
    let product = |[first, second]: &[Row; 2]| {
        first.function(Some(window)).times(&second.function(Some(window)))
    };
    Ok(greatest(rows.iter().map(product).collect(), Some(window)))
}

/// The greatest of functions; from `low` to `high`, where these are given.
fn greatest(
    mut functions: Vec<PiecewisePolynomial>,
    window: Option<&(Rational, Rational)>,
) -> PiecewisePolynomial {
    if let Some((low, high)) = window {
        let middle = (low + high) / Rational::from(2);
        let champion = functions.iter().max_by_key(|function| function.at(&middle)).cloned();
        // What is below one of them everywhere there is left out.
        let below = |function: &PiecewisePolynomial| match (&champion, function.pieces()) {
            (Some(champion), [piece]) if champion.piece_count() == 1 => {
                let ahead = champion.pieces()[0].minus(piece);
                ahead.sign_at(low) > 0 && !ahead.numerator().may_vanish_between(low, high)
            }
            _ => false,
        };
        functions.retain(|function| !below(function));
        functions.sort_by_cached_key(PiecewisePolynomial::to_string);
        functions.dedup();
    }
    // In pairs, so that the functions compared are of like size.
    while functions.len() > 1 {
        let greater = |pair: &[PiecewisePolynomial]| match pair {
            [first, second] => first.greater(second),
            _ => pair[0].clone(),
        };
        functions = functions.chunks(2).map(greater).collect();
    }
    functions.pop().unwrap_or_else(|| PiecewisePolynomial::constant(Rational::zero()))
}

fn check(rules: &Rules<RationalPolynomial>, levels: u32) -> Result<(), RangeError> {
    let (arity, width) = (rules.arity(), rules.width());
    let degrees = rules.rows().iter().flatten().filter_map(RationalPolynomial::degree);
    let degree = degrees.max().unwrap_or(0).max(1) * levels as usize;
    let work = (arity as u64)
        .checked_pow(levels)
        .and_then(|classes| classes.checked_mul(width as u64)?.checked_mul(degree as u64))
        .and_then(|work| work.checked_mul(degree as u64));
    match work.filter(|&work| work <= MAX_RANGE_WORK) {
        Some(_) => Ok(()),
        None => Err(RangeError::Work { arity, levels, width, degree }),
    }
}

/// A row of Rᶜ, as terms |p_j|/q to be summed. Polynomials that are multiples of each
/// other make one term.
struct Row {
    terms: Vec<IntegerPolynomial>,
    /// q.
    denominator: Integer,
}

impl Row {
    fn function(&self, window: Option<&(Rational, Rational)>) -> PiecewisePolynomial {
        let over = |term: &IntegerPolynomial| RationalPolynomial::over(term, &self.denominator);
        let terms: Vec<RationalPolynomial> = self.terms.iter().map(over).collect();
        match window {
            None => PiecewisePolynomial::sum_of_magnitudes(&terms),
            Some((low, high)) => PiecewisePolynomial::sum_of_magnitudes_on(&terms, low, high),
        }
    }

    fn degree(&self) -> usize {
        self.terms.iter().filter_map(IntegerPolynomial::degree).sum()
    }
}

/// Primitive polynomials with their factors.
type Terms = BTreeMap<Vec<Integer>, Integer>;

/// The rows of the c-th powers of K operators of one shape, those of few and short
/// terms first. Rows of the same terms, which symmetric rules have, are one.
fn distinct_rows<const K: usize>(
    rules: [&Rules<RationalPolynomial>; K],
    levels: u32,
    order: Order,
) -> Result<Vec<[Row; K]>, RangeError> {
    for rules in rules {
        check(rules, levels)?;
    }
    let denominators = rules.map(denominator);
    let mut scales = denominators.iter().map(|q| RationalPolynomial::constant(q.clone().into()));
    let operators = rules.map(|rules| {
        let scale = scales.next().expect("one for each operator");
        let integers = |entry: &RationalPolynomial| entry.times(&scale).numerator().clone();
        let oriented = oriented(rules, order);
        oriented.rows().iter().map(|row| row.iter().map(integers).collect()).collect()
    });
    let mut distinct: BTreeSet<[Terms; K]> = BTreeSet::new();
    walk_rows(&operators, 0, levels, &mut |rows: &[Vec<IntegerPolynomial>; K], _| {
        distinct.insert(rows.each_ref().map(|row| terms(row)));
    });
    let row = |terms: Terms, denominator: &Integer| {
        let term = |(coefficients, factor): (Vec<Integer>, Integer)| {
            &IntegerPolynomial::new(coefficients) * &IntegerPolynomial::new(vec![factor])
        };
        let terms = terms.into_iter().map(term).collect();
        Row { terms, denominator: denominator.pow(levels) }
    };
    let mut rows: Vec<[Row; K]> = distinct
        .into_iter()
        .map(|rows| {
            let mut denominators = denominators.iter();
            rows.map(|terms| row(terms, denominators.next().expect("one for each operator")))
        })
        .collect();
    rows.sort_by_key(|rows| rows.iter().map(Row::degree).sum::<usize>());
    Ok(rows)
}

fn terms(row: &[IntegerPolynomial]) -> Terms {
    let mut terms = Terms::new();
    for entry in row.iter().filter(|entry| !entry.is_zero()) {
        let factor = terms.entry(entry.primitive().coefficients().to_vec());
        *factor.or_insert_with(Integer::zero) += &entry.content();
    }
    terms
}

/// The least common denominator of all coefficients.
fn denominator(rules: &Rules<RationalPolynomial>) -> Integer {
    rules.rows().iter().flatten().fold(Integer::one(), |lcm, entry| {
        entry.coefficients().iter().fold(lcm, |lcm, c| lcm.lcm(&c.denominator()))
    })
}
