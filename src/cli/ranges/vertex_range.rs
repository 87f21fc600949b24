//! `subcert range --smoothness` of rules around a vertex or on a face.

use super::sets::{Set, write_irrational};
use crate::cli::arguments::{RangeArguments, Valences};
use crate::cli::console::answer::{Answer, SCHEMA, show};
use crate::cli::console::output::{Failure, Outcome};
use serde::Serialize;
use subcert::characteristic::{self, vertex_range};
use subcert::report::{Grid, SCOPE, Sheet};
use subcert::scheme::{SchemeError, parse_rules_in_parameter};

/// The range, if the scheme is rules around a vertex or on a face; `None` for masks.
pub(crate) fn of_rules(arguments: &RangeArguments, parameter: &str) -> Option<Outcome> {
    let valences = match arguments.valences {
        None => None,
        Some(Valences::Some(first, last)) => Some(first..=last),
        Some(Valences::All) => {
            let message = "ranges are those of single valences: give some, such as 3..12";
            return Some(Err(Failure::Input(message.to_owned())));
        }
    };
    let scheme = &arguments.scheme;
    let mut found = Vec::new();
    for valence in valences.map_or_else(|| vec![None], |all| all.map(Some).collect()) {
        let ring = match parse_rules_in_parameter(scheme, parameter, valence) {
            Ok(ring) => ring,
            Err(SchemeError::NotRing { .. } | SchemeError::TensorProduct { .. })
                if valence.is_none() =>
            {
                return None;
            }
            Err(error) => return Some(Err(error.into())),
        };
        if arguments.smoothness != Some(1) {
            let message = "for rules around a vertex or on a face, the range of C^1 is computed: give `--smoothness 1`";
            return Some(Err(Failure::Input(message.to_owned())));
        }
        match vertex_range(&ring, parameter) {
            Ok(range) => found.push(range),
            Err(error) => return Some(Err(Failure::Input(error.to_string()))),
        }
    }
    let valence = |range: characteristic::VertexRange| VertexValence {
        valence: range.order,
        inside: Set::of(&range.inside, parameter),
        outside: Set::of(&range.outside, parameter),
    };
    let valences = found.into_iter().map(valence).collect();
    let answer =
        VertexRange { schema: SCHEMA, scheme, parameter, smoothness: 1, scope: SCOPE, valences };
    Some(show(&arguments.output, &answer))
}

/// For which values of a parameter in rules around a vertex or on a face surfaces are C^1 there.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct VertexRange<'a> {
    /// The version of this form.
    schema: u32,
    /// The scheme as it was given.
    scheme: &'a str,
    /// The parameter.
    parameter: &'a str,
    /// 1.
    smoothness: usize,
    /// What «C¹» means here.
    scope: &'static str,
    /// The valences.
    valences: Vec<VertexValence>,
}

/// One valence.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct VertexValence {
    /// The valence.
    valence: usize,
    /// There the surface is proved C^1.
    inside: Set,
    /// There it is refuted.
    outside: Set,
}

impl Answer for VertexRange<'_> {
    const NAME: &'static str = "range-smoothness-vertex";

    fn sheet(&self) -> Sheet {
        let mut sheet = Sheet::titled(format!(
            "{}: where surfaces are C^1 at the vertex or on the face",
            self.scheme
        ));
        let row = |one: &VertexValence| {
            vec![one.valence.to_string(), one.inside.proved(&one.outside), one.outside.found()]
        };
        sheet.grid(Grid::of(["n", "C^1", "not C^1"], self.valences.iter().map(row), 3));
        let sets = self.valences.iter().flat_map(|one| [&one.inside, &one.outside]);
        write_irrational(&mut sheet, self.parameter, sets, std::iter::empty());
        sheet.text(
        "C^1: the eigenvalues are in order, and the characteristic map is regular and injective. Not C^1: its Jacobian has both \
         signs, an eigenvalue of block 0 is above the others, or one beside the simple 1 is not below 1. Elsewhere a hypothesis on the eigenvalues fails, or the sign \
         of the Jacobian is not decided.",
    );
        sheet.text(format!("{SCOPE}."));
        sheet
    }
}
