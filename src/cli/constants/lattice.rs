//! `subcert constants` of a mask on Z^d.

use super::delta::number_row;
use crate::cli::arguments::ConstantsArguments;
use crate::cli::console::answer::{Answer, SCHEMA, show};
use crate::cli::console::lattice::{matrix, vector};
use crate::cli::console::output::{Failure, Outcome};
use crate::cli::console::quantity::Number;
use serde::Serialize;
use subcert::lattice::{Contraction, LatticeConstants as Constants};
use subcert::report::json::vectors;
use subcert::report::{Grid, Sheet};
use subcert::scheme::LatticeMask;

pub(crate) fn lattice_constants(mask: &LatticeMask, arguments: &ConstantsArguments) -> Outcome {
    if arguments.forward {
        let problem = "--forward: the rules of a mask on Z^d have no order; leave it out";
        return Err(Failure::Input(problem.to_owned()));
    }
    let d = mask.dimension();
    let (mut levels, mut ended) = (Vec::new(), None);
    let mut constants = Constants::new(mask);
    for _ in 0..arguments.block.levels {
        if let Err(cap) = constants.advance() {
            ended = Some(format!("{cap}; the constants up to here are exact"));
            break;
        }
        let found = constants.contraction().map_err(|error| Failure::Input(error.to_string()))?;
        levels.push(Level::of(&found, (&constants.norm()).into(), d));
    }
    if levels.is_empty() {
        return Err(Failure::Input(ended.unwrap_or_default()));
    }
    show(
        &arguments.output,
        &LatticeConstants {
            schema: SCHEMA,
            scheme: &arguments.scheme,
            dilation: mask.dilation().rows().map(<[i64]>::to_vec).collect(),
            edges: vectors(mask.edges(), d),
            levels,
            ended,
        },
    )
}

/// The constants of a mask on Z^d.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct LatticeConstants<'a> {
    /// The version of this form.
    schema: u32,
    /// The scheme as it was given.
    scheme: &'a str,
    /// The dilation matrix M, row by row.
    dilation: Vec<Vec<i64>>,
    /// The edges along which data differ by at most 1.
    edges: Vec<Vec<i64>>,
    /// T_c and Λ_c for c = 1, 2, …
    levels: Vec<Level>,
    /// Why some of them are missing; absent where none is.
    #[serde(skip_serializing_if = "Option::is_none")]
    ended: Option<String>,
}

/// The constants for blocks of c levels.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Level {
    /// c.
    c: u32,
    /// T_c.
    contraction: Number,
    /// The new point α …
    place: Vec<i64>,
    /// … and the edge u, of which the difference at α + u and α attains it.
    edge: Vec<i64>,
    /// A net that attains it: its values at places, which differ by at most 1 along edges.
    net: Vec<Height>,
    /// Λ_c.
    norm: Number,
}

/// A value of a net.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Height {
    /// The place.
    place: Vec<i64>,
    /// The value.
    value: i64,
}

impl Level {
    fn of(found: &Contraction, norm: Number, dimension: usize) -> Level {
        let height = |(place, value): (&[i64; 3], &i64)| Height {
            place: place[..dimension].to_vec(),
            value: *value,
        };
        Level {
            c: found.count,
            contraction: (&found.value).into(),
            place: found.place[..dimension].to_vec(),
            edge: found.edge[..dimension].to_vec(),
            net: found.norm.heights.iter().map(height).collect(),
            norm,
        }
    }
}

impl Answer for LatticeConstants<'_> {
    const NAME: &'static str = "constants-lattice";

    fn sheet(&self) -> Sheet {
        let mut sheet = Sheet::titled(self.scheme);
        let edges: Vec<String> = self.edges.iter().map(|edge| vector(edge)).collect();
        sheet.facts(vec![
            ("dilation matrix M".to_owned(), matrix(&self.dilation)),
            ("edges".to_owned(), edges.join(" ")),
        ]);
        let row = |level: &Level| {
            let of = format!("α = {}, u = {}", vector(&level.place), vector(&level.edge));
            vec![level.c.to_string(), level.contraction.words(), of, level.norm.words()]
        };
        sheet.grid(Grid::of(["c", "T_c", "attained by", "Λ_c"], self.levels.iter().map(row), 0));
        sheet.text(
            "T_c is the greatest difference of new points α + u and α after c steps, of data that differ by at most 1 along edges."
                .to_owned(),
        );
        if let Some(ended) = &self.ended {
            sheet.text(ended.clone());
        }
        sheet
    }

    /// One row for each number.
    fn grid(&self) -> Option<Grid> {
        let rows = self.levels.iter().flat_map(|level| {
            let c = level.c.to_string();
            [("contraction", &level.contraction), ("norm", &level.norm)]
                .map(|(name, value)| number_row(&[name, &c], value))
        });
        Some(Grid::of(["quantity", "c", "exact", "decimal"], rows.collect::<Vec<_>>(), 2))
    }
}
