//! The depth of one tensor net.

use super::faces::{FacesFormat, plain_rows};
use super::kind::Kind;
use super::mesh::Report;
use super::pictures::{Drawn, Pieces};
use super::promise::{Formula, promises};
use super::refined::Refined;
use crate::cli::arguments::{DepthArguments, FindingFormat};
use crate::cli::finding::Destination;
use crate::cli::net::{NetFile, NetInput, failure};
use crate::cli::output::{Failure, Outcome, positive};
use crate::cli::progress::Progress;
use subcert::patch::{APriori, NET_FORMULA_PAPER, NetDistances, net_a_priori, net_formula_level};

pub(super) fn net_depth(
    asked: &NetInput<'_>,
    arguments: &DepthArguments,
    to: &Destination,
) -> Outcome {
    let tolerance = positive("--tolerance", &arguments.tolerance)?;
    let NetFile { scheme, name, net } = asked.read()?;
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
    let mut pictures = Vec::new();
    let found = if arguments.a_priori {
        None
    } else {
        let mesh = net.mesh().map_err(|error| Failure::Input(error.to_string()))?;
        let control = net.clone();
        let distances = NetDistances::new(net, &scheme).map_err(failure)?;
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
        drop(progress);
        Some(depth)
    };
    let report = Report {
        scheme: scheme.name().to_owned(),
        name,
        tolerance,
        guaranteed,
        promised,
        found,
        kind: Kind::Net { faces_in_row },
        pictures,
    };
    report.show(arguments, to)
}
