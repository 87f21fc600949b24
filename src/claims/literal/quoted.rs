//! Lengths of words with rules of their own: numbers, texts in quotes, comments, and lines for the preprocessor.

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
pub(super) fn directive_length(rest: &str, language: Language) -> usize {
    let bytes = rest.as_bytes();
    let (mut at, mut comment) = (0, false);
    while at < bytes.len() {
        let after = &bytes[at..];
        let word = at > 0 && is_of_word(bytes[at - 1]);
        at += match after[0] {
            // `1'000` and `R"(…)"`
            byte if byte.is_ascii_digit() && !word && !comment => {
                number_length(&rest[at..], language)
            }
            byte if byte.is_ascii_alphabetic() && !word && !comment => {
                raw_length(&rest[at..], language).unwrap_or(1)
            }
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
            b'"' | b'\'' if !comment => quoted_length(after).unwrap_or(1),
            _ => 1,
        };
    }
    at
}

/// The length of a text in quotes, if it ends on its line.
fn quoted_length(text: &[u8]) -> Option<usize> {
    let mut at = 1;
    loop {
        match *text.get(at)? {
            b'\n' => return None,
            b'\\' => at += 1 + usize::from(text[at + 1..].starts_with(b"\r\n")),
            byte if byte == text[0] => return Some(at + 1),
            _ => {}
        }
        at += 1;
    }
}

fn is_of_word(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || byte == b'_' || !byte.is_ascii()
}

/// Whether `\` joins parts of one word in a line for the preprocessor, or what may be parts of one sign.
pub(super) fn splits_word(line: &str) -> bool {
    line.match_indices('\\').any(|(at, _)| {
        let next = line[at + 1..].trim_start_matches([' ', '\t', '\r']).strip_prefix('\n');
        let next = next.and_then(|next| next.bytes().next());
        let before = line[..at].bytes().next_back();
        before.zip(next).is_some_and(|(before, next)| {
            is_of_word(before) && is_of_word(next) || b"/#%?:".contains(&before)
        })
    })
}

/// Whether C takes the signs here for one of `[`, `]`, `{`, `}` and `#`; `<::` is `<` and `::` mostly.
pub(super) fn is_digraph(rest: &str) -> bool {
    let global = rest.strip_prefix("<::").is_some_and(|rest| !rest.starts_with([':', '>']));
    !global && ["<:", ":>", "<%", "%>", "%:"].iter().any(|signs| rest.starts_with(signs))
}

/// The length of a comment of MATLAB between lines `%{` and `%}`, or of the line.
pub(super) fn block_length(comment: &str) -> usize {
    let (mut depth, mut length) = (0_usize, 0);
    for line in comment.split_inclusive('\n') {
        length += line.len();
        match line.trim() {
            "%{" => depth += 1,
            "%}" => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth == 0 {
            break;
        }
    }
    length
}

/// A number takes all letters, digits and separators that follow, one point, and signs after an exponent. Two
/// points in a row are none of it, as in `0..3`.
pub(super) fn number_length(rest: &str, language: Language) -> usize {
    let bytes = rest.as_bytes();
    let hexadecimal = rest.len() > 1 && bytes[0] == b'0' && bytes[1].eq_ignore_ascii_case(&b'x');
    let exponents: &[u8] = match language {
        _ if hexadecimal => b"pP",
        Language::Matlab => b"eEdD",
        _ => b"eE",
    };
    let mut at = 0;
    while at < bytes.len() {
        let (byte, next) = (bytes[at], bytes.get(at + 1).copied());
        let taken = match byte {
            b'.' => next != Some(b'.') && !bytes[..at].contains(&b'.'),
            b'+' | b'-' => at > 0 && exponents.contains(&bytes[at - 1]),
            b'\'' => language == Language::C && next.is_some_and(|b| b.is_ascii_alphanumeric()),
            _ => byte.is_ascii_alphanumeric() || byte == b'_',
        };
        if !taken {
            break;
        }
        at += 1;
    }
    at
}
