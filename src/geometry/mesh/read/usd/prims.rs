//! The prims of a file, and the fields of meshes as tokens.

use super::tokens::{Kind, Token};
use crate::diagnostic::{Diagnostic, SourceText};
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

/// The deepest nesting of prims and values.
const MAX_DEPTH: usize = 100;

/// The value of a field: its tokens, and what is in parentheses after it.
#[derive(Default)]
pub(super) struct Field {
    pub(super) name: Range<usize>,
    pub(super) value: Vec<Token>,
    pub(super) about: Vec<Token>,
}

/// A mesh: its name, where it begins, and its fields.
pub(super) struct Prim {
    pub(super) name: String,
    pub(super) place: Range<usize>,
    pub(super) fields: BTreeMap<String, Field>,
}

pub(super) struct Reader<'a> {
    source: &'a Arc<SourceText>,
    tokens: Vec<Token>,
    at: usize,
    meshes: Vec<Prim>,
    /// Whether a transformation stands above or in a mesh.
    moved: bool,
}

impl<'a> Reader<'a> {
    /// The meshes of a file, and whether a transformation stands above or in one.
    pub(super) fn read(
        source: &'a Arc<SourceText>,
        tokens: Vec<Token>,
    ) -> Result<(Vec<Prim>, bool), Diagnostic> {
        let mut reader = Reader { source, tokens, at: 0, meshes: Vec::new(), moved: false };
        reader.parentheses()?;
        reader.body(None, 0)?;
        Ok((reader.meshes, reader.moved))
    }

    fn text(&self, token: &Token) -> &str {
        &self.source.text[token.place.clone()]
    }

    fn is(&self, sign: u8) -> bool {
        self.tokens.get(self.at).is_some_and(|token| token.kind == Kind::Sign(sign))
    }

    fn wrong(&self, token: Option<&Token>, message: impl Into<String>) -> Diagnostic {
        let end = self.source.text.trim_end().len();
        let place = token.map_or(end..end, |token| token.place.clone());
        Diagnostic::new(self.source, place, message)
    }

    fn cut_off(&self) -> Diagnostic {
        self.wrong(None, "the file ends here, and a bracket is open")
            .with_help("the file is cut off, or a bracket is missing")
    }

    /// The tokens between a bracket and its counterpart, if a bracket stands here.
    fn bracketed(&mut self, open: u8, close: u8) -> Result<Option<Vec<Token>>, Diagnostic> {
        if !self.is(open) {
            return Ok(None);
        }
        let (start, mut depth) = (self.at, 0_usize);
        while let Some(token) = self.tokens.get(self.at) {
            self.at += 1;
            if token.kind == Kind::Sign(open) {
                depth += 1;
            } else if token.kind == Kind::Sign(close) {
                depth -= 1;
                if depth == 0 {
                    return Ok(Some(self.tokens[start + 1..self.at - 1].to_vec()));
                }
            }
        }
        Err(self.cut_off())
    }

    fn parentheses(&mut self) -> Result<Vec<Token>, Diagnostic> {
        Ok(self.bracketed(b'(', b')')?.unwrap_or_default())
    }

    /// The prims and fields up to a closing bracket, or to the end of the file.
    fn body(&mut self, mut mesh: Option<&mut Prim>, depth: usize) -> Result<(), Diagnostic> {
        if depth > MAX_DEPTH {
            let message = format!("prims are nested deeper than {MAX_DEPTH}");
            return Err(self.wrong(self.tokens.get(self.at), message));
        }
        loop {
            let Some(token) = self.tokens.get(self.at).cloned() else {
                return if depth == 0 { Ok(()) } else { Err(self.cut_off()) };
            };
            match token.kind {
                Kind::Sign(b'}') if depth > 0 => {
                    self.at += 1;
                    return Ok(());
                }
                Kind::Sign(b';') => self.at += 1,
                Kind::Word => match self.text(&token) {
                    "def" | "over" | "class" => self.prim(depth)?,
                    "variantSet" => {
                        self.at += 2;
                        if self.is(b'=') {
                            self.at += 1;
                        }
                        self.bracketed(b'{', b'}')?;
                    }
                    _ => self.field(mesh.as_deref_mut())?,
                },
                _ => {
                    return Err(self
                        .wrong(Some(&token), "a prim or a field is expected here")
                        .with_help(
                            "prims are `def Mesh \"name\" { … }`, fields `type name = value`",
                        ));
                }
            }
        }
    }

    fn prim(&mut self, depth: usize) -> Result<(), Diagnostic> {
        let word = self.tokens[self.at].clone();
        self.at += 1;
        let mut kind = String::new();
        while let Some(token) = self.tokens.get(self.at).filter(|token| token.kind == Kind::Word) {
            self.text(token).clone_into(&mut kind);
            self.at += 1;
        }
        let Some(name) = self.tokens.get(self.at).filter(|token| token.kind == Kind::Text).cloned()
        else {
            return Err(self
                .wrong(self.tokens.get(self.at), "the name of the prim is expected here")
                .with_help("write it between quotation marks"));
        };
        self.at += 1;
        self.parentheses()?;
        if !self.is(b'{') {
            return Err(self
                .wrong(self.tokens.get(self.at), "`{` is expected here")
                .with_help("the file is cut off, or a bracket is missing"));
        }
        self.at += 1;
        if kind != "Mesh" {
            return self.body(None, depth + 1);
        }
        let place = word.place.start..name.place.end;
        let name = self.text(&name).to_owned();
        let mut prim = Prim { name, place, fields: BTreeMap::new() };
        self.body(Some(&mut prim), depth + 1)?;
        self.meshes.push(prim);
        Ok(())
    }

    /// `type name = value (about)`; the value may be absent.
    fn field(&mut self, mesh: Option<&mut Prim>) -> Result<(), Diagnostic> {
        let line = self.tokens[self.at].line;
        let mut last = self.tokens[self.at].clone();
        while let Some(token) = self.tokens.get(self.at) {
            if token.kind != Kind::Word || token.line != line {
                break;
            }
            last = token.clone();
            self.at += 1;
        }
        let mut field = Field { name: last.place.clone(), ..Field::default() };
        let mut end = line;
        if self.is(b'=') {
            self.at += 1;
            let mut value = None;
            for [open, close] in [b"[]", b"()", b"{}"] {
                if value.is_none() {
                    value = self.bracketed(*open, *close)?;
                }
            }
            field.value = if let Some(value) = value {
                value
            } else {
                let token = self.tokens.get(self.at).cloned().ok_or_else(|| self.cut_off())?;
                if !matches!(token.kind, Kind::Word | Kind::Text | Kind::Path) {
                    return Err(self.wrong(Some(&token), "a value is expected here"));
                }
                self.at += 1;
                vec![token]
            };
            end = self.tokens[self.at - 1].line;
        }
        if self.tokens.get(self.at).is_some_and(|token| token.line == end) {
            field.about = self.parentheses()?;
        }
        let name = self.text(&last).to_owned();
        self.moved |= name.starts_with("xformOp:") && !field.value.is_empty();
        if let Some(mesh) = mesh {
            let (place, message) = (field.name.clone(), format!("`{name}` for the second time"));
            if mesh.fields.insert(name, field).is_some_and(|field| !field.value.is_empty()) {
                let error = Diagnostic::new(self.source, place, message);
                return Err(error.with_help("keep one of the two"));
            }
        }
        Ok(())
    }
}
