//! Languages, and what they make of a literal.

use std::path::Path;

/// The language of a source file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// C, C++, Objective-C and CUDA: a literal without a suffix is a double, and `1/6` is 0.
    C,
    /// GLSL: a literal without a suffix is a float.
    Shader,
    /// HLSL, Metal and OpenCL: it depends on the compiler whether a literal without a suffix is rounded to a double before it
    /// becomes a float.
    Hlsl,
    /// WGSL: all numbers are floats, but a compiler may round a literal to a double first.
    Wgsl,
    /// JavaScript and TypeScript: every number is a double.
    JavaScript,
    /// Python 3: `1/6` is a double.
    Python,
    /// Rust: a literal has the type of the table.
    Rust,
    /// MATLAB and Octave: every literal is a double.
    Matlab,
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
            "hlsl" | "hlsli" | "fx" | "fxh" | "metal" | "cl" => Language::Hlsl,
            "wgsl" => Language::Wgsl,
            "m" => return Err("it is MATLAB, `matlab`, or Objective-C, which is read as `c`"),
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
            Language::Shader | Language::Hlsl | Language::Wgsl | Language::Matlab => None,
            Language::JavaScript | Language::Python | Language::Rust => Some('_'),
        }
    }

    /// Whether `float` before a number, or its bracket, is a conversion: `(float)x` and `float(x)`.
    pub(super) fn converts(self) -> [bool; 2] {
        match self {
            Language::C | Language::Shader | Language::Hlsl => [true, true],
            Language::Python | Language::Wgsl | Language::Matlab => [false, true],
            Language::JavaScript | Language::Rust => [false, false],
        }
    }

    /// The language of a name in a claim file: `c`, `shader`, `hlsl`, `wgsl`, `javascript`, `python`, `rust` or `matlab`.
    #[must_use]
    pub fn parse(name: &str) -> Option<Language> {
        Some(match name {
            "c" => Language::C,
            "shader" => Language::Shader,
            "hlsl" => Language::Hlsl,
            "wgsl" => Language::Wgsl,
            "matlab" => Language::Matlab,
            "javascript" => Language::JavaScript,
            "python" => Language::Python,
            "rust" => Language::Rust,
            _ => return None,
        })
    }

    /// The signs that begin a comment up to the end of its line. Octave has `#` too.
    pub(super) fn line_comments(self) -> &'static [&'static str] {
        match self {
            Language::Python => &["#"],
            Language::Matlab => &["%", "#"],
            _ => &["//"],
        }
    }

    /// Whether `/*` begins a comment.
    pub(super) fn has_block_comments(self) -> bool {
        !matches!(self, Language::Python | Language::Matlab)
    }

    /// Whether a type stands before a name, and a list in braces.
    pub(super) fn is_native(self) -> bool {
        matches!(self, Language::C | Language::Shader | Language::Hlsl)
    }

    /// Whether a line that begins with `#` is for a preprocessor.
    pub(super) fn has_preprocessor(self) -> bool {
        self.is_native()
    }

    /// How a table is declared that the language keeps as it is.
    pub(super) fn constant(self) -> Option<&'static str> {
        match self {
            Language::C | Language::Shader | Language::Hlsl | Language::Wgsl => Some("`const`"),
            Language::JavaScript => Some("with `Object.freeze`"),
            Language::Python => Some("as a tuple"),
            Language::Rust => Some("without `mut`"),
            Language::Matlab => None,
        }
    }
}
