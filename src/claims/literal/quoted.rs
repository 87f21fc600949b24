//! Lengths of what is no code: texts in quotes with rules of their own, and lines for the preprocessor.

use super::language::Language;

/// How deep templates may stand in each other.
const MAX_TEMPLATES: usize = 64;

/// The length of a raw text that begins here, as `R"x(…)x"` in C++ and `r#"…"#` in Rust.
pub(super) fn raw_length(rest: &str, language: Language) -> Option<usize> {
    let prefixes: &[&str] = match language {
        Language::C => &["R", "LR", "uR", "UR", "u8R"],
        Language::Rust => &["r", "br", "cr"],
        _ => return None,
    };
    let word = rest.find(|c: char| !c.is_ascii_alphanumeric())?;
    prefixes.contains(&&rest[..word]).then_some(())?;
    let after = &rest[word..];
    let (open, close) = if language == Language::C {
        let bracket = after.strip_prefix('"')?.find('(')?;
        (bracket + 2, format!("){}\"", &after[1..=bracket]))
    } else {
        let marks = after.len() - after.trim_start_matches('#').len();
        after[marks..].starts_with('"').then_some(())?;
        (marks + 1, format!("\"{}", &after[..marks]))
    };
    // Without an end, all is text.
    let length = after[open..].find(&close).map_or(after.len(), |at| open + at + close.len());
    Some(word + length)
}

/// The length of a template of JavaScript, with the expressions `${…}` in it.
pub(super) fn template_length(rest: &str, depth: usize) -> Option<usize> {
    let bytes = rest.as_bytes();
    let mut at = 1;
    let mut braces = 0_usize;
    while at < bytes.len() && depth <= MAX_TEMPLATES {
        at += match bytes[at] {
            b'\\' => 2,
            b'`' if braces == 0 => return Some(at + 1),
            b'`' => template_length(&rest[at..], depth + 1)?,
            b'$' if braces == 0 && bytes.get(at + 1) == Some(&b'{') => {
                braces = 1;
                2
            }
            b'{' if braces > 0 => {
                braces += 1;
                1
            }
            b'}' if braces > 0 => {
                braces -= 1;
                1
            }
            quote @ (b'"' | b'\'') if braces > 0 => {
                2 + bytes[at + 1..].iter().position(|&byte| byte == quote)?
            }
            _ => 1,
        };
    }
    None
}

/// The length of a regular expression of JavaScript `/…/`, if it ends on its line.
pub(super) fn regex_length(rest: &str) -> Option<usize> {
    let bytes = rest.as_bytes();
    bytes.starts_with(b"/").then_some(())?;
    let (mut at, mut class) = (1, false);
    loop {
        match *bytes.get(at)? {
            b'\n' => return None,
            b'\\' => at += 1,
            b'[' => class = true,
            b']' => class = false,
            b'/' if !class => return Some(at + 1),
            _ => {}
        }
        at += 1;
    }
}

/// The length of a line for the preprocessor, with the lines that `\` or a comment joins to it.
pub(super) fn directive_length(rest: &str) -> usize {
    let bytes = rest.as_bytes();
    let (mut at, mut comment) = (0, false);
    while at < bytes.len() {
        let after = &bytes[at..];
        at += match after[0] {
            b'\n' => return at + 1,
            b'\\' => {
                let blanks = after[1..].iter().take_while(|b| matches!(b, b' ' | b'\t' | b'\r'));
                let length = 1 + blanks.count();
                length + usize::from(after.get(length) == Some(&b'\n'))
            }
            b'/' if !comment && after.starts_with(b"//") => {
                comment = true;
                2
            }
            b'/' if !comment && after.starts_with(b"/*") => {
                rest[at + 2..].find("*/").map_or(after.len(), |length| length + 4)
            }
            quote @ (b'"' | b'\'') if !comment => {
                let closes =
                    after[1..].iter().take_while(|&&b| b != b'\n').position(|&b| b == quote);
                closes.map_or(1, |length| length + 2)
            }
            _ => 1,
        };
    }
    at
}
