//! The depth of one net with a mask on Z².

use super::faces::{FacesFormat, plain_rows};
use super::kind::Kind;
use super::parametric::{ParametricDepth, search};
use super::pictures::{Drawn, Pieces};
use super::subject::Subject;
use crate::cli::arguments::{DepthArguments, DistanceArgument};
use crate::cli::console::answer::deliver;
use crate::cli::console::destination::Destination;
use crate::cli::console::output::{Failure, Outcome};
use crate::cli::depth::certified;
use crate::cli::geometry::net::failure;
use subcert::exact::Rational;
use subcert::lattice::Between;
use subcert::net::Net;
use subcert::patch::LatticeNetDistances;
use subcert::scheme::LatticeMask;

/// The depth of a net; the scheme as it was typed, the name of the file, and what is to be told of it.
pub(super) fn lattice_net_depth(
    mask: &LatticeMask,
    net: &Net,
    (scheme, name, mut notes): (String, String, Vec<String>),
    (tolerance, arguments): (Rational, &DepthArguments),
    to: &Destination,
) -> Outcome {
    let refused = [
        (arguments.distance == Some(DistanceArgument::Geometric), "--distance geometric"),
        (arguments.relative, "--relative"),
    ];
    if let Some((_, option)) = refused.into_iter().find(|(given, _)| *given) {
        let text = format!(
            "{option}: nets with masks on Z^2 are compared with their limits at equal parameters only"
        );
        return Err(Failure::Input(text));
    }
    if arguments.certificate.is_some() {
        return Err(certified::none("nets with masks on Z^2 have none"));
    }
    let distances = LatticeNetDistances::new(net, mask).map_err(failure)?;
    let guaranteed = distances.a_priori(&tolerance).map_err(failure)?;
    let (compared, all) = (distances.compared(), net.faces().iter().product::<usize>());
    if compared < all {
        notes.push(format!("{compared} of {all} faces are compared: those with all points around them that are needed"));
    }
    let triangles = Between::of(mask) != Some(Between::Boxes);
    let subject = Subject {
        scheme,
        name,
        notes,
        kind: Kind::LatticeNet { faces_in_row: net.faces()[1], triangles },
        arguments,
        tolerance,
        guaranteed: guaranteed.into(),
        promised: None,
    };
    if arguments.a_priori {
        return deliver(to, &ParametricDepth::of(subject, None, Vec::new()));
    }
    let mesh = net.mesh().map_err(|error| Failure::Input(error.to_string()))?;
    let per_face = arguments.per_face.as_deref();
    let per_face =
        per_face.map(|path| FacesFormat::of(path).map(|format| (path, format))).transpose()?;
    let find = |subject: &Subject<'_>| {
        let depth = distances.depth(&subject.tolerance).map_err(failure)?;
        if let Some((path, format)) = per_face {
            format.write(path, &mesh, &plain_rows(depth.level, distances.faces(depth.level)))?;
        }
        Ok(depth)
    };
    search(subject, &distances.work(), to, find, |subject, depth| {
        let pieces = Pieces::of_mesh(&mesh, distances.faces(depth.level));
        let drawn = Drawn { subject, depth, refined: None };
        drawn.pictures(&pieces, |level| distances.distance(level))
    })
}
