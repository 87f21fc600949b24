//! `subcert depth`.

mod bound;
mod certified;
mod compared;
mod distance;
mod exact;
mod lattice;
mod local_rules;
mod masks;
mod meshes;
mod numbers;
mod place;
mod points;
mod polygon;
mod scheme_pictures;
mod sets;
mod surface;

use crate::cli::arguments::{DepthArguments, DistanceArgument, FacesArgument};
use crate::cli::console::answer::deliver;
use crate::cli::console::destination::Destination;
use crate::cli::console::output::{Failure, Outcome};
use crate::cli::geometry::commands::{Geometry, check_boundary};
use crate::cli::geometry::net::NetInput;
#[cfg(feature = "schema")]
pub(super) use lattice::LatticeDepth;
#[cfg(feature = "schema")]
pub(super) use local_rules::LocalReport;
use local_rules::ring_depth;
pub(super) use masks::Depth;
#[cfg(feature = "schema")]
pub(super) use meshes::{ParametricDepth, SetDepth};
use subcert::scheme::{AnyScheme, parse_any_scheme};

pub(super) fn depth(arguments: &DepthArguments) -> Outcome {
    let to = Destination::of(&arguments.output, &page_name(arguments))?;
    if arguments.certificate.is_some() && arguments.mesh.is_none() && arguments.polygon.is_none() {
        return Err(certified::none("give one by --polygon or --mesh"));
    }
    if let Some(path) = &arguments.mesh {
        let net = NetInput { scheme: &arguments.scheme, path, closed: arguments.closed };
        let geometry = Geometry::with(&net, [arguments.weld.given()])?;
        check_boundary(arguments.boundary, false, matches!(geometry, Geometry::Mesh))?;
        return match geometry {
            Geometry::Mesh | Geometry::Solid if arguments.certificate.is_some() => {
                Err(certified::none("polygon meshes and solids have none"))
            }
            Geometry::Mesh => meshes::mesh_depth(path, arguments, &to),
            Geometry::Net => meshes::net_depth(&net, arguments, &to),
            Geometry::Solid => meshes::solid_depth(path, arguments, &to),
        };
    }
    check_boundary(arguments.boundary, arguments.polygon.is_some(), false)?;
    match (&arguments.polygon, arguments.distance) {
        (None, _) => only_parametric(arguments, "all control polygons of a spread")?,
        (Some(_), Some(DistanceArgument::Parametric)) if arguments.relative => {
            let message = "--relative is for the distance of sets: leave out --distance parametric, or give \
                           the tolerance itself";
            return Err(Failure::Input(message.to_owned()));
        }
        _ => {}
    }
    let scheme = match parse_any_scheme(&arguments.scheme)? {
        AnyScheme::Uniform(scheme) => scheme,
        AnyScheme::Lattice(mask) => return lattice::lattice_depth(&mask, arguments, &to),
        AnyScheme::LocalRules(ring) => return ring_depth(&ring, arguments, &to),
    };
    deliver(&to, &Depth::of(&scheme, arguments)?)
}

/// Refuses the options of distances of sets.
fn only_parametric(arguments: &DepthArguments, of: &str) -> Outcome {
    let asked = [
        (arguments.distance == Some(DistanceArgument::Geometric), "--distance geometric"),
        (arguments.faces == FacesArgument::Fan, "--faces fan"),
        (arguments.relative, "--relative"),
    ];
    match asked.iter().find(|(asked, _)| *asked) {
        None => Ok(()),
        Some((_, option)) => {
            let message = format!(
                "{option} is for meshes, nets, solids and control polygons; {of} are compared with their limits at \
                 equal parameters"
            );
            Err(Failure::Input(message))
        }
    }
}

/// The name of a page in a folder: `depth-` and that of the file, or of the scheme.
fn page_name(arguments: &DepthArguments) -> String {
    let path = arguments.mesh.as_ref().or(arguments.polygon.as_ref());
    let stem = path.and_then(|path| path.file_stem()).map(|stem| stem.to_string_lossy());
    format!("depth-{}", stem.as_deref().unwrap_or(&arguments.scheme))
}
