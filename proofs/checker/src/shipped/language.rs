//! The languages of programs.

/// A language, or a family of languages with the same rules.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// C, C++ and CUDA.
    C,
    /// GLSL and HLSL.
    Shader,
    /// JavaScript and TypeScript.
    JavaScript,
    /// Python.
    Python,
    /// Rust.
    Rust,
}

/// The endings of file names, by language.
const ENDINGS: [(Language, &str); 5] = [
    (Language::C, "c h cc cpp cxx hh hpp hxx inl ipp cu cuh cl m mm metal"),
    (Language::Shader, "glsl vert frag geom comp tesc tese hlsl fx"),
    (Language::JavaScript, "js mjs cjs ts jsx tsx"),
    (Language::Python, "py pyx pyi"),
    (Language::Rust, "rs"),
];

impl Language {
    /// The language of a name in a claim file.
    pub fn read(name: &str) -> Option<Language> {
        Some(match name {
            "c" => Language::C,
            "shader" => Language::Shader,
            "javascript" => Language::JavaScript,
            "python" => Language::Python,
            "rust" => Language::Rust,
            _ => return None,
        })
    }

    /// The language of a source file, by the ending of its name.
    pub fn of_file(name: &str) -> Option<Language> {
        let (_, ending) = name.rsplit_once('.')?;
        let ending = ending.to_ascii_lowercase();
        let known = |endings: &str| endings.split(' ').any(|known| known == ending);
        ENDINGS.iter().find(|(_, endings)| known(endings)).map(|(language, _)| *language)
    }

    /// Whether a quotient of integers is an integer.
    pub fn truncates(self) -> bool {
        matches!(self, Language::C | Language::Shader)
    }

    /// The sign that may stand between digits.
    pub fn separator(self) -> Option<char> {
        match self {
            Language::C => Some('\''),
            Language::Shader => None,
            _ => Some('_'),
        }
    }
}
