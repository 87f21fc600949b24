//! The distances of all faces of a mesh, as a table or as colours.

use crate::cli::output::{Failure, Outcome};
use crate::cli::save::save;
use std::fmt::Write as _;
use std::path::Path;
use subcert::exact::{Rational, RealCyclotomic};
use subcert::float::shortest;
use subcert::mesh::{PolygonMesh, to_ply};

/// The forms of the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FacesFormat {
    Csv,
    Ply,
}

impl FacesFormat {
    /// By the extension.
    pub(super) fn of(path: &Path) -> Result<FacesFormat, Failure> {
        let extension = path.extension().unwrap_or_default().to_ascii_lowercase();
        match extension.to_str() {
            Some("csv") => Ok(FacesFormat::Csv),
            Some("ply") => Ok(FacesFormat::Ply),
            _ => Err(Failure::Input(format!(
                "--per-face writes .csv or .ply, and not `{}`",
                path.display()
            ))),
        }
    }

    /// Writes the lower and upper bounds of all faces.
    pub(super) fn write(
        self,
        path: &Path,
        mesh: &PolygonMesh<Rational>,
        level: u32,
        distances: &[[f64; 2]],
    ) -> Outcome {
        let text = match self {
            FacesFormat::Csv => csv(mesh, level, distances),
            FacesFormat::Ply => ply(mesh, level, distances)?,
        };
        save(path, &text)
            .map_err(|error| Failure::Input(format!("cannot write `{}`: {error}", path.display())))
    }
}

fn csv(mesh: &PolygonMesh<Rational>, level: u32, distances: &[[f64; 2]]) -> String {
    let mut text = "face,vertices,level,lower,upper\n".to_owned();
    for (face, ([lower, upper], vertices)) in distances.iter().zip(mesh.faces()).enumerate() {
        let (lower, upper) = (shortest(*lower), shortest(*upper));
        writeln!(text, "{face},{},{level},{lower},{upper}", vertices.len()).expect("memory");
    }
    text
}

/// From blue over white to red, by the share of the greatest distance.
fn colour(share: f64) -> [u8; 3] {
    let byte = |x: f64| {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // From 0 to 255.
        let byte = (255.0 * x.clamp(0.0, 1.0)).round() as u8;
        byte
    };
    [byte(2.0 * share), byte(1.0 - 2.0 * (share - 0.5).abs()), byte(2.0 - 2.0 * share)]
}

/// The control mesh with the colours and the upper bounds of its faces; a vertex has the greatest
/// distance of its faces.
fn ply(
    mesh: &PolygonMesh<Rational>,
    level: u32,
    distances: &[[f64; 2]],
) -> Result<String, Failure> {
    let title = format!("distance of each face from the limit surface at level {level}");
    let plain = to_ply(&mesh.map(|x| RealCyclotomic::from(x.clone())), &title)
        .map_err(|error| Failure::Input(error.to_string()))?;
    let upper: Vec<f64> = distances.iter().map(|[_, upper]| *upper).collect();
    let greatest = upper.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
    let mut at_vertices = vec![0.0_f64; mesh.points().len()];
    for (face, distance) in mesh.faces().iter().zip(&upper) {
        for &vertex in face {
            at_vertices[vertex] = at_vertices[vertex].max(*distance);
        }
    }
    let values: Vec<f64> = at_vertices.into_iter().chain(upper).collect();
    let properties = "property uchar red\nproperty uchar green\nproperty uchar blue\n\
                      property double distance\n";
    let (head, body) = plain.split_once("end_header\n").unwrap_or((&plain, ""));
    let mut text = String::with_capacity(2 * plain.len());
    for line in head.lines() {
        if line.starts_with("element face") {
            text.push_str(properties);
        }
        text.push_str(line);
        text.push('\n');
    }
    text.push_str(properties);
    text.push_str("end_header\n");
    for (line, value) in body.lines().zip(values) {
        let [red, green, blue] = colour(value / greatest);
        writeln!(text, "{line} {red} {green} {blue} {}", shortest(value)).expect("memory");
    }
    Ok(text)
}
