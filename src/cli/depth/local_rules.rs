//! `subcert depth` of a ring.

use super::exact::points_text;
use super::numbers::{levels, too_few};
use crate::cli::arguments::DepthArguments;
use crate::cli::console::destination::{Destination, command};
use crate::cli::console::output::{Failure, Outcome, positive, with_decimal};
use crate::cli::json::{SCHEMA, depth as form};
use subcert::audit::{Attained, Control, Place, Refiner};
use subcert::exact::{Rational, RealCyclotomic, format::short};
use subcert::float::nearest;
use subcert::limit::{LocalDepth, LocalDistances, LocalLimit, LocalLimitError, LocalWitness};
use subcert::report::html::{FindingPage, LevelLine, Levels, Picture};
use subcert::report::{Sheet, json::Exact};
use subcert::scheme::LocalRules;

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
    let depth = Depth::of(ring, &tolerance, &spread);
    let report = Report { ring, tolerance, spread, depth };
    let page = || {
        let (sentence, command, pictures) = (report.sentence(), command(), report.pictures());
        let sheet = &report.sheet(arguments);
        let pictures = &pictures;
        Ok(FindingPage { sentence: &sentence, sheet, pictures, command: &command }.to_html())
    };
    to.deliver(|| report.sheet(arguments), || report.form(arguments), page)
}

/// The most levels of a picture.
const MAX_LEVELS: u32 = 24;

struct Report<'a> {
    ring: &'a LocalRules,
    tolerance: Rational,
    spread: Rational,
    depth: Result<Depth, LocalLimitError>,
}

struct Depth {
    levels: LocalDepth,
    /// The distances at the depth and at the level below it, of spread 1.
    at: LocalWitness,
    below: Option<LocalWitness>,
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

impl Report<'_> {
    fn distance(&self, witness: &LocalWitness) -> RealCyclotomic {
        &witness.distance * &RealCyclotomic::from(self.spread.clone())
    }

    /// The depth in a sentence.
    fn sentence(&self) -> String {
        let tolerance = short(&self.tolerance, 6);
        match &self.depth {
            Ok(Depth { levels, .. }) => format!(
                "From level {} on, the points of every control ring are within {tolerance} of their limit.",
                levels.settled
            ),
            Err(error) => format!("No depth is known: {error}."),
        }
    }

    fn pictures(&self) -> Vec<Picture> {
        let Ok(Depth { levels, at, below, of_levels }) = &self.depth else { return Vec::new() };
        let spread = nearest(&self.spread);
        let line = LevelLine {
            name: "distance".to_owned(),
            values: of_levels.iter().map(|(level, value)| (*level, value * spread)).collect(),
            met: Some(levels.settled),
            is_constant: false,
        };
        let chart = Levels { tolerance: &self.tolerance, lines: vec![line], promised: Vec::new() };
        let witness = below.as_ref().unwrap_or(at);
        let points = (0..).zip(&witness.ring).map(|(a, x)| (self.ring.name(a), *x)).collect();
        let attained = Attained {
            control: Control::Points(points),
            place: Place::Named(self.ring.name(witness.point)),
            value: witness.distance.clone(),
        };
        let (refiner, most) = (Refiner::Ring(self.ring.clone()), &self.tolerance / &self.spread);
        let data = Picture::of_data(&refiner, &attained, witness.level, &most, [0.0; 2]);
        Picture::of_levels(&chart).into_iter().chain(data).collect()
    }

    fn sheet(&self, arguments: &DepthArguments) -> Sheet {
        let mut sheet = Sheet::default();
        let (name, spread) = (&arguments.scheme, &arguments.spread.spread);
        sheet.heading(1, format!("{name}, ε = {}, β = {spread}", arguments.tolerance));
        let Depth { levels: depth, at, below, .. } = match &self.depth {
            Ok(depth) => depth,
            Err(error) => {
                sheet.facts(vec![("exact depth".to_owned(), format!("none: {error}"))]);
                return sheet;
            }
        };
        let few = match depth.settled {
            0 => String::new(),
            level => too_few(level - 1),
        };
        let mut facts = vec![("exact depth".to_owned(), format!("{}{few}", levels(depth.settled)))];
        if depth.settled > depth.level {
            let text = format!("level {}, but not all later ones", depth.level);
            facts.push(("first met at".to_owned(), text));
        }
        let distance = with_decimal(&self.distance(at));
        facts.push((format!("distance C_{}·β", at.level), distance));
        if let Some(below) = below {
            let text = format!(
                "β times {}: {} is {} from the limit",
                points_text(&below.ring),
                self.ring.name(below.point),
                short(&self.distance(below), 9)
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

    fn form<'a>(&'a self, arguments: &'a DepthArguments) -> form::LocalReport<'a> {
        let depth = match &self.depth {
            Ok(Depth { levels: depth, at, below, .. }) => {
                let level = depth.settled;
                form::OrNone::Found(form::ExactlyOfRing {
                    depth: form::TwoSided { level, lower: level, upper: level, minimal: true },
                    first: depth.level,
                    distance: self.witness_form(at),
                    witness: below.as_ref().map(|witness| self.witness_form(witness)),
                })
            }
            Err(error) => form::OrNone::None { none: error.to_string() },
        };
        form::LocalReport {
            schema: SCHEMA,
            scheme: &arguments.scheme,
            tolerance: self.tolerance.to_string(),
            spread: self.spread.to_string(),
            depth,
        }
    }

    fn witness_form<'a>(&self, witness: &'a LocalWitness) -> form::LocalWitness<'a> {
        form::LocalWitness {
            level: witness.level,
            ring: &witness.ring,
            times: self.spread.to_string(),
            point: self.ring.name(witness.point),
            distance: Exact::of(&self.distance(witness)),
        }
    }
}
