//! The depth of one tensor net.

use super::faces::{FacesFormat, plain_rows};
use super::geometric::{Faces, GeometricReport, Growth, asks_for_faces, measure};
use super::kind::Kind;
use super::mesh::Report;
use super::pictures::{Drawn, Pieces};
use super::promise::{Formula, promises};
use super::refined::Refined;
use crate::cli::arguments::{DepthArguments, FacesArgument, FindingFormat};
use crate::cli::console::destination::Destination;
use crate::cli::console::interrupt::Interrupt;
use crate::cli::console::output::{Failure, Outcome, positive};
use crate::cli::console::progress::Progress;
use crate::cli::depth::certified;
use crate::cli::geometry::net::{NetFile, NetInput, failure};
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
    let NetFile { scheme, name, net } = asked.read()?;
    let (geometric, tolerance) = measure(net.points(), arguments, &given, "net")?;
    let guaranteed = net_a_priori(&net, &scheme, &tolerance).map_err(failure)?;
    let promised = net_formula_level(&net, &scheme, &tolerance)
        .map(|level| Formula { paper: NET_FORMULA_PAPER, level });
    let per_face = arguments.per_face.as_deref();
    let per_face =
        per_face.map(|path| FacesFormat::of(path).map(|format| (path, format))).transpose()?;
    let faces_in_row = net.faces()[1];
    let [u, v] = guaranteed.longest_edges;
    let guaranteed =
        APriori { level: guaranteed.level, longest_edge: u.max(v), ratio: guaranteed.ratio };
    let kind = Kind::Net { faces_in_row };
    if geometric && !arguments.a_priori {
        let mesh = net.mesh().map_err(|error| Failure::Input(error.to_string()))?;
        let distances = NetDistances::new(net.clone(), &scheme).map_err(failure)?;
        let interrupt = Interrupt::stops_work(&distances.work(), arguments.seconds);
        let wanted = arguments.output.format != FindingFormat::Json;
        let progress = Progress::of_pieces(distances.work(), wanted);
        let found = distances.geometric_depth(&tolerance).map_err(failure)?;
        if let Some(path) = &arguments.certificate {
            certified::of_net(path, &net, &scheme, &distances, &found, &tolerance)?;
        }
        let faces = match found.level.filter(|_| asks_for_faces(arguments)) {
            None => None,
            Some(level) => {
                let depths = distances.geometric_faces(&tolerance).map_err(failure)?;
                let bounds = distances.geometric_distances(level, &tolerance).map_err(failure)?;
                Some(Faces::new(depths, bounds, level, &tolerance))
            }
        };
        drop((interrupt, progress));
        let report = GeometricReport {
            scheme: scheme.name().to_owned(),
            kind,
            growth: Growth::Arities(scheme.masks().iter().map(Mask::arity).product()),
            name,
            mesh: &mesh,
            tolerance,
            relative: arguments.relative.then_some(given),
            surface: FaceSurface::Bilinear,
            guaranteed,
            promised,
            found,
            faces,
            certificate: arguments.certificate.as_deref(),
            solid: None,
        };
        return report.show(arguments, to);
    }
    if arguments.certificate.is_some() {
        return Err(certified::none("leave out --distance parametric"));
    }
    let (mut pictures, mut stopped) = (Vec::new(), false);
    let found = if arguments.a_priori {
        None
    } else {
        let mesh = net.mesh().map_err(|error| Failure::Input(error.to_string()))?;
        let control = net.clone();
        let distances = NetDistances::new(net, &scheme).map_err(failure)?;
        let interrupt = Interrupt::stops_work(&distances.work(), arguments.seconds);
        let wanted = arguments.output.format != FindingFormat::Json;
        let progress = Progress::of_pieces(distances.work(), wanted);
        let depth = distances.depth(&tolerance).map_err(failure)?;
        if let Some((path, format)) = per_face {
            format.write(path, &mesh, &plain_rows(depth.level, distances.faces(depth.level)))?;
        }
        if arguments.output.is_page() {
            let refined = Refined::of_net(&control, &scheme, depth.level);
            let pieces = Pieces::of_mesh(&mesh, distances.faces(depth.level));
            let drawn = Drawn { name: &name, tolerance: &tolerance, depth: &depth, refined };
            let promised = promises(promised.as_ref(), &guaranteed);
            pictures = drawn.pictures(&pieces, promised, |level| distances.distance(level));
        }
        stopped = distances.work().is_stopped();
        drop((interrupt, progress));
        Some(depth)
    };
    let report = Report {
        scheme: scheme.name().to_owned(),
        name,
        tolerance,
        guaranteed,
        promised,
        found,
        kind,
        pictures,
        stopped,
    };
    report.show(arguments, to)
}
