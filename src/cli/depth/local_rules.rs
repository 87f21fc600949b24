//! `subcert depth` of a ring.

use super::distance::TwoSided;
use super::exact::points_text;
use super::numbers::{levels, too_few};
use crate::cli::arguments::DepthArguments;
use crate::cli::console::answer::{Answer, OrNone, SCHEMA, deliver};
use crate::cli::console::destination::Destination;
use crate::cli::console::output::{Failure, Outcome, positive};
use crate::cli::console::quantity::{Number, Text, above};
use serde::Serialize;
use subcert::audit::{Attained, Control, Place, Refiner};
use subcert::exact::{Rational, RealCyclotomic, format::short};
use subcert::float::nearest;
use subcert::limit::{
    self, LocalDepth, LocalDistances, LocalLimit, LocalLimitError, TwoSidedDepth,
};
use subcert::report::Sheet;
use subcert::report::html::{LevelLine, Levels, Picture};
use subcert::scheme::{LocalRules, notes};

pub(super) fn ring_depth(
    ring: &LocalRules,
    arguments: &DepthArguments,
    to: &Destination,
) -> Outcome {
    if arguments.polygon.is_some() || arguments.width.is_some() {
        return Err(Failure::Input(
            "--polygon and --width are for curves; distances of rings are exact".to_owned(),
        ));
    }
    let tolerance = positive("--tolerance", &arguments.tolerance)?;
    let spread = positive("--spread", &arguments.spread.spread)?;
    let (depth, pictures) = match Depth::of(ring, &tolerance, &spread) {
        Ok(found) => (
            OrNone::Found(ExactlyOfRing::of(ring, &found, &spread)),
            if arguments.output.is_page() {
                pictures(ring, &found, [&tolerance, &spread])
            } else {
                Vec::new()
            },
        ),
        Err(error) => (OrNone::None { none: error.to_string() }, Vec::new()),
    };
    let answer = LocalReport {
        schema: SCHEMA,
        scheme: &arguments.scheme,
        notes: notes(&arguments.scheme),
        tolerance: Text(tolerance),
        spread: Text(spread),
        depth,
        given: [&arguments.tolerance, &arguments.spread.spread],
        pictures,
    };
    deliver(to, &answer)
}

/// The most levels of a picture.
const MAX_LEVELS: u32 = 24;

/// The depth of a ring.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct LocalReport<'a> {
    /// The version of this form.
    schema: u32,
    /// The scheme as it was given.
    scheme: &'a str,
    /// What is to be told of the numbers, such as that they are those of several steps; missing where there is nothing.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    notes: Vec<String>,
    /// The tolerance ε.
    tolerance: Text<Rational>,
    /// The spread β.
    spread: Text<Rational>,
    /// The true depth for every control ring of the spread.
    depth: OrNone<ExactlyOfRing>,
    /// The tolerance and the spread as they were given.
    #[serde(skip)]
    given: [&'a str; 2],
    #[serde(skip)]
    pictures: Vec<Picture>,
}

/// The true depth for every control ring of the spread.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct ExactlyOfRing {
    /// The depth; its fields stand here.
    #[serde(flatten)]
    depth: TwoSided,
    /// The least level that meets the tolerance; a later one need not.
    first: u32,
    /// The greatest distance at the depth.
    distance: LocalWitness,
    /// A control ring that is too far from its limit at the level below the depth.
    witness: Option<LocalWitness>,
}

/// A control ring, and how far one of its points is from its limit.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct LocalWitness {
    /// The level.
    level: u32,
    /// The points of the ring.
    ring: Vec<i64>,
    /// What they are multiplied by.
    times: Text<Rational>,
    /// The point.
    point: String,
    /// The distance of this point from its limit.
    distance: Number,
}

struct Depth {
    levels: LocalDepth,
    /// The distances at the depth and at the level below it, of spread 1.
    at: limit::LocalWitness,
    below: Option<limit::LocalWitness>,
    /// The distances of spread 1 up to the depth.
    of_levels: Vec<(u32, f64)>,
}

impl Depth {
    fn of(
        ring: &LocalRules,
        tolerance: &Rational,
        spread: &Rational,
    ) -> Result<Depth, LocalLimitError> {
        let distances = LocalDistances::new(LocalLimit::new(ring)?);
        let depth = distances.depth(spread, tolerance)?;
        let at = distances.constant(depth.settled)?;
        let below =
            depth.settled.checked_sub(1).map(|level| distances.constant(level)).transpose()?;
        let of_levels = (depth.settled.saturating_sub(MAX_LEVELS)..=depth.settled)
            .map(|level| Ok((level, nearest(&distances.constant(level)?.distance))))
            .collect::<Result<_, LocalLimitError>>()?;
        Ok(Depth { levels: depth, at, below, of_levels })
    }
}

impl ExactlyOfRing {
    fn of(ring: &LocalRules, found: &Depth, spread: &Rational) -> ExactlyOfRing {
        let LocalDepth { level: first, settled: level, .. } = found.levels;
        let witness = |witness: &limit::LocalWitness| LocalWitness {
            level: witness.level,
            ring: witness.ring.clone(),
            times: Text(spread.clone()),
            point: ring.name(witness.point),
            distance: (&(&witness.distance * &RealCyclotomic::from(spread.clone()))).into(),
        };
        ExactlyOfRing {
            depth: TwoSidedDepth { lower: level, upper: level }.into(),
            first,
            distance: witness(&found.at),
            witness: found.below.as_ref().map(witness),
        }
    }
}

fn pictures(ring: &LocalRules, found: &Depth, [tolerance, spread]: [&Rational; 2]) -> Vec<Picture> {
    let Depth { levels, at, below, of_levels } = found;
    let times = nearest(spread);
    let line = LevelLine {
        name: "distance".to_owned(),
        values: of_levels.iter().map(|(level, value)| (*level, value * times)).collect(),
        met: Some(levels.settled),
        is_constant: false,
    };
    let chart = Levels { tolerance, lines: vec![line], promised: Vec::new() };
    let witness = below.as_ref().unwrap_or(at);
    let points = (0..).zip(&witness.ring).map(|(a, x)| (ring.name(a), *x)).collect();
    let attained = Attained {
        control: Control::Points(points),
        place: Place::Named(ring.name(witness.point)),
        value: witness.distance.clone(),
    };
    let (refiner, most) = (Refiner::Ring(ring.clone()), tolerance / spread);
    let data = Picture::of_data(&refiner, &attained, witness.level, &most, [0.0; 2]);
    Picture::of_levels(&chart).into_iter().chain(data).collect()
}

impl Answer for LocalReport<'_> {
    const NAME: &'static str = "depth-ring";

    fn sheet(&self) -> Sheet {
        let mut sheet = Sheet::default();
        let [tolerance, spread] = self.given;
        sheet.heading(1, format!("{}, ε = {tolerance}, β = {spread}", self.scheme));
        sheet.notes(&self.notes);
        let ExactlyOfRing { depth, first, distance, witness } = match &self.depth {
            OrNone::Found(depth) => depth,
            OrNone::None { none } => {
                sheet.facts(vec![("exact depth".to_owned(), format!("none: {none}"))]);
                return sheet;
            }
        };
        let few = match depth.level {
            0 => String::new(),
            level => too_few(level - 1),
        };
        let mut facts = vec![("exact depth".to_owned(), format!("{}{few}", levels(depth.level)))];
        if depth.level > *first {
            let text = format!("level {first}, but not all later ones");
            facts.push(("first met at".to_owned(), text));
        }
        facts.push((format!("distance C_{}·β", distance.level), distance.distance.words()));
        if let Some(below) = witness {
            let text = format!(
                "β times {}: {} is {} from the limit",
                points_text(&below.ring),
                below.point,
                above(&below.distance, &self.tolerance.0)
            );
            facts.push((format!("too far at level {}", below.level), text));
        }
        sheet.facts(facts);
        sheet.text(
            "The depth is the least level from which on, for every control ring of this spread, all \
             points are within the tolerance of the one that they tend to. Around a vertex that \
             is not the distance from the limit surface, but at the vertex.",
        );
        sheet
    }

    fn sentence(&self) -> String {
        let tolerance = short(&self.tolerance.0, 6);
        match &self.depth {
            OrNone::Found(found) => format!(
                "From level {} on, the points of every control ring are within {tolerance} of their limit.",
                found.depth.level
            ),
            OrNone::None { none } => format!("No depth is known: {none}."),
        }
    }

    fn pictures(&self) -> Vec<Picture> {
        self.pictures.clone()
    }
}
