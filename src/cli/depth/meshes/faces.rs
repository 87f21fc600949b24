//! The distances of all faces of a mesh, as a table or as colours.

use crate::cli::console::answer::SCHEMA;
use crate::cli::console::output::{Failure, Outcome};
use crate::cli::console::save::save;
use std::fmt::Write as _;
use std::path::Path;
use subcert::exact::{Rational, RealCyclotomic};
use subcert::float::shortest;
use subcert::mesh::{PolygonMesh, to_ply};

/// One row: what is known of a face.
pub(super) struct FaceRow {
    /// The level of the bounds, and these.
    pub(super) level: u32,
    pub(super) bounds: [f64; 2],
    /// The least level of the face itself, and whether all below certainly are not sufficient.
    pub(super) own: Option<(u32, bool)>,
}

/// Rows without levels of their own.
pub(super) fn plain_rows(level: u32, bounds: Vec<[f64; 2]>) -> Vec<FaceRow> {
    bounds.into_iter().map(|bounds| FaceRow { level, bounds, own: None }).collect()
}

/// The forms of the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FacesFormat {
    Csv,
    Json,
    Ply,
}

impl FacesFormat {
    /// By the extension.
    pub(super) fn of(path: &Path) -> Result<FacesFormat, Failure> {
        let extension = path.extension().unwrap_or_default().to_ascii_lowercase();
        match extension.to_str() {
            Some("csv") => Ok(FacesFormat::Csv),
            Some("json") => Ok(FacesFormat::Json),
            Some("ply") => Ok(FacesFormat::Ply),
            _ => Err(Failure::Input(format!(
                "--per-face writes .csv, .json or .ply, and of the cells of a solid .vtk with --distance \
                 parametric, and not `{}`",
                path.display()
            ))),
        }
    }

    /// Writes the lower and upper bounds of all faces; a table has no rows of holes.
    pub(super) fn write(
        self,
        path: &Path,
        mesh: &PolygonMesh<Rational>,
        rows: &[FaceRow],
    ) -> Outcome {
        let text = match self {
            FacesFormat::Csv => csv(mesh, rows),
            FacesFormat::Json => json(mesh, rows),
            FacesFormat::Ply => ply(mesh, rows)?,
        };
        save(path, &text)
            .map_err(|error| Failure::Input(format!("cannot write `{}`: {error}", path.display())))
    }
}

/// The faces that are no holes, with what each has of a list for all faces, and their vertices.
pub(super) fn without_holes<'a, T>(
    mesh: &'a PolygonMesh<Rational>,
    rows: &'a [T],
) -> impl Iterator<Item = (usize, &'a T, &'a Vec<usize>)> {
    let holes = mesh.tags().holes(mesh.connectivity());
    let all = rows.iter().zip(mesh.faces()).enumerate();
    all.filter(move |(face, _)| !holes.contains(face)).map(|(face, (row, own))| (face, row, own))
}

fn csv(mesh: &PolygonMesh<Rational>, rows: &[FaceRow]) -> String {
    let own = rows.iter().any(|row| row.own.is_some());
    let more = if own { ",own_level,is_least" } else { "" };
    let mut text = format!("face,vertices,level,lower,upper{more}\n");
    for (face, row, vertices) in without_holes(mesh, rows) {
        let FaceRow { level, bounds, own } = row;
        let [lower, upper] = bounds.map(shortest);
        let own = own.map(|(level, least)| format!(",{level},{least}")).unwrap_or_default();
        writeln!(text, "{face},{},{level},{lower},{upper}{own}", vertices.len()).expect("memory");
    }
    text
}

fn json(mesh: &PolygonMesh<Rational>, rows: &[FaceRow]) -> String {
    let row = |(face, row, vertices): (usize, &FaceRow, &Vec<usize>)| {
        let FaceRow { level, bounds, own } = row;
        let [lower, upper] = bounds.map(shortest);
        let mut entry = serde_json::json!({
            "face": face, "vertices": vertices.len(), "level": level, "lower": lower, "upper": upper,
        });
        if let Some((level, is_least)) = own {
            entry["own_level"] = (*level).into();
            entry["is_least"] = (*is_least).into();
        }
        entry
    };
    let rows: Vec<serde_json::Value> = without_holes(mesh, rows).map(row).collect();
    let form = serde_json::json!({ "schema": SCHEMA, "faces": rows });
    serde_json::to_string_pretty(&form).expect("keys that are texts") + "\n"
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
fn ply(mesh: &PolygonMesh<Rational>, rows: &[FaceRow]) -> Result<String, Failure> {
    let level = rows.first().map_or(0, |row| row.level);
    let title = format!("distance of each face from the limit surface at level {level}");
    let plain = to_ply(&mesh.map(|x| RealCyclotomic::from(x.clone())), &title)
        .map_err(|error| Failure::Input(error.to_string()))?;
    let upper: Vec<f64> = rows.iter().map(|row| row.bounds[1]).collect();
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
