//! `subcert smoothness` of rules around a vertex or on a face.

use super::arguments::{SmoothnessArguments, Valences};
use super::json::{SCHEMA, vertex as form};
use super::output::{Failure, Outcome, show};
use super::spectrum::failure;
use subcert::characteristic::{Family, ORDERED, Vertex, regular_for_all_valences};
use subcert::report::json::VertexForm;
use subcert::report::{Grid, SCOPE, Sheet, VERTEX_HEADER, vertex_facts, vertex_row};

pub(super) fn vertex(arguments: &SmoothnessArguments) -> Outcome {
    let scheme = &arguments.scheme;
    let (mut all, mut found) = (None, Vec::new());
    match arguments.valences {
        None => found.push(Vertex::of(scheme, None).map_err(failure)?),
        Some(Valences::Some(first, last)) => {
            for n in first..=last {
                found.push(Vertex::of(scheme, Some(n)).map_err(failure)?);
            }
        }
        Some(Valences::All) => {
            let known = ORDERED.iter().find(|(name, _)| name == scheme);
            let (_, family) = known.ok_or_else(|| {
                let names = ORDERED.map(|(name, _)| name).join(", ");
                Failure::Input(format!(
                    "all valences at once are known of {names}; of other rules, give a range such as 3..50"
                ))
            })?;
            all = Some((*family, regular_for_all_valences(*family)));
        }
    }
    show(
        arguments.output.format,
        || sheet(scheme, all, &found),
        || form::Vertices {
            schema: SCHEMA,
            scheme,
            scope: SCOPE,
            all_valences: all.map(|(_, holds)| holds),
            valences: found.iter().map(VertexForm::of).collect(),
        },
    )
}

fn sheet(scheme: &str, all: Option<(Family, bool)>, found: &[Vertex]) -> Sheet {
    let mut sheet = Sheet::default();
    sheet.heading(1, format!("{scheme}: smoothness at the vertex or on the face"));
    if let Some((family, holds)) = all {
        let verdict = if holds { "proved for all valences n >= 3" } else { "open" };
        let map = "all Bernstein coefficients of the Jacobian and of the half-plane are positive, as polynomials \
                   in one variable, by Sturm's theorem";
        let order = "0 < λ < 1, from the blocks 1 and n − 1, and above all others, for every n: theorem 135 of \
                     proofs/THEOREMS.md";
        let facts = [
            ("C^1", verdict),
            ("ring", family.pieces()),
            ("characteristic map", if holds { map } else { "not decided" }),
            ("eigenvalues", order),
        ];
        sheet.facts(facts.map(|(a, b)| (a.to_owned(), b.to_owned())).to_vec());
    } else if let [vertex] = found {
        sheet.facts(vertex_facts(vertex));
    } else {
        let rows = found.iter().map(vertex_row).collect();
        let header = VERTEX_HEADER.map(str::to_owned).to_vec();
        sheet.grid(Grid { header, rows, left_columns: 0 });
    }
    sheet.text(format!("{SCOPE}."));
    sheet
}
