//! Data that exceed a bound, as statements that the Coq library of `proofs/coq` covers.

use crate::bound::{Constants, SoundBound};
use crate::claim::Quantity;
use crate::exact::{Rational, RealCyclotomic};
use crate::finding::{Attained, Control, Excess, KernelStatement, Place, Refiner, RingExcess};
use crate::limit::{Parametrisation, natural_shift, step_supremum};
use crate::scheme::{LocalRules, Mask};

/// The most levels that are computed for the bound of all later ones.
const MAX_LEVELS: u32 = 200;

/// The statement that data exceed a bound, if the library covers it. The points of masks are at these parameters.
pub(super) fn exceeds(
    (refiner, interpolant): (&Refiner, Option<&LocalRules>),
    (quantity, level): (Quantity, u32),
    attained: &Attained,
    (bound, limit): (&Rational, Option<&[Rational]>),
    points: Parametrisation,
) -> Option<KernelStatement> {
    match (refiner, &attained.control) {
        (Refiner::Masks(masks), Control::Polygon(polygon)) => {
            let [mask] = &masks[..] else { return None };
            let shift = shift(mask, points)?;
            let excess = match (quantity, &attained.place) {
                (Quantity::Difference, Place::Difference(i)) => Excess::Difference(*i),
                (Quantity::Step, Place::Point(i)) => step((mask, &shift), level, *i),
                (Quantity::Distance, Place::Parameter(t)) => {
                    far((mask, &shift), t, &(attained.value.as_rational()? - bound))?
                }
                _ => return None,
            };
            let (first, points) = (polygon.first, polygon.points.clone());
            let (mask, bound) = (mask.clone(), bound.clone());
            Some(KernelStatement::Exceeds { mask, shift, level, first, points, excess, bound })
        }
        (Refiner::Masks(masks), Control::Net { first, rows }) => {
            let masks = <[Mask; 2]>::try_from(masks.clone()).ok()?;
            let [s, r] = &masks;
            let shifts = [shift(s, points)?, shift(r, points)?];
            let (s, r) = ((s, &shifts[0]), (r, &shifts[1]));
            let [a, b] = summands(rows)?;
            let excess = match (quantity, &attained.place) {
                (Quantity::Step, Place::Points([i, j])) => [step(s, level, *i), step(r, level, *j)],
                (Quantity::Distance, Place::Parameters([t, u])) => {
                    let gap = (attained.value.as_rational()? - bound) / Rational::from(2);
                    [far(s, t, &gap)?, far(r, u, &gap)?]
                }
                _ => return None,
            };
            let (polygons, bound) = ([(first[0], a), (first[1], b)], bound.clone());
            Some(KernelStatement::Net { masks, shifts, level, polygons, excess, bound })
        }
        (Refiner::Ring(ring), Control::Points(points)) => {
            let place = |name: &String| points.iter().position(|(known, _)| known == name);
            let excess = match (quantity, &attained.place) {
                (Quantity::Difference, Place::Edge([a, b])) => {
                    RingExcess::Difference(place(a)?, place(b)?)
                }
                (Quantity::Step, Place::Named(a)) => {
                    let weights = interpolant.map_or_else(|| Some(identity(ring)), weights);
                    RingExcess::Step(place(a)?, weights?)
                }
                // With an interpolant, only the points that it keeps have the limit of the ring.
                (Quantity::Distance, Place::Named(a)) if interpolant.is_none() => {
                    RingExcess::Distance(place(a)?, limit?.to_vec())
                }
                _ => return None,
            };
            let points = points.iter().map(|(_, height)| *height).collect();
            let (weights, edges) = (weights(ring)?, ring.edges().to_vec());
            let bound = bound.clone();
            Some(KernelStatement::Ring { weights, edges, level, points, excess, bound })
        }
        _ => None,
    }
}

/// The shift of the points of a mask; `None` where no shift takes lines to lines.
fn shift(mask: &Mask, points: Parametrisation) -> Option<Rational> {
    let lines = points == Parametrisation::Indexed || natural_shift(mask).keeps_lines;
    lines.then(|| points.shift(mask))
}

/// The step of a point of level k + 1.
fn step((mask, shift): (&Mask, &Rational), level: u32, point: i64) -> Excess {
    let points = Rational::from(mask.arity() as u64).pow((level + 1).cast_signed());
    Excess::Step((Rational::from(point) + shift) / points)
}

/// Polygons a and b with x_{i,j} = a_i + b_j, if there are any.
fn summands(rows: &[Vec<i64>]) -> Option<[Vec<i64>; 2]> {
    let a: Vec<i64> = rows.iter().map(|row| row[0]).collect();
    let b: Vec<i64> = rows[0].iter().map(|x| x - rows[0][0]).collect();
    let is_sum = |(row, a): (&Vec<i64>, &i64)| row.iter().zip(&b).all(|(x, b)| *x == a + b);
    rows.iter().zip(&a).all(is_sum).then_some([a, b])
}

/// The weights that leave every point where it is.
fn identity(ring: &LocalRules) -> Vec<Vec<Rational>> {
    let points = 0..ring.point_count();
    let row = |a| points.clone().map(|b| Rational::from(u64::from(a == b))).collect();
    points.clone().map(row).collect()
}

fn weights(ring: &LocalRules) -> Option<Vec<Vec<Rational>>> {
    let weights = ring.weights();
    (0..ring.point_count()).map(|row| rationals(weights.row(row))).collect()
}

/// A later level whose distance to all levels beyond is so small that what exceeds a bound by `gap`
/// in the limit exceeds it from there on.
fn far((mask, shift): (&Mask, &Rational), place: &Rational, gap: &Rational) -> Option<Excess> {
    let mut tail = Rational::one();
    while &tail + &tail + &tail > *gap {
        tail /= Rational::from(2);
    }
    let constants = Constants::new(mask.clone());
    let most = (1..=8).take_while(|c| (mask.arity() as u64).pow(*c) <= 1 << 11).last()?;
    let bound = SoundBound::curve(&constants, most).ok()?;
    let one = Rational::one();
    let least = bound.constants().iter().skip(1).position(|constant| *constant < one)? + 1;
    let factor = if shift.is_zero() {
        bound.factor().clone()
    } else {
        step_supremum(mask, 0, shift).ok()?
    };
    let bound = SoundBound::of(factor, bound.constants()[..=least].to_vec());
    let later =
        (0..MAX_LEVELS).find(|level| bound.level(*level).is_some_and(|(b, _)| b <= tail))?;
    let block = (least, bound.level(later)?.1);
    Some(Excess::Distance { place: place.clone(), later, tail, block })
}

/// Numbers, if all are rational.
pub(super) fn rationals<'n>(
    numbers: impl IntoIterator<Item = &'n RealCyclotomic>,
) -> Option<Vec<Rational>> {
    numbers.into_iter().map(|number| number.as_rational().cloned()).collect()
}
