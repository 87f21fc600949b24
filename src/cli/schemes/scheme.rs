//! `subcert scheme`.

use super::compare::Comparison;
use super::words::{sheet, summary};
use crate::cli::arguments::SchemeArguments;
use crate::cli::console::answer::{Answer, deliver};
use crate::cli::console::destination::Destination;
use crate::cli::console::output::Outcome;
use crate::cli::console::progress::Progress;
use crate::cli::console::quantity::written;
use subcert::facts::{Drawing, FamilyFacts, SchemeFacts};
use subcert::report::Sheet;
use subcert::report::html::{Picture, Plot};
use subcert::report::json::{Facts, FactsForm};
use subcert::scheme::SchemeError;

pub(crate) fn scheme(arguments: &SchemeArguments) -> Outcome {
    let names = &arguments.schemes;
    let to = Destination::of(&arguments.output, &names.join(" "))?;
    let progress = Progress::of_search(true);
    let facts = names.iter().map(|name| SchemeFacts::of(name));
    let facts = facts.collect::<Result<Vec<SchemeFacts>, SchemeError>>()?;
    let mut pictures = Vec::new();
    if arguments.output.is_page() {
        for (name, facts) in names.iter().zip(&facts) {
            pictures.extend(Plot::of(name, &Drawing::of_facts(name, facts)?).pictures());
        }
    }
    let [name] = &names[..] else {
        let comparison = Comparison::of(names, &facts, pictures)?;
        drop(progress);
        return deliver(&to, &comparison);
    };
    let family = FamilyFacts::of(name);
    drop(progress);
    deliver(&to, &Scheme { facts: FactsForm::of(name, &facts[0]), family, pictures })
}

/// What is known of a scheme, and of its family.
pub(crate) struct Scheme {
    facts: FactsForm,
    family: Option<FamilyFacts>,
    pictures: Vec<Picture>,
}

written!(this: Scheme => Facts<'_>, Facts::of(&this.facts, this.family.as_ref()));

impl Answer for Scheme {
    const NAME: &'static str = "scheme";

    fn sheet(&self) -> Sheet {
        sheet(&self.facts, self.family.as_ref())
    }

    fn sentence(&self) -> String {
        summary(&self.facts)
    }

    fn pictures(&self) -> Vec<Picture> {
        self.pictures.clone()
    }
}
