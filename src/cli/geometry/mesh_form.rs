//! The forms in which meshes, nets and solids are written.

use crate::cli::arguments::{MeshOutput, MeshOutputFormat};
use crate::cli::console::endings::format_of;
use crate::cli::console::output::Failure;

/// The forms of one kind of geometry.
pub(crate) struct Forms {
    /// The first one is the default.
    pub(crate) all: &'static [MeshOutputFormat],
    /// In words, as in `polygon meshes are written as obj, ply or json`.
    pub(crate) words: &'static str,
}

pub(crate) const OF_MESHES: Forms = Forms {
    all: &[
        MeshOutputFormat::Obj,
        MeshOutputFormat::Off,
        MeshOutputFormat::Ply,
        MeshOutputFormat::Stl,
        MeshOutputFormat::Usda,
        MeshOutputFormat::Json,
    ],
    words: "polygon meshes are written as obj, off, ply, stl, usda or json",
};

pub(crate) const OF_NETS: Forms = Forms {
    all: &[
        MeshOutputFormat::Obj,
        MeshOutputFormat::Off,
        MeshOutputFormat::Ply,
        MeshOutputFormat::Stl,
        MeshOutputFormat::Csv,
        MeshOutputFormat::Json,
    ],
    words: "nets are written as obj, off, ply, stl, csv or json",
};

pub(crate) const OF_SOLIDS: Forms = Forms {
    all: &[MeshOutputFormat::Vtk, MeshOutputFormat::Medit, MeshOutputFormat::Json],
    words: "solids are written as vtk, medit or json",
};

impl Forms {
    /// The form that is asked for by `--format`, or else by the extension of the file.
    pub(crate) fn chosen(&self, output: &MeshOutput) -> Result<MeshOutputFormat, Failure> {
        let format = match output.format {
            Some(format) => format,
            None => format_of(output.file.as_deref(), self.all)?.unwrap_or(self.all[0]),
        };
        if self.all.contains(&format) {
            return Ok(format);
        }
        Err(Failure::Input(format!("{}; take one of these with --format", self.words)))
    }
}
