//! What the greatest differences of a net guarantee, wherever its points are.

use super::constants::UP;
use crate::bound::{Budget, Constants, Operator, Order};
use crate::exact::Rational;
use crate::float::{exact, upper};
use crate::limit::{Limit, Parametrisation, Spreads, SurfaceDistances, SurfaceError};
use crate::net::{Net, NetError, NetScheme};
use crate::patch::distance::surface::positive;
use crate::patch::mesh::apriori::longest;
use crate::patch::range::scale;

/// The most steps that the bounds of schemes with negative coefficients may take.
const STEPS: u64 = 200_000_000;

/// The highest level.
const MAX_LEVEL: u32 = 128;

/// What a net guarantees by its edges.
#[derive(Clone, Debug, PartialEq)]
pub struct NetAPriori {
    /// The level from which on every net with no longer edges, in either direction, is within the
    /// tolerance.
    pub level: u32,
    /// Upper bounds of the lengths of the longest edges from row to row, and along the rows; of the
    /// lesser one it may be a 10⁻⁶th of the other one too much.
    pub longest_edges: [f64; 2],
    /// A factor by which edges shrink from level to level: the greater T_1Λ_1, with T_1 of one direction and
    /// Λ_1 of the other.
    pub ratio: f64,
}

/// The level that the longest edges of a net guarantee: the least k with a bound of the distance of
/// all nets with no longer edges within the tolerance.
///
/// Source: `proofs/THEOREMS.md`, 32 to 34 and 86, with the points at their natural parameters. Their upper
/// bounds are sums of multiples of edges, and so hold for points of space.
///
/// # Errors
/// When the tolerance is not positive, a curve is not shown to converge, or no level up to 128 is sufficient.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::net::{Closed, Net, NetScheme};
/// use subcert::patch::net_a_priori;
///
/// let point = |k: i64| [k % 5, k / 5, k * k % 3].map(Rational::from);
/// let net = Net::new((0..25).map(point).collect(), 5, Closed::default())?;
/// let guaranteed = net_a_priori(&net, &NetScheme::parse("bicubic")?, &Rational::new(1, 100))?;
/// assert_eq!(guaranteed.level, 4);
/// # Ok::<(), subcert::net::NetError>(())
/// ```
pub fn net_a_priori(
    net: &Net,
    scheme: &NetScheme,
    tolerance: &Rational,
) -> Result<NetAPriori, NetError> {
    positive::<NetError>(tolerance)?;
    let edges = longest_edges(net)?;
    let longest_edges = edges.each_ref().map(upper);
    let [u, v] = scheme.masks().each_ref();
    let factor = |mask: &crate::scheme::Mask, operator| {
        Constants::new(mask.clone())
            .norm(operator, 1, Order::Adjoint)
            .map_or(f64::INFINITY, |x| upper(&x))
    };
    let shrinks =
        |first, second| factor(first, Operator::Difference) * factor(second, Operator::Scheme) * UP;
    let ratio = shrinks(u, v).max(shrinks(v, u));
    let limits = [Limit::new(u)?, Limit::new(v)?];
    let guaranteed = |level| NetAPriori { level, longest_edges, ratio };
    let spreads = Spreads::new(&edges[0], &edges[1]).map_err(surface)?;
    let budget = Budget::new(STEPS);
    let natural = Parametrisation::Natural;
    let distances =
        SurfaceDistances::placed(&limits[0], &limits[1], natural, &budget).map_err(surface)?;
    let level = (0..=MAX_LEVEL).find(|level| distances.at_most(*level, &spreads) <= *tolerance);
    level.map(guaranteed).ok_or_else(|| {
        NetError::TooMuch(format!(
            "the longest edges of the net guarantee the tolerance for no level up to {MAX_LEVEL}; take a \
             greater one"
        ))
    })
}

fn surface(error: SurfaceError) -> NetError {
    match error {
        SurfaceError::Limit(error) => NetError::Limit(error),
        error => NetError::TooMuch(error.to_string()),
    }
}

/// Upper bounds of the lengths of the longest edges of both directions; each is a multiple of 2^−20 of the
/// greater one, so that their ratio is one of small integers.
pub(super) fn longest_edges(net: &Net) -> Result<[Rational; 2], NetError> {
    let scale = scale::<NetError>(net.points())?;
    let ([rows, columns], closed) = (net.sizes(), net.closed());
    let next = |index: usize, count: usize, closed: bool| {
        let next = index + 1;
        if closed { Some(next % count) } else { Some(next).filter(|next| *next < count) }
    };
    let edges = |rightwards: bool| {
        (0..rows * columns).filter_map(move |point| {
            let (i, j) = (point / columns, point % columns);
            let other = if rightwards {
                i * columns + next(j, columns, closed.v)?
            } else {
                next(i, rows, closed.u)? * columns + j
            };
            Some([point, other])
        })
    };
    let longest = |rightwards| longest(net.points(), &scale, edges(rightwards));
    // Where all points of a direction are the same, a positive bound is needed too.
    let edges = [longest(false), longest(true)].map(|edge| edge.max(f64::EPSILON));
    let greatest = edges[0].max(edges[1]);
    let unit = exact(greatest).unwrap_or_else(Rational::one) * scale / Rational::from(1 << 20);
    Ok(edges.map(|edge| {
        let part = exact(edge / greatest).unwrap_or_else(Rational::one) * Rational::from(1 << 20);
        // A quotient that is rounded to 1 is at most 1.
        let more = if edge < greatest { Rational::new(1, 1 << 20) } else { Rational::zero() };
        Rational::from((part + more).ceil()) * &unit
    }))
}
