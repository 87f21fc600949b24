//! `subcert refine` and `subcert limit`, and `subcert oracle --mesh`, of hexahedral solids.

use super::mesh::{deliver, in_form, input};
use super::mesh_form::OF_SOLIDS;
use super::mesh_input::text_of;
use super::net::limit_at;
use crate::cli::arguments::{LimitArguments, MeshOutputFormat, OracleFormat, RefineArguments};
use crate::cli::console::answer::SCHEMA;
use crate::cli::console::output::{Failure, Outcome};
use crate::cli::console::progress::Progress;
use std::path::Path;
use subcert::diagnostic::SourceText;
use subcert::exact::Rational;
use subcert::mesh::Point;
use subcert::solid::{
    HexMesh, SOLID_SCHEME, SolidError, SolidFile, SolidFormat, read_solid, refine_solid,
    solid_limit_points, solid_to_json, to_medit, to_vtk,
};

/// Whether this is the scheme for solids.
pub(crate) fn takes(scheme: &str) -> bool {
    scheme == SOLID_SCHEME
}

pub(crate) fn refine(arguments: &RefineArguments) -> Outcome {
    let format = OF_SOLIDS.chosen(&arguments.output)?;
    let work = Work::new(&arguments.mesh, arguments.level)?;
    let mesh = work.refined()?;
    let text = work.text(format, &mesh, "refined", None)?;
    deliver(&arguments.output, &text)
}

pub(crate) fn limit(arguments: &LimitArguments) -> Outcome {
    let format = OF_SOLIDS.chosen(&arguments.output)?;
    let work = Work::new(&arguments.mesh, arguments.level)?;
    let mesh = work.refined()?;
    let limits = solid_limit_points(&mesh);
    let title = "limit points of its vertices";
    let text = work.text(format, &mesh, title, Some(limits))?;
    deliver(&arguments.output, &text)
}

/// What `subcert oracle --mesh` writes.
pub(crate) fn reference_values(
    path: &Path,
    level: u32,
    format: OracleFormat,
) -> Result<String, Failure> {
    let work = Work::new(path, level)?;
    let mesh = work.refined()?;
    let limits = solid_limit_points(&mesh);
    if format == OracleFormat::Json {
        return Ok(solid_to_json(&mesh, &work.head(), Some(&limits)));
    }
    let limits: Vec<_> = limits.into_iter().map(|point| Some(limit_at(point))).collect();
    let meshes = [work.file.mesh(), &mesh].map(Into::into);
    in_form(&meshes, &limits, level, &work.head(), format)
}

/// The solid in a file, with the name of the file.
pub(crate) fn read(path: &Path) -> Result<(String, SolidFile), Failure> {
    let (name, text) = text_of(path)?;
    let Some(format) = SolidFormat::of(path, &text) else {
        return Err(Failure::Input(format!(
            "`{name}` is not a solid: `{SOLID_SCHEME}` refines hexahedra in a VTK or MEDIT file \
             (.vtk, .mesh); for polygon meshes take another scheme, such as catmull-clark"
        )));
    };
    let file = read_solid(&SourceText::new(name.clone(), text), format)?;
    Ok((name, file))
}

/// What cannot be done with the solid in a file.
pub(crate) fn failure(file: &SolidFile, error: &SolidError) -> Failure {
    if error.cell().is_some() || error.point().is_some() {
        return file.diagnostic(error).into();
    }
    let help = error.help().map(|help| format!("; {help}")).unwrap_or_default();
    Failure::Input(format!("{error}{help}"))
}

/// A solid and its level.
struct Work {
    level: u32,
    name: String,
    file: SolidFile,
}

impl Work {
    fn new(path: &Path, level: u32) -> Result<Work, Failure> {
        let (name, file) = read(path)?;
        Ok(Work { level, name, file })
    }

    fn refined(&self) -> Result<HexMesh<Rational>, Failure> {
        let _progress = Progress::of_mesh(format!("refining to level {}", self.level));
        refine_solid(self.file.mesh(), self.level).map_err(|error| failure(&self.file, &error))
    }

    /// The solid, with its vertices at their limits if these are given; JSON has both.
    fn text(
        &self,
        format: MeshOutputFormat,
        mesh: &HexMesh<Rational>,
        what: &str,
        limits: Option<Vec<Point<Rational>>>,
    ) -> Result<String, Failure> {
        if format == MeshOutputFormat::Json {
            return Ok(solid_to_json(mesh, &self.head(), limits.as_deref()));
        }
        let title = format!("{}, {SOLID_SCHEME}, level {}: {what}", self.name, self.level);
        let shown = limits.map(|limits| mesh.with_points(limits));
        let shown = shown.as_ref().unwrap_or(mesh);
        let written = match format {
            MeshOutputFormat::Medit => to_medit(shown, &title),
            _ => to_vtk(shown, &title),
        };
        written.map_err(|error| input(&error))
    }

    fn head(&self) -> [(&'static str, String); 4] {
        let text = |text: &str| serde_json::Value::from(text).to_string();
        [
            ("schema", SCHEMA.to_string()),
            ("scheme", text(SOLID_SCHEME)),
            ("mesh", text(&self.name)),
            ("level", self.level.to_string()),
        ]
    }
}
