//! Reference values of a ring.

use super::control::Control;
use super::header::{COLUMNS, Header, LocalShape, SCHEMA, program};
use super::refine::{MAX_REFINED_LEVEL, OracleError};
use super::values::{CONTRACTION, CONTROL, Group, NORM, OracleValues, REFINED, group};
use crate::bound::{LocalConstants, LocalWork};
use crate::exact::{Rational, RealCyclotomic};
use crate::scheme::LocalRules;

/// The input of [`ring_reference_values`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LocalRequest {
    /// The name of the ring for the header, such as `doo-sabin:n=5`.
    pub scheme: String,
    /// The greatest c of T_c and Λ_c.
    pub max_block: u32,
    /// One number or point for each point of the ring: [`Control::polygon`],
    /// [`Control::points`] or [`Control::seeded_polygon`].
    pub control: Control,
    /// The number of refinements.
    pub level: u32,
}

const WEIGHTS: &str = "m[a][b]: x'[a] = sum over b of m[a][b]*x[b]";
const SIGMA: &str = "sigma: the largest distance of a new point x'[a] from the old point x[a], per \
                     unit of the largest difference along an edge";

/// M^k x: the control points refined k times. Their number stays the same.
///
/// # Errors
/// When there is not one control point for each point of the ring, the level is too high,
/// or the work is above the cap.
///
/// # Panics
/// When the points and the weights have no
/// [`common_conductor`](crate::exact::common_conductor).
///
/// ```
/// use subcert::assert_within_ulps;
/// use subcert::exact::RealCyclotomic;
/// use subcert::oracle::refine_ring;
/// use subcert::scheme::parse_local_rules;
///
/// let ring = parse_local_rules("doo-sabin:n=5")?;
/// let face = [1, 0, 0, 0, 0].map(RealCyclotomic::from);
/// let refined = refine_ring(&ring, &face, 1)?;
/// assert_eq!(refined[1].to_string(), "3/20 + 1/10*cos(2*pi/5)");
/// assert_within_ulps!(0.15 + 0.1 * (0.4 * std::f64::consts::PI).cos(), &refined[1], 2.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn refine_ring(
    ring: &LocalRules,
    points: &[impl Clone + Into<RealCyclotomic>],
    level: u32,
) -> Result<Vec<RealCyclotomic>, OracleError> {
    if level > MAX_REFINED_LEVEL {
        return Err(OracleError::Level(level));
    }
    if points.len() != ring.point_count() {
        let counts = ring.orbits().iter().map(|orbit| format!("{} {}", orbit.count, orbit.name));
        return Err(OracleError::LocalPoints {
            found: points.len(),
            expected: ring.point_count(),
            names: counts.collect::<Vec<String>>().join(", "),
        });
    }
    // As many products as for the powers of one row.
    LocalWork::check(ring, 1, level.saturating_add(1))?;
    let points: Vec<RealCyclotomic> = points.iter().cloned().map(Into::into).collect();
    Ok((0..level).fold(points, |points, _| ring.refine(&points)))
}

/// The reference values of a ring: its weights, T_c and Λ_c, σ, the control points and
/// their refinement.
///
/// # Errors
/// As [`refine_ring`], and when the work for the powers of the ring is above the cap.
///
/// ```
/// use subcert::oracle::{Control, LocalRequest, ring_reference_values};
/// use subcert::scheme::parse_local_rules;
///
/// let request = LocalRequest {
///     scheme: "catmull-clark:N=3".to_owned(),
///     max_block: 2,
///     control: Control::seeded_polygon(1, 7),
///     level: 3,
/// };
/// let values = ring_reference_values(&parse_local_rules(&request.scheme)?, &request)?;
/// assert_eq!(values.group("weights").unwrap().values[0].exact, "5/12");
/// assert_eq!(values.group("refined").unwrap().values.len(), 7);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn ring_reference_values(
    ring: &LocalRules,
    request: &LocalRequest,
) -> Result<OracleValues, OracleError> {
    let refine = |(number, control)| {
        let control: &[Rational] = control;
        Ok((number, control, refine_ring(ring, control, request.level)?))
    };
    let refined: Vec<(String, &[Rational], Vec<RealCyclotomic>)> =
        request.control.named_coordinates().map(refine).collect::<Result<_, OracleError>>()?;
    let constants = LocalConstants::new(ring, request.max_block)?;
    let count = ring.point_count();
    let levels = constants.levels.iter();
    let contraction: Vec<_> = levels.clone().map(|l| l.contraction().1.value.clone()).collect();
    let norm: Vec<_> = levels.map(|level| level.norm.clone()).collect();
    let sigma = constants.displacement().1.value.clone();
    let weights: Vec<_> = (0..count).flat_map(|a| ring.weights().row(a).cloned()).collect();
    let mut groups: Vec<Group> = vec![
        group("weights", WEIGHTS, &[count, count], 0, &weights),
        group("contraction-constant", CONTRACTION, &[contraction.len()], 1, &contraction),
        group("scheme-norm", NORM, &[norm.len()], 1, &norm),
        group("displacement", SIGMA, &[], 0, &[sigma]),
    ];
    for (number, control, refined) in refined {
        groups.push(group(&format!("control{number}"), CONTROL, &[count], 0, control));
        groups.push(group(&format!("refined{number}"), REFINED, &[count], 0, &refined));
    }
    Ok(OracleValues { schema: SCHEMA, header: header(ring, request), groups })
}

fn header(ring: &LocalRules, request: &LocalRequest) -> Header {
    let points = (0..ring.point_count()).map(|point| ring.name(point)).collect();
    Header {
        program: program(),
        scheme: request.scheme.clone(),
        masks: Vec::new(),
        ring: Some(LocalShape { points, edges: ring.edges().to_vec() }),
        max_block: request.max_block,
        level: request.level,
        boundary: None,
        seed: request.control.seed().map(|seed| seed.to_string()),
        first_index: Vec::new(),
        notes: Vec::new(),
        columns: COLUMNS,
    }
}
