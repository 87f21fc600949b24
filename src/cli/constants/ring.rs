//! `subcert constants` of a ring.

use crate::cli::arguments::ConstantsArguments;
use crate::cli::console::csv;
use crate::cli::console::output::{Failure, Outcome, show_table, with_decimal};
use crate::cli::json::{SCHEMA, constants as form};
use subcert::bound::{LocalConstants, Transport};
use subcert::exact::{RealCyclotomic, format::short};
use subcert::report::{Grid, Sheet, json::Exact};
use subcert::scheme::LocalRules;

/// The most weights of a row that the text shows.
const SHOWN_WEIGHTS: usize = 12;

/// The longest exact weight that the text shows.
const SHOWN_LENGTH: usize = 24;

/// The largest ring whose extremal control ring the text shows.
const SHOWN_POINTS: usize = 30;

pub(crate) fn local_constants(ring: &LocalRules, arguments: &ConstantsArguments) -> Outcome {
    let constants = LocalConstants::new(ring, arguments.block.levels)
        .map_err(|error| Failure::Input(error.to_string()))?;
    let report = Report { ring, constants };
    let name = &arguments.scheme;
    show_table(
        &arguments.output,
        || report.sheet(name),
        || report.form(name),
        || csv::local_constants(&report.form(name)),
    )
}

struct Report<'a> {
    ring: &'a LocalRules,
    constants: LocalConstants,
}

type Contraction = ((usize, usize), Transport<RealCyclotomic>);

impl Report<'_> {
    /// T_c and where it is attained, and Λ_c, from c = 1.
    fn levels(&self) -> impl Iterator<Item = (u32, &Contraction, &RealCyclotomic)> {
        (1..).zip(&self.constants.levels).map(|(c, level)| (c, level.contraction(), &level.norm))
    }

    fn edge(&self, (a, b): (usize, usize)) -> String {
        format!("{} – {}", self.ring.name(a), self.ring.name(b))
    }

    fn sheet(&self, name: &str) -> Sheet {
        let mut sheet = Sheet::default();
        sheet.heading(1, name);
        sheet.facts(self.facts());
        let header = ["c", "T_c", "Λ_c", "T_c attained on"].map(str::to_owned).to_vec();
        let rows = self.levels().map(|(c, (edge, found), norm)| {
            vec![c.to_string(), short(&found.value, 10), short(norm, 10), self.edge(*edge)]
        });
        sheet.grid(Grid { header, rows: rows.collect(), left_columns: 0 });
        sheet.text(
            "T_c bounds the differences along the edges of the ring after c levels, and no smaller \
             number does. σ bounds how far a new point is from the old point of the same name. \
             The control rings of integers that attain them are in --format json.",
        );
        sheet
    }

    fn facts(&self) -> Vec<(String, String)> {
        let orbits =
            self.ring.orbits().iter().map(|orbit| format!("{} {}", orbit.count, orbit.name));
        let mut facts = vec![
            ("points".to_owned(), orbits.collect::<Vec<String>>().join(", ")),
            ("edges".to_owned(), self.ring.edges().len().to_string()),
        ];
        let rows = self.ring.representatives().points.into_iter();
        facts.extend(rows.map(|point| {
            (
                format!("weights of {}", self.ring.name(point)),
                row_text(self.ring.weights().row(point)),
            )
        }));
        if let Some((edge, found)) = self.constants.contraction(1) {
            let holds = if self.contracts() { "< 1: one level contracts" } else { "not < 1" };
            facts.push(("δ = T_1".to_owned(), format!("{}, {holds}", with_decimal(&found.value))));
            if self.ring.point_count() <= SHOWN_POINTS {
                let heights = found.heights.iter().map(i64::to_string).collect::<Vec<String>>();
                let text = format!("{}, by the ring {}", self.edge(*edge), heights.join(" "));
                facts.push(("T_1 attained on".to_owned(), text));
            }
        }
        facts.push(("σ".to_owned(), with_decimal(&self.constants.displacement().1.value)));
        facts
    }

    fn contracts(&self) -> bool {
        let one = RealCyclotomic::from(1);
        self.constants.contraction(1).is_some_and(|(_, found)| found.value < one)
    }

    fn form<'a>(&'a self, name: &'a str) -> form::LocalConstants<'a> {
        let orbits = self.ring.orbits().iter();
        let orbits = orbits.map(|orbit| form::Orbit { name: &orbit.name, count: orbit.count });
        let levels = self.levels().map(|(c, (edge, found), norm)| form::LocalLevel {
            c,
            contraction: Exact::of(&found.value),
            edge: *edge,
            heights: &found.heights,
            norm: Exact::of(norm),
        });
        let (point, moved) = self.constants.displacement();
        let delta = |found: &Transport<RealCyclotomic>| form::Delta {
            value: Exact::of(&found.value),
            holds: self.contracts(),
        };
        let texts = |a| self.ring.weights().row(a).map(ToString::to_string).collect();
        form::LocalConstants {
            schema: SCHEMA,
            scheme: name,
            orbits: orbits.collect(),
            edges: self.ring.edges(),
            weights: (0..self.ring.point_count()).map(texts).collect(),
            delta: self.constants.contraction(1).map(|(_, found)| delta(found)),
            displacement: form::LocalDisplacement {
                value: Exact::of(&moved.value),
                point: *point,
                heights: &moved.heights,
            },
            levels: levels.collect(),
        }
    }
}

fn row_text<'a>(row: impl ExactSizeIterator<Item = &'a RealCyclotomic>) -> String {
    let weight = |weight: &RealCyclotomic| {
        let exact = weight.to_string();
        if exact.len() > SHOWN_LENGTH { short(weight, 10) } else { exact }
    };
    let more = row.len() > SHOWN_WEIGHTS;
    let shown = row.take(SHOWN_WEIGHTS).map(weight).collect::<Vec<String>>().join("  ");
    if more { format!("{shown}  … (all in --format json)") } else { shown }
}
