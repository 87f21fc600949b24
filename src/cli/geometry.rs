//! `subcert refine` and `limit`, and `oracle --mesh`: what the file holds decides who does it.

use super::arguments::{LimitArguments, OracleArguments, RefineArguments};
use super::net::NetInput;
use super::output::Outcome;
use super::{mesh, net};
use std::path::Path;

pub(super) fn refine(arguments: &RefineArguments) -> Outcome {
    let RefineArguments { scheme, mesh, closed, level, output } = arguments;
    let net = NetInput { scheme, path: mesh, closed: *closed };
    if net.is_net() { net::refine(&net, *level, output) } else { mesh::refine(arguments) }
}

pub(super) fn limit(arguments: &LimitArguments) -> Outcome {
    let LimitArguments { scheme, mesh, closed, level, output } = arguments;
    let net = NetInput { scheme, path: mesh, closed: *closed };
    if net.is_net() { net::limit(&net, *level, output) } else { mesh::limit(arguments) }
}

/// What `subcert oracle --mesh` writes.
pub(super) fn reference_values(arguments: &OracleArguments, path: &Path) -> Outcome {
    let OracleArguments { scheme, closed, level, .. } = arguments;
    let net = NetInput { scheme, path, closed: *closed };
    if net.is_net() {
        net::reference_values(&net, *level)
    } else {
        mesh::reference_values(scheme, path, *level)
    }
}
