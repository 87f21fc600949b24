//! `subcert refine` and `subcert limit`, and `subcert oracle --mesh`.

use super::mesh_form::OF_MESHES;
use crate::cli::arguments::{
    IsolatedArgument, LimitArguments, MeshBoundary, MeshOutput, MeshOutputFormat, RefineArguments,
};
use crate::cli::console::answer::SCHEMA;
use crate::cli::console::output::{Failure, Outcome, write_results};
use crate::cli::console::save::save;
use std::path::Path;
use subcert::diagnostic::{SourceText, read_bytes_from};
use subcert::exact::RealCyclotomic;
use subcert::mesh::{
    Boundary, LimitPoint, MAX_FILE_BYTES, MeshError, MeshFile, MeshFormat, MeshScheme, PolygonMesh,
    is_polygonal_vtk, limit_points, read_binary_mesh, read_mesh, refine_mesh, to_json, to_obj,
    to_ply, to_usda,
};
use subcert::net::NetScheme;
use subcert::scheme::split_name;
use subcert::solid::{SOLID_SCHEME, SolidFormat};

type Mesh = PolygonMesh<RealCyclotomic>;

pub(crate) fn refine(arguments: &RefineArguments) -> Outcome {
    let given = (arguments.boundary, arguments.isolated);
    let work = Work::new(&arguments.scheme, &arguments.mesh, arguments.level, given)?;
    let mesh = work.refined()?;
    let title = work.title("refined");
    let format = OF_MESHES.chosen(&arguments.output)?;
    note_what_is_lost(&mesh, format);
    let text = match format {
        MeshOutputFormat::Obj => to_obj(&mesh, &title, &[]).map_err(|e| input(&e))?,
        MeshOutputFormat::Ply => to_ply(&mesh, &title).map_err(|e| input(&e))?,
        MeshOutputFormat::Usda => to_usda(&mesh, work.scheme, &title).map_err(|e| input(&e))?,
        _ => to_json(&mesh, &work.head(), None),
    };
    deliver(&arguments.output, &text)
}

pub(crate) fn limit(arguments: &LimitArguments) -> Outcome {
    let given = (arguments.boundary, arguments.isolated);
    let work = Work::new(&arguments.scheme, &arguments.mesh, arguments.level, given)?;
    let mesh = work.refined()?;
    let limits = work.limits(&mesh)?;
    let title = work.title("limit points of its vertices");
    let format = OF_MESHES.chosen(&arguments.output)?;
    note_what_is_lost(&mesh, format);
    let text = match format {
        MeshOutputFormat::Obj => {
            to_obj(&at_limit(&mesh, &limits)?, &title, &limits).map_err(|e| input(&e))?
        }
        MeshOutputFormat::Ply => {
            to_ply(&at_limit(&mesh, &limits)?, &title).map_err(|e| input(&e))?
        }
        MeshOutputFormat::Usda => {
            to_usda(&at_limit(&mesh, &limits)?, work.scheme, &title).map_err(|e| input(&e))?
        }
        _ => to_json(&mesh, &work.head(), Some(&limits)),
    };
    deliver(&arguments.output, &text)
}

/// Says what a file of this form does not hold of a mesh.
fn note_what_is_lost(mesh: &Mesh, format: MeshOutputFormat) {
    let extras = !mesh.tags().is_plain() || mesh.texture().is_some();
    if format == MeshOutputFormat::Ply && extras {
        crate::cli::console::output::note(
            "ply holds no creases, corners, holes and texture coordinates, and they are left out; obj, \
             usda and json have them",
        );
    }
}

/// What `subcert oracle --mesh` writes.
pub(crate) fn reference_values(scheme: &str, path: &Path, level: u32) -> Result<String, Failure> {
    let work = Work::new(scheme, path, level, (None, None))?;
    let mesh = work.refined()?;
    let limits = work.limits(&mesh)?;
    Ok(to_json(&mesh, &work.head(), Some(&limits)))
}

/// The scheme of a name and the mesh in a file, with the name of the file.
pub(crate) fn read(scheme: &str, path: &Path) -> Result<(MeshScheme, String, MeshFile), Failure> {
    let scheme = MeshScheme::parse(scheme).map_err(|message| {
        let of_nets = NetScheme::parse(scheme).is_ok();
        let solid = split_name(scheme).0 == SOLID_SCHEME;
        Failure::Input(if solid {
            format!("a solid has its own valences: write `{SOLID_SCHEME}`")
        } else if of_nets {
            format!("{message}; `{scheme}` refines nets, which are in .csv or .json")
        } else {
            message
        })
    })?;
    let (name, bytes) = bytes_of(path)?;
    if let Some(file) = read_binary_mesh(&name, &bytes) {
        return Ok(noted(scheme, name, file?));
    }
    let text = text(&name, bytes)?;
    if SolidFormat::of(path, &text).is_some() && !is_polygonal_vtk(&text) {
        return Err(Failure::Input(format!(
            "`{name}` is a hexahedral mesh, and `{}` refines polygon meshes; take {SOLID_SCHEME}",
            scheme.name()
        )));
    }
    let format = MeshFormat::of(path, &text);
    let file = read_mesh(&SourceText::new(name.clone(), text), format)?;
    Ok(noted(scheme, name, file))
}

/// The mesh of a file with these rules at its boundary.
pub(crate) fn with_boundary(file: MeshFile, boundary: MeshBoundary) -> MeshFile {
    let mut tags = file.mesh().tags().clone();
    tags.boundary = match boundary {
        MeshBoundary::None => Boundary::None,
        MeshBoundary::Edge => Boundary::Edge,
        MeshBoundary::Corner => Boundary::Corner,
    };
    let mesh = file.mesh().clone().with_tags(tags);
    file.with_mesh(mesh)
}

/// The file, after its notes have been told.
fn noted(scheme: MeshScheme, name: String, file: MeshFile) -> (MeshScheme, String, MeshFile) {
    for note in file.notes() {
        crate::cli::console::output::note(&format!("{name}: {note}"));
    }
    (scheme, name, file)
}

/// The name of a file, or of the standard input, and its text.
pub(crate) fn text_of(path: &Path) -> Result<(String, String), Failure> {
    let (name, bytes) = bytes_of(path)?;
    let text = text(&name, bytes)?;
    Ok((name, text))
}

/// The name of a file, or of the standard input, and what is in it.
fn bytes_of(path: &Path) -> Result<(String, Vec<u8>), Failure> {
    let standard = path.as_os_str() == "-";
    let name = if standard { "standard input".to_owned() } else { path.display().to_string() };
    let bytes = if standard {
        read_bytes_from(std::io::stdin().lock(), MAX_FILE_BYTES)
    } else {
        let file = std::fs::File::open(path).map_err(|error| error.to_string());
        file.and_then(|file| read_bytes_from(file, MAX_FILE_BYTES))
    };
    let bytes =
        bytes.map_err(|reason| Failure::Input(format!("cannot read `{name}`: {reason}")))?;
    Ok((name, bytes))
}

/// The text of a file that is no binary mesh.
fn text(name: &str, bytes: Vec<u8>) -> Result<String, Failure> {
    String::from_utf8(bytes).map_err(|_| {
        Failure::Input(format!(
            "cannot read `{name}`: it is not UTF-8 text, and no binary PLY or STL that is whole; save it \
             in an ascii form"
        ))
    })
}

/// An error about a face or a point is about level 0, and so has a place in the file.
pub(crate) fn failure(file: &MeshFile, error: &MeshError) -> Failure {
    if error.face().is_some() || error.point().is_some() {
        file.diagnostic(error).into()
    } else {
        let help = error.help().map(|help| format!("; {help}")).unwrap_or_default();
        Failure::Input(format!("{error}{help}"))
    }
}

/// A mesh, its scheme and its level.
struct Work {
    scheme: MeshScheme,
    level: u32,
    name: String,
    file: MeshFile,
}

impl Work {
    fn new(
        scheme: &str,
        path: &Path,
        level: u32,
        (boundary, isolated): (Option<MeshBoundary>, Option<IsolatedArgument>),
    ) -> Result<Work, Failure> {
        let (scheme, name, mut file) = read(scheme, path)?;
        if let Some(boundary) = boundary {
            file = with_boundary(file, boundary);
        }
        let keeps = isolated == Some(IsolatedArgument::Keep);
        if !file.mesh().isolated().is_empty() {
            crate::cli::console::output::note(if keeps {
                "the points of no face are written after the others"
            } else {
                "the points of no face are left out; --isolated keep writes them after the others"
            });
        }
        if !keeps {
            let mesh = file.mesh().clone().with_isolated(Vec::new());
            file = file.with_mesh(mesh);
        }
        Ok(Work { scheme, level, name, file })
    }

    fn refined(&self) -> Result<Mesh, Failure> {
        let control = self.file.mesh().map(|x| x.clone().into());
        refine_mesh(&control, self.scheme, self.level).map_err(|error| self.failure(&error))
    }

    fn limits(&self, mesh: &Mesh) -> Result<Vec<Option<LimitPoint>>, Failure> {
        limit_points(mesh, self.scheme).map_err(|error| self.failure(&error))
    }

    fn failure(&self, error: &MeshError) -> Failure {
        failure(&self.file, error)
    }

    fn title(&self, what: &str) -> String {
        let Work { scheme, level, name, .. } = self;
        format!("{name}, {}, level {level}: {what}", scheme.name())
    }

    fn head(&self) -> [(&'static str, String); 4] {
        let text = |text: &str| serde_json::Value::from(text).to_string();
        [
            ("schema", SCHEMA.to_string()),
            ("scheme", text(self.scheme.name())),
            ("mesh", text(&self.name)),
            ("level", self.level.to_string()),
        ]
    }
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
