//! `subcert range --smoothness` of rules around a vertex or on a face.

use super::sets::Parameter;
use crate::cli::arguments::{RangeArguments, Valences};
use crate::cli::console::output::{Failure, Outcome, show};
use crate::cli::json::{SCHEMA, range as form};
use subcert::characteristic::{VertexRange, vertex_range};
use subcert::exact::IntervalSet;
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
            let message = "of rules around a vertex or on a face, the range of C^1 is computed: give `--smoothness 1`";
            return Some(Err(Failure::Input(message.to_owned())));
        }
        match vertex_range(&ring, parameter) {
            Ok(range) => found.push(range),
            Err(error) => return Some(Err(Failure::Input(error.to_string()))),
        }
    }
    let parameter = Parameter(parameter);
    let valence_form = |range: &VertexRange| form::VertexValence {
        valence: range.order,
        inside: parameter.set_form(&range.inside),
        outside: parameter.set_form(&range.outside),
    };
    Some(show(
        &arguments.output,
        || sheet(scheme, parameter, &found),
        || form::VertexRange {
            schema: SCHEMA,
            scheme,
            parameter: parameter.0,
            smoothness: 1,
            scope: SCOPE,
            valences: found.iter().map(valence_form).collect(),
        },
    ))
}

fn sheet(scheme: &str, parameter: Parameter<'_>, found: &[VertexRange]) -> Sheet {
    let mut sheet = Sheet::default();
    sheet.heading(1, format!("{scheme}: where surfaces are C^1 at the vertex or on the face"));
    let row = |range: &VertexRange| {
        vec![
            range.order.to_string(),
            parameter.found(&range.inside),
            parameter.found(&range.outside),
        ]
    };
    let header = ["n", "C^1", "not C^1"].map(str::to_owned).to_vec();
    sheet.grid(Grid { header, rows: found.iter().map(row).collect(), left_columns: 3 });
    let sets = found.iter().flat_map(|range| [&range.inside, &range.outside]);
    let ends = parameter.irrational(sets.flat_map(IntervalSet::ends).map(|(end, _)| end));
    if !ends.is_empty() {
        sheet.heading(2, "Irrational numbers");
        sheet.facts(ends);
    }
    sheet.text(
        "C^1: the eigenvalues are in order, and the characteristic map is regular and injective. Not C^1: its Jacobian has both \
         signs, an eigenvalue of block 0 is above the others, or one beside the simple 1 is not below 1. Elsewhere a hypothesis on the eigenvalues fails, or the sign \
         of the Jacobian is not decided.",
    );
    sheet.text(format!("{SCOPE}."));
    sheet
}
