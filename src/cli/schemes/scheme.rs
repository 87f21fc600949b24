//! `subcert scheme`.

use crate::cli::arguments::SchemeArguments;
use crate::cli::console::answer::{Answer, show};
use crate::cli::console::output::{Failure, Outcome};
use crate::cli::console::progress::Progress;
use crate::cli::console::quantity::{is_fraction, written};
use crate::cli::ranges::sets::Set;
use subcert::facts::{Depths, FamilyFacts, ParameterFacts, SchemeFacts};
use subcert::report::json::{
    CurveForm, DepthForm, Exact, Facts, FactsForm, StencilForm, ValenceForm,
};
use subcert::report::{Grid, SCOPE, Sheet};
use subcert::scheme::{AnyScheme, parse_any_scheme};

pub(crate) fn scheme(arguments: &SchemeArguments) -> Outcome {
    let name = &arguments.scheme;
    if let Ok(AnyScheme::Uniform(scheme)) = parse_any_scheme(name)
        && scheme.masks().len() > 1
    {
        return Err(Failure::Input(format!(
            "`{name}` is a tensor product; its facts are those of its factors: ask for them one by one"
        )));
    }
    let progress = Progress::of_search(true);
    let facts = FactsForm::of(name, &SchemeFacts::of(name)?);
    let family = FamilyFacts::of(name);
    drop(progress);
    show(&arguments.output, &Scheme { facts, family })
}

/// What is known of a scheme, and of its family.
pub(crate) struct Scheme {
    facts: FactsForm,
    family: Option<FamilyFacts>,
}

written!(this: Scheme => Facts<'_>, Facts::of(&this.facts, this.family.as_ref()));

impl Answer for Scheme {
    const NAME: &'static str = "scheme";

    fn sheet(&self) -> Sheet {
        sheet(&self.facts, self.family.as_ref())
    }
}

/// Where in the parameter of its family the limits are C^m.
fn write_family(family: &FamilyFacts, sheet: &mut Sheet) {
    sheet.heading(2, format!("The family, in {}", family.parameter));
    let row = |range: &ParameterFacts| {
        let [inside, outside] =
            [&range.inside, &range.outside].map(|set| Set::of(set, &family.parameter));
        let but = if range.but_finitely_many { "\nbut for finitely many" } else { "" };
        vec![format!("C^{}", range.m), inside.proved(&outside), format!("{}{but}", outside.found())]
    };
    sheet.grid(Grid::of(["", "all limits", "not all"], family.ranges.iter().map(row), 3));
    let end = &family.end;
    sheet.text(format!("What is in neither set is open; `subcert range` looks closer. {end}."));
}

pub(crate) fn sheet(facts: &FactsForm, family: Option<&FamilyFacts>) -> Sheet {
    let mut sheet = Sheet::titled(facts.scheme.clone());
    if let Some(curve) = &facts.curve {
        write_curve(curve, &mut sheet);
    }
    if let Some(family) = family {
        write_family(family, &mut sheet);
    }
    if let Some(valences) = &facts.valences {
        sheet.grid(Grid::of(VALENCE_HEADER, valences.iter().map(valence_row), 0));
        sheet.text(valence_note());
        let open =
            valences.iter().filter_map(|one| Some((one.valence.to_string(), one.open.clone()?)));
        let open: Vec<(String, String)> = open.collect();
        if !open.is_empty() {
            sheet.heading(2, "Open");
            sheet.facts(open);
        }
    }
    sheet
}

fn write_curve(curve: &CurveForm, sheet: &mut Sheet) {
    let fact = |name: &str, text: String| (name.to_owned(), text);
    let yes = |holds: bool| if holds { "yes" } else { "no" }.to_owned();
    let [low, high] = &curve.support;
    let symmetry = curve
        .centre
        .as_ref()
        .map_or("none".to_owned(), |centre| format!("about {}", number(centre)));
    let reproduced = match &curve.natural_shift {
        Some(shift) => format!(
            "up to degree {}, with x^k_i at (i + s)/{}^k, s = {}",
            curve.reproduction,
            curve.arity,
            number(shift)
        ),
        None => "only constants: lines are not kept".to_owned(),
    };
    sheet.facts(vec![
        fact("arity n", curve.arity.to_string()),
        fact("points of a rule", curve.points.to_string()),
        fact("primal or dual", curve.kind.unwrap_or("neither").to_owned()),
        fact("interpolating", yes(curve.interpolating)),
        fact("support", format!("from {} to {}", number(low), number(high))),
        fact("symmetry", symmetry),
    ]);
    sheet.heading(2, "Polynomials and smoothness");
    sheet.facts(vec![
        fact("sum rules", format!("of order {}", curve.sum_rules)),
        fact("generated", format!("up to degree {}", curve.generation)),
        fact("reproduced", reproduced),
        fact("limits", continuity(curve)),
        fact("Hölder exponent", hoelder(curve)),
    ]);
    sheet.heading(2, "Constants");
    let longest = curve.contraction.len().max(curve.norm.len());
    let cell = |value: Option<&Exact>| value.map_or("open".to_owned(), decimal);
    let row = |i: usize| {
        vec![(i + 1).to_string(), cell(curve.contraction.get(i)), cell(curve.norm.get(i))]
    };
    sheet.grid(Grid::of(["c", "T_c", "Λ_c"], (0..longest).map(row), 0));
    let mut constants = vec![fact("σ", number(&curve.displacement))];
    if let Some(best) = &curve.best_offset {
        let text = format!("{} at offset {}", number(&best.displacement), best.offset);
        constants.push(fact("least σ", text));
    }
    constants.push(fact("depth at i/n^k", depth(curve.depth_indexed.as_ref())));
    constants.push(fact("depth at natural parameters", depth(curve.depth_natural.as_ref())));
    sheet.facts(constants);
    let tolerance = Depths::tolerance();
    sheet.text(format!(
        "Depths are those of polygons with differences up to 1, for the tolerance {tolerance}."
    ));
    if let (Some(values), Some(stencils)) = (&curve.values, &curve.stencils) {
        sheet.heading(2, "Limit");
        let mut facts: Vec<(String, String)> =
            values.iter().map(|one| (format!("φ({})", one.index), number(&one.value))).collect();
        facts.extend(stencils.iter().map(stencil));
        sheet.facts(facts);
    }
    if !curve.open.is_empty() {
        sheet.heading(2, "Open");
        sheet.facts(curve.open.iter().map(|one| fact(one.fact, one.reason.clone())).collect());
    }
}

fn stencil(stencil: &StencilForm) -> (String, String) {
    let terms = stencil.weights.iter().map(|one| format!("{} x_{}", number(&one.value), one.index));
    let at = number(&stencil.parameter);
    (format!("limit at {at}"), terms.collect::<Vec<String>>().join("\n"))
}

/// The longest exact value that is shown.
const LONGEST: usize = 32;

/// The digits of a decimal.
const DIGITS: usize = 12;

/// The exact value where that is a short fraction, or else a decimal.
pub(crate) fn number(value: &Exact) -> String {
    let fraction = is_fraction(&value.exact) && value.exact.len() <= LONGEST;
    if fraction { value.exact.clone() } else { decimal(value) }
}

/// A decimal, cut to a few digits.
fn decimal(value: &Exact) -> String {
    shortened(&value.decimal)
}

/// A decimal without the digits beyond a few places, which are cut.
fn shortened(decimal: &str) -> String {
    if decimal.contains('e') {
        return decimal.to_owned();
    }
    match decimal.split_once('.') {
        Some((whole, places)) if places.len() > DIGITS => {
            let places = places[..DIGITS].trim_end_matches('0');
            format!("{whole}.{places}…")
        }
        _ => decimal.to_owned(),
    }
}

/// C^m in words.
pub(crate) fn continuity(curve: &CurveForm) -> String {
    match (curve.continuity, curve.continuity_fails) {
        (_, Some(0)) => "diverges".to_owned(),
        (Some(m), Some(fails)) if fails == m + 1 => format!("C^{m}, not C^{fails}"),
        (Some(m), Some(fails)) => format!("C^{m}, not C^{fails}; between is open"),
        (Some(m), None) => format!("C^{m} at least"),
        (None, Some(fails)) => format!("convergence is open, not C^{fails}"),
        (None, None) => "open".to_owned(),
    }
}

/// The exponent in words.
pub(crate) fn hoelder(curve: &CurveForm) -> String {
    let Some(found) = &curve.hoelder else {
        return if curve.continuity_fails == Some(0) { "none" } else { "open" }.to_owned();
    };
    let not = if found.attained == Some(false) { ", not attained" } else { "" };
    match &found.exact {
        Some(exact) if is_fraction(exact) => format!("{exact}{not}"),
        Some(exact) if exact.len() <= LONGEST => format!("{exact} = {}…{not}", found.lower),
        Some(_) => format!("{}…{not}", found.lower),
        None => format!("open: from {} to {}", found.lower, found.upper),
    }
}

/// A depth in words.
pub(crate) fn depth(depth: Option<&DepthForm>) -> String {
    match depth {
        None => "open".to_owned(),
        Some(DepthForm { lower, upper }) if lower == upper => upper.to_string(),
        Some(DepthForm { lower, upper }) => format!("{lower} to {upper}"),
    }
}

/// What the columns of [`VALENCE_HEADER`] mean.
pub(crate) fn valence_note() -> String {
    format!("{SCOPE}. μ is the greatest modulus after λ.")
}

/// The columns of [`valence_row`].
pub(crate) const VALENCE_HEADER: [&str; 6] = ["n", "C^1", "λ", "μ", "Hölder α", "curvature"];

/// A valence in a line.
pub(crate) fn valence_row(one: &ValenceForm) -> Vec<String> {
    let vertex = one.vertex.as_ref();
    let shown = |value: Option<&Exact>| value.map_or("open".to_owned(), decimal);
    let exponent = vertex.and_then(|vertex| vertex.hoelder.as_ref());
    let curvature = vertex.and_then(|vertex| vertex.curvature);
    vec![
        one.valence.to_string(),
        vertex.map_or("open", |vertex| vertex.verdict).to_owned(),
        shown(vertex.and_then(|vertex| vertex.subdominant.as_ref())),
        shown(one.next.as_ref()),
        exponent.map_or("open".to_owned(), |ends| shortened(&ends[0])),
        curvature.unwrap_or("open").to_owned(),
    ]
}
