//! Theorems of a paper that data refute: one instance, and the bound there.

#![warn(clippy::arithmetic_side_effects)]

use super::read::Theorems;
use super::stated::{comment, masks, parameters, placed, ring};
use super::statement::{Argument, Theorem};
use crate::claims::Paper;
use crate::data::{Points, Setting};
use crate::kinds::theorem::instance::{Instance, first_level, points};
use crate::kinds::theorem::sides::Stated;
use crate::numbers::{Q, Value, int, read_rational};
use crate::text::{At, Checked, Reason, Toml, compare, require};
use num_traits::Signed;

/// Compares theorems with a theorem of the paper.
pub fn agree<'a>(paper: &'a Paper<'a>, claim: &'a Toml, file: &Theorems) -> Checked<()> {
    if let Some((name, _)) = file.assumed.first() {
        return Err(Reason::Recovered(name.clone()).into());
    }
    for theorem in &file.statements {
        one(paper, claim, theorem).at(theorem.line)?;
    }
    Ok(())
}

/// An instance that a comment names: the reference to the scheme, the values, the level, ε, and the parameters of points.
struct Named {
    reference: String,
    values: Vec<(String, Value)>,
    level: u32,
    tolerance: Option<Q>,
    points: Points,
}

fn one<'a>(paper: &'a Paper<'a>, claim: &'a Toml, theorem: &Theorem) -> Checked<()> {
    let of = |key: &str| claim.text(key).unwrap_or_default();
    let place = comment(&format!("{}: {}", of("locus"), of("title")));
    compare(theorem.place == place, &theorem.place, &place, Reason::Stated)?;
    let depth = of("bounds") == "depth";
    let named = named(paper, claim, &theorem.about, depth)?;
    let Named { reference, values, level, tolerance, points } = named;
    let Instance { scope, schemes, offset, setting } =
        Instance::new(paper, claim, &reference, values)?;
    require(level >= first_level(claim)?, Reason::Level)?;
    let quantity = if depth { "distance" } else { of("bounds") };
    let stated = self::points(claim)?;
    require(
        stated == Points::Indexed || points == stated,
        Reason::Malformed("natural parameters"),
    )?;
    let stated = Stated { quantity, level, tolerance: tolerance.map(Value::from) };
    // The data of the statement have the spread 1.
    let bound = stated.bound(claim, scope, &[int(1), int(1)])?;
    let bound = bound.rational().ok_or(Reason::Malformed("a rational bound"))?;
    let (form, mut expected) = match &setting {
        Setting::LocalRules(rules, interpolant) => {
            require(points == Points::Indexed, Reason::Malformed("masks"))?;
            let mut rings = vec![ring(rules, &rules.weights)?];
            match of("bounds") {
                // Without an interpolant each point is compared with itself.
                "step" => rings.push(match interpolant {
                    Some(interpolant) => ring(rules, &interpolant.weights)?,
                    None => ring(rules, &rules.units())?,
                }),
                "difference" => {}
                _ => require(interpolant.is_none(), Reason::NoLimit)?,
            }
            ("ring_", rings)
        }
        Setting::Masks(rules, _) => {
            let form = if rules.len() > 1 { "net_" } else { "" };
            let of = match quantity {
                "difference" => {
                    // Differences have no parameter.
                    require(points == Points::Indexed, Reason::Malformed("a step or a distance"))?;
                    masks(schemes.iter().map(|scheme| &**scheme), offset)?
                }
                _ => placed(paper.library, &schemes, offset, points)?,
            };
            (form, of)
        }
    };
    expected.push(Argument::Level(level));
    expected.extend([int(1), bound].map(Argument::Number));
    super::stated::stated(theorem, &format!("exceeds_{form}{quantity}"), &expected)
}

/// Reads `Refuted for SCHEME, NAME = VALUE at level K; the bound is BY`, or for a depth
/// `… at level K and tolerance NUMBER; the depth is BY`.
fn named<'a>(paper: &'a Paper<'a>, claim: &'a Toml, about: &str, depth: bool) -> Checked<Named> {
    let malformed = || Reason::Malformed("Refuted for SCHEME, VALUES at level K; the bound is BY");
    let (points, said) = parameters(about, "Refuted").ok_or_else(malformed)?;
    let said = said.strip_prefix("for ").ok_or_else(malformed)?;
    let by = comment(claim.text("by").unwrap_or_default());
    let end = format!("; the {} is {by}", if depth { "depth" } else { "bound" });
    let said = said.strip_suffix(&end[..]);
    let said = said.ok_or_else(|| Reason::Stated(about.to_owned().into(), end.into()))?;
    let (instance, level) = said.rsplit_once(" at level ").ok_or_else(malformed)?;
    let (level, tolerance) = match (level.split_once(" and tolerance "), depth) {
        (Some((level, number)), true) => {
            let number = read_rational(number).filter(Q::is_positive).ok_or_else(malformed)?;
            (level, Some(number))
        }
        (None, false) => (level, None),
        _ => return Err(malformed().into()),
    };
    let said = level;
    let level: u32 = level.parse().map_err(|_| malformed())?;
    require(level.to_string() == said, malformed())?;
    // The longest reference that the text begins with; the values follow it.
    let known = claim.list("schemes").iter().map(Toml::as_text).chain([claim.text("scheme")]);
    let mut known: Vec<String> = known.flatten().map(comment).collect();
    known.sort_by_key(|reference| std::cmp::Reverse(reference.len()));
    let begins = |reference: &&String| {
        let rest = instance.strip_prefix(&reference[..]);
        rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(", "))
    };
    let reference = known.iter().find(begins);
    let reference = reference
        .ok_or_else(|| Reason::Stated(instance.to_owned().into(), known.join(", ").into()))?;
    let mut values = Vec::new();
    for value in instance[reference.len()..].split(", ").skip(1) {
        let (name, value) = value.split_once(" = ").ok_or_else(malformed)?;
        values.push((name.to_owned(), paper.number(value)?));
    }
    Ok(Named { reference: reference.clone(), values, level, tolerance, points })
}
