//! `subcert depth` of a mask on Z^d, for all nets of a spread.

use super::numbers::levels;
use crate::cli::arguments::DepthArguments;
use crate::cli::console::answer::{Answer, SCHEMA, deliver};
use crate::cli::console::destination::Destination;
use crate::cli::console::lattice::vector;
use crate::cli::console::output::{Failure, Outcome, positive};
use crate::cli::console::quantity::{Number, Text};
use serde::Serialize;
use subcert::bound::SoundBound;
use subcert::exact::Rational;
use subcert::lattice::{LatticeConstants, LatticeDistance, displacement, natural_shift};
use subcert::report::json::vectors;
use subcert::report::{Grid, Sheet};
use subcert::scheme::LatticeMask;

/// The most levels of a depth that is looked for by distances.
const MAX_DEPTH: u32 = 400;

pub(super) fn lattice_depth(
    mask: &LatticeMask,
    arguments: &DepthArguments,
    to: &Destination,
) -> Outcome {
    if arguments.polygon.is_some() || arguments.width.is_some() {
        let problem = "--polygon and --width are for curves; of masks on Z^d a bound for all nets of a spread is computed";
        return Err(Failure::Input(problem.to_owned()));
    }
    let tolerance = positive("--tolerance", &arguments.tolerance)?;
    let spread = positive("--spread", &arguments.spread.spread)?;
    let d = mask.dimension();
    let all =
        LatticeConstants::up_to_cap(mask).map_err(|error| Failure::Input(error.to_string()))?;
    let shifts = [("M^-k α", vec![Rational::zero(); d]), ("M^-k (α + τ)", natural_shift(mask))];
    let placed = shifts
        .into_iter()
        .map(|(places, shift)| Placed::of(places, mask, &shift, &all, [&spread, &tolerance]));
    let placements = placed.collect::<Result<Vec<Placed>, Failure>>()?;
    deliver(
        to,
        &LatticeDepth {
            schema: SCHEMA,
            scheme: &arguments.scheme,
            edges: vectors(mask.edges(), d),
            tolerance: Text(tolerance),
            spread: Text(spread),
            contraction: all[1..].iter().map(Number::from).collect(),
            placements,
            given: [&arguments.tolerance, &arguments.spread.spread],
        },
    )
}

/// The depth of nets with a mask on Z^d.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct LatticeDepth<'a> {
    /// The version of this form.
    schema: u32,
    /// The scheme as it was given.
    scheme: &'a str,
    /// The edges along which data differ by at most the spread.
    edges: Vec<Vec<i64>>,
    /// The tolerance ε.
    tolerance: Text<Rational>,
    /// The spread β.
    spread: Text<Rational>,
    /// T_1, T_2, …
    contraction: Vec<Number>,
    /// With the points at M^{−k}α, and at their natural places.
    placements: Vec<Placed>,
    /// The tolerance and the spread as they were given.
    #[serde(skip)]
    given: [&'a str; 2],
}

/// The depth with the points at given places.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Placed {
    /// The places of the points of level k.
    places: &'static str,
    /// σ: the displacement of one step.
    displacement: Number,
    /// Fewer levels are too few for some net of the spread.
    at_least: u32,
    /// A depth that is enough; null where there is none.
    depth: Option<u32>,
    /// For k = 0, 1, … bounds of the greatest |P^∞ − P^k| of nets of spread 1.
    distances: Vec<Bounds>,
    /// Why there is none; missing where there is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    note: Option<String>,
}

/// Bounds of a distance, as decimals that are rounded outwards.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Bounds {
    /// It is not below this.
    at_least: Number,
    /// It is not above this; null where no T_c is below 1.
    at_most: Option<Number>,
}

impl Placed {
    fn of(
        places: &'static str,
        mask: &LatticeMask,
        shift: &[Rational],
        constants: &[Rational],
        [spread, tolerance]: [&Rational; 2],
    ) -> Result<Placed, Failure> {
        let input = |error: &dyn std::fmt::Display| Failure::Input(error.to_string());
        let found = displacement(mask, shift).map_err(|error| input(&error))?;
        let Some(sigma) = found else {
            let problem =
                "nets in three dimensions have a depth for diagonal dilation matrices only";
            return Err(Failure::Input(problem.to_owned()));
        };
        let bound = SoundBound::of(sigma.clone(), constants.to_vec());
        let depth = bound.depth(spread, tolerance);
        let sound = depth.as_ref().ok().map(|found| found.level);
        let found = LatticeDistance::of(mask, shift, constants.to_vec());
        let distance = found.map_err(|error| input(&error))?;
        let (at_least, nearer) = distance.as_ref().map_or((0, None), |distance| {
            distance.depth(spread, tolerance, sound.unwrap_or(0).min(MAX_DEPTH))
        });
        let bounds = |(k, lower): (u32, &Rational)| Bounds {
            at_least: lower.into(),
            at_most: distance.as_ref().and_then(|all| all.upper(k)).as_ref().map(Number::from),
        };
        let lower = distance.iter().flat_map(|all| &all.lower);
        Ok(Placed {
            places,
            displacement: (&sigma).into(),
            at_least,
            depth: nearer.or(sound),
            distances: (0..).zip(lower).map(bounds).collect(),
            note: depth.err().map(|error| error.to_string()),
        })
    }
}

impl Placed {
    /// The depth in words.
    fn words(&self) -> String {
        match self.depth {
            None => self.note.clone().unwrap_or_default(),
            Some(depth) if depth <= self.at_least => levels(depth),
            Some(depth) if self.at_least == 0 => format!("at most {}", levels(depth)),
            Some(depth) => format!("{} to {}", self.at_least, levels(depth)),
        }
    }
}

impl Answer for LatticeDepth<'_> {
    const NAME: &'static str = "depth-lattice";

    fn sheet(&self) -> Sheet {
        let mut sheet = Sheet::titled(self.scheme);
        let [tolerance, spread] = self.given;
        let edges: Vec<String> = self.edges.iter().map(|edge| vector(edge)).collect();
        sheet.facts(vec![
            ("tolerance ε".to_owned(), tolerance.to_owned()),
            ("spread β".to_owned(), format!("{spread}, along {}", edges.join(" "))),
        ]);
        let row = |placed: &Placed| {
            vec![placed.places.to_owned(), placed.displacement.words(), placed.words()]
        };
        let header = ["points of level k at", "σ", "depth"];
        sheet.grid(Grid::of(header, self.placements.iter().map(row), 0));
        for placed in self.placements.iter().filter(|placed| !placed.distances.is_empty()) {
            sheet.heading(2, format!("Distances with the points at {}", placed.places));
            let row = |(k, bounds): (usize, &Bounds)| {
                let most = bounds.at_most.as_ref().map_or("open".to_owned(), Number::words);
                vec![k.to_string(), bounds.at_least.words(), most]
            };
            let header = ["k", "at least", "at most"];
            sheet.grid(Grid::of(header, placed.distances.iter().enumerate().map(row), 0));
        }
        sheet.text(
            "These are bounds of the greatest |P^∞ − P^k| of all nets P^0 of spread 1: from below at points where P^∞ is known exactly, from above by the exact greatest |P^{i+1} − P^i|, i = k, k+1, …, and T_c for the rest.",
        );
        sheet
    }

    fn sentence(&self) -> String {
        let depths: Vec<String> = self.placements.iter().map(Placed::words).collect();
        let [tolerance, spread] = self.given;
        format!(
            "{}: {} for ε = {tolerance} and β = {spread}; with the points at their natural places {}.",
            self.scheme, depths[0], depths[1]
        )
    }
}
