//! `subcert constants` of a ring.

use super::delta::{Delta, number_row};
use crate::cli::arguments::ConstantsArguments;
use crate::cli::console::answer::{Answer, SCHEMA, show};
use crate::cli::console::output::{Failure, Outcome};
use crate::cli::console::quantity::{Number, Orbit, Text};
use serde::Serialize;
use subcert::bound::{LocalConstants, Transport};
use subcert::exact::{RealCyclotomic, format::short};
use subcert::report::{Grid, Sheet};
use subcert::scheme::{LocalRules, notes};

/// The most weights of a row that the text shows.
const SHOWN_WEIGHTS: usize = 12;

/// The longest exact weight that the text shows.
const SHOWN_LENGTH: usize = 24;

/// The largest ring whose extremal control ring the text shows.
const SHOWN_POINTS: usize = 30;

pub(crate) fn local_constants(ring: &LocalRules, arguments: &ConstantsArguments) -> Outcome {
    let constants = LocalConstants::new(ring, arguments.block.levels)
        .map_err(|error| Failure::Input(error.to_string()))?;
    show(&arguments.output, &RingConstants::of(&arguments.scheme, ring, &constants))
}

/// The constants of a ring.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "LocalConstants"))]
pub(crate) struct RingConstants<'a> {
    /// The version of this form.
    schema: u32,
    /// The scheme as it was given.
    scheme: &'a str,
    /// What is to be told of the numbers, such as that they are those of several steps; missing where there is nothing.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    notes: Vec<String>,
    /// The kinds of points.
    orbits: Vec<Orbit>,
    /// The edges: pairs of points.
    edges: &'a [(usize, usize)],
    /// The weights of each point.
    weights: Vec<Vec<Text<RealCyclotomic>>>,
    /// δ = T_1.
    delta: Option<Delta>,
    /// σ.
    displacement: LocalDisplacement<'a>,
    /// T_c and Λ_c for c = 1, 2, …
    levels: Vec<LocalLevel<'a>>,
    /// The ring.
    #[serde(skip)]
    ring: &'a LocalRules,
}

/// σ of a ring.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct LocalDisplacement<'a> {
    /// The value; its fields stand here.
    #[serde(flatten)]
    value: Number,
    /// The point that attains it.
    point: usize,
    /// A control ring that attains it.
    heights: &'a [i64],
}

/// The constants of a ring for blocks of c levels.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct LocalLevel<'a> {
    /// c.
    c: u32,
    /// T_c.
    contraction: Number,
    /// The edge that attains it.
    edge: (usize, usize),
    /// A control ring that attains it.
    heights: &'a [i64],
    /// Λ_c.
    norm: Number,
}

impl<'a> RingConstants<'a> {
    fn of(
        scheme: &'a str,
        ring: &'a LocalRules,
        constants: &'a LocalConstants,
    ) -> RingConstants<'a> {
        let levels = (1..).zip(&constants.levels).map(|(c, level)| {
            let (edge, Transport { value, heights, .. }) = level.contraction();
            LocalLevel {
                c,
                contraction: value.into(),
                edge: *edge,
                heights,
                norm: (&level.norm).into(),
            }
        });
        let levels: Vec<LocalLevel<'_>> = levels.collect();
        let one = RealCyclotomic::from(1);
        let delta = constants
            .contraction(1)
            .map(|(_, found)| Delta { holds: found.value < one, value: (&found.value).into() });
        let (point, moved) = constants.displacement();
        let row = |a| ring.weights().row(a).cloned().map(Text).collect();
        RingConstants {
            schema: SCHEMA,
            scheme,
            notes: notes(scheme),
            orbits: Orbit::all(ring.orbits()),
            edges: ring.edges(),
            weights: (0..ring.point_count()).map(row).collect(),
            delta,
            displacement: LocalDisplacement {
                value: (&moved.value).into(),
                point: *point,
                heights: &moved.heights,
            },
            levels,
            ring,
        }
    }

    fn edge(&self, (a, b): (usize, usize)) -> String {
        format!("{} – {}", self.ring.name(a), self.ring.name(b))
    }

    fn facts(&self) -> Vec<(String, String)> {
        let mut facts = vec![
            ("points".to_owned(), Orbit::words(&self.orbits)),
            ("edges".to_owned(), self.edges.len().to_string()),
        ];
        let rows = self.ring.representatives().points.into_iter();
        facts.extend(rows.map(|point| {
            (format!("weights of {}", self.ring.name(point)), row_text(&self.weights[point]))
        }));
        if let (Some(delta), Some(first)) = (&self.delta, self.levels.first()) {
            facts.push(("δ = T_1".to_owned(), delta.words()));
            if self.ring.point_count() <= SHOWN_POINTS {
                let heights = first.heights.iter().map(i64::to_string).collect::<Vec<String>>();
                let text = format!("{}, by the ring {}", self.edge(first.edge), heights.join(" "));
                facts.push(("T_1 attained on".to_owned(), text));
            }
        }
        facts.push(("σ".to_owned(), self.displacement.value.words()));
        facts
    }
}

impl Answer for RingConstants<'_> {
    const NAME: &'static str = "constants-ring";

    fn sheet(&self) -> Sheet {
        let mut sheet = Sheet::titled(self.scheme);
        sheet.notes(&self.notes);
        sheet.facts(self.facts());
        let row = |level: &LocalLevel<'_>| {
            let [contraction, norm] = [&level.contraction, &level.norm].map(|x| x.short(10));
            vec![level.c.to_string(), contraction, norm, self.edge(level.edge)]
        };
        sheet.grid(Grid::of(
            ["c", "T_c", "Λ_c", "T_c attained on"],
            self.levels.iter().map(row),
            0,
        ));
        sheet.text(
            "T_c bounds the differences along the edges of the ring after c levels, and no smaller \
             number does. σ bounds how far a new point is from the old point of the same name. \
             The control rings of integers that attain them are in --format json.",
        );
        sheet
    }

    /// One row for each number.
    fn grid(&self) -> Option<Grid> {
        let mut rows = vec![number_row(&["displacement", ""], &self.displacement.value)];
        for level in &self.levels {
            let c = &level.c.to_string();
            rows.push(number_row(&["contraction", c], &level.contraction));
            rows.push(number_row(&["norm", c], &level.norm));
        }
        Some(Grid::of(["quantity", "c", "exact", "decimal"], rows, 2))
    }
}

fn row_text(row: &[Text<RealCyclotomic>]) -> String {
    let weight = |Text(weight): &Text<RealCyclotomic>| {
        let exact = weight.to_string();
        if exact.len() > SHOWN_LENGTH { short(weight, 10) } else { exact }
    };
    let shown = row.iter().take(SHOWN_WEIGHTS).map(weight).collect::<Vec<String>>().join("  ");
    let more = row.len() > SHOWN_WEIGHTS;
    if more { format!("{shown}  … (all in --format json)") } else { shown }
}
