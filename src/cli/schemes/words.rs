//! The facts of schemes in words.

use super::lattice::write_lattice;
use super::numbers::{decimal, level, number, shortened};
use crate::cli::console::lattice::sentence;
use crate::cli::console::quantity::{exponent_in_short, proved_continuity};
use crate::cli::ranges::sets::Set;
use crate::cli::ranges::special::write_special;
use std::collections::BTreeSet;
use subcert::facts::{Depths, FamilyFacts, ParameterFacts};
use subcert::report::json::{
    CurveForm, DepthForm, Exact, FactsForm, SpecialForm, StencilForm, ValenceForm,
};
use subcert::report::{Grid, SCOPE, Sheet};

/// How smooth its limits are, in a sentence.
pub(crate) fn summary(form: &FactsForm) -> String {
    let name = &form.scheme;
    match (&form.curve, &form.lattice) {
        (Some(curve), _) => {
            format!("{name}: {}; Hölder exponent: {}.", continuity(curve), hoelder(curve))
        }
        (None, Some(lattice)) => sentence(name, &lattice.smoothness),
        (None, None) => {
            format!("{name}: {}.", proved(form.valences.as_deref().unwrap_or_default()).1)
        }
    }
}

/// At how many of these valences C^1 is proven, also in words.
pub(crate) fn proved(valences: &[ValenceForm]) -> (usize, String) {
    let proved =
        |one: &&ValenceForm| one.vertex.as_ref().is_some_and(|found| found.verdict == "proved");
    let count = valences.iter().filter(proved).count();
    (count, format!("C^1 proven at {count} of {} valences", valences.len()))
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
    let special = family.special.as_ref();
    let special =
        special.map(|values| SpecialForm::all(values, &family.parameter)).unwrap_or_default();
    write_special(sheet, &special, &family.parameter);
}

pub(crate) fn sheet(facts: &FactsForm, family: Option<&FamilyFacts>) -> Sheet {
    let mut sheet = Sheet::titled(facts.scheme.clone());
    sheet.notes(&facts.notes);
    if let Some(curve) = &facts.curve {
        write_curve(curve, &mut sheet);
    }
    if let Some(lattice) = &facts.lattice {
        write_lattice(lattice, &mut sheet);
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
    let CurveWords { shape, smoothness, constants, limit } = curve_words(curve, &places([curve]));
    sheet.facts(shape);
    sheet.heading(2, "Polynomials and smoothness");
    sheet.facts(smoothness);
    sheet.heading(2, "Constants");
    let longest = curve.contraction.len().max(curve.norm.len());
    let row = |c: usize| vec![c.to_string(), level(&curve.contraction, c), level(&curve.norm, c)];
    sheet.grid(Grid::of(["c", "T_c", "Λ_c"], (1..=longest).map(row), 0));
    sheet.facts(constants);
    sheet.text(depth_note());
    if !limit.is_empty() {
        sheet.heading(2, "Limit");
        sheet.facts(limit);
    }
    if !curve.open.is_empty() {
        sheet.heading(2, "Open");
        sheet.facts(
            curve.open.iter().map(|one| (one.fact.to_owned(), one.reason.clone())).collect(),
        );
    }
}

/// What the depths are those of.
pub(crate) fn depth_note() -> String {
    format!(
        "Depths are those of polygons with differences up to 1, for the tolerance {}.",
        Depths::tolerance()
    )
}

/// Facts of a mask in words.
pub(crate) struct CurveWords {
    pub(crate) shape: Vec<(String, String)>,
    pub(crate) smoothness: Vec<(String, String)>,
    /// Without T_c and Λ_c.
    pub(crate) constants: Vec<(String, String)>,
    /// Empty where it is open.
    pub(crate) limit: Vec<(String, String)>,
}

/// Where the basic limit function of one of these is known not to be 0.
pub(crate) fn places<'a>(curves: impl IntoIterator<Item = &'a CurveForm>) -> BTreeSet<i64> {
    curves
        .into_iter()
        .flat_map(|curve| curve.values.iter().flatten())
        .map(|one| one.index)
        .collect()
}

/// Facts of a mask in words; the values of the basic limit function at these places.
pub(crate) fn curve_words(curve: &CurveForm, places: &BTreeSet<i64>) -> CurveWords {
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
    let shape = vec![
        fact("arity n", curve.arity.to_string()),
        fact("points of a rule", curve.points.to_string()),
        fact("primal or dual", curve.kind.unwrap_or("neither").to_owned()),
        fact("interpolating", yes(curve.interpolating)),
        fact("support", format!("from {} to {}", number(low), number(high))),
        fact("symmetry", symmetry),
    ];
    let smoothness = vec![
        fact("sum rules", format!("of order {}", curve.sum_rules)),
        fact("generated", format!("up to degree {}", curve.generation)),
        fact("reproduced", reproduced),
        fact("limits", continuity(curve)),
        fact("Hölder exponent", hoelder(curve)),
    ];
    let mut constants = vec![fact("σ", number(&curve.displacement))];
    if let Some(best) = &curve.best_offset {
        let text = format!("{} at offset {}", number(&best.displacement), best.offset);
        constants.push(fact("least σ", text));
    }
    constants.push(fact("depth at i/n^k", depth(curve.depth_indexed.as_ref())));
    constants.push(fact("depth at natural parameters", depth(curve.depth_natural.as_ref())));
    let mut limit = Vec::new();
    if let (Some(values), Some(stencils)) = (&curve.values, &curve.stencils) {
        let value = |at: &i64| {
            let found = values.iter().find(|one| one.index == *at);
            fact(&format!("φ({at})"), found.map_or("0".to_owned(), |one| number(&one.value)))
        };
        limit.extend(places.iter().map(value).chain(stencils.iter().map(stencil)));
    }
    CurveWords { shape, smoothness, constants, limit }
}

fn stencil(stencil: &StencilForm) -> (String, String) {
    let terms = stencil.weights.iter().map(|one| format!("{} x_{}", number(&one.value), one.index));
    let at = number(&stencil.parameter);
    (format!("limit at {at}"), terms.collect::<Vec<String>>().join("\n"))
}

/// C^m in words.
pub(crate) fn continuity(curve: &CurveForm) -> String {
    proved_continuity(curve.continuity, curve.continuity_fails)
}

/// The exponent in words.
pub(crate) fn hoelder(curve: &CurveForm) -> String {
    match &curve.hoelder {
        Some(found) => exponent_in_short(found),
        None => if curve.continuity_fails == Some(0) { "none" } else { "open" }.to_owned(),
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
