//! `subcert refine` and `subcert limit`, and `subcert oracle --mesh`.

use super::mesh_form::OF_MESHES;
use super::mesh_input::{Given, failure, read, with_boundary};
use crate::cli::arguments::{
    IsolatedArgument, LimitArguments, MeshBoundary, MeshOutput, MeshOutputFormat, OracleFormat,
    RefineArguments,
};
use crate::cli::console::answer::SCHEMA;
use crate::cli::console::output::{Failure, Outcome, note, write_results};
use crate::cli::console::progress::Progress;
use crate::cli::console::save::save;
use std::path::Path;
use subcert::exact::RealCyclotomic;
use subcert::mesh::{
    LimitPoint, MeshError, MeshFile, MeshScheme, PolygonMesh, limit_points, refine_mesh, to_json,
    to_obj, to_off, to_ply, to_stl, to_usda, without_normals,
};
use subcert::oracle::{OracleMesh, mesh_to_csv, mesh_to_source};

type Mesh = PolygonMesh<RealCyclotomic>;

pub(crate) fn refine(arguments: &RefineArguments) -> Outcome {
    let given = (arguments.boundary, arguments.isolated, arguments.weld.tolerance.as_deref());
    let format = OF_MESHES.chosen(&arguments.output)?;
    let work = Work::new(&arguments.scheme, &arguments.mesh, arguments.level, given)?;
    let mesh = work.refined()?;
    let title = work.title("refined");
    note_what_is_lost(&mesh, format, false);
    let text = match format {
        MeshOutputFormat::Obj => to_obj(&mesh, &title, &[]).map_err(|e| input(&e))?,
        MeshOutputFormat::Off => to_off(&mesh, &title).map_err(|e| input(&e))?,
        MeshOutputFormat::Ply => to_ply(&mesh, &title).map_err(|e| input(&e))?,
        MeshOutputFormat::Stl => to_stl(&mesh, &title).map_err(|e| input(&e))?,
        MeshOutputFormat::Usda => to_usda(&mesh, work.scheme, &title).map_err(|e| input(&e))?,
        _ => to_json(&mesh, &work.head(), None),
    };
    deliver(&arguments.output, &text)
}

pub(crate) fn limit(arguments: &LimitArguments) -> Outcome {
    let given = (arguments.boundary, arguments.isolated, arguments.weld.tolerance.as_deref());
    let format = OF_MESHES.chosen(&arguments.output)?;
    let mut work = Work::new(&arguments.scheme, &arguments.mesh, arguments.level, given)?;
    let mesh = work.refined()?;
    let limits = work.limits(&mesh)?;
    let title = work.title("limit points of its vertices");
    note_what_is_lost(&mesh, format, true);
    if format == MeshOutputFormat::Obj && without_normals(&limits).is_some() {
        note("obj is written with the normals of all vertices or of none; json has the others");
    }
    let text = match format {
        MeshOutputFormat::Obj => {
            to_obj(&at_limit(&mesh, &limits)?, &title, &limits).map_err(|e| input(&e))?
        }
        MeshOutputFormat::Off => {
            to_off(&at_limit(&mesh, &limits)?, &title).map_err(|e| input(&e))?
        }
        MeshOutputFormat::Ply => {
            to_ply(&at_limit(&mesh, &limits)?, &title).map_err(|e| input(&e))?
        }
        MeshOutputFormat::Stl => {
            to_stl(&at_limit(&mesh, &limits)?, &title).map_err(|e| input(&e))?
        }
        MeshOutputFormat::Usda => {
            to_usda(&at_limit(&mesh, &limits)?, work.scheme, &title).map_err(|e| input(&e))?
        }
        _ => to_json(&mesh, &work.head(), Some(&limits)),
    };
    deliver(&arguments.output, &text)
}

/// Says what a file of this form does not hold of a mesh, or of its limit.
pub(crate) fn note_what_is_lost(mesh: &Mesh, format: MeshOutputFormat, is_limit: bool) {
    let name = match format {
        MeshOutputFormat::Off => "off",
        MeshOutputFormat::Ply => "ply",
        MeshOutputFormat::Stl => "stl",
        MeshOutputFormat::Usda => "usda",
        _ => return,
    };
    if is_limit {
        note(&format!(
            "{name} is written without the normals of the limit; obj and json have them"
        ));
    }
    let extras = !mesh.tags().is_plain() || mesh.texture().is_some();
    if extras && format != MeshOutputFormat::Usda {
        note(&format!(
            "{name} holds no creases, corners, holes and texture coordinates, and they are left out; obj, \
             usda and json have them"
        ));
    }
    let split = mesh.faces().iter().filter(|face| face.len() > 3).count();
    if format == MeshOutputFormat::Stl && split > 0 {
        note(&format!(
            "stl holds triangles: {split} faces of more than 3 vertices are split into triangles with their first \
             vertex"
        ));
    }
    let left = mesh.isolated().len();
    if format == MeshOutputFormat::Stl && left > 0 {
        note(&format!("stl holds no points of no face, and {left} are left out"));
    }
}

/// What `subcert oracle --mesh` writes.
pub(crate) fn reference_values(
    scheme: &str,
    path: &Path,
    level: u32,
    given: (Option<MeshBoundary>, Option<IsolatedArgument>, Option<&str>),
    format: OracleFormat,
) -> Result<String, Failure> {
    let mut work = Work::new(scheme, path, level, given)?;
    let mesh = work.refined()?;
    // Other forms than JSON say by themselves which normals are missing.
    let mut head = work.head();
    let limits = work.limits(&mesh)?;
    if format == OracleFormat::Json {
        return Ok(to_json(&mesh, &work.head(), Some(&limits)));
    }
    let control: Mesh = work.file.mesh().map(|x| x.clone().into());
    let tags = control.tags();
    if !tags.is_plain() {
        head.extend(work.boundary());
    }
    if tags.has_sharp() || !tags.holes(control.connectivity()).is_empty() {
        head.push(("tags", "the creases, corners and holes of the mesh are in json".to_owned()));
    }
    in_form(&[(&control).into(), (&mesh).into()], &limits, level, &head, format)
}

/// Test vectors of a control mesh and the refined one, in a form other than JSON. The version in the head is that of JSON.
pub(crate) fn in_form(
    meshes: &[OracleMesh; 2],
    limits: &[Option<LimitPoint>],
    level: u32,
    head: &[(&'static str, String)],
    format: OracleFormat,
) -> Result<String, Failure> {
    let head = &head[1..];
    match format.language() {
        Some(language) => mesh_to_source(meshes, limits, level, head, language),
        None => mesh_to_csv(&meshes[1], limits, Some(head).filter(|_| format == OracleFormat::Csv)),
    }
    .map_err(|error| input(&error))
}

/// A mesh, its scheme and its level.
struct Work {
    scheme: MeshScheme,
    level: u32,
    name: String,
    file: MeshFile,
    notes: Vec<String>,
}

impl Work {
    fn new(
        scheme: &str,
        path: &Path,
        level: u32,
        (boundary, isolated, weld): (Option<MeshBoundary>, Option<IsolatedArgument>, Option<&str>),
    ) -> Result<Work, Failure> {
        let Given { scheme, name, mut file, notes } = read(scheme, path, weld)?;
        for told in &notes {
            note(told);
        }
        if let Some(boundary) = boundary {
            file = with_boundary(file, boundary);
        }
        let keeps = isolated == Some(IsolatedArgument::Keep);
        if !file.mesh().isolated().is_empty() {
            note(if keeps {
                "the points of no face are written after the others"
            } else {
                "the points of no face are left out; --isolated keep writes them after the others"
            });
        }
        if !keeps {
            let mesh = file.mesh().clone().with_isolated(Vec::new());
            file = file.with_mesh(mesh);
        }
        Ok(Work { scheme, level, name, file, notes })
    }

    fn refined(&self) -> Result<Mesh, Failure> {
        let _progress = Progress::of_mesh(format!("refining to level {}", self.level));
        let control = self.file.mesh().map(|x| x.clone().into());
        refine_mesh(&control, self.scheme, self.level).map_err(|error| self.failure(&error))
    }

    /// The limits of the vertices, with a note on those without a normal.
    fn limits(&mut self, mesh: &Mesh) -> Result<Vec<Option<LimitPoint>>, Failure> {
        let progress =
            Progress::of_mesh(format!("limit points and normals of level {}", self.level));
        let limits = limit_points(mesh, self.scheme).map_err(|error| match self.level {
            0 => self.failure(&error),
            // Points of a refined mesh have no place in the file.
            level => Failure::Input(format!("limit points of level {level}: {error}")),
        })?;
        drop(progress);
        if let Some(told) = without_normals(&limits) {
            note(&told);
            self.notes.push(told);
        }
        Ok(limits)
    }

    fn failure(&self, error: &MeshError) -> Failure {
        failure(&self.file, error)
    }

    fn title(&self, what: &str) -> String {
        let Work { scheme, level, name, .. } = self;
        format!("{name}, {}, level {level}: {what}", scheme.name())
    }

    /// The rules at the boundary, if there is one and the scheme has rules for it.
    fn boundary(&self) -> Option<(&'static str, String)> {
        let mesh = self.file.mesh();
        let has_boundary = mesh.connectivity().edges().iter().any(|edge| edge.other.is_none());
        let name = serde_json::Value::from(mesh.tags().boundary.name()).to_string();
        (has_boundary && self.scheme != MeshScheme::DooSabin).then_some(("boundary", name))
    }

    fn head(&self) -> Vec<(&'static str, String)> {
        let text = |text: &str| serde_json::Value::from(text).to_string();
        let mut head = vec![
            ("schema", SCHEMA.to_string()),
            ("scheme", text(self.scheme.name())),
            ("mesh", text(&self.name)),
            ("level", self.level.to_string()),
        ];
        // Where there are tags, JSON has it among them.
        head.extend(self.boundary().filter(|_| self.file.mesh().tags().is_plain()));
        head.extend(noted(&self.notes));
        head
    }
}

/// The notes on a file as a field, if there are some.
pub(crate) fn noted(notes: &[String]) -> Option<(&'static str, String)> {
    let field = || ("notes", serde_json::Value::from(notes.to_vec()).to_string());
    (!notes.is_empty()).then(field)
}

/// The mesh with its vertices at their limits.
fn at_limit(mesh: &Mesh, limits: &[Option<LimitPoint>]) -> Result<Mesh, Failure> {
    let position = |limit: &Option<LimitPoint>| Some(limit.as_ref()?.position.clone());
    if let Some(points) = limits.iter().map(position).collect::<Option<Vec<_>>>() {
        return Ok(mesh.with_points(points).with_isolated(mesh.isolated().to_vec()));
    }
    let missing = limits.iter().filter(|limit| limit.is_none()).count();
    Err(Failure::Input(format!(
        "{missing} vertices at the boundary have no limit point: the scheme has no rules for the \
         boundary, and the surface ends before it; --format json writes the others"
    )))
}

pub(crate) fn input(error: &impl ToString) -> Failure {
    Failure::Input(error.to_string())
}

/// Writes the text to the file, whole or not at all, or to the standard output.
pub(crate) fn deliver(output: &MeshOutput, text: &str) -> Outcome {
    match output.file.as_deref() {
        Some(path) if path.as_os_str() != "-" => save(path, text)
            .map_err(|error| Failure::Input(format!("cannot write `{}`: {error}", path.display()))),
        _ => write_results(text),
    }
}
