//! Meshes in files, as commands are given them.

use crate::cli::arguments::MeshBoundary;
use crate::cli::console::output::Failure;
use std::path::Path;
use subcert::diagnostic::{SourceText, read_bytes, read_bytes_from, text_or_latin1};
use subcert::exact::parse_rational;
use subcert::mesh::{
    Boundary, MAX_FILE_BYTES, MeshError, MeshFile, MeshFormat, MeshScheme, read_binary_mesh,
    read_welded_mesh,
};
use subcert::net::NetScheme;
use subcert::scheme::split_name;
use subcert::solid::SOLID_SCHEME;

/// A mesh in a file, the scheme of a name, and what is to be told of them.
pub(crate) struct Given {
    pub(crate) scheme: MeshScheme,
    pub(crate) name: String,
    pub(crate) file: MeshFile,
    pub(crate) notes: Vec<String>,
}

/// The scheme of a name and the mesh in a file, its points joined as `--weld` says.
pub(crate) fn read(scheme: &str, path: &Path, weld: Option<&str>) -> Result<Given, Failure> {
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
    let weld = weld.map(|weld| {
        let wrong = |why: String| {
            Failure::Input(format!(
                "--weld: {why}; it is a distance such as 1e-6, and 0 joins equal points"
            ))
        };
        match parse_rational(weld) {
            Ok(weld) if weld.sign() < 0 => Err(wrong(format!("{weld} is below 0"))),
            Ok(weld) => Ok(weld),
            Err(error) => Err(wrong(error.to_string())),
        }
    });
    let weld = weld.transpose()?;
    let (name, bytes) = bytes_of(path)?;
    let file = if let Some(file) = read_binary_mesh(&name, &bytes, weld.as_ref()) {
        file?
    } else {
        let text = text(&name, bytes)?;
        let format = MeshFormat::of(path, &text);
        read_welded_mesh(&SourceText::new(name.clone(), text), format, weld.as_ref())?
    };
    let notes = file.notes().iter().cloned().chain(file.other_scheme(scheme));
    let notes = notes.map(|note| format!("{name}: {note}")).collect();
    Ok(Given { scheme, name, file, notes })
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
        read_bytes(path, MAX_FILE_BYTES)
    };
    let bytes =
        bytes.map_err(|reason| Failure::Input(format!("cannot read `{name}`: {reason}")))?;
    Ok((name, bytes))
}

/// The text of a file that is no binary mesh.
fn text(name: &str, bytes: Vec<u8>) -> Result<String, Failure> {
    text_or_latin1(bytes).ok_or_else(|| {
        Failure::Input(format!(
            "cannot read `{name}`: it is neither UTF-8 nor Latin-1 text, and no binary PLY or STL that is whole; save it \
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
