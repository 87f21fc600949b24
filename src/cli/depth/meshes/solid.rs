//! The depth of one hexahedral solid.

use super::as_sets::{SetDepth, measure, no_fan};
use super::face_depths::Search;
use super::faces::FacesFormat;
use super::kind::Kind;
use super::parametric::{ParametricDepth, search};
use super::pictures::{Drawn, Pieces};
use super::promise::{APriori, Formula};
use super::refined::Refined;
use super::subject::Subject;
use crate::cli::arguments::DepthArguments;
use crate::cli::console::answer::deliver;
use crate::cli::console::destination::Destination;
use crate::cli::console::output::{Failure, Outcome, positive};
use crate::cli::console::save::save;
use crate::cli::geometry::solid::{failure, read};
use std::fmt::Write as _;
use std::path::Path;
use subcert::exact::Rational;
use subcert::float::shortest;
use subcert::mesh::{MeshError, MeshScheme};
use subcert::patch::{
    MeshDistances, SOLID_FORMULA_PAPER, a_priori, solid_a_priori, solid_formula_level,
};
use subcert::solid::{HexMesh, SOLID_SCHEME, to_vtk};

pub(in crate::cli::depth) fn solid_depth(
    path: &Path,
    arguments: &DepthArguments,
    to: &Destination,
) -> Outcome {
    let asked = positive("--tolerance", &arguments.tolerance)?;
    let (name, file) = read(path)?;
    let mesh = file.mesh();
    let refused = |error: MeshError| Failure::Input(error.to_string());
    let boundary = match mesh.boundary() {
        Ok(boundary) => Some(boundary),
        Err(_) if arguments.distance.is_none() => None,
        Err(error) => return Err(refused(error)),
    };
    let points = boundary.as_ref().map_or(mesh.points(), |boundary| boundary.mesh.points());
    let mut notes = Vec::new();
    let (geometric, tolerance) = measure(points, arguments, &asked, "boundary", &mut notes)?;
    let promised = solid_formula_level(mesh, &tolerance).map_err(refused)?;
    let promised = Formula::new(SOLID_FORMULA_PAPER, Some(promised));
    let subject = |kind, tolerance, guaranteed: APriori| Subject {
        scheme: SOLID_SCHEME.to_owned(),
        name,
        notes,
        kind,
        arguments,
        tolerance,
        guaranteed,
        promised: Some(promised),
    };
    if let Some(boundary) = boundary.filter(|_| geometric && !arguments.a_priori) {
        arguments.per_face.as_deref().map(FacesFormat::of).transpose()?;
        let found = Search::of(&boundary.mesh, SCHEME, &tolerance, arguments, refused)?;
        let guaranteed = a_priori(&boundary.mesh, SCHEME, &tolerance).map_err(refused)?;
        let subject = subject(Kind::Boundary, tolerance, guaranteed.into());
        let depth = SetDepth::of(subject, asked, &boundary.mesh, Some(&boundary), found)?;
        return deliver(to, &depth);
    }
    no_fan(arguments)?;
    let per_face = arguments.per_face.as_deref();
    let per_face =
        per_face.map(|path| CellsFormat::of(path).map(|form| (path, form))).transpose()?;
    let distances =
        MeshDistances::of_solid(mesh.clone()).map_err(|error| failure(&file, &error))?;
    let guaranteed = solid_a_priori(mesh, &distances, &tolerance).map_err(refused)?;
    let subject = subject(Kind::Solid, tolerance, guaranteed.into());
    if arguments.a_priori {
        return deliver(to, &ParametricDepth::of(subject, None, Vec::new()));
    }
    let find = |subject: &Subject<'_>| {
        let depth = distances.depth(&subject.tolerance).map_err(refused)?;
        if let Some((path, format)) = per_face {
            format.write(path, mesh, depth.level, &distances.faces(depth.level))?;
        }
        Ok(depth)
    };
    search(subject, &distances.work(), to, find, |subject, depth| {
        let pieces = Pieces::of_solid(mesh, &distances.faces(depth.level));
        let refined = Refined::of_solid(mesh, depth.level);
        let drawn = Drawn { subject, depth, refined };
        drawn.pictures(&pieces, |level| distances.distance(level))
    })
}

/// The rules of the boundary.
const SCHEME: MeshScheme = MeshScheme::Bajaj;

/// The forms of the file of the distances of all cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum CellsFormat {
    Csv,
    Vtk,
}

impl CellsFormat {
    /// By the extension.
    fn of(path: &Path) -> Result<CellsFormat, Failure> {
        let extension = path.extension().unwrap_or_default().to_ascii_lowercase();
        match extension.to_str() {
            Some("csv") => Ok(CellsFormat::Csv),
            Some("vtk") => Ok(CellsFormat::Vtk),
            _ => Err(Failure::Input(format!(
                "--per-face writes .csv or .vtk of the cells of a solid, and not `{}`",
                path.display()
            ))),
        }
    }

    /// Writes the lower and upper bounds of all cells.
    fn write(
        self,
        path: &Path,
        mesh: &HexMesh<Rational>,
        level: u32,
        distances: &[[f64; 2]],
    ) -> Outcome {
        let text = match self {
            CellsFormat::Csv => csv(level, distances),
            CellsFormat::Vtk => vtk(mesh, level, distances)?,
        };
        save(path, &text)
            .map_err(|error| Failure::Input(format!("cannot write `{}`: {error}", path.display())))
    }
}

fn csv(level: u32, distances: &[[f64; 2]]) -> String {
    let mut text = "cell,level,lower,upper\n".to_owned();
    for (cell, [lower, upper]) in distances.iter().enumerate() {
        writeln!(text, "{cell},{level},{},{}", shortest(*lower), shortest(*upper)).expect("memory");
    }
    text
}

/// The control mesh with the upper bounds as data of its cells.
fn vtk(mesh: &HexMesh<Rational>, level: u32, distances: &[[f64; 2]]) -> Result<String, Failure> {
    let title = format!("distance of each cell from the limit solid at level {level}");
    let mut text = to_vtk(mesh, &title).map_err(|error| Failure::Input(error.to_string()))?;
    let head = "SCALARS distance double 1\nLOOKUP_TABLE default";
    writeln!(text, "CELL_DATA {}\n{head}", distances.len()).expect("memory");
    for [_, upper] in distances {
        writeln!(text, "{}", shortest(*upper)).expect("memory");
    }
    Ok(text)
}
