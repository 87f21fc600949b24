//! The depth of one polygon mesh.

use super::as_sets::{SetDepth, measure, no_fan};
use super::face_depths::Search;
use super::faces::{FacesFormat, plain_rows};
use super::kind::Kind;
use super::parametric::{ParametricDepth, search};
use super::pictures::{Drawn, Pieces};
use super::promise::Formula;
use super::refined::Refined;
use super::subject::Subject;
use crate::cli::arguments::{AnyBoundary, DepthArguments};
use crate::cli::console::answer::deliver;
use crate::cli::console::destination::Destination;
use crate::cli::console::output::{Outcome, positive};
use crate::cli::geometry::mesh_input::{Given, failure, read, with_boundary};
use std::path::Path;
use subcert::mesh::MeshScheme;
use subcert::patch::{FORMULA_PAPER, MeshDistances, a_priori, formula_level};

pub(in crate::cli::depth) fn mesh_depth(
    path: &Path,
    arguments: &DepthArguments,
    to: &Destination,
) -> Outcome {
    let asked = positive("--tolerance", &arguments.tolerance)?;
    let Given { scheme, name, file, mut notes } =
        read(&arguments.scheme, path, arguments.weld.tolerance.as_deref())?;
    let file = match arguments.boundary {
        Some(AnyBoundary::Mesh(boundary)) => with_boundary(file, boundary),
        _ => file,
    };
    let mesh = file.mesh();
    let (geometric, tolerance) = measure(mesh.points(), arguments, &asked, "mesh", &mut notes)?;
    let refused = |error| failure(&file, &error);
    let guaranteed = a_priori(mesh, scheme, &tolerance).map_err(refused)?;
    let promised = (scheme == MeshScheme::DooSabin).then(|| {
        let level = formula_level(mesh, guaranteed.longest_edge, &tolerance);
        Formula::new(FORMULA_PAPER, level)
    });
    let subject = Subject {
        scheme: scheme.name().to_owned(),
        name,
        notes,
        kind: Kind::Mesh { tagged: !mesh.tags().is_plain() },
        arguments,
        tolerance,
        guaranteed: guaranteed.into(),
        promised,
    };
    let per_face = arguments.per_face.as_deref();
    let per_face =
        per_face.map(|path| FacesFormat::of(path).map(|format| (path, format))).transpose()?;
    if geometric && !arguments.a_priori {
        let found = Search::of(mesh, scheme, &subject.tolerance, arguments, refused)?;
        return deliver(to, &SetDepth::of(subject, asked, mesh, None, found)?);
    }
    no_fan(arguments)?;
    if arguments.a_priori {
        return deliver(to, &ParametricDepth::of(subject, None, Vec::new()));
    }
    let distances = MeshDistances::new(mesh.clone(), scheme).map_err(refused)?;
    let find = |subject: &Subject<'_>| {
        let depth = distances.depth(&subject.tolerance).map_err(refused)?;
        if let Some((path, format)) = per_face {
            let rows = plain_rows(depth.level, distances.faces(depth.level));
            format.write(path, mesh, &rows)?;
        }
        Ok(depth)
    };
    search(subject, &distances.work(), to, find, |subject, depth| {
        let pieces = Pieces::of_mesh(mesh, distances.faces(depth.level));
        let refined = Refined::of_mesh(mesh, scheme, depth.level);
        let drawn = Drawn { subject, depth, refined };
        drawn.pictures(&pieces, |level| distances.distance(level))
    })
}
