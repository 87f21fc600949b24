//! The part of TOML 1.1 that claim files use: strings, booleans, lists, tables, and whole numbers, which are the strings
//! that they spell. Other numbers stand in quotes.

mod text;
mod tree;
mod value;

pub use value::Toml;

use crate::text::cursor::Cursor;

/// The most bytes of a claim file.
pub const MAX_BYTES: usize = 4 << 20;

impl Toml {
    /// Reads a file.
    pub fn read(text: &str) -> Result<Toml, String> {
        if text.len() > MAX_BYTES {
            return Err(format!("more than {MAX_BYTES} bytes"));
        }
        let mut cursor = Cursor::new(text.strip_prefix('\u{feff}').unwrap_or(text));
        tree::file(&mut cursor).map_err(|what| cursor.expected(what))
    }
}
