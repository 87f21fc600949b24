//! `subcert spectrum --sector`.

use super::ring::{
    eigenvalue_form, eigenvalue_grid, failure, orbit_facts, orbits, orbits_text, weights,
};
use crate::cli::arguments::SpectrumArguments;
use crate::cli::console::output::{Outcome, show, with_decimal};
use crate::cli::json::{SCHEMA, spectrum as form};
use std::cmp::Ordering;
use subcert::report::{Sheet, json::Exact};
use subcert::spectrum::Sector;

/// What the blocks are.
const BLOCKS: &str = "Block 0 is the vertex with the two sharp edges, by itself. Where these are 0, the others are sums of \
     sines, and block j has cos(πj/F), F the number of faces.";

pub(crate) fn sector(arguments: &SpectrumArguments, faces: usize) -> Outcome {
    let sector = Sector::of(&arguments.scheme, faces, arguments.corner).map_err(failure)?;
    show(
        &arguments.output,
        || sheet(&arguments.scheme, &sector),
        || form(&arguments.scheme, &sector),
    )
}

fn sheet(name: &str, sector: &Sector) -> Sheet {
    let mut sheet = Sheet::default();
    let faces = if sector.faces == 1 { "face" } else { "faces" };
    let place = if sector.corner { "at a corner" } else { "on a crease" };
    sheet.heading(1, format!("{name}, sector of {} {faces} {place}", sector.faces));
    sheet.heading(2, "Eigenvalues");
    sheet.facts(vec![("of the points".to_owned(), orbits_text(&sector.orbits))]);
    sheet.grid(eigenvalue_grid(&sector.eigenvalues));
    sheet.text(BLOCKS);
    sheet.heading(2, "Stencils");
    let mut facts = Vec::new();
    orbit_facts(&sector.orbits, "limit", &sector.limit, &mut facts);
    for (number, tangent) in sector.along.iter().enumerate() {
        let which = if sector.corner { format!(" {}", number + 1) } else { String::new() };
        orbit_facts(&sector.orbits, &format!("along{which}"), tangent, &mut facts);
    }
    if let Some(stencil) = sector.across.as_ref().and_then(|across| across.stencil.as_ref()) {
        orbit_facts(&sector.orbits, "across", stencil, &mut facts);
    }
    sheet.facts(facts);
    sheet.heading(2, "Shape");
    sheet.facts(shape(sector));
    sheet
}

/// How the points of level k, less the limit, compare with the powers of 1/2 and of the eigenvalue across.
fn shape(sector: &Sector) -> Vec<(String, String)> {
    let plane =
        "scaled by 2^k, the points of level k tend to one figure in the plane of both tangents";
    let side = sector.across.as_ref().map_or(Ordering::Less, |across| across.side);
    let text = match (sector.corner, side) {
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
    if let Some(across) = &sector.across {
        let value = with_decimal(&across.eigenvalue);
        facts.push(("λ across".to_owned(), format!("{value}, {}", across.comparison())));
    }
    facts.push(("so".to_owned(), text.to_owned()));
    if !sector.corner && sector.across.as_ref().is_some_and(|across| across.second_above) {
        let text = "block 2 has an eigenvalue above 1/2, too: for generic data they have no limit at the vertex";
        facts.push(("normals".to_owned(), text.to_owned()));
    }
    facts
}

fn form<'a>(scheme: &'a str, sector: &'a Sector) -> form::Sector<'a> {
    let name = |point| sector.name(point);
    form::Sector {
        schema: SCHEMA,
        scheme,
        faces: sector.faces,
        corner: sector.corner,
        orbits: orbits(&sector.orbits),
        eigenvalues: sector.eigenvalues.iter().map(eigenvalue_form).collect(),
        limit: weights(&sector.limit, name),
        along: sector.along.iter().map(|one| weights(one, name)).collect(),
        across: sector.across.as_ref().map(|across| form::Across {
            eigenvalue: Exact::of(&across.eigenvalue),
            comparison: across.comparison(),
            second_above: across.second_above,
            weights: across.stencil.as_ref().map(|stencil| weights(stencil, name)),
        }),
    }
}
