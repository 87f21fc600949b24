//! The languages of programs.

/// A language, or a family of languages with the same rules.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// C, C++, Objective-C and CUDA.
    C,
    /// GLSL.
    Shader,
    /// JavaScript and TypeScript.
    JavaScript,
    /// Python 3.
    Python,
    /// Rust.
    Rust,
    /// HLSL, Metal and OpenCL. A compiler may round literals to doubles first.
    Hlsl,
    /// WGSL. A compiler may round literals to doubles first.
    Wgsl,
    /// MATLAB and Octave.
    Matlab,
}

/// The endings of file names, by language.
const ENDINGS: [(Language, &str); 7] = [
    (Language::C, "c h cc cpp cxx hh hpp hxx inl ipp cu cuh mm"),
    (Language::Shader, "glsl vert frag geom comp tesc tese"),
    (Language::JavaScript, "js mjs cjs ts jsx tsx"),
    (Language::Python, "py pyi"),
    (Language::Rust, "rs"),
    (Language::Hlsl, "hlsl hlsli fx fxh metal cl"),
    (Language::Wgsl, "wgsl"),
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
            "hlsl" => Language::Hlsl,
            "wgsl" => Language::Wgsl,
            "matlab" => Language::Matlab,
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
        matches!(self, Language::C | Language::Shader | Language::Hlsl | Language::Wgsl)
    }

    /// Whether a compiler may round literals to doubles first.
    pub fn may_widen(self) -> bool {
        matches!(self, Language::Hlsl | Language::Wgsl)
    }

    /// The text of a literal without the separators of its digits; `None` if one stands where the language has none.
    pub fn joined(self, text: &str) -> Option<String> {
        let sign = match self {
            Language::C => '\'',
            Language::Shader | Language::Hlsl | Language::Wgsl | Language::Matlab => {
                return Some(text.to_owned());
            }
            _ => '_',
        };
        let mut kept = String::new();
        // Digits of 16 stand between 0x and p.
        let prefix = text.get(..2).filter(|start| start.eq_ignore_ascii_case("0x"));
        let mut base = if prefix.is_some() { 16 } else { 10 };
        let mut rest =
            text.strip_prefix(prefix.unwrap_or_default()).unwrap_or(text).chars().peekable();
        let mut before = None;
        while let Some(next) = rest.next() {
            if next == sign {
                let digit = |c: Option<char>| c.is_some_and(|c| c.is_digit(base));
                let first = before.is_none() && prefix.is_some();
                let allowed = match self {
                    Language::Rust => first || before.is_some_and(|c| c != '.'),
                    Language::Python if first => digit(rest.peek().copied()),
                    _ => digit(before) && digit(rest.peek().copied()),
                };
                if !allowed {
                    return None;
                }
            } else {
                kept.push(next);
                base = if matches!(next, 'p' | 'P') { 10 } else { base };
            }
            before = Some(next);
        }
        Some(format!("{}{kept}", prefix.unwrap_or_default()))
    }
}
