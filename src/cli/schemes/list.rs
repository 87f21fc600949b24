//! `subcert schemes`.

use crate::cli::arguments::SchemesArguments;
use crate::cli::console::answer::{Answer, SCHEMA, show};
use crate::cli::console::output::Outcome;
use serde::Serialize;
use subcert::report::Sheet;
use subcert::scheme::{SchemeDefinition, catalogue};

pub(crate) fn schemes(arguments: &SchemesArguments) -> Outcome {
    let schemes = catalogue().iter().map(Scheme::of).collect();
    show(&arguments.output, &Catalogue { schema: SCHEMA, schemes })
}

/// The catalogue.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct Catalogue<'a> {
    /// The version of this form.
    schema: u32,
    /// Its schemes.
    schemes: Vec<Scheme<'a>>,
}

/// A scheme of the catalogue.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Scheme<'a> {
    /// Its name.
    name: &'a str,
    /// What it is.
    title: &'a str,
    /// The publication that it is from.
    source: &'a str,
    /// `mask` of curves, `lattice` for a mask on Z^d, or `ring` around a vertex or a face.
    kind: &'static str,
    /// Its parameters.
    parameters: Vec<Parameter<'a>>,
}

/// A parameter of a scheme.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Parameter<'a> {
    /// Its name.
    name: &'a str,
    /// Its value where none is given; null where one must be.
    default: Option<&'a str>,
    /// Its least value, if it is a whole number; null if it may be any number.
    least: Option<&'a str>,
    /// What it is.
    about: &'a str,
}

impl Scheme<'_> {
    fn of(entry: &SchemeDefinition) -> Scheme<'_> {
        let parameters = entry.parameters.iter().map(|(name, spec)| {
            let [default, least] = [&spec.default, &spec.least]
                .map(|formula| formula.as_ref().map(|formula| formula.text.as_str()));
            Parameter { name, default, least, about: &spec.about }
        });
        Scheme {
            name: &entry.name,
            title: &entry.title,
            source: &entry.citation,
            kind: if entry.is_ring() {
                "ring"
            } else if entry.is_lattice() {
                "lattice"
            } else {
                "mask"
            },
            parameters: parameters.collect(),
        }
    }

    fn fact(&self) -> (String, String) {
        let parameters =
            self.parameters.iter().map(|Parameter { name, default, about, .. }| {
                let default = default.map(|value| format!(" = {value}"));
                format!("{name}{}: {about}", default.unwrap_or_default())
            });
        let lines = std::iter::once(self.title.to_owned()).chain(parameters);
        let lines = lines.chain([format!("[{}]", self.source)]);
        (self.name.to_owned(), lines.collect::<Vec<String>>().join("\n"))
    }
}

impl Answer for Catalogue<'_> {
    const NAME: &'static str = "schemes";

    fn sheet(&self) -> Sheet {
        let mut sheet = Sheet::default();
        sheet.facts(self.schemes.iter().map(Scheme::fact).collect());
        sheet.text(
            "Write parameters as `six-point:w=3/256` or `newton:j=1,n=3`. Schemes around a vertex or on \
             a face are rings: `constants`, `depth`, `certify` and `oracle` take them.",
        );
        sheet
    }
}
