//! `subcert smoothness` of rules around a vertex or on a face.

use crate::cli::arguments::{SmoothnessArguments, Valences};
use crate::cli::console::answer::{Answer, SCHEMA, deliver};
use crate::cli::console::destination::Destination;
use crate::cli::console::output::{Failure, Outcome};
use crate::cli::spectrum::ring::{failure, failure_without_valence};
use serde::Serialize;
use subcert::characteristic::{Family, Vertex, ordered, regular_for_all_valences};
use subcert::report::html::Picture;
use subcert::report::json::VertexForm;
use subcert::report::{
    Grid, SCOPE, Sheet, VERTEX_HEADER, verdict_name, verdict_reason, vertex_facts, vertex_row,
};
use subcert::scheme::notes;

pub(crate) fn vertex(arguments: &SmoothnessArguments, to: &Destination) -> Outcome {
    let scheme = &arguments.scheme;
    let (mut all, mut found) = (None, Vec::new());
    match arguments.valences {
        None => {
            let vertex = Vertex::of(scheme, None);
            found.push(vertex.map_err(|error| failure_without_valence(error, "--valences 5"))?);
        }
        Some(Valences::Some(first, last)) => {
            for n in first..=last {
                found.push(Vertex::of(scheme, Some(n)).map_err(failure)?);
            }
        }
        Some(Valences::All) => {
            let known = ordered().find(|(name, _)| name == scheme);
            let (_, family) = known.ok_or_else(|| {
                let names = ordered().map(|(name, _)| name).collect::<Vec<&str>>().join(", ");
                Failure::Input(format!(
                    "all valences at once are known of {names}; of other rules, give a range such as 3..50"
                ))
            })?;
            all = Some((family, regular_for_all_valences(family)));
        }
    }
    let answer = Vertices {
        schema: SCHEMA,
        scheme,
        notes: notes(scheme),
        scope: SCOPE,
        all_valences: all.map(|(_, holds)| holds),
        valences: found.iter().map(VertexForm::of).collect(),
        found,
        family: all.map(|(family, _)| family),
    };
    deliver(to, &answer)
}

/// One valence or several.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct Vertices<'a> {
    /// The version of this form.
    schema: u32,
    /// The scheme as it was given.
    scheme: &'a str,
    /// What is to be told of the numbers, such as that they are those of several steps; missing where there is nothing.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    notes: Vec<String>,
    /// What «C¹» means here.
    scope: &'static str,
    /// Whether the surface is proved C¹ at all valences from 3 on; absent unless asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    all_valences: Option<bool>,
    /// The valences.
    valences: Vec<VertexForm>,
    /// What is known of them, for words and pictures.
    #[serde(skip)]
    found: Vec<Vertex>,
    /// The family, if all valences are asked for.
    #[serde(skip)]
    family: Option<Family>,
}

impl Answer for Vertices<'_> {
    const NAME: &'static str = "smoothness-vertex";

    fn sheet(&self) -> Sheet {
        let mut sheet =
            Sheet::titled(format!("{}: smoothness at the vertex or on the face", self.scheme));
        sheet.notes(&self.notes);
        if let Some((family, holds)) = self.family.zip(self.all_valences) {
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
        } else if let [vertex] = &self.found[..] {
            sheet.facts(vertex_facts(vertex));
        } else {
            sheet.grid(Grid::of(VERTEX_HEADER, self.found.iter().map(vertex_row), 0));
        }
        sheet.text(format!("{SCOPE}."));
        sheet
    }

    fn sentence(&self) -> String {
        match (self.all_valences, &self.found[..]) {
            (Some(true), _) => "C^1 is proved for all valences n >= 3.".to_owned(),
            (Some(_), _) => "It is open whether surfaces are C^1 for all valences.".to_owned(),
            (None, [vertex]) => {
                let verdict = &vertex.verdict;
                format!(
                    "C^1 at valence {}: {}, as {}.",
                    vertex.spectrum.order,
                    verdict_name(verdict),
                    verdict_reason(verdict)
                )
            }
            (None, found) => {
                let proved = |vertex: &&Vertex| verdict_name(&vertex.verdict) == "proved";
                format!(
                    "C^1 is proved at {} of {} valences.",
                    found.iter().filter(proved).count(),
                    found.len()
                )
            }
        }
    }

    fn pictures(&self) -> Vec<Picture> {
        match &self.found[..] {
            [vertex] => Picture::of_ring(vertex).into_iter().collect(),
            _ => Vec::new(),
        }
    }
}
