//! `subcert scheme` of several schemes: their facts side by side.

use super::lattice::lattice_words;
use super::numbers::{level, number};
use super::words::{
    CurveWords, VALENCE_HEADER, curve_words, depth_note, places, summary, valence_note, valence_row,
};
use crate::cli::console::answer::{Answer, SCHEMA};
use crate::cli::console::output::Failure;
use serde::Serialize;
use std::collections::BTreeSet;
use subcert::facts::SchemeFacts;
use subcert::report::html::Picture;
use subcert::report::json::{CurveForm, FactsForm, LatticeForm, OpenForm, ValenceForm};
use subcert::report::{Grid, Sheet};
use subcert::smoothness::Symbol;

/// The facts of several schemes of one kind.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct Comparison {
    /// The version of this form.
    schema: u32,
    /// How the masks are related, where all have rational coefficients; null otherwise.
    masks: Option<Masks>,
    /// The schemes.
    schemes: Vec<FactsForm>,
    #[serde(skip)]
    pictures: Vec<Picture>,
}

/// How masks are related.
#[derive(Clone, Copy, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
enum Masks {
    /// All new points are the same.
    Same,
    /// All new points are the same, but have other indices.
    Shifted,
    /// Some new points are others.
    Different,
}

impl Masks {
    fn of(symbols: &[&Symbol]) -> Masks {
        let all = |same: &dyn Fn(&Symbol, &Symbol) -> bool| {
            symbols.windows(2).all(|pair| same(pair[0], pair[1]))
        };
        if all(&|one, other| one == other) {
            Masks::Same
        } else if all(&|one, other| {
            (one.arity(), one.coefficients()) == (other.arity(), other.coefficients())
        }) {
            Masks::Shifted
        } else {
            Masks::Different
        }
    }

    fn sentence(self) -> &'static str {
        match self {
            Masks::Same => "The masks are the same, and so are their places.",
            Masks::Shifted => {
                "The masks are the same, but stand at other places: new points are the same, with other indices."
            }
            Masks::Different => "The masks are different.",
        }
    }
}

impl Comparison {
    /// Schemes of one kind; an error names two that are not.
    pub(crate) fn of<'f>(
        names: &[String],
        facts: &'f [SchemeFacts],
        pictures: Vec<Picture>,
    ) -> Result<Comparison, Failure> {
        let schemes: Vec<FactsForm> =
            names.iter().zip(facts).map(|(name, facts)| FactsForm::of(name, facts)).collect();
        let kind = |form: &FactsForm| (form.curve.is_some(), form.lattice.is_some());
        if let Some(other) = schemes.iter().position(|one| kind(one) != kind(&schemes[0])) {
            let words = |form: &FactsForm| match kind(form) {
                (true, _) => "is a mask of curves",
                (_, true) => "is a mask on Z^d",
                _ => "are rules around a vertex or on a face",
            };
            return Err(Failure::Input(format!(
                "`{}` {}, and `{}` {}, with other facts: compare schemes of one kind",
                names[0],
                words(&schemes[0]),
                names[other],
                words(&schemes[other])
            )));
        }
        let symbol = |facts: &'f SchemeFacts| match facts {
            SchemeFacts::Rational(curve) => Some(&curve.symbol),
            _ => None,
        };
        let symbols = facts.iter().map(symbol).collect::<Option<Vec<&Symbol>>>();
        let masks = symbols.map(|symbols| Masks::of(&symbols));
        Ok(Comparison { schema: SCHEMA, masks, schemes, pictures })
    }

    fn of_masks(&self, curves: &[&CurveForm], sheet: &mut Sheet) {
        let places = places(curves.iter().copied());
        let words: Vec<CurveWords> = curves.iter().map(|one| curve_words(one, &places)).collect();
        let longest = curves.iter().map(|one| one.contraction.len().max(one.norm.len())).max();
        let levels = |curve: &CurveForm| -> Vec<(String, String)> {
            let both = |c| {
                let [contraction, norm] =
                    [&curve.contraction, &curve.norm].map(|all| level(all, c));
                [(format!("T_{c}"), contraction), (format!("Λ_{c}"), norm)]
            };
            (1..=longest.unwrap_or(0)).flat_map(both).collect()
        };
        let mut part = |title: &str, of: &dyn Fn(&CurveWords) -> Vec<(String, String)>| {
            sheet.heading(2, title);
            sheet.grid(self.side_by_side(&words.iter().map(of).collect::<Vec<_>>()));
        };
        part("Shape", &|words| words.shape.clone());
        part("Polynomials and smoothness", &|words| words.smoothness.clone());
        part("Constants", &|words| words.constants.clone());
        if words.iter().any(|words| !words.limit.is_empty()) {
            part("Limit", &|words| words.limit.clone());
        }
        sheet.heading(2, "Contraction and norm");
        sheet.grid(self.side_by_side(&curves.iter().map(|one| levels(one)).collect::<Vec<_>>()));
        sheet.text(depth_note());
        let open = |(scheme, curve): (&FactsForm, &&CurveForm)| {
            let reason =
                |one: &OpenForm| (format!("{}: {}", scheme.scheme, one.fact), one.reason.clone());
            curve.open.iter().map(reason).collect::<Vec<_>>()
        };
        let open: Vec<_> = self.schemes.iter().zip(curves).flat_map(open).collect();
        if !open.is_empty() {
            sheet.heading(2, "Open");
            sheet.facts(open);
        }
    }

    fn of_lattices(&self, lattices: &[&LatticeForm], sheet: &mut Sheet) {
        let all: Vec<Vec<(String, String)>> = lattices
            .iter()
            .map(|one| {
                let words = lattice_words(one).into_iter().flat_map(|(_, facts)| facts);
                let levels = one.contraction.iter().zip(&one.norm).zip(1..);
                let levels = levels.flat_map(|((contraction, norm), c)| {
                    [(format!("T_{c}"), number(contraction)), (format!("Λ_{c}"), number(norm))]
                });
                words.chain(levels).collect()
            })
            .collect();
        sheet.grid(self.side_by_side(&all));
    }

    /// A row for each fact, in the order in which they first occur.
    fn side_by_side(&self, facts: &[Vec<(String, String)>]) -> Grid {
        let mut names: Vec<&String> = Vec::new();
        for (name, _) in facts.iter().flatten() {
            if !names.contains(&name) {
                names.push(name);
            }
        }
        let row = |name: &&String| {
            let cell = |one: &Vec<(String, String)>| {
                let found = one.iter().find(|(known, _)| known == *name);
                found.map_or("–".to_owned(), |(_, text)| text.clone())
            };
            std::iter::once((*name).clone()).chain(facts.iter().map(cell)).collect()
        };
        let header = std::iter::once(String::new());
        let header = header.chain(self.schemes.iter().map(|one| one.scheme.clone()));
        Grid::of(header, names.iter().map(row), facts.len() + 1)
    }

    /// A row for each valence of each scheme.
    fn of_rings(&self, sheet: &mut Sheet) {
        let all = |one: &FactsForm| -> Vec<usize> {
            one.valences.iter().flatten().map(|found| found.valence).collect()
        };
        let valences: BTreeSet<usize> = self.schemes.iter().flat_map(all).collect();
        let at = |n: usize| {
            self.schemes.iter().flat_map(move |one| {
                let found = one.valences.iter().flatten().filter(move |found| found.valence == n);
                found.map(|found: &ValenceForm| {
                    let mut row = valence_row(found);
                    row.insert(1, one.scheme.clone());
                    row
                })
            })
        };
        let mut header: Vec<&str> = VALENCE_HEADER.to_vec();
        header.insert(1, "scheme");
        sheet.grid(Grid::of(header, valences.into_iter().flat_map(at), 2));
        sheet.text(valence_note());
        self.schemes.iter().for_each(|one| sheet.notes(&one.notes));
    }
}

impl Answer for Comparison {
    const NAME: &'static str = "scheme-comparison";

    fn sheet(&self) -> Sheet {
        let names: Vec<&str> = self.schemes.iter().map(|one| one.scheme.as_str()).collect();
        let mut sheet = Sheet::titled(names.join(", "));
        if let Some(masks) = self.masks {
            sheet.text(masks.sentence());
        }
        let curves: Option<Vec<&CurveForm>> =
            self.schemes.iter().map(|one| one.curve.as_ref()).collect();
        let lattices: Option<Vec<&LatticeForm>> =
            self.schemes.iter().map(|one| one.lattice.as_ref()).collect();
        match (curves, lattices) {
            (Some(curves), _) => self.of_masks(&curves, &mut sheet),
            (None, Some(lattices)) => self.of_lattices(&lattices, &mut sheet),
            (None, None) => self.of_rings(&mut sheet),
        }
        sheet
    }

    fn sentence(&self) -> String {
        let masks = self.masks.map(|masks| masks.sentence().to_owned());
        self.schemes.iter().map(summary).chain(masks).collect::<Vec<String>>().join(" ")
    }

    fn pictures(&self) -> Vec<Picture> {
        self.pictures.clone()
    }
}
