//! Whether the data that break a promise break it as sets of points too.

use crate::audit::{Broken, Control, Kept, Refiner, TableFinding, promise_refiner};
use crate::bound::Budget;
use crate::claim::Paper;
use crate::diagnostic::Diagnostic;
use crate::exact::{Rational, format::short};
use crate::limit::Limit;
use crate::patch::CurveSets;

/// How many pieces of the curve are looked at.
const PIECES: u64 = 2_000_000;

/// How many points more the polygon has at both ends, where it is constant.
const MORE: i64 = 24;

/// Whether a promise is broken to the eye: see [`to_the_eye`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Eye {
    /// The level of the promise.
    pub level: u32,
    /// The promised bound.
    pub most: Rational,
    /// Whether the Hausdorff distance is more than that; `None` where that is not decided.
    pub broken: Option<bool>,
}

/// The control polygon of a broken promise as a set of points.
///
/// Its points βx_i are numbers. In the plane they are taken as (βi, βx_i): then differences in both coordinates are at
/// most β, so that the promise speaks of this polygon too, in the first coordinate it moves along itself, and its
/// Hausdorff distance from the limit at the level of the promise is what the eye sees. `None` of a promise that is kept, of nets and
/// of rings.
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
    let Control::Polygon(polygon) = &attained.control else { return Ok(None) };
    let Some(Refiner::Masks(masks)) = promise_refiner(paper, finding, at)? else {
        return Ok(None);
    };
    let [mask] = &masks[..] else { return Ok(None) };
    let last = i64::try_from(polygon.points.len()).unwrap_or(i64::MAX) - 1;
    let value = |i: i64| {
        let place = usize::try_from(i.clamp(0, last)).unwrap_or(0);
        Rational::from(polygon.points[place]) * spread
    };
    let indices = || -MORE..=last + MORE;
    let along: Vec<Rational> = indices().map(|i| Rational::from(i) * spread).collect();
    let up: Vec<Rational> = indices().map(value).collect();
    let within = || {
        let limit = Limit::new(mask).ok()?;
        let sets = CurveSets::new(&limit, &[along, up], false).ok()?;
        sets.with_budget(Budget::new(PIECES)).is_within(*level, most).ok()?
    };
    let broken = within().map(|within| !within);
    Ok(Some(Eye { level: *level, most: most.clone(), broken }))
}

/// The name and the text of the fact.
pub(super) fn fact(eye: &Eye) -> (String, String) {
    let Eye { level, most, broken } = eye;
    let most = short(most, 6);
    let text = match broken {
        Some(true) => format!(
            "broken too: with neighbours β apart along a second coordinate, the polygon of level {level} is farther than {most} \
             from its limit, as the eye sees it"
        ),
        Some(false) => format!(
            "kept by these data: with neighbours β apart along a second coordinate, the polygon of level {level} is \
             within {most} of its limit; points are far at equal parameters only"
        ),
        None => {
            format!("open: whether the polygon of level {level} is within {most} is not decided")
        }
    };
    ("as a set of points".to_owned(), text)
}
