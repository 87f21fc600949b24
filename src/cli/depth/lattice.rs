//! `subcert depth` of a mask on Z^d: the sound bound, for all nets of a spread.

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
use subcert::lattice::{LatticeConstants, displacement, natural_shift};
use subcert::report::json::vectors;
use subcert::report::{Grid, Sheet};
use subcert::scheme::LatticeMask;

/// The most differences of one constant.
const MAX_DIFFERENCES: usize = 1 << 12;

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
    let (mut constants, mut all) = (LatticeConstants::new(mask), vec![Rational::one()]);
    loop {
        let many = constants.next_count() > MAX_DIFFERENCES;
        if all.len() > 1 && many || constants.advance().is_err() {
            break;
        }
        let found = constants.contraction().map_err(|error| Failure::Input(error.to_string()))?;
        all.push(found.value);
    }
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
    /// A depth that is enough; null where there is none.
    depth: Option<u32>,
    /// Why there is none; missing where there is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    note: Option<String>,
}

impl Placed {
    fn of(
        places: &'static str,
        mask: &LatticeMask,
        shift: &[Rational],
        constants: &[Rational],
        [spread, tolerance]: [&Rational; 2],
    ) -> Result<Placed, Failure> {
        let found = displacement(mask, shift).map_err(|error| Failure::Input(error.to_string()))?;
        let Some(sigma) = found else {
            let problem =
                "nets in three dimensions have a depth for diagonal dilation matrices only";
            return Err(Failure::Input(problem.to_owned()));
        };
        let bound = SoundBound::of(sigma.clone(), constants.to_vec());
        let depth = bound.depth(spread, tolerance);
        Ok(Placed {
            places,
            displacement: (&sigma).into(),
            depth: depth.as_ref().ok().map(|found| found.level),
            note: depth.err().map(|error| error.to_string()),
        })
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
            let depth = placed.depth.map_or_else(
                || placed.note.clone().unwrap_or_default(),
                |depth| format!("at most {}", levels(depth)),
            );
            vec![placed.places.to_owned(), placed.displacement.words(), depth]
        };
        let header = ["points of level k at", "σ", "depth by the sound bound"];
        sheet.grid(Grid::of(header, self.placements.iter().map(row), 0));
        sheet.text(
            "|P^∞ − P^k| ≤ σβ(T_k + T_{k+1} + …) for the net P^k of level k; fewer levels may be enough."
                .to_owned(),
        );
        sheet
    }

    fn sentence(&self) -> String {
        let depths: Vec<String> = self
            .placements
            .iter()
            .map(|placed| placed.depth.map_or("none".to_owned(), |depth| depth.to_string()))
            .collect();
        let [tolerance, spread] = self.given;
        format!(
            "{}: at most {} levels for ε = {tolerance} and β = {spread}; with the points at their natural places {}.",
            self.scheme, depths[0], depths[1]
        )
    }
}
