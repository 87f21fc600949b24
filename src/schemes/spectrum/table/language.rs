//! The languages of tables.

use super::real::{Real, RealType};

/// A language that tables are written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// C99.
    C,
    /// C++11.
    Cpp,
    /// Rust.
    Rust,
    /// Python.
    Python,
    /// GLSL 3.30, or 4.00 for f64.
    Glsl,
    /// HLSL, from shader model 5 on for f64.
    Hlsl,
    /// WGSL, which has f32 only.
    Wgsl,
    /// JSON.
    Json,
}

impl Language {
    /// All languages.
    pub const ALL: [Language; 8] = [
        Language::C,
        Language::Cpp,
        Language::Rust,
        Language::Python,
        Language::Glsl,
        Language::Hlsl,
        Language::Wgsl,
        Language::Json,
    ];

    /// The name, as in `--format`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Language::C => "c",
            Language::Cpp => "cpp",
            Language::Rust => "rust",
            Language::Python => "python",
            Language::Glsl => "glsl",
            Language::Hlsl => "hlsl",
            Language::Wgsl => "wgsl",
            Language::Json => "json",
        }
    }

    /// The types of numbers that it has, the usual one first.
    #[must_use]
    pub fn types(self) -> &'static [RealType] {
        match self {
            Language::Wgsl => &[RealType::F32],
            _ => &[RealType::F64, RealType::F32],
        }
    }

    /// The literal of a number. Readers of Python and JSON know f64 only; there an f32 is written as the
    /// f64 that equals it.
    pub(super) fn literal(self, value: Real) -> String {
        let single = matches!(value, Real::F32(_));
        match self {
            Language::C | Language::Cpp | Language::Hlsl | Language::Wgsl if single => {
                format!("{}f", value.shortest())
            }
            Language::Glsl if !single => format!("{}lf", value.shortest()),
            Language::Hlsl => format!("{}L", value.shortest()),
            Language::Python | Language::Json => value.as_f64(),
            _ => value.shortest(),
        }
    }

    /// The name of the type.
    pub(super) fn type_name(self, real: RealType) -> &'static str {
        match (self, real) {
            (Language::Rust | Language::Wgsl, RealType::F32) => "f32",
            (Language::Rust, RealType::F64) => "f64",
            (_, RealType::F32) => "float",
            (_, RealType::F64) => "double",
        }
    }

    /// A line of a comment. In C one that ends in `\` or `??/`, as a path may, would go on in the next line.
    pub(super) fn comment(self, line: &str) -> String {
        let mark = if self == Language::Python { "#" } else { "//" };
        let text = format!("{mark} {line}").trim_end().to_owned();
        if text.ends_with('\\') || text.ends_with("??/") { text + " ." } else { text }
    }
}
