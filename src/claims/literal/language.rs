//! Languages, and what they make of a literal.

use std::path::Path;

/// The language of a source file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// C, C++ and CUDA: a literal without a suffix is a double, and `1/6` is 0.
    C,
    /// GLSL and HLSL: a literal without a suffix is a float.
    Shader,
    /// JavaScript and TypeScript: every number is a double.
    JavaScript,
    /// Python: `1/6` is a double.
    Python,
    /// Rust: a literal has the type of the table.
    Rust,
}

/// The type of the numbers in a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// IEEE binary32.
    Single,
    /// IEEE binary64.
    Double,
}

impl Language {
    /// The language that the ending of a file's name says.
    ///
    /// ```
    /// use std::path::Path;
    /// use subcert::literal::Language;
    ///
    /// assert_eq!(Language::of(Path::new("far/loopPatchBuilder.cpp")), Some(Language::C));
    /// assert_eq!(Language::of(Path::new("notes.txt")), None);
    /// ```
    #[must_use]
    pub fn of(path: &Path) -> Option<Language> {
        let ending = path.extension()?.to_str()?.to_ascii_lowercase();
        Some(match ending.as_str() {
            "c" | "h" | "cc" | "cpp" | "cxx" | "hh" | "hpp" | "hxx" | "inl" | "ipp" | "cu"
            | "cuh" | "cl" | "m" | "mm" | "metal" => Language::C,
            "glsl" | "vert" | "frag" | "geom" | "comp" | "tesc" | "tese" | "hlsl" | "fx" => {
                Language::Shader
            }
            "js" | "mjs" | "cjs" | "ts" | "jsx" | "tsx" => Language::JavaScript,
            "py" | "pyx" | "pyi" => Language::Python,
            "rs" => Language::Rust,
            _ => return None,
        })
    }

    /// The language of a name in a claim file: `c`, `shader`, `javascript`, `python` or `rust`.
    #[must_use]
    pub fn parse(name: &str) -> Option<Language> {
        Some(match name {
            "c" => Language::C,
            "shader" => Language::Shader,
            "javascript" => Language::JavaScript,
            "python" => Language::Python,
            "rust" => Language::Rust,
            _ => return None,
        })
    }

    /// Whether `#` begins a comment.
    pub(super) fn has_hash_comments(self) -> bool {
        self == Language::Python
    }

    /// Whether `//` and `/*` begin comments.
    pub(super) fn has_slash_comments(self) -> bool {
        self != Language::Python
    }

    /// Whether a line that begins with `#` is for a preprocessor.
    pub(super) fn has_preprocessor(self) -> bool {
        matches!(self, Language::C | Language::Shader)
    }
}
