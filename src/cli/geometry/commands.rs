//! `subcert refine` and `limit`, and `oracle --mesh`: for polygon meshes, tensor nets and hexahedral
//! solids.

use super::mesh;
use super::net;
use super::net::NetInput;
use super::solid;
use crate::cli::arguments::{AnyBoundary, LimitArguments, OracleArguments, RefineArguments};
use crate::cli::console::output::{Failure, Outcome, deliver};
use std::path::Path;
use subcert::scheme::find_definition;

/// What is refined.
pub(crate) enum Geometry {
    Mesh,
    Net,
    Solid,
}

impl Geometry {
    /// The same, where options are given that polygon meshes alone have.
    pub(crate) fn with<const N: usize>(
        input: &NetInput<'_>,
        given: [(bool, &str); N],
    ) -> Result<Geometry, Failure> {
        let geometry = Geometry::of(input)?;
        match given.into_iter().find(|(given, _)| *given) {
            Some((_, option)) if !matches!(geometry, Geometry::Mesh) => {
                Err(Failure::Input(format!("{option} is for polygon meshes")))
            }
            _ => Ok(geometry),
        }
    }

    /// The scheme decides on solids, the file or `--closed` on nets.
    pub(crate) fn of(input: &NetInput<'_>) -> Result<Geometry, Failure> {
        if solid::takes(input.scheme) {
            if input.closed.is_some() {
                let message = "--closed is for nets in .csv or .json, and bajaj refines solids";
                return Err(Failure::Input(message.to_owned()));
            }
            return Ok(Geometry::Solid);
        }
        if input.is_net() {
            return Ok(Geometry::Net);
        }
        if find_definition(input.scheme).is_ok_and(|found| found.is_lattice()) {
            return Err(Failure::Input(format!(
                "`{}` is a mask on Z^d, and refines nets in .csv or .json; schemes of polygon meshes are catmull-clark, \
                 loop and others, which `subcert schemes` lists",
                input.scheme.trim()
            )));
        }
        Ok(Geometry::Mesh)
    }
}

/// Refuses `--boundary` where it says nothing.
pub(crate) fn check_boundary(
    boundary: Option<AnyBoundary>,
    of_polygons: bool,
    of_meshes: bool,
) -> Outcome {
    let fits = match boundary {
        None => true,
        Some(AnyBoundary::Polygon(_)) => of_polygons,
        Some(AnyBoundary::Mesh(_)) => of_meshes,
    };
    if fits {
        return Ok(());
    }
    let message = "--boundary closed and open are for control polygons (--polygon), and none, edge and corner for \
                   polygon meshes (--mesh)";
    Err(Failure::Input(message.to_owned()))
}

pub(crate) fn refine(arguments: &RefineArguments) -> Outcome {
    let RefineArguments { scheme, mesh, closed, level, output, boundary, isolated, weld } =
        arguments;
    let net = NetInput { scheme, path: mesh, closed: *closed };
    let given =
        [(boundary.is_some(), "--boundary"), (isolated.is_some(), "--isolated"), weld.given()];
    match Geometry::with(&net, given)? {
        Geometry::Mesh => mesh::refine(arguments),
        Geometry::Net => net::refine(&net, *level, output),
        Geometry::Solid => solid::refine(arguments),
    }
}

pub(crate) fn limit(arguments: &LimitArguments) -> Outcome {
    let LimitArguments { scheme, mesh, closed, level, output, boundary, isolated, weld } =
        arguments;
    let net = NetInput { scheme, path: mesh, closed: *closed };
    let given =
        [(boundary.is_some(), "--boundary"), (isolated.is_some(), "--isolated"), weld.given()];
    match Geometry::with(&net, given)? {
        Geometry::Mesh => mesh::limit(arguments),
        Geometry::Net => net::limit(&net, *level, output),
        Geometry::Solid => solid::limit(arguments),
    }
}

/// What `subcert oracle --mesh` writes.
pub(crate) fn reference_values(arguments: &OracleArguments, path: &Path) -> Outcome {
    let OracleArguments { scheme, closed, level, boundary, weld, format, .. } = arguments;
    let net = NetInput { scheme, path, closed: *closed };
    let geometry = Geometry::with(&net, [weld.given()])?;
    check_boundary(*boundary, false, matches!(geometry, Geometry::Mesh))?;
    let text = match geometry {
        Geometry::Mesh => {
            let boundary = boundary.and_then(AnyBoundary::of_mesh);
            let given = (boundary, None, weld.tolerance.as_deref());
            mesh::reference_values(scheme, path, *level, given, *format)?
        }
        Geometry::Net => net::reference_values(&net, *level, *format)?,
        Geometry::Solid => solid::reference_values(path, *level, *format)?,
    };
    deliver(&text, arguments.file.as_deref())
}
