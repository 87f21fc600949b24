//! Whether the data that break a promise break it as sets of points too.

use crate::audit::{Broken, Control, Kept, Refiner, TableFinding, promise_refiner};
use crate::bound::Budget;
use crate::claim::Paper;
use crate::diagnostic::Diagnostic;
use crate::exact::{Rational, format::short};
use crate::limit::Limit;
use crate::net::{Closed, Net, NetScheme};
use crate::patch::{CurveSets, NetDistances};
use crate::scheme::Mask;

/// How many pieces of the curve are looked at.
const PIECES: u64 = 2_000_000;

/// How many points more the polygon has at both ends, where it is constant.
const MORE: i64 = 24;

/// Whether a promise is broken to the eye: see [`to_the_eye`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Eye {
    /// Whether the data are a net.
    pub of_net: bool,
    /// The level of the promise.
    pub level: u32,
    /// The promised bound.
    pub most: Rational,
    /// Whether the Hausdorff distance is more than that; `None` where that is not decided.
    pub broken: Option<bool>,
}

/// The control polygon or net of a broken promise as a set of points.
///
/// Its points βx_i are numbers. In the plane they are taken as (βi, βx_i), those of a net in space as (βi, βj, βx_ij): then
/// differences in all coordinates are at most β, so that the promise speaks of these data too, in the other coordinates
/// they move along themselves, and their Hausdorff distance from the limit at the level of the promise is what the eye
/// sees. `None` of a promise that is kept, and of rings.
///
/// Source: `proofs/THEOREMS.md`, 164 and 165.
///
/// # Errors
/// When a formula of the claim file is wrong.
pub fn to_the_eye(
    paper: &Paper,
    finding: &TableFinding<'_>,
    at: (usize, usize),
) -> Result<Option<Eye>, Diagnostic> {
    let Some(Kept::No(broken)) = &finding.cells[at.0][at.1].kept else { return Ok(None) };
    let Broken { attained, spread, level, most, .. } = &**broken;
    let Some(Refiner::Masks(masks)) = promise_refiner(paper, finding, at)? else {
        return Ok(None);
    };
    let within = match (&attained.control, &masks[..]) {
        (Control::Polygon(polygon), [mask]) => curve(mask, &polygon.points, spread, *level, most),
        (Control::Net { rows, .. }, [s, r]) => net([s, r], rows, spread, *level, most),
        _ => return Ok(None),
    };
    let of_net = matches!(attained.control, Control::Net { .. });
    let (most, broken) = (most.clone(), within.map(|within| !within));
    Ok(Some(Eye { of_net, level: *level, most, broken }))
}

/// The indices of so many points and of `more` at both ends, each with the index of its value.
fn indices(count: usize, more: i64) -> impl Iterator<Item = (i64, usize)> {
    let last = i64::try_from(count).unwrap_or(i64::MAX) - 1;
    (-more..=last + more).map(move |i| (i, usize::try_from(i.clamp(0, last)).unwrap_or(0)))
}

/// Whether the polygon of a level is within `most` of its limit; `None` where that is open.
fn curve(
    mask: &Mask,
    points: &[i64],
    spread: &Rational,
    level: u32,
    most: &Rational,
) -> Option<bool> {
    let along = indices(points.len(), MORE).map(|(i, _)| Rational::from(i) * spread).collect();
    let up =
        indices(points.len(), MORE).map(|(_, at)| Rational::from(points[at]) * spread).collect();
    let sets = CurveSets::new(&Limit::new(mask).ok()?, &[along, up], false).ok()?;
    sets.with_budget(Budget::new(PIECES)).is_within(level, most).ok()?
}

/// The same of a net.
fn net(
    masks: [&Mask; 2],
    rows: &[Vec<i64>],
    spread: &Rational,
    level: u32,
    most: &Rational,
) -> Option<bool> {
    let width = rows.first()?.len();
    // Beyond twice the width of the rules both sets are flat, and on those cells nothing is far.
    let [up, along] = masks.map(|mask| i64::try_from(2 * mask.width() + 2).unwrap_or(MORE));
    let point = |(i, row): (i64, usize)| {
        indices(width, along)
            .map(move |(j, at)| [i, j, rows[row][at]].map(|x| Rational::from(x) * spread))
    };
    let points = indices(rows.len(), up).flat_map(point).collect();
    let net = Net::new(points, indices(width, along).count(), Closed::default()).ok()?;
    let distances = NetDistances::new(net, &NetScheme::of_masks(masks.map(Mask::clone))).ok()?;
    distances.is_within(level, most).ok()?
}

/// The name and the text of the fact.
pub(crate) fn fact(eye: &Eye) -> (String, String) {
    let Eye { of_net, level, most, broken } = eye;
    let most = short(most, 6);
    let (of, along) = match of_net {
        false => ("polygon", "a second coordinate"),
        true => ("net", "two more coordinates"),
    };
    let text = match broken {
        Some(true) => format!(
            "broken too: with neighbours β apart along {along}, the {of} of level {level} is farther than {most} \
             from its limit, as the eye sees it"
        ),
        Some(false) => format!(
            "kept by these data: with neighbours β apart along {along}, the {of} of level {level} is \
             within {most} of its limit; points are far at equal parameters only"
        ),
        None => {
            format!("open: whether the {of} of level {level} is within {most} is not decided")
        }
    };
    ("as a set of points".to_owned(), text)
}
