//! Languages, and what they make of a literal.

use std::path::Path;

/// The language of a source file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// C, C++, Objective-C and CUDA: a literal without a suffix is a double, and `1/6` is 0.
    C,
    /// GLSL: a literal without a suffix is a float.
    Shader,
    /// JavaScript and TypeScript: every number is a double.
    JavaScript,
    /// Python 3: `1/6` is a double.
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
    /// # Errors
    /// Why the ending says none: it belongs to no language that is read, to several, or to one in which a number
    /// depends on more than its text.
    ///
    /// ```
    /// use std::path::Path;
    /// use subcert::literal::Language;
    ///
    /// assert_eq!(Language::of(Path::new("far/loopPatchBuilder.cpp")), Ok(Language::C));
    /// assert!(Language::of(Path::new("weights.m")).is_err());
    /// ```
    pub fn of(path: &Path) -> Result<Language, &'static str> {
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
        Ok(match ending.to_ascii_lowercase().as_str() {
            "c" | "h" | "cc" | "cpp" | "cxx" | "hh" | "hpp" | "hxx" | "inl" | "ipp" | "cu"
            | "cuh" | "mm" => Language::C,
            "glsl" | "vert" | "frag" | "geom" | "comp" | "tesc" | "tese" => Language::Shader,
            "js" | "mjs" | "cjs" | "ts" | "jsx" | "tsx" => Language::JavaScript,
            "py" | "pyi" => Language::Python,
            "rs" => Language::Rust,
            "m" => {
                return Err(
                    "it is MATLAB, which is not read, or Objective-C, which is read as `c`",
                );
            }
            "metal" | "hlsl" | "fx" => {
                return Err(
                    "it has no literals of doubles, and whether one without a suffix is rounded to a double \
                            first depends on the compiler; `shader` rounds once",
                );
            }
            "cl" => {
                return Err(
                    "whether a literal without a suffix is a double depends on the device; `c` says that it \
                            is, `shader` that it is none",
                );
            }
            "pyx" => {
                return Err(
                    "whether a quotient of integers is cut depends on directives; `python` says that it is not",
                );
            }
            _ => return Err("the ending of its name belongs to no language that is read"),
        })
    }

    /// The sign that may stand between digits.
    pub(super) fn separator(self) -> Option<char> {
        match self {
            Language::C => Some('\''),
            Language::Shader => None,
            Language::JavaScript | Language::Python | Language::Rust => Some('_'),
        }
    }

    /// Whether `float` before a number, or its bracket, is a conversion: `(float)x` and `float(x)`.
    pub(super) fn converts(self) -> [bool; 2] {
        match self {
            Language::C | Language::Shader => [true, true],
            Language::Python => [false, true],
            Language::JavaScript | Language::Rust => [false, false],
        }
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
