//! The depth of one net.

use super::as_sets::{SetDepth, measure};
use super::face_depths::{Faces, Growth, Search, asks_for_faces};
use super::faces::{FacesFormat, plain_rows};
use super::kind::Kind;
use super::lattice::lattice_net_depth;
use super::parametric::{ParametricDepth, search};
use super::pictures::{Drawn, Pieces};
use super::promise::Formula;
use super::refined::Refined;
use super::subject::{Subject, searched};
use crate::cli::arguments::{DepthArguments, FacesArgument};
use crate::cli::console::answer::deliver;
use crate::cli::console::destination::Destination;
use crate::cli::console::output::{Failure, Outcome, positive};
use crate::cli::depth::certified;
use crate::cli::geometry::net::{NetFile, NetInput, failure};
use subcert::net::NetRules;
use subcert::patch::{
    APriori, FaceSurface, NET_FORMULA_PAPER, NetDistances, net_a_priori, net_formula_level,
};
use subcert::scheme::Mask;

pub(in crate::cli::depth) fn net_depth(
    asked: &NetInput<'_>,
    arguments: &DepthArguments,
    to: &Destination,
) -> Outcome {
    let given = positive("--tolerance", &arguments.tolerance)?;
    if arguments.faces == FacesArgument::Fan {
        let message = "--faces fan is for polygon meshes; the faces of a net are bilinear";
        return Err(Failure::Input(message.to_owned()));
    }
    let NetFile { scheme, name, net, mut notes } = asked.read()?;
    let scheme = match scheme {
        NetRules::Product(scheme) => scheme,
        NetRules::Lattice(typed, mask) => {
            let subject = (typed, name, notes);
            return lattice_net_depth(&mask, &net, subject, (given, arguments), to);
        }
    };
    let (geometric, tolerance) = measure(net.points(), arguments, &given, "net", &mut notes)?;
    let guaranteed = net_a_priori(&net, &scheme, &tolerance).map_err(failure)?;
    let promised = net_formula_level(&net, &scheme, &tolerance)
        .map(|level| Formula::new(NET_FORMULA_PAPER, level));
    let per_face = arguments.per_face.as_deref();
    let per_face =
        per_face.map(|path| FacesFormat::of(path).map(|format| (path, format))).transpose()?;
    let [u, v] = guaranteed.longest_edges;
    let guaranteed =
        APriori { level: guaranteed.level, longest_edge: u.max(v), ratio: guaranteed.ratio };
    let subject = Subject {
        scheme: scheme.name().to_owned(),
        name,
        notes,
        kind: Kind::Net { faces_in_row: net.faces()[1] },
        arguments,
        tolerance,
        guaranteed: guaranteed.into(),
        promised,
    };
    let tolerance = &subject.tolerance;
    let mesh = || net.mesh().map_err(|error| Failure::Input(error.to_string()));
    let distances = || NetDistances::new(net.clone(), &scheme).map_err(failure);
    if geometric && !arguments.a_priori {
        let (mesh, distances) = (mesh()?, distances()?);
        let (found, stopped) = searched(&distances.work(), arguments, || {
            let found = distances.geometric_depth(tolerance).map_err(failure)?;
            if let Some(path) = &arguments.certificate {
                certified::of_net(path, &net, &scheme, &distances, &found, tolerance)?;
            }
            let faces = match found.level.filter(|_| asks_for_faces(arguments)) {
                None => None,
                Some(level) => {
                    let depths = distances.geometric_faces(tolerance).map_err(failure)?;
                    let bounds =
                        distances.geometric_distances(level, tolerance).map_err(failure)?;
                    Some(Faces::new(depths, bounds, level, tolerance))
                }
            };
            let growth = Growth::Arities(scheme.masks().iter().map(Mask::arity).product());
            Ok(Search { surface: FaceSurface::Bilinear, growth, found, faces })
        })?;
        return deliver(to, &SetDepth::of(subject, given, &mesh, None, found.ended(stopped))?);
    }
    if arguments.certificate.is_some() {
        return Err(certified::none("leave out --distance parametric"));
    }
    if arguments.a_priori {
        return deliver(to, &ParametricDepth::of(subject, None, Vec::new()));
    }
    let (mesh, distances) = (mesh()?, distances()?);
    let find = |subject: &Subject<'_>| {
        let depth = distances.depth(&subject.tolerance).map_err(failure)?;
        if let Some((path, format)) = per_face {
            format.write(path, &mesh, &plain_rows(depth.level, distances.faces(depth.level)))?;
        }
        Ok(depth)
    };
    search(subject, &distances.work(), to, find, |subject, depth| {
        let refined = Refined::of_net(&net, &scheme, depth.level);
        let pieces = Pieces::of_mesh(&mesh, distances.faces(depth.level));
        let drawn = Drawn { subject, depth, refined };
        drawn.pictures(&pieces, |level| distances.distance(level))
    })
}
