//! Certificates of the limits of masks on Z^d. `proofs/format/lattice.md`.

use super::radius::{
    limits, line, numbers, write_basis, write_hull, write_radius, write_reduction,
};
use super::shown::Shown;
use crate::exact::{LogSum, LogTerm, Rational};
use crate::lattice::{Figure, LatticeRadius, LatticeSmoothness, Motion, RangePiece, RangeProof};
use crate::scheme::{LatticeMask, Mask};
use crate::smoothness::Smoothness;
use crate::stop::Stop;
use std::fmt::Write as _;

/// The lines about the limits of a mask on Z^d, and what they show; or why there are none.
pub(super) fn lattice_limits(
    mask: &LatticeMask,
    known: &LatticeSmoothness,
) -> Result<(String, Shown), &'static str> {
    if let Some(factors) = &known.factors {
        return of_factors(factors);
    }
    // What directions of a box spline decide, radii have to show here.
    let by_radii;
    let known = if known.radius.is_none() && known.accuracy.is_some() {
        by_radii = LatticeSmoothness::by_radii(mask, &Stop::default());
        &by_radii
    } else {
        known
    };
    let mut text = String::new();
    let d = mask.dimension();
    if let Some((c, _)) = &known.contraction {
        line(&mut text, "contraction", &c.to_string());
    } else {
        let found = known.differences.as_ref().ok_or("convergence is open")?;
        text.push_str("differences\n");
        parts(&mut text, &found.parts, d);
        let bounds = write_radius_of(&mut text, found)?;
        if known.converges == Some(false) && bounds.lower.is_some_and(|q| q >= Rational::one()) {
            text.push_str("end\n");
            return Ok((text, Shown { not_continuous: Some(0), ..Shown::default() }));
        }
        if bounds.upper >= Rational::one() {
            return Err("the rational bounds of the joint spectral radius do not show this");
        }
    }
    let (n, power) = base(mask);
    let mut shown = Shown { continuous: Some(0), bases: vec![n], ..Shown::default() };
    if let Some(found) = &known.radius {
        tile(&mut text, found.figure, &found.parts, d);
        line(&mut text, "accuracy", &found.order.to_string());
        let bounds = write_radius_of(&mut text, found)?;
        bounds.conclude(&mut shown, found, (n, power), mask);
    }
    text.push_str("end\n");
    Ok((text, shown))
}

/// n and 1 if m = n^d, and otherwise m and d: log_s x = power·log_base x.
fn base(mask: &LatticeMask) -> (usize, usize) {
    let dilation = mask.dilation();
    dilation.root().map_or((dilation.class_count(), dilation.dimension()), |n| (n, 1))
}

/// The bounds that the lines of a radius show.
struct Bounds {
    /// The radius is not above it.
    upper: Rational,
    /// It is not above the radius to this power.
    lower: Option<Rational>,
    degree: usize,
}

impl Bounds {
    /// What follows for the limits, with the radius of the steps times a factor.
    fn conclude(
        &self,
        shown: &mut Shown,
        found: &LatticeRadius,
        (base, power): (usize, usize),
        mask: &LatticeMask,
    ) {
        let (m, d) = (mask.dilation().class_count(), mask.dimension());
        let accuracy = usize::try_from(found.order).expect("a small number");
        let raised = |x: &Rational, k: usize| x.pow(i32::try_from(k).expect("a small number"));
        let below = |k: usize| raised(&(&self.upper / &found.factor), d) * raised(&m.into(), k);
        let above = |k: usize| {
            let lower = self.lower.as_ref()? / &raised(&found.factor, self.degree);
            Some(raised(&lower, d) * raised(&m.into(), k * self.degree) >= Rational::one())
        };
        shown.continuous = (0..accuracy).take_while(|k| below(*k) < Rational::one()).last();
        shown.continuous = shown.continuous.or(Some(0));
        shown.not_continuous = (1..accuracy).find(|k| above(*k) == Some(true)).or(Some(accuracy));
        let exponent = |of: &Rational, degree: usize| {
            let factor =
                -Rational::new(i64::try_from(power).unwrap_or(1), 1) / Rational::from(degree);
            let whole = (0..=128).find(|j| raised(&base.into(), *j) >= found.factor).unwrap_or(0);
            LogSum {
                rational: Rational::from(whole * power),
                terms: vec![LogTerm { factor, base, of: of.clone() }],
            }
        };
        shown.lower = vec![exponent(&self.upper, 1)];
        let upper = self.lower.as_ref().map(|of| exponent(of, self.degree));
        let most = LogSum { rational: Rational::from(accuracy), terms: Vec::new() };
        shown.upper = upper.into_iter().chain([most]).collect();
    }
}

fn write_radius_of(text: &mut String, found: &LatticeRadius) -> Result<Bounds, &'static str> {
    let hull = found.radius.hull.as_ref().ok_or("no invariant hull is found")?;
    let lower = write_radius(text, &found.matrices, &found.radius, hull);
    Ok(Bounds { upper: hull.bound.clone(), lower, degree: found.radius.degree })
}

/// What shows that all limits are C^m for all values of an interval.
pub(super) fn cover(proof: &RangeProof, d: usize) -> String {
    let mut text = String::new();
    tile(&mut text, proof.figure, &proof.parts, d);
    if let Some(reduction) = &proof.reduction {
        write_reduction(&mut text, reduction);
    }
    for block in &proof.blocks {
        line(&mut text, "block", "");
        for RangePiece { ends, hull } in block {
            line(&mut text, "piece", &numbers(ends));
            if let Some([basis, inverse]) = &hull.basis {
                write_basis(&mut text, [basis, inverse], &[basis.len()]);
            }
            write_hull(&mut text, &hull.hull);
        }
    }
    text
}

fn tile(text: &mut String, figure: Option<Figure>, all: &[Motion], d: usize) {
    let figure = match figure {
        None => "digits",
        Some(Figure::Square) => "square",
        Some(Figure::HexagonSum) => "hexagon +",
        Some(Figure::HexagonDifference) => "hexagon -",
        Some(Figure::Cube) => "cube",
    };
    line(text, "tile", figure);
    parts(text, all, d);
}

/// The motions x ↦ Gx + t: the rows of G, and t.
fn parts(text: &mut String, parts: &[Motion], d: usize) {
    for part in parts {
        let rows = part.matrix[..d].iter().chain([&part.shift]);
        let all = rows.flat_map(|row| &row[..d]).fold(String::new(), |mut all, x| {
            write!(all, " {x}").expect("a text in memory");
            all
        });
        line(text, "part", all.trim_start());
    }
}

/// The lines about a product of masks of curves.
fn of_factors(factors: &[(Mask, Smoothness)]) -> Result<(String, Shown), &'static str> {
    let mut text = String::from("factors\n");
    let mut all = Vec::new();
    for (mask, smoothness) in factors {
        let lines = limits(smoothness).ok_or("no invariant hull is found")?;
        text.push_str(&lines.text);
        all.push(Shown::of_curve(&lines, mask.arity()));
    }
    Ok((text, Shown::of_factors(all)))
}
