//! The certificate of how many levels a control polygon or a net needs as a set of points.

use super::radius::{line, numbers};
use crate::exact::Rational;
use crate::scheme::Mask;

/// One direction of control data.
#[derive(Clone, Debug)]
pub struct DepthDirection<'a> {
    /// The mask.
    pub mask: &'a Mask,
    /// How many points there are in this direction.
    pub count: usize,
    /// The natural parameters between which the sets are compared; `None` for a closed direction.
    pub range: Option<[Rational; 2]>,
}

/// That a level is not sufficient.
#[derive(Clone, Debug)]
pub struct DepthFar {
    /// The level.
    pub level: u32,
    /// Whether it is the limit that has a point which is far from the other set.
    pub of_limit: bool,
    /// Its natural parameters, one for each direction.
    pub parameters: Vec<Rational>,
}

/// The certificate that the Hausdorff distance of control data from their limit is within a tolerance at a level, and is
/// not at others: `proofs/format/depth.md`. `points` has the points row by row.
///
/// The checker looks for the balls that show it by itself: nothing of the search is in the certificate but parameters of
/// far points.
///
/// ```
/// use subcert::certificate::{DepthDirection, depth_certificate};
/// use subcert::exact::Rational;
/// use subcert::scheme::parse_scheme;
///
/// let chaikin = parse_scheme("chaikin")?;
/// let direction = DepthDirection { mask: chaikin.masks()[0], count: 4, range: None };
/// let points = [[0, 0], [4, 0], [4, 4], [0, 4]].map(|point| point.map(Rational::from).to_vec());
/// let text = depth_certificate(&Rational::new(1, 2), &[direction], &points, Some(1), &[]);
/// assert!(text.starts_with("subcert-depth 1\ntolerance 1/2\ndirection 0 4 closed\nrule 3/4 1/4\n"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn depth_certificate(
    tolerance: &Rational,
    directions: &[DepthDirection<'_>],
    points: &[Vec<Rational>],
    enough: Option<u32>,
    too_few: &[DepthFar],
) -> String {
    let mut text = String::from("subcert-depth 1\n");
    line(&mut text, "tolerance", &tolerance.to_string());
    for DepthDirection { mask, count, range } in directions {
        let rules = mask.rules();
        let range = match range {
            None => "closed".to_owned(),
            Some(ends) => numbers(ends),
        };
        line(&mut text, "direction", &format!("{} {count} {range}", rules.offset()));
        for row in rules.rows() {
            line(&mut text, "rule", &numbers(row));
        }
    }
    for point in points {
        line(&mut text, "point", &numbers(point));
    }
    if let Some(level) = enough {
        line(&mut text, "enough", &level.to_string());
    }
    for DepthFar { level, of_limit, parameters } in too_few {
        let set = if *of_limit { "limit" } else { "polygon" };
        line(&mut text, "too-few", &format!("{level} {set} {}", numbers(parameters)));
    }
    text.push_str("end\n");
    text
}
