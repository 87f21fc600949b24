//! `subcert schemes` and `subcert completions`.

use super::Outcome;
use super::arguments::{Arguments, SchemesArguments};
use super::output::{show, write};
use clap::CommandFactory as _;
use serde_json::{Value, json};
use subcert::report::{Grid, Sheet};
use subcert::scheme::{SchemeDefinition, catalogue};

pub(super) fn schemes(arguments: &SchemesArguments) -> Outcome {
    show(arguments.format, sheet, || Value::from(catalogue().iter().map(json).collect::<Vec<_>>()))
}

fn sheet() -> Sheet {
    let rows = catalogue().iter().map(|entry| {
        let parameters = entry.parameters.iter().map(|(name, spec)| {
            let default = spec.default.as_ref().map(|formula| format!(" = {}", formula.text));
            format!("{name}{}: {}", default.unwrap_or_default(), spec.about)
        });
        let parameters = parameters.collect::<Vec<String>>().join("\n");
        vec![entry.name.clone(), entry.title.clone(), parameters, entry.citation.clone()]
    });
    let header = ["name", "scheme", "parameters", "source"].map(str::to_owned).to_vec();
    let mut sheet = Sheet::default();
    sheet.grid(Grid { header, rows: rows.collect(), left_columns: 4 });
    sheet
}

fn json(entry: &SchemeDefinition) -> Value {
    let parameters = entry.parameters.iter().map(|(name, spec)| {
        let default = spec.default.as_ref().map(|formula| formula.text.clone());
        json!({ "name": name, "default": default, "about": spec.about })
    });
    json!({
        "name": entry.name,
        "title": entry.title,
        "source": entry.citation,
        "parameters": parameters.collect::<Vec<Value>>(),
    })
}

pub(super) fn completions(shell: clap_complete::Shell) -> Outcome {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Arguments::command(), "subcert", &mut script);
    write(&String::from_utf8_lossy(&script))
}
