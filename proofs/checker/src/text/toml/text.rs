//! Blanks, names, strings and numbers of TOML.

use crate::text::cursor::{Cursor, Parsed};

const CONTROL: &str = "no control character, and line ends that are LF or CRLF";

/// Whether a character may stand in comments and strings. Line ends are no part of it.
fn is_plain(c: char) -> bool {
    c == '\t' || !c.is_ascii_control()
}

/// Skips blanks, and line ends and comments if `lines`.
pub fn space(c: &mut Cursor, lines: bool) -> Parsed<()> {
    loop {
        c.take(|c| matches!(c, ' ' | '\t'));
        if !lines {
            return Ok(());
        }
        if c.eat("#") {
            c.take(is_plain);
            if !is_line_end(c) {
                return Err(CONTROL);
            }
        } else if !c.eat("\n") && !c.eat("\r\n") {
            return Ok(());
        }
    }
}

/// Whether a line ends here.
pub fn is_line_end(c: &Cursor) -> bool {
    c.peek().is_none() || c.is_at("\n") || c.is_at("\r\n")
}

pub fn name(c: &mut Cursor) -> Parsed<String> {
    for quote in ["'", "\""] {
        if c.eat(quote) {
            return string(c, quote);
        }
    }
    let name = c.take(|c| c.is_ascii_alphanumeric() || c == '_' || c == '-');
    if name.is_empty() { Err("a name") } else { Ok(name) }
}

/// Reads a decimal whole number: a sign, digits without a 0 before them, and `_` between digits. A `+` and `_` are left out.
pub fn whole_number(c: &mut Cursor) -> Parsed<String> {
    const WHOLE: &str = "a whole number; other numbers stand in quotes";
    let negative = c.eat("-");
    if !negative {
        c.eat("+");
    }
    let spelled = c.take(|c| c.is_ascii_alphanumeric() || matches!(c, '_' | '.' | '+' | '-' | ':'));
    let groups: Vec<&str> = spelled.split('_').collect();
    let digits = groups.concat();
    let right =
        groups.iter().all(|group| !group.is_empty() && group.bytes().all(|b| b.is_ascii_digit()));
    if !right || digits.len() > 1 && digits.starts_with('0') {
        return Err(WHOLE);
    }
    Ok(if negative { format!("-{digits}") } else { digits })
}

/// Reads a string after its opening quote.
pub fn string(c: &mut Cursor, quote: &str) -> Parsed<String> {
    const CLOSED: &str = "the closing quote";
    let mut text = String::new();
    let (long, escapes) = (quote.len() == 3, quote.starts_with('"'));
    // A line end behind the opening quotes is no part of the string.
    _ = long && (c.eat("\n") || c.eat("\r\n"));
    loop {
        if c.eat(quote) {
            // One or two more quotes belong to the string.
            for _ in 0..2 {
                if long && c.eat(&quote[..1]) {
                    text.push_str(&quote[..1]);
                }
            }
            return Ok(text);
        }
        if long && c.eat("\r\n") {
            text.push('\n');
            continue;
        }
        match c.next().ok_or(CLOSED)? {
            '\n' if long => text.push('\n'),
            '\n' => return Err(CLOSED),
            '\\' if escapes => text.extend(escaped(c, long)?),
            other if is_plain(other) => text.push(other),
            _ => return Err(CONTROL),
        }
    }
}

/// What an escape after its `\` stands for; nothing for the end of a line, with all blanks behind it.
fn escaped(c: &mut Cursor, long: bool) -> Parsed<Option<char>> {
    const ESCAPES: &str =
        "one of the escapes \\\" \\\\ \\b \\e \\f \\n \\r \\t \\xHH \\uHHHH \\UHHHHHHHH";
    let start = c.at();
    if long {
        c.take(|c| matches!(c, ' ' | '\t'));
        if is_line_end(c) {
            while c.eat("\n") || c.eat("\r\n") || !c.take(|c| matches!(c, ' ' | '\t')).is_empty() {}
            return Ok(None);
        }
        c.back(start);
    }
    Ok(Some(match c.next().ok_or(ESCAPES)? {
        escaped @ ('"' | '\\') => escaped,
        'b' => '\u{8}',
        'e' => '\u{1b}',
        'f' => '\u{c}',
        'n' => '\n',
        'r' => '\r',
        't' => '\t',
        mark @ ('x' | 'u' | 'U') => {
            let count = match mark {
                'x' => 2,
                'u' => 4,
                _ => 8,
            };
            let mut code = 0_u32;
            for _ in 0..count {
                let digit = c.next().and_then(|digit| digit.to_digit(16)).ok_or(ESCAPES)?;
                code = code << 4 | digit;
            }
            char::from_u32(code).ok_or(ESCAPES)?
        }
        _ => return Err(ESCAPES),
    }))
}
