//! Judging the values of two parameters for which the limits are said to be C^m.

use super::mask::limits;
use crate::claim::{Sign, SmoothRegionStatement};
use crate::diagnostic::Diagnostic;
use crate::evaluation::limits::LimitScheme;
use crate::exact::{Rational, Scalar as _};
use crate::finding::{KnownLimits, Reason, RegionOfLimits, SmoothnessVerdict, Witness};
use crate::formula::{HalfPlanes, LocatedFormula, Pieces, Scope, evaluate};
use crate::smoothness::{SmoothRangeError, polygon_contraction};

/// The most levels of a contraction.
const MAX_LEVELS: u32 = 4;

/// How far from the sides points are tried, as parts of the way to the centre.
const STEPS: [(i64, i64); 3] = [(1, 1_000), (1, 20), (1, 3)];

/// Judges a region.
pub(super) fn judge(
    scheme: &LimitScheme<'_>,
    statement: &SmoothRegionStatement,
) -> Result<(SmoothnessVerdict, KnownLimits), Diagnostic> {
    let variables = statement.variables.each_ref().map(String::as_str);
    let planes = half_planes(scheme, statement)?;
    let corners = planes.corners().map_err(|error| {
        let formula = statement.inequalities[0].left.formulas()[0].clone();
        Diagnostic::new(&formula.source, formula.span, error.to_string())
            .with_help("the inequalities of `where` bound a polygon together")
    })?;
    let rules = scheme.rules_in_plane(variables)?;
    let contains = |point: [&Rational; 2]| planes.contain(point);
    let found = polygon_contraction(&rules, statement.m, &corners, &contains, MAX_LEVELS);
    let (proof, mut points) = match found {
        Ok(Ok(proof)) => (Some(proof), Vec::new()),
        Ok(Err(points)) => (None, points),
        Err(SmoothRangeError::SumRules { .. }) => (None, Vec::new()),
        Err(error) => {
            let reason = Reason::from(error);
            return Ok((SmoothnessVerdict::NotCheckable, KnownLimits::Capped(reason)));
        }
    };
    let mut known = RegionOfLimits { proof, corners, witness: None, tried: 0 };
    if known.proof.is_none() || statement.only {
        points.extend(tried(&known.corners));
    }
    for at in points {
        let inside = planes.contain([&at[0], &at[1]]);
        // Points of the region refute it, and the others do if it is the only one.
        if inside && known.proof.is_some() || !inside && !statement.only {
            continue;
        }
        known.tried += 1;
        let values = [(variables[0], &at[0]), (variables[1], &at[1])];
        let Ok(limits) = limits(scheme.mask(&values)?) else { continue };
        let proven = limits.proven();
        if proven.and_then(|proven| proven.is_continuous(statement.m)) == Some(!inside) {
            known.witness = Some(Witness { at, inside, limits });
            break;
        }
    }
    let verdict = match (&known.witness, &known.proof) {
        (Some(_), _) => SmoothnessVerdict::Refuted,
        (None, Some(_)) if !statement.only => SmoothnessVerdict::Confirmed,
        _ => SmoothnessVerdict::Open,
    };
    Ok((verdict, KnownLimits::Region(Box::new(known))))
}

/// The half planes of which the inequalities speak.
fn half_planes(
    scheme: &LimitScheme<'_>,
    statement: &SmoothRegionStatement,
) -> Result<HalfPlanes, Diagnostic> {
    let mut scope: Scope<'_, Pieces> = scheme.scope()?;
    for (second, name) in [false, true].into_iter().zip(&statement.variables) {
        scope = scope.with(name, Pieces::variable(second));
    }
    let value = |formula: &LocatedFormula| {
        evaluate(&formula.expr, &scope).map_err(|error| {
            let found = formula.diagnostic(&error);
            if !error.kind.is_other_real() {
                return found;
            }
            let message = "the inequalities of `where` have rational coefficients";
            Diagnostic { message: message.to_owned(), ..found }
        })
    };
    let mut planes = HalfPlanes::default();
    for comparison in &statement.inequalities {
        let (left, right) = (&comparison.left.formulas()[0], comparison.right());
        let (less, more) = match comparison.sign {
            Sign::Less | Sign::AtMost => (value(left)?, value(right)?),
            _ => (value(right)?, value(left)?),
        };
        let difference = less.minus(&more);
        let pieces = difference.convex().ok_or_else(|| {
            let message = "the points that satisfy this inequality are not shown to be convex";
            Diagnostic::new(&left.source, left.span.clone(), message).with_help(
                "take linear expressions in the two parameters with rational coefficients, and `abs` and `max` of such on the lesser side",
            )
        })?;
        planes.add(pieces, matches!(comparison.sign, Sign::Less | Sign::Greater));
    }
    Ok(planes)
}

/// Points in a polygon near its corners and the middles of its sides, these points themselves, and such points outside.
fn tried(corners: &[[Rational; 2]]) -> Vec<[Rational; 2]> {
    let mean = |points: &[&[Rational; 2]]| {
        let over = Rational::from(points.len()).recip();
        [0, 1].map(|i| points.iter().map(|point| point[i].clone()).sum::<Rational>() * &over)
    };
    let centre = mean(&corners.iter().collect::<Vec<_>>());
    let next = corners.iter().cycle().skip(1);
    let sides: Vec<[Rational; 2]> = corners.iter().zip(next).map(|(a, b)| mean(&[a, b])).collect();
    let edge: Vec<&[Rational; 2]> = corners.iter().chain(&sides).collect();
    let moved = |point: &[Rational; 2], part: &Rational| {
        [0, 1].map(|i| &point[i] + (&centre[i] - &point[i]) * part)
    };
    let mut points = vec![centre.clone()];
    for (p, q) in STEPS {
        let part = Rational::new(p, q);
        points.extend(edge.iter().map(|point| moved(point, &part)));
        points.extend(edge.iter().map(|point| moved(point, &-&part)));
    }
    points.extend(edge.into_iter().cloned());
    points
}
