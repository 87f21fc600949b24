//! Windows of Z^d that steps of a mask do not leave.

use crate::cap::Cap;
use crate::exact::Rational;
use crate::scheme::{Dilation, Point, difference};
use std::collections::{BTreeSet, HashSet};

/// The most points of the box in which a window is looked for.
const MAX_BOX: u64 = 1 << 20;

/// The most steps until one contracts.
const MAX_STEPS: usize = 64;

/// The most points of a window.
pub const MAX_WINDOW: usize = 400;

/// The integer points of the attractor X = M^{−1}(X + D) of a set D of integer points: the largest finite set Ω with Ω = M^{−1}(Ω + D) ∩ Z^d.
///
/// ```
/// use std::collections::BTreeSet;
/// use subcert::lattice::attractor;
/// use subcert::scheme::Dilation;
///
/// // The square [0, 1]², of the digits of 2I.
/// let two = Dilation::scalar(2, 2)?;
/// let digits: BTreeSet<[i64; 3]> = two.digits().iter().copied().collect();
/// assert_eq!(attractor(&two, &digits).map(|points| points.len()), Ok(4));
/// # Ok::<(), subcert::scheme::DilationError>(())
/// ```
///
/// A point x of it is M^{−1}(y + d) with y = Mx − d in the attractor again, so that Ω is no larger than the right side; and from any set that
/// contains it, repeated application of the right side ends with it.
///
/// # Errors
/// When it, or the box around it, has too many points.
pub fn attractor(dilation: &Dilation, places: &BTreeSet<Point>) -> Result<Vec<Point>, Cap> {
    let before = |image: Point, window: &HashSet<Point>| {
        places.iter().any(|place| window.contains(&difference(image, *place)))
    };
    largest(dilation, radius(dilation, places)?, before)
}

/// The largest set of points of a box of which each has a point `before` it in the set, given what M makes of it.
pub(super) fn largest(
    dilation: &Dilation,
    radius: i64,
    before: impl Fn(Point, &HashSet<Point>) -> bool,
) -> Result<Vec<Point>, Cap> {
    let side = u64::try_from(2 * radius + 1).expect("a size");
    let count = side.saturating_pow(u32::try_from(dilation.dimension()).expect("2 or 3"));
    if count > MAX_BOX {
        return Err(Cap::new("the number of points of a box", MAX_BOX));
    }
    let range = |axis: usize| if axis < dilation.dimension() { -radius..=radius } else { 0..=0 };
    let mut window: HashSet<Point> = HashSet::new();
    for x in range(0) {
        for y in range(1) {
            window.extend(range(2).map(|z| [x, y, z]));
        }
    }
    loop {
        let kept = |point: &&Point| before(dilation.times(**point), &window);
        let next: HashSet<Point> = window.iter().filter(kept).copied().collect();
        if next.len() == window.len() {
            break;
        }
        window = next;
    }
    if window.len() > MAX_WINDOW {
        return Err(Cap::new("the number of points of a window", MAX_WINDOW as u64));
    }
    let mut points: Vec<Point> = window.into_iter().collect();
    points.sort_unstable();
    Ok(points)
}

/// A number that no coordinate of the attractor exceeds: with ‖M^{−j}‖_∞ = q < 1 and b_i the largest coordinate of M^{−i}D, it is at most
/// (b_1 + … + b_j)/(1 − q).
pub(super) fn radius(dilation: &Dilation, places: &BTreeSet<Point>) -> Result<i64, Cap> {
    let d = dilation.dimension();
    let rational = |point: &[i64]| point.iter().map(|x| Rational::from(*x)).collect();
    let mut images: Vec<Vec<Rational>> = places.iter().map(|place| rational(&place[..d])).collect();
    let mut units: Vec<Vec<Rational>> =
        (0..d).map(|j| (0..d).map(|i| Rational::from(i64::from(i == j))).collect()).collect();
    let mut total = Rational::zero();
    for _ in 0..MAX_STEPS {
        images = images.iter().map(|x| dilation.inverse_times(x)).collect();
        units = units.iter().map(|x| dilation.inverse_times(x)).collect();
        total += &images.iter().flatten().map(Rational::abs).max().unwrap_or_else(Rational::zero);
        let row = |i: usize| units.iter().map(|column| column[i].abs()).sum::<Rational>();
        let q = (0..d).map(row).max().expect("two axes");
        if q <= Rational::new(1, 2) {
            let radius = total / (Rational::one() - q);
            return radius.ceil().to_i64().ok_or_else(|| Cap::new("the size of a box", MAX_BOX));
        }
    }
    Err(Cap::new("the number of steps until a step contracts", MAX_STEPS as u64))
}

/// The differences of places and digits.
#[must_use]
pub fn less_digits(places: impl Iterator<Item = Point>, dilation: &Dilation) -> BTreeSet<Point> {
    let less = |place: Point| dilation.digits().iter().map(move |digit| difference(place, *digit));
    places.flat_map(less).collect()
}
