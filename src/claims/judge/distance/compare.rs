//! Whether curves and nets are farther from their limit than a bound: by search, and by polygons
//! that are far from their limits.

use crate::exact::Rational;
use crate::finding::{Attained, Control, Place, Reason};
use crate::limit::{
    Comparison, Distances, ExtremalPolygon, Limit, Spreads, SurfaceDistances, SurfaceWitness,
    Witness, is_fraction,
};

/// How many levels m, from the level of the data on, are tried for a place i/n^m.
const MAX_FINER: u32 = 20;

/// Compares the distance constant of a curve at a level with a bound. Where the search leaves this
/// open, a polygon that is far from its limit may decide it.
pub(super) fn curve(
    distances: &Distances,
    level: u32,
    bound: &Rational,
) -> Result<Comparison<Attained>, Reason> {
    Ok(match distances.compare(level, bound).map_err(Reason::from)? {
        Comparison::Within => Comparison::Within,
        Comparison::Exceeds(Witness { polygon, parameter, distance, .. }) => {
            let found = far_curve(polygon, parameter, distance);
            Comparison::Exceeds(at_fraction(distances, level, bound, found))
        }
        Comparison::Undecided(enclosure) => {
            match distances.limit().far_polygon_from(level, distances.shift()) {
                Ok(far) if far.distance > *bound => {
                    let found = far_curve(far.polygon, far.parameter, far.distance);
                    Comparison::Exceeds(at_fraction(distances, level, bound, found))
                }
                _ => Comparison::Undecided(enclosure),
            }
        }
    })
}

/// The violation at a nearby place i/n^m, which certificates can express; the given one if no such
/// place is found with a distance above the bound.
fn at_fraction(distances: &Distances, level: u32, bound: &Rational, found: Attained) -> Attained {
    let Place::Parameter(t) = &found.place else { return found };
    let error = |t: &Rational| distances.error(level, t).ok();
    let arity = distances.limit().mask().arity();
    let near = fractions([(t, arity)], level).find_map(|[t]| {
        let error = error(&t)?;
        let distance = error.norm();
        (distance > *bound).then(|| far_curve(error.extremal_polygon(), t, distance))
    });
    near.unwrap_or(found)
}

/// For each m from `level` on, these places, where each that is no i/n^l for any l is rounded to
/// the nearest i/n^m. Empty if no place has to be rounded.
fn fractions<const K: usize>(
    places: [(&Rational, usize); K],
    level: u32,
) -> impl Iterator<Item = [Rational; K]> {
    let others = places.iter().any(|(t, arity)| !is_fraction(t, *arity));
    let last = if others { level + MAX_FINER } else { level };
    (level..last).map(move |m| {
        places.map(|(t, arity)| {
            let points = Rational::from(arity).pow(m.cast_signed());
            let nearest = (t * &points + Rational::new(1, 2)).floor();
            if is_fraction(t, arity) { t.clone() } else { Rational::from(nearest) / points }
        })
    })
}

fn far_curve(polygon: ExtremalPolygon, t: Rational, distance: Rational) -> Attained {
    let (control, place) = (Control::Polygon(polygon), Place::Parameter(t));
    Attained { control, place, value: distance.into() }
}

pub(super) fn net(
    distances: &SurfaceDistances,
    limits: &[Limit; 2],
    level: u32,
    bound: &Rational,
) -> Result<Comparison<Attained>, Reason> {
    // The far net is tried first: the search takes longer, and at high levels much longer.
    if let Some(found) = far_net(limits, distances.shifts(), level, bound) {
        return Ok(Comparison::Exceeds(net_at_fraction(distances, limits, level, bound, found)));
    }
    let compared = distances.compare(level, bound, &Spreads::one()).map_err(Reason::from)?;
    Ok(match compared {
        Comparison::Within => Comparison::Within,
        Comparison::Undecided(enclosure) => Comparison::Undecided(enclosure),
        Comparison::Exceeds(SurfaceWitness { first, net, parameters, distance, .. }) => {
            let control = Control::Net { first, rows: net };
            let place = Place::Parameters(parameters);
            let found = Attained { control, place, value: distance.into() };
            Comparison::Exceeds(net_at_fraction(distances, limits, level, bound, found))
        }
    })
}

/// As [`at_fraction`], for a net.
fn net_at_fraction(
    distances: &SurfaceDistances,
    limits: &[Limit; 2],
    level: u32,
    bound: &Rational,
    found: Attained,
) -> Attained {
    let Place::Parameters([s, t]) = &found.place else { return found };
    let arity = |axis: usize| limits[axis].mask().arity();
    let near = fractions([(s, arity(0)), (t, arity(1))], level).find_map(|places| {
        let SurfaceWitness { first, net, parameters, distance, .. } =
            distances.at(level, &places, &Spreads::one()).ok()?;
        (distance > *bound).then(|| Attained {
            control: Control::Net { first, rows: net },
            place: Place::Parameters(parameters),
            value: distance.into(),
        })
    });
    near.unwrap_or(found)
}

/// The net a_i + b_j of two polygons that are far from their limits, if its distance from the
/// limit, which is the sum of theirs, is above the bound.
fn far_net(
    limits: &[Limit; 2],
    shifts: [&Rational; 2],
    level: u32,
    bound: &Rational,
) -> Option<Attained> {
    let far = |axis: usize| limits[axis].far_polygon_from(level, shifts[axis]).ok();
    let (x, y) = (far(0)?, far(1)?);
    let distance = x.distance + y.distance;
    let (rows, columns) = (x.polygon, y.polygon);
    let row = |x: &i64| columns.points.iter().map(|y| x + y).collect();
    (distance > *bound).then(|| Attained {
        control: Control::Net {
            first: [rows.first, columns.first],
            rows: rows.points.iter().map(row).collect(),
        },
        place: Place::Parameters([x.parameter, y.parameter]),
        value: distance.into(),
    })
}
