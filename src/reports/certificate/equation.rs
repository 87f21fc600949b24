//! Equations and other relations: whether they hold, and the difference of the sides where they do not.

use super::block::{Block, Certified, closed};
use super::parametric::place;
use super::radius::radius;
use crate::audit::{EquationFinding, EquationVerdict, Failure, Limits, OnReals, SideValue};
use crate::claim::{EquationBody, Identity, Paper};
use crate::exact::{Integer, Rational};
use crate::formula::{RealValue, Value as _};

impl Certified for EquationFinding<'_> {
    fn block(&self, _: &Paper) -> Block {
        let mut block = Block::new(self.equation.kind(), &self.equation.id);
        for (name, limits) in &self.limits {
            known(&mut block, name.as_deref(), limits);
        }
        match &self.equation.body {
            EquationBody::NotCheckable(absent) => block.restate("absent", absent),
            EquationBody::Identity(identity) => restate(&mut block, identity),
        }
        match &self.verdict {
            EquationVerdict::Holds { cases } => block.line(format!("holds {cases}")),
            EquationVerdict::Proved => block.line("holds all"),
            EquationVerdict::Tried { cases } => block.line(format!("tried {cases}")),
            EquationVerdict::Fails { cases, failures, .. } => {
                block.line(match &self.equation.body {
                    EquationBody::Identity(identity) if identity.is_for_all() => {
                        "fails all".to_owned()
                    }
                    _ => format!("fails {cases}"),
                });
                for failure in failures {
                    block.line(case(failure));
                }
            }
            EquationVerdict::Reals(found) => on_reals(&mut block, found, &self.equation.body),
            EquationVerdict::Undecided { .. } => block.give_up("bounds leave it open"),
            EquationVerdict::NotCheckable => {}
            EquationVerdict::BeyondCap(cap) => block.give_up(cap.to_string()),
        }
        block
    }
}

/// `holds reals`, or `fails reals` and the first number that shows it: `false 3 1/2`, `true 0`.
fn on_reals(block: &mut Block, found: &OnReals, body: &EquationBody) {
    let first = found.cases.iter().find_map(|case| Some((case, case.counterexample.as_ref()?)));
    let Some((case, number)) = first else { return block.line("holds reals".to_owned()) };
    block.line("fails reals".to_owned());
    let mut words: Vec<String> = case.indices.iter().map(ToString::to_string).collect();
    words.insert(found.place.min(words.len()), place(&number.value));
    let several = matches!(body, EquationBody::Identity(body) if body.comparisons.len() > 1);
    if let Some(comparison) = number.fails.filter(|_| several) {
        words.push((comparison + 1).to_string());
    }
    let truth = if number.fails.is_some() { "false" } else { "true" };
    block.line(format!("{truth} {}", words.join(" ")));
}

fn restate(block: &mut Block, identity: &Identity) {
    if let Some(states) = &identity.states {
        return states.iter().for_each(|text| block.restate("states", text));
    }
    let equation = identity.first();
    for left in equation.left.formulas() {
        block.restate("left", &left.text);
    }
    block.restate("right", &equation.right().text);
}

/// `limits four-point:w=1/16`, and what is shown of the limits of this scheme.
fn known(block: &mut Block, name: Option<&str>, limits: &Limits) {
    match name {
        Some(name) => block.line(format!("limits {name}")),
        None => block.give_up("certificates name schemes with rational parameters"),
    }
    let Some(lines) = radius(block, limits) else { return };
    let known = &limits.smoothness;
    if lines.continuous != known.continuity || lines.not_continuous != known.continuity_fails {
        block.give_up("the rational bounds of the joint spectral radius show less");
    }
}

/// The bits behind the point of the bounds of a difference.
const PLACES: u32 = 40;

/// Bounds l < h of a real number, with room for the enclosures of others.
fn bounds(value: &RealValue) -> [Rational; 2] {
    let interval = value.interval();
    let unit = Rational::from(Integer::one().shifted_left(PLACES));
    let room = interval.width() + unit.recip();
    let low = ((interval.lower() - &room) * &unit).floor();
    let high = ((interval.upper() + &room) * &unit).ceil();
    [low, high].map(|end| Rational::from(end) / &unit)
}

/// `case 3 1/2 = p[0]-p[1]`, or `case 3 in 1/8 1/4`.
fn case(failure: &Failure) -> String {
    let mut line = "case".to_owned();
    for value in &failure.indices {
        line.extend([" ", &value.to_string()]);
    }
    match failure.difference() {
        SideValue::Polynomial(difference) => format!("{line} = {}", closed(&difference)),
        SideValue::Real(difference) => {
            if let Some(number) = difference.number() {
                return format!("{line} = {}", closed(&number));
            }
            let [low, high] = bounds(&difference);
            format!("{line} in {low} {high}")
        }
    }
}
