//! `subcert atlas`.

use super::atlas_pages;
use super::numbers::{level, number};
use super::words::{VALENCE_HEADER, continuity, depth, hoelder, valence_note, valence_row};
use crate::cli::arguments::AtlasArguments;
use crate::cli::console::answer::{Answer, SCHEMA, show};
use crate::cli::console::destination::no_page;
use crate::cli::console::lattice::{matrix, smoothness_words};
use crate::cli::console::output::{Failure, Outcome};
use crate::cli::console::progress::Progress;
use serde::Serialize;
use subcert::audit::on_all_cores;
use subcert::facts::{AtlasEntry, Depths, SchemeFacts, atlas_entry, atlas_references};
use subcert::report::json::{CurveForm, FactsForm, LatticeForm};
use subcert::report::{Grid, Sheet};
use subcert::scheme::{SchemeError, catalogue};

pub(crate) fn atlas(arguments: &AtlasArguments) -> Outcome {
    let entries =
        if arguments.names.is_empty() { atlas_references() } else { chosen(&arguments.names)? };
    let all = entries
        .iter()
        .flat_map(|(entry, references)| references.iter().map(move |reference| (entry, reference)));
    let all: Vec<_> = all.collect();
    let to = match arguments.format.of_text(arguments.file.as_ref()) {
        None => return atlas_pages::pages(arguments, &entries),
        Some(_) if !arguments.claims.is_empty() => {
            let message = "--claims is for pages, which link to the claims: add --format html";
            return Err(Failure::Input(message.to_owned()));
        }
        Some(to) => no_page(to)?,
    };
    let progress = Progress::of_schemes(all.len(), true);
    let found = on_all_cores(&all, |(entry, reference)| {
        let facts = SchemeFacts::of(reference).map(|facts| FactsForm::of(reference, &facts));
        progress.step();
        facts.map(|facts| Entry { title: &entry.title, source: &entry.citation, facts })
    });
    drop(progress);
    let schemes = found.into_iter().collect::<Result<Vec<Entry<'_>>, _>>();
    let atlas = Atlas { schema: SCHEMA, schemes: schemes.map_err(Failure::from)? };
    show(&to, &atlas)
}

/// The entries of these schemes, in the order of the catalogue, with one's own behind it.
fn chosen(schemes: &[String]) -> Result<Vec<AtlasEntry>, SchemeError> {
    let mut entries: Vec<AtlasEntry> = Vec::new();
    for scheme in schemes {
        let (entry, references) = atlas_entry(scheme)?;
        match entries.iter_mut().find(|(known, _)| known.name == entry.name) {
            Some((_, known)) => {
                let new = references.into_iter().filter(|one| !known.contains(one));
                known.extend(new.collect::<Vec<String>>());
            }
            None => entries.push((entry, references)),
        }
    }
    let place = |entry: &AtlasEntry| catalogue().iter().position(|one| one.name == entry.0.name);
    entries.sort_by_key(|entry| place(entry).unwrap_or(usize::MAX));
    Ok(entries)
}

/// The facts of schemes, where none are named those of the catalogue.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct Atlas<'a> {
    /// The version of this form.
    schema: u32,
    /// The schemes, families at their samples.
    schemes: Vec<Entry<'a>>,
}

/// A scheme.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Entry<'a> {
    /// Its title.
    title: &'a str,
    /// Where it was published.
    source: &'a str,
    /// The facts; their fields stand here.
    #[serde(flatten)]
    facts: FactsForm,
}

impl Answer for Atlas<'_> {
    const NAME: &'static str = "atlas";

    fn sheet(&self) -> Sheet {
        let mut sheet = Sheet::titled("The atlas of schemes");
        sheet.heading(2, "Curves");
        let header = [
            "scheme",
            "n",
            "points",
            "kind",
            "support",
            "sum rules",
            "reproduces",
            "limits",
            "Hölder exponent",
            "T_1",
            "σ",
            "depths",
        ];
        sheet.text(format!(
            "n is the arity. Points counts those of a rule, from the first to the last. Support is its length. \
             Reproduces has the degree of polynomials that are reproduced, at the natural shift. Depths has the \
             levels that polygons with differences up to 1 need for the tolerance {}, with x^k_i at i/n^k and \
             at natural parameters. What is not decided is open; `subcert scheme NAME` gives the reasons, and all \
             constants.",
            Depths::tolerance()
        ));
        let curves =
            self.schemes.iter().filter_map(|entry| Some((entry, entry.facts.curve.as_ref()?)));
        let rows = curves.map(|(entry, curve)| curve_row(&entry.facts.scheme, curve));
        sheet.grid(Grid::of(header, rows, 1));
        let lattices =
            self.schemes.iter().filter_map(|entry| Some((entry, entry.facts.lattice.as_ref()?)));
        let rows: Vec<Vec<String>> =
            lattices.map(|(entry, form)| lattice_row(&entry.facts.scheme, form)).collect();
        if !rows.is_empty() {
            sheet.heading(2, "Masks on Z^d");
            let header =
                ["scheme", "M", "sum rules", "reproduces", "limits", "Hölder exponent", "T_1"];
            sheet.grid(Grid::of(header, rows, 1));
        }
        sheet.heading(2, "Rules around a vertex or on a face");
        let surfaces =
            self.schemes.iter().filter_map(|entry| Some((entry, entry.facts.valences.as_ref()?)));
        let rows = surfaces.flat_map(|(entry, valences)| {
            valences.iter().map(|one| {
                let name = std::iter::once(entry.facts.scheme.clone());
                name.chain(valence_row(one)).collect::<Vec<String>>()
            })
        });
        let header = std::iter::once("scheme").chain(VALENCE_HEADER).map(str::to_owned);
        sheet.text(valence_note());
        self.schemes.iter().for_each(|entry| sheet.notes(&entry.facts.notes));
        sheet.grid(Grid::of(header, rows, 1));
        sheet
    }
}

fn lattice_row(name: &str, form: &LatticeForm) -> Vec<String> {
    let words = smoothness_words(&form.smoothness, form.smoothness.accuracy);
    let mut row = vec![
        name.to_owned(),
        matrix(&form.dilation),
        form.sum_rules.to_string(),
        form.reproduction.to_string(),
    ];
    row.extend(words.into_iter().map(|(_, text)| text));
    row.push(level(&form.contraction, 1));
    row
}

fn curve_row(name: &str, curve: &CurveForm) -> Vec<String> {
    let kind = curve.kind.unwrap_or("neither");
    let kind = if curve.interpolating { format!("{kind}, interpolating") } else { kind.to_owned() };
    let [indexed, natural] = [&curve.depth_indexed, &curve.depth_natural];
    vec![
        name.to_owned(),
        curve.arity.to_string(),
        curve.points.to_string(),
        kind,
        number(&curve.support_length),
        curve.sum_rules.to_string(),
        if curve.natural_shift.is_some() { curve.reproduction.to_string() } else { "0".to_owned() },
        continuity(curve),
        hoelder(curve),
        curve.contraction.first().map_or("open".to_owned(), number),
        number(&curve.displacement),
        format!("{}, {}", depth(indexed.as_ref()), depth(natural.as_ref())),
    ]
}
