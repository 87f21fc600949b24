//! How many levels of Catmull–Clark does the mesh in an OBJ file need?
//!
//! `cargo run --release --example mesh_depth -- examples/cube.obj 1/100`

use std::error::Error;
use subcert::diagnostic::SourceText;
use subcert::exact::parse_rational;
use subcert::mesh::{MeshFormat, MeshScheme, read_mesh};
use subcert::patch::MeshDistances;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let path = arguments.next().unwrap_or_else(|| "examples/cube.obj".to_owned());
    let tolerance = parse_rational(&arguments.next().unwrap_or_else(|| "1/100".to_owned()))?;
    let source = SourceText::new(path.clone(), std::fs::read_to_string(&path)?);
    let control = read_mesh(&source, MeshFormat::Obj).map_err(|error| error.to_string())?;
    let distances = MeshDistances::new(control.mesh().clone(), MeshScheme::CatmullClark)?;
    let depth = distances.depth(&tolerance)?;
    let [lower, upper] = depth.distance;
    println!("level {}: from {lower} to {upper} away from the limit", depth.level);
    if let Some(few) = depth.too_few {
        println!("level {few} is not enough");
    }
    Ok(())
}
