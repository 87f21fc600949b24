//! The facts of masks on Z^d in words.

use super::numbers::{level, number};
use crate::cli::console::lattice::{matrix, smoothness_words, vector};
use subcert::report::json::{Exact, LatticeForm, ValueForm};
use subcert::report::{Grid, Sheet};

/// Facts of a mask on Z^d in words, under their headings; those without one first.
pub(crate) fn lattice_words(form: &LatticeForm) -> Vec<(&'static str, Vec<(String, String)>)> {
    let fact = |name: &str, text: String| (name.to_owned(), text);
    let yes = |holds: bool| if holds { "yes" } else { "no" }.to_owned();
    let support = form.support.as_ref().map_or("not computed".to_owned(), |axes| {
        let axis = |[low, high]: &[Exact; 2]| format!("[{}, {}]", number(low), number(high));
        axes.iter().map(axis).collect::<Vec<String>>().join(" × ")
    });
    let shift = form.natural_shift.iter().map(number).collect::<Vec<String>>().join(", ");
    let reproduced = if form.generation == 0 {
        "only constants: lines are not kept".to_owned()
    } else {
        format!("up to degree {}, with x^k_α at M^-k (α + τ), τ = ({shift})", form.reproduction)
    };
    let shape = vec![
        fact("dilation matrix M", matrix(&form.dilation)),
        fact("rules", form.arity.to_string()),
        fact("coefficients", form.coefficients.to_string()),
        fact("edges", form.edges.iter().map(|edge| vector(edge)).collect::<Vec<_>>().join(" ")),
        fact("primal or dual", form.kind.unwrap_or("neither").to_owned()),
        fact("interpolating", yes(form.interpolating)),
        fact("support in", support),
        fact("symmetries", form.symmetries.to_string()),
    ];
    let mut polynomials = vec![
        fact("sum rules", format!("of order {}", form.sum_rules)),
        fact("generated", format!("up to degree {}", form.generation)),
        fact("reproduced", reproduced),
    ];
    polynomials.extend(smoothness_words(&form.smoothness, Some(form.sum_rules)));
    vec![("", shape), ("Polynomials and smoothness", polynomials)]
}

/// The most values in words.
const MAX_VALUES: usize = 30;

/// The values with their places, the greatest first: `1/2 at (2,2); 1/12 at (1,1) (1,2)`.
fn grouped(values: &[ValueForm]) -> String {
    if values.len() > MAX_VALUES {
        return format!("at {} points, which the JSON has", values.len());
    }
    let mut groups: Vec<(&Exact, Vec<String>)> = Vec::new();
    for one in values {
        let place = vector(&one.place);
        match groups.iter_mut().find(|(value, _)| **value == one.value) {
            Some((_, places)) => places.push(place),
            None => groups.push((&one.value, vec![place])),
        }
    }
    groups.sort_by_key(|(_, places)| places.len());
    let group = |(value, places): &(&Exact, Vec<String>)| {
        format!("{} at {}", number(value), places.join(" "))
    };
    groups.iter().map(group).collect::<Vec<String>>().join("; ")
}

pub(crate) fn write_lattice(form: &LatticeForm, sheet: &mut Sheet) {
    for (title, facts) in lattice_words(form) {
        if !title.is_empty() {
            sheet.heading(2, title);
        }
        sheet.facts(facts);
    }
    sheet.heading(2, "Constants");
    let longest = form.contraction.len().max(form.norm.len());
    let row = |c: usize| vec![c.to_string(), level(&form.contraction, c), level(&form.norm, c)];
    sheet.grid(Grid::of(["c", "T_c", "Λ_c"], (1..=longest).map(row), 0));
    if let (Some(indexed), Some(natural)) = (&form.displacement, &form.displacement_natural) {
        sheet.facts(vec![
            ("σ at M^-k α".to_owned(), number(indexed)),
            ("σ at natural places".to_owned(), number(natural)),
        ]);
    }
    if let Some(values) = &form.values {
        sheet.heading(2, "Limit");
        sheet.facts(vec![("φ at integers".to_owned(), grouped(values))]);
        sheet.text("The limit of data p at α is Σ_β φ(α − β) p_β.");
    }
    if !form.open.is_empty() {
        sheet.heading(2, "Open");
        let open = form.open.iter().map(|one| (one.fact.to_owned(), one.reason.clone()));
        sheet.facts(open.collect());
    }
}
