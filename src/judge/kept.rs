//! Whether a distance is ever greater than a paper promises, exactly.

use crate::bound::Constants;
use crate::evaluation::library::Resolved;
use crate::exact::{Rational, RealCyclotomic};
use crate::finding::{Broken, ControlData, Kept};
use crate::limit::{
    Comparison, Distances, Limit, RingDistances, RingLimit, Spreads, SurfaceDistances,
};
use crate::scheme::{Instance, Mask, Ring};
use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::rc::Rc;

/// The most cells that one comparison looks at.
const MAX_CELLS: u32 = 1 << 13;

/// The most that the squares of the numbers of points of the rings of one claim sum to.
pub(crate) const MAX_RING_SIZE: usize = 600_000;

/// A scheme, and the offset at which it is compared with its limit, if not its own.
type SchemeAt = (Vec<Instance>, Option<i64>);

/// The distances that the cells of one table ask for. Another table has its own: what is found with a
/// limited amount of work for one must not decide what is found for the other.
#[derive(Default)]
pub(crate) struct DistanceMemo {
    masks: RefCell<BTreeMap<SchemeAt, Rc<Remembered>>>,
    rings: RefCell<BTreeMap<Instance, Rc<Remembered>>>,
    /// The sum of the squares of the numbers of points of these rings.
    ring_size: Cell<usize>,
}

impl DistanceMemo {
    /// The distances from the limits of a scheme, at its own offset or at another.
    pub(crate) fn of(&self, scheme: &Resolved, offset: Option<i64>) -> Rc<Remembered> {
        let key = (scheme.instances.clone(), offset);
        let mut all = self.masks.borrow_mut();
        let remembered = all.entry(key).or_insert_with(|| {
            let shifted = |constants: &Rc<Constants>| {
                let mask = constants.mask();
                mask.with_offset(offset.unwrap_or(mask.offset()))
            };
            let masks: Vec<Mask> = scheme.constants.iter().map(shifted).collect();
            Rc::new(match &masks[..] {
                [curve] => Remembered::curve(curve),
                [first, second, ..] => Remembered::surface(first, second),
                [] => unreachable!("a scheme has one mask or two"),
            })
        });
        Rc::clone(remembered)
    }

    /// The distances from the limit of a ring.
    pub(crate) fn of_ring(&self, (instance, ring): &(Instance, Ring)) -> Rc<Remembered> {
        let mut all = self.rings.borrow_mut();
        let new = || {
            let size = self.ring_size.get().saturating_add(ring.point_count().pow(2));
            self.ring_size.set(size);
            Rc::new(if size <= MAX_RING_SIZE {
                Remembered::ring(ring)
            } else {
                Remembered::new(Err(format!(
                    "the rings of this table have more points than the cap: the squares of their \
                     numbers sum to {MAX_RING_SIZE} at most"
                )))
            })
        };
        Rc::clone(all.entry(instance.clone()).or_insert_with(new))
    }
}

/// The distances of one scheme from its limits, with what was found of them.
pub(crate) struct Remembered {
    distances: Result<Of, String>,
    /// For each level what is known of its distance constant.
    levels: RefCell<BTreeMap<u32, Known>>,
}

/// Of what they are distances.
enum Of {
    Curve(Box<Distances>),
    Surface(Box<(SurfaceDistances, [Limit; 2])>),
    Ring(RingDistances),
}

/// Data of spread 1 with their distance.
#[derive(Clone)]
struct Found {
    data: ControlData,
    distance: RealCyclotomic,
}

/// What is known of a distance constant.
#[derive(Default)]
struct Known {
    at_most: Option<Rational>,
    /// The greatest distance found.
    found: Option<Found>,
    /// The thresholds that were not decided.
    open: Vec<Rational>,
}

impl Remembered {
    /// The distances of this scheme for curves, at its offset.
    pub(crate) fn curve(mask: &Mask) -> Remembered {
        let distances = Limit::new(mask).and_then(|limit| Distances::new(&limit));
        let distances =
            distances.map(|distances| Of::Curve(Box::new(distances.with_cells(MAX_CELLS))));
        Remembered::new(distances.map_err(|error| error.to_string()))
    }

    /// The distances of the tensor product of these schemes, at their offsets.
    pub(crate) fn surface(first: &Mask, second: &Mask) -> Remembered {
        let limits = Limit::new(first).and_then(|first| Ok((first, Limit::new(second)?)));
        let distances = limits.map_err(|error| error.to_string()).and_then(|(first, second)| {
            let distances = SurfaceDistances::new(&first, &second);
            let distances = distances.map_err(|error| error.to_string())?;
            Ok(Of::Surface(Box::new((distances, [first, second]))))
        });
        Remembered::new(distances)
    }

    /// The distances of the points of this ring.
    pub(crate) fn ring(ring: &Ring) -> Remembered {
        let limit = RingLimit::new(ring).map(|limit| Of::Ring(RingDistances::new(limit)));
        Remembered::new(limit.map_err(|error| error.to_string()))
    }

    fn new(distances: Result<Of, String>) -> Remembered {
        Remembered { distances, levels: RefCell::default() }
    }

    /// Whether all control data of spread `spread` are within `most` of their limit at a
    /// level.
    pub(crate) fn kept(&self, level: u32, spread: &Rational, most: &Rational) -> Kept {
        let distances = match &self.distances {
            Ok(distances) => distances,
            Err(why) => return Kept::Open(why.clone()),
        };
        if spread.sign() <= 0 {
            return Kept::Open(format!("the spread {spread} is not positive"));
        }
        let threshold = most / spread;
        let mut levels = self.levels.borrow_mut();
        let broken = |found: &Found| {
            let Found { data, distance } = found.clone();
            let distance = &distance * &RealCyclotomic::from(spread.clone());
            let (spread, most) = (spread.clone(), most.clone());
            Kept::No(Box::new(Broken { data, spread, level, distance, most }))
        };
        let known = levels.entry(level).or_default();
        if known.at_most.as_ref().is_some_and(|bound| *bound <= threshold) {
            return Kept::Yes;
        }
        let exceeds = |found: &&Found| found.distance > threshold.clone().into();
        if let Some(found) = known.found.as_ref().filter(exceeds) {
            return broken(found);
        }
        let undecided = || Kept::Open("the caps of the search do not decide it".to_owned());
        if known.open.contains(&threshold) {
            return undecided();
        }
        match distances.compare(level, &threshold) {
            Ok(Comparison::Within) => {
                known.at_most = Some(threshold);
                Kept::Yes
            }
            Ok(Comparison::Exceeds(found)) => broken(known.found.insert(found)),
            Ok(Comparison::Undecided(_)) => {
                known.open.push(threshold);
                undecided()
            }
            Err(why) => Kept::Open(why),
        }
    }
}

impl Remembered {
    /// Of a ring, the weights of its limit.
    pub(crate) fn limit_weights(&self) -> Option<&[RealCyclotomic]> {
        match &self.distances {
            Ok(Of::Ring(distances)) => Some(distances.limit().weights()),
            _ => None,
        }
    }

    /// Of a ring, flows that bound the distances of its points at a level.
    pub(crate) fn flows(&self, level: u32) -> Option<Vec<Vec<RealCyclotomic>>> {
        match &self.distances {
            Ok(Of::Ring(distances)) => distances.flows(level).ok(),
            _ => None,
        }
    }

    /// Of a ring, the least level from which on all meet a tolerance.
    pub(crate) fn settled(&self, spread: &Rational, tolerance: &Rational) -> Result<u32, String> {
        match self.distances.as_ref().map_err(Clone::clone)? {
            Of::Ring(distances) => {
                let depth = distances.depth(spread, tolerance);
                depth.map(|depth| depth.settled).map_err(|error| error.to_string())
            }
            Of::Curve(_) | Of::Surface(_) => Err("this is no ring".to_owned()),
        }
    }
}

impl Of {
    /// Compares the distance constant of a level with a threshold.
    fn compare(&self, level: u32, threshold: &Rational) -> Result<Comparison<Found>, String> {
        match self {
            Of::Curve(distances) => curve(distances, level, threshold),
            Of::Surface(surface) => {
                let (distances, limits) = &**surface;
                if let Some(found) = far_net(limits, level, threshold) {
                    return Ok(Comparison::Exceeds(found));
                }
                let compared = distances.compare(level, threshold, &Spreads::one());
                Ok(match compared.map_err(|error| error.to_string())? {
                    Comparison::Within => Comparison::Within,
                    Comparison::Undecided(enclosure) => Comparison::Undecided(enclosure),
                    Comparison::Exceeds(witness) => Comparison::Exceeds(Found {
                        data: ControlData::Net(witness.net, witness.first, witness.parameters),
                        distance: witness.distance.into(),
                    }),
                })
            }
            Of::Ring(distances) => {
                let compared = distances.compare(level, &threshold.clone().into());
                let name = |point| distances.limit().ring().name(point);
                Ok(match compared.map_err(|error| error.to_string())? {
                    Comparison::Within => Comparison::Within,
                    Comparison::Undecided(enclosure) => Comparison::Undecided(enclosure),
                    Comparison::Exceeds(witness) => Comparison::Exceeds(Found {
                        data: ControlData::Ring(witness.ring, name(witness.point)),
                        distance: witness.distance,
                    }),
                })
            }
        }
    }
}

fn curve(
    distances: &Distances,
    level: u32,
    threshold: &Rational,
) -> Result<Comparison<Found>, String> {
    let compared = distances.compare(level, threshold).map_err(|error| error.to_string())?;
    Ok(match compared {
        Comparison::Within => Comparison::Within,
        Comparison::Exceeds(witness) => Comparison::Exceeds(Found {
            data: ControlData::Polygon(witness.polygon, witness.parameter),
            distance: witness.distance.into(),
        }),
        Comparison::Undecided(enclosure) => match distances.limit().far_polygon(level) {
            Ok(far) if far.distance > *threshold => Comparison::Exceeds(Found {
                data: ControlData::Polygon(far.polygon, far.parameter),
                distance: far.distance.into(),
            }),
            _ => Comparison::Undecided(enclosure),
        },
    })
}

/// The sum of polygons that are far from their limits along both directions, when its distance, which is the sum of
/// theirs, is above the threshold.
fn far_net(limits: &[Limit; 2], level: u32, threshold: &Rational) -> Option<Found> {
    let [x, y] = [&limits[0], &limits[1]].map(|limit| limit.far_polygon(level).ok());
    let (x, y) = (x?, y?);
    let distance = x.distance + y.distance;
    let (rows, columns) = (x.polygon, y.polygon);
    let row = |x: &i64| columns.points.iter().map(|y| x + y).collect();
    (distance > *threshold).then(|| Found {
        data: ControlData::Net(
            rows.points.iter().map(row).collect(),
            [rows.first, columns.first],
            [x.parameter, y.parameter],
        ),
        distance: distance.into(),
    })
}
