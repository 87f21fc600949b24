//! USD, ascii: one mesh.

mod fields;
mod prims;
mod tokens;

use super::assemble::Parts;
use crate::diagnostic::{Diagnostic, SourceText};
use fields::Fields;
use prims::Reader;
use std::sync::Arc;
use tokens::tokens;

pub(super) fn read(source: &Arc<SourceText>) -> Result<Parts, Diagnostic> {
    let start = source.text.len() - source.text.trim_start_matches('\u{feff}').len();
    if !source.text[start..].starts_with("#usda") {
        let end = source.text.len().min(start + 1);
        return Err(Diagnostic::new(source, start..end, "a USD file begins with `#usda 1.0`")
            .with_help("convert a binary file with `usdcat in.usd -o out.usda`"));
    }
    let tokens = tokens(source, start)?;
    let (meshes, moved) = Reader::read(source, tokens)?;
    let mut meshes = meshes.into_iter();
    let help = "save one mesh in a file";
    let Some(prim) = meshes.next() else {
        return Err(Diagnostic::new(source, start..start + 5, "there is no `def Mesh`").with_help(
            "is it behind a reference or in a variant? `usdcat --flatten` writes it out",
        ));
    };
    if let Some(other) = meshes.next() {
        let message = format!("a second mesh, `{}` after `{}`", other.name, prim.name);
        return Err(Diagnostic::new(source, other.place, message)
            .with_place(prim.place, "the first mesh")
            .with_help(help));
    }
    let mut parts = Parts::new(source, 0);
    Fields { source, prim: &prim }.put(&mut parts)?;
    if moved {
        let note = "transformations (`xformOp`) are not applied: points are as the mesh has them";
        parts.extras.notes.push(note.to_owned());
    }
    Ok(parts)
}
