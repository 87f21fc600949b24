//! `subcert schemes`.

use crate::cli::arguments::SchemesArguments;
use crate::cli::console::output::{Outcome, show};
use crate::cli::json::SCHEMA;
use crate::cli::json::schemes::{Catalogue, Parameter, Scheme};
use subcert::report::Sheet;
use subcert::scheme::{SchemeDefinition, catalogue};

pub(crate) fn schemes(arguments: &SchemesArguments) -> Outcome {
    show(&arguments.output, sheet, || Catalogue {
        schema: SCHEMA,
        schemes: catalogue().iter().map(form).collect(),
    })
}

fn sheet() -> Sheet {
    let fact = |entry: &SchemeDefinition| {
        let parameters = entry.parameters.iter().map(|(name, spec)| {
            let default = spec.default.as_ref().map(|formula| format!(" = {}", formula.text));
            format!("{name}{}: {}", default.unwrap_or_default(), spec.about)
        });
        let lines = std::iter::once(entry.title.clone()).chain(parameters);
        let lines = lines.chain([format!("[{}]", entry.citation)]);
        (entry.name.clone(), lines.collect::<Vec<String>>().join("\n"))
    };
    let mut sheet = Sheet::default();
    sheet.facts(catalogue().iter().map(fact).collect());
    sheet.text(
        "Write parameters as `six-point:w=3/256` or `newton:j=1,n=3`. Schemes around a vertex or on \
         a face are rings: `constants`, `depth`, `certify` and `oracle` take them.",
    );
    sheet
}

fn form(entry: &SchemeDefinition) -> Scheme<'_> {
    let parameters = entry.parameters.iter().map(|(name, spec)| {
        let default = spec.default.as_ref().map(|formula| formula.text.as_str());
        Parameter { name, default, about: &spec.about }
    });
    Scheme {
        name: &entry.name,
        title: &entry.title,
        source: &entry.citation,
        kind: if entry.is_ring() { "ring" } else { "mask" },
        parameters: parameters.collect(),
    }
}
