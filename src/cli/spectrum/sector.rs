//! `subcert spectrum --sector`.

use super::parts::{Eigenvalue, Weight, eigenvalue_grid, orbit_facts, weights};
use super::ring::failure;
use crate::cli::arguments::SpectrumArguments;
use crate::cli::console::answer::{Answer, SCHEMA, show};
use crate::cli::console::output::Outcome;
use crate::cli::console::quantity::{Number, Orbit};
use serde::Serialize;
use std::cmp::Ordering;
use subcert::report::Sheet;
use subcert::spectrum;

/// What the blocks are.
const BLOCKS: &str = "Block 0 is the vertex with the two sharp edges, by itself. Where these are 0, the others are sums of \
     sines, and block j has cos(πj/F), F the number of faces.";

pub(crate) fn sector(arguments: &SpectrumArguments, faces: usize) -> Outcome {
    let scheme = &arguments.scheme;
    let found = spectrum::Sector::of(scheme, faces, arguments.corner).map_err(failure)?;
    let name = |point| found.name(point);
    let across = found.across.as_ref().map(|across| Across {
        eigenvalue: (&across.eigenvalue).into(),
        comparison: across.comparison(),
        side: across.side,
        second_above: across.second_above,
        weights: across.stencil.as_ref().map(|stencil| weights(stencil, name)),
    });
    let answer = Sector {
        schema: SCHEMA,
        scheme,
        faces: found.faces,
        corner: found.corner,
        orbits: Orbit::all(&found.orbits),
        eigenvalues: Eigenvalue::all(&found.eigenvalues),
        limit: weights(&found.limit, name),
        along: found.along.iter().map(|one| weights(one, name)).collect(),
        across,
    };
    show(&arguments.output, &answer)
}

/// The rules between two sharp edges at a vertex.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct Sector<'a> {
    /// The version of this form.
    schema: u32,
    /// The scheme as it was given.
    scheme: &'a str,
    /// The number F of faces.
    faces: usize,
    /// Whether the vertex is a corner.
    corner: bool,
    /// The points: the edges 0 and F are sharp.
    orbits: Vec<Orbit>,
    /// All eigenvalues, in descending order; block 0 is the vertex with the two sharp edges.
    eigenvalues: Vec<Eigenvalue>,
    /// The weights of the points in the limit of the vertex.
    limit: Vec<Weight>,
    /// The weights of the points in the tangent along the crease; at a corner in both tangents along the sharp edges.
    along: Vec<Vec<Weight>>,
    /// What goes into the sector; null for one face at a corner.
    across: Option<Across>,
}

/// The greatest eigenvalue λ of block 1; for one face on a crease that of the crease.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Across {
    /// λ.
    eigenvalue: Number,
    /// λ compared with 1/2, the eigenvalue of the tangents along sharp edges: `below`, `equal` or `above`.
    comparison: &'static str,
    /// The same.
    #[serde(skip)]
    side: Ordering,
    /// Whether block 2 has an eigenvalue above 1/2, too: on a crease, normals of generic data then have no limit.
    second_above: bool,
    /// The weights of the points in the tangent across; null where λ has a Jordan block with that 1/2.
    weights: Option<Vec<Weight>>,
}

impl Sector<'_> {
    /// How the points of level k, less the limit, compare with the powers of 1/2 and of the eigenvalue across.
    fn shape(&self) -> Vec<(String, String)> {
        let plane =
            "scaled by 2^k, the points of level k tend to one figure in the plane of both tangents";
        let side = self.across.as_ref().map_or(Ordering::Less, |across| across.side);
        let text = match (self.corner, side) {
            (false, Ordering::Equal) | (true, Ordering::Less) => plane,
            (false, Ordering::Less) => {
                "scaled by 2^k, the points of level k tend to the line of the tangent along"
            }
            (false, Ordering::Greater) => {
                "scaled by λ^−k, the points of level k tend to the line of the tangent across"
            }
            (true, Ordering::Equal) => {
                "1/2 has a Jordan block: scaled by 2^k/k, the points of level k tend to the line of the sum of both tangents"
            }
            (true, Ordering::Greater) => {
                "scaled by λ^−k, the points of level k tend to the line of the tangent across, which is in general not in \
             the plane of the tangents along: no tangent plane for generic data"
            }
        };
        let mut facts = vec![("λ along".to_owned(), "1/2".to_owned())];
        if let Some(across) = &self.across {
            let value = across.eigenvalue.words();
            facts.push(("λ across".to_owned(), format!("{value}, {}", across.comparison)));
        }
        facts.push(("so".to_owned(), text.to_owned()));
        if !self.corner && self.across.as_ref().is_some_and(|across| across.second_above) {
            let text = "block 2 has an eigenvalue above 1/2, too: for generic data they have no limit at the vertex";
            facts.push(("normals".to_owned(), text.to_owned()));
        }
        facts
    }
}

impl Answer for Sector<'_> {
    const NAME: &'static str = "spectrum-sector";

    fn sheet(&self) -> Sheet {
        let mut sheet = Sheet::default();
        let faces = if self.faces == 1 { "face" } else { "faces" };
        let place = if self.corner { "at a corner" } else { "on a crease" };
        sheet.heading(1, format!("{}, sector of {} {faces} {place}", self.scheme, self.faces));
        sheet.heading(2, "Eigenvalues");
        sheet.facts(vec![("of the points".to_owned(), Orbit::words(&self.orbits))]);
        sheet.grid(eigenvalue_grid(&self.eigenvalues));
        sheet.text(BLOCKS);
        sheet.heading(2, "Stencils");
        let mut facts = Vec::new();
        orbit_facts(&self.orbits, "limit", &self.limit, &mut facts);
        for (number, tangent) in self.along.iter().enumerate() {
            let which = if self.corner { format!(" {}", number + 1) } else { String::new() };
            orbit_facts(&self.orbits, &format!("along{which}"), tangent, &mut facts);
        }
        if let Some(stencil) = self.across.as_ref().and_then(|across| across.weights.as_ref()) {
            orbit_facts(&self.orbits, "across", stencil, &mut facts);
        }
        sheet.facts(facts);
        sheet.heading(2, "Shape");
        sheet.facts(self.shape());
        sheet
    }
}
