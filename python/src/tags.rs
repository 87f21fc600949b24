//! What is sharp in a polygon mesh.

use crate::error::{plain, with_remedy};
use crate::number::{Fraction, fraction, rational};
use pyo3::prelude::*;
use subcert::mesh::{Boundary, Connectivity, Creasing, Sharpness, Tags};

/// Edges by their ends and vertices with their sharpness, holes, the rules at the boundary, and how sharpness falls.
pub(crate) type Said<S> = (Vec<([usize; 2], S)>, Vec<(usize, S)>, Vec<usize>, String, String);

/// What Python says as tags.
pub(crate) fn tags(said: &Said<Bound<'_, PyAny>>, mesh: &Connectivity) -> PyResult<Tags> {
    let (edges, vertices, holes, boundary, creasing) = said;
    let mut tags = Tags::default();
    let found = Boundary::NAMES.into_iter().find(|(_, name)| name == boundary);
    tags.boundary = found.map(|(boundary, _)| boundary).ok_or_else(|| {
        let remedy = "it is \"edge\", \"corner\" or \"none\"";
        with_remedy(&format!("the boundary is {boundary:?}"), remedy)
    })?;
    let all = [Creasing::Uniform, Creasing::Chaikin];
    tags.creasing = all.into_iter().find(|one| one.name() == creasing).ok_or_else(|| {
        let remedy = "it is \"uniform\" or \"chaikin\"";
        with_remedy(&format!("the creasing is {creasing:?}"), remedy)
    })?;
    for (ends, value) in edges {
        tags.crease(mesh, *ends, sharpness(value)?).map_err(plain)?;
    }
    for (vertex, value) in vertices {
        tags.corner(mesh, *vertex, sharpness(value)?).map_err(plain)?;
    }
    for &face in holes {
        tags.hole(mesh, face).map_err(plain)?;
    }
    Ok(tags)
}

fn sharpness(value: &Bound<'_, PyAny>) -> PyResult<Option<Sharpness>> {
    let value = rational(value)?;
    if value.sign() < 0 {
        return Err(with_remedy(&format!("a sharpness is {value}"), "it is 0 or more"));
    }
    Ok(Sharpness::new(&value))
}

/// Tags as Python has them.
pub(crate) fn said(tags: &Tags, mesh: &Connectivity) -> Said<Fraction> {
    let number = |sharp: &Sharpness| fraction(&sharp.number());
    let edges = tags.edges().iter().map(|(&edge, sharp)| (mesh.edges()[edge].ends, number(sharp)));
    let vertices = tags.vertices().iter().map(|(&vertex, sharp)| (vertex, number(sharp)));
    let holes = tags.holes(mesh).into_iter().collect();
    let names = (tags.boundary.name().to_owned(), tags.creasing.name().to_owned());
    (edges.collect(), vertices.collect(), holes, names.0, names.1)
}
