//! Tables of sectors between sharp edges by number of faces.

use super::arrays::{Array, Entries};
use super::language::Language;
use super::real::{Real, RealType};
use super::write::{Origin, identifier, number_lines};
use super::writer::Writer;
use crate::exact::{Enclosed, Rational};
use crate::spectrum::Sector;

/// A table of sectors of consecutive numbers of faces as source code, all on a crease or all at a corner. Tangent 1 is the one along
/// the crease and tangent 2 the one across it; at a corner they are those along both sharp edges. The first lines say how to check it.
///
/// # Panics
/// When there are no sectors, or the language has no numbers of the type ([`Language::types`]).
///
/// ```
/// use subcert::spectrum::{Sector, table::{Language, Origin, RealType, write_sectors}};
///
/// let sectors = (1..=3).map(|n| Sector::of("loop", n, false)).collect::<Result<Vec<_>, _>>()?;
/// let origin = Origin { scheme: "loop", command: "subcert table loop --sectors 1..3 --format rust" };
/// let text = write_sectors(&sectors, Language::Rust, RealType::F64, &origin);
/// assert!(text.contains("pub const ACROSS: [f64; 3] = [0.25, 0.375, 0.5];"));
/// # Ok::<(), subcert::spectrum::SpectrumError>(())
/// ```
#[must_use]
pub fn write_sectors(
    sectors: &[Sector],
    language: Language,
    real: RealType,
    origin: &Origin<'_>,
) -> String {
    let (first, last) = (&sectors[0], &sectors[sectors.len() - 1]);
    let place = if first.corner { "corner" } else { "crease" };
    let count = |n: usize| i64::try_from(n).expect("a small number of faces");
    let constants = vec![("first_faces", count(first.faces)), ("last_faces", count(last.faces))];
    let name = format!("{}_{place}", identifier(origin.scheme));
    let writer = Writer { language, real, name, constants, vectors: false };
    writer.written(&header(first, last, real, origin), &arrays(sectors, real))
}

fn header(first: &Sector, last: &Sector, real: RealType, origin: &Origin<'_>) -> Vec<String> {
    let (place, flag, tangents) = if first.corner {
        ("at a corner", " --corner", "Tangents 1 and 2 go along both sharp edges, from the vertex.")
    } else {
        let tangents =
            "Tangent 1 goes along the crease to edge[0], tangent 2 across it into the sector.";
        ("on a crease or at the boundary", "", tangents)
    };
    let Origin { scheme, .. } = origin;
    let mut lines = vec![
        format!(
            "Stencils of {scheme} {place}, by the number n = {}, ..., {} of",
            first.faces, last.faces
        ),
        "faces between two sharp edges, edge[0] and edge[n], counter-clockwise.".to_owned(),
    ];
    lines.extend(number_lines(real, origin));
    lines.extend([
        format!("    subcert spectrum {scheme} --sector n{flag} --format json"),
        format!("Row n - {} of a table is that of n faces. {tangents}", first.faces),
        "A positive factor of each is free.".to_owned(),
    ]);
    lines
}

fn arrays(sectors: &[Sector], real: RealType) -> Vec<Array<'static>> {
    fn nearest<V: Enclosed>(values: &[V], real: RealType) -> Vec<Real> {
        values.iter().map(|value| Real::nearest(value, real)).collect()
    }
    let first = &sectors[0];
    let [vertex, end] = if first.corner { [(1, 1), (0, 1)] } else { [(3, 4), (1, 8)] };
    let rule = [vertex, end].map(|(p, q)| Rational::new(p, q));
    let ends = "the weights of vertex, and of edge[0] and edge[n] each";
    let table = |name, about: &str, rows: Vec<Vec<Real>>| Array {
        name,
        about: vec![format!("{about}: {ends}")],
        entries: Entries::Table(rows),
    };
    let faces = if first.orbits.len() > 2 { ", face[0], ..., [n - 1]" } else { "" };
    let start = format!("from offset[n - {}] on", first.faces);
    let tangent = |name, number: usize, rows: Vec<Vec<Real>>| Array {
        name,
        about: vec![format!(
            "tangent {number}, {start}: the weights of vertex, edge[0], ..., [n]{faces}"
        )],
        entries: Entries::List(rows),
    };
    let offsets = sectors.iter().scan(0, |next, sector| {
        let points = sector.limit.len();
        Some(std::mem::replace(next, *next + points))
    });
    let limit = |sector: &Sector| nearest(&sector.limit[..2], real);
    let along = |i: usize| sectors.iter().map(|sector| nearest(&sector.along[i], real)).collect();
    let mut arrays = vec![
        table("weights", "new vertex", sectors.iter().map(|_| nearest(&rule, real)).collect()),
        table("limit", "limit point", sectors.iter().map(limit).collect()),
        Array {
            name: "offset",
            about: vec!["where the entries of a sector begin in the lists".to_owned()],
            entries: Entries::Integers(offsets.collect()),
        },
        tangent("tangent_1", 1, along(0)),
    ];
    if first.corner {
        arrays.push(tangent("tangent_2", 2, along(1)));
        return arrays;
    }
    let across = || sectors.iter().filter_map(|sector| sector.across.as_ref());
    let eigenvalues = across().map(|one| Real::nearest(&one.eigenvalue, real)).collect();
    let stencils = across().filter_map(|one| one.stencil.as_ref());
    let stencils = stencils.map(|stencil| nearest(stencil, real)).collect();
    arrays.insert(
        1,
        Array {
            name: "across",
            about: vec!["the eigenvalue of tangent 2; that of tangent 1 is 1/2".to_owned()],
            entries: Entries::List(vec![eigenvalues]),
        },
    );
    arrays.push(tangent("tangent_2", 2, stencils));
    arrays
}
