//! `subcert depth` of a ring.

use super::exact::points_text;
use crate::cli::arguments::DepthArguments;
use crate::cli::json::{SCHEMA, depth as form};
use crate::cli::output::{Failure, Outcome, positive, show, with_decimal};
use subcert::exact::{Rational, RealCyclotomic, format::short};
use subcert::limit::{LocalDepth, LocalDistances, LocalLimit, LocalLimitError, LocalWitness};
use subcert::report::{Sheet, json::Exact};
use subcert::scheme::LocalRules;

pub(super) fn ring_depth(ring: &LocalRules, arguments: &DepthArguments) -> Outcome {
    if arguments.polygon.is_some() || arguments.width.is_some() {
        return Err(Failure::Input(
            "--polygon and --width are for curves; distances of rings are exact".to_owned(),
        ));
    }
    let tolerance = positive("--tolerance", &arguments.tolerance)?;
    let spread = positive("--spread", &arguments.spread.spread)?;
    let depth = Depth::of(ring, &tolerance, &spread);
    let report = Report { ring, tolerance, spread, depth };
    show(arguments.output.format, || report.sheet(arguments), || report.form(arguments))
}

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
        Ok(Depth { levels: depth, at, below })
    }
}

impl Report<'_> {
    fn distance(&self, witness: &LocalWitness) -> RealCyclotomic {
        &witness.distance * &RealCyclotomic::from(self.spread.clone())
    }

    fn sheet(&self, arguments: &DepthArguments) -> Sheet {
        let mut sheet = Sheet::default();
        let (name, spread) = (&arguments.scheme, &arguments.spread.spread);
        sheet.heading(1, format!("{name}, ε = {}, β = {spread}", arguments.tolerance));
        let Depth { levels: depth, at, below } = match &self.depth {
            Ok(depth) => depth,
            Err(error) => {
                sheet.facts(vec![("exact depth".to_owned(), format!("none: {error}"))]);
                return sheet;
            }
        };
        let few = match depth.settled {
            0 => String::new(),
            level => format!("; {} are too few", level - 1),
        };
        let mut facts = vec![("exact depth".to_owned(), format!("{} levels{few}", depth.settled))];
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
            Ok(Depth { levels: depth, at, below }) => {
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
