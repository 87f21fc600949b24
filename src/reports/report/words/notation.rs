//! The notation of texts. Words are written with the signs of a keyboard, as claim files are: `T_c`, `C^1`, `x^k_i`,
//! `<=`, and `code` between backticks. Each output typesets these parts in its own way.

use super::greek::greek;

/// A part of a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Part<'t> {
    /// As it is.
    Plain(&'t str),
    /// What is typed as it stands here, without its backticks.
    Code(&'t str),
    /// A letter, or a Greek one by its name, or nothing where the scripts belong to what stands before, with an index and
    /// an exponent.
    Scripts {
        /// All of it as it is typed.
        typed: &'t str,
        /// The letter.
        base: &'t str,
        /// The index.
        below: Option<&'t str>,
        /// The exponent.
        above: Option<&'t str>,
    },
    /// The minus of a number.
    Minus,
}

/// The parts of a text, from its beginning to its end.
pub(crate) fn parts(text: &str) -> Vec<Part<'_>> {
    let mut parts = Vec::new();
    let (mut start, mut at) = (0, 0);
    while let Some(c) = text[at..].chars().next() {
        let Some((part, length)) = special(&text[..at], &text[at..]) else {
            at += c.len_utf8();
            continue;
        };
        if start < at {
            parts.push(Part::Plain(&text[start..at]));
        }
        parts.push(part);
        at += length;
        start = at;
    }
    if start < text.len() {
        parts.push(Part::Plain(&text[start..]));
    }
    parts
}

/// A part that begins here and is not plain, with its length; `done` is the text in front of it.
fn special<'t>(done: &str, rest: &'t str) -> Option<(Part<'t>, usize)> {
    let first = rest.chars().next()?;
    let before = done.chars().next_back();
    let in_word = before.is_some_and(|c| c.is_alphanumeric() || c == '_');
    match first {
        '`' => {
            let code = rest[1..].split_once('`')?.0;
            let is_code = !code.is_empty() && !code.contains('\n');
            is_code.then_some((Part::Code(code), code.len() + 2))
        }
        '<' if rest.starts_with("<=") && !rest.starts_with("<==") => Some((Part::Plain("≤"), 2)),
        '>' if rest.starts_with(">=") => Some((Part::Plain("≥"), 2)),
        '-' => {
            let stands_alone = before.is_none_or(|c| " ([|,".contains(c));
            let number = rest[1..].starts_with(|c: char| c.is_ascii_digit() || c == '√');
            (stands_alone && number).then_some((Part::Minus, 1))
        }
        '^' if in_word || before.is_some_and(|c| ")|‖′∞".contains(c)) => scripts(0, rest),
        'l' if !in_word && rest.starts_with("log_") => scripts(3, rest),
        // A colon or a dash stands in names, as those of schemes.
        c if c.is_alphabetic() && !in_word && before.is_none_or(|c| !":-.".contains(c)) => {
            let word = &rest[..rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len())];
            let long = if greek(word).is_some() { word.len() } else { c.len_utf8() };
            let typed = &rest[..long];
            let letter = Part::Scripts { typed, base: typed, below: None, above: None };
            scripts(long, rest)
                .or_else(|| is_variable(done, &rest[long..]).then_some((letter, long)))
        }
        _ => None,
    }
}

/// The signs between the sides of a relation.
const RELATIONS: [&str; 7] = [" < ", " <= ", " = ", " > ", " >= ", " ≤ ", " ≥ "];

/// Whether a letter between these texts is a variable: alone, or a side of a relation.
fn is_variable(before: &str, after: &str) -> bool {
    let related = RELATIONS.iter().any(|sign| after.starts_with(sign))
        || RELATIONS.iter().any(|sign| before.ends_with(sign));
    let ends = !after.starts_with(|c: char| c.is_alphanumeric() || "(_^'’-".contains(c));
    ends && (related
        || before.is_empty() && after.is_empty()
        || before.ends_with('|') && after.starts_with('|'))
}

/// The scripts that follow the first so many bytes, with these.
fn scripts(base: usize, rest: &str) -> Option<(Part<'_>, usize)> {
    let (mut below, mut above, mut length) = (None, None, base);
    while let Some(sign) = rest[length..].chars().next().filter(|c| matches!(c, '_' | '^')) {
        let place = if sign == '_' { &mut below } else { &mut above };
        let (script, long) = script(sign, &rest[length + 1..])?;
        if place.replace(script).is_some() {
            return None;
        }
        length += 1 + long;
    }
    let mut after = rest[length..].chars();
    let is_name = match after.next() {
        // As in a_b.obj and w_1=3/256.
        Some('.') => after.next().is_some_and(char::is_alphanumeric),
        Some('=') => true,
        _ => false,
    };
    let (typed, base) = (&rest[..length], &rest[..base]);
    (below.or(above).is_some() && !is_name)
        .then_some((Part::Scripts { typed, base, below, above }, length))
}

/// What stands below or above, and its length in the text.
fn script(sign: char, rest: &str) -> Option<(&str, usize)> {
    if let Some((inner, _)) = rest.strip_prefix('{').and_then(|rest| rest.split_once('}')) {
        return (!inner.is_empty()).then_some((inner, inner.len() + 2));
    }
    if rest.starts_with('(') {
        let end = rest.find(')')? + 1;
        let plain = !rest[1..end].contains([' ', '(', '^', '_']);
        return plain.then_some((&rest[..end], end));
    }
    let run = |text: &str, is: fn(char) -> bool| text.find(|c| !is(c)).unwrap_or(text.len());
    let sign_length =
        rest.chars().next().filter(|c| matches!(c, '-' | '−')).map_or(0, char::len_utf8);
    let digits = sign_length + run(&rest[sign_length..], |c| c.is_ascii_digit());
    let word = run(rest, |c| c.is_alphanumeric() || c == '∞');
    let end = match rest.chars().next()? {
        _ if digits > sign_length && word <= digits => digits,
        // An exponent of several letters may be a product.
        c if (c.is_alphabetic() || c == '∞') && (sign == '_' || word == c.len_utf8()) => word,
        _ => return None,
    };
    Some((&rest[..end], end))
}

/// A text with the signs of print that Unicode has for single characters: `C¹`, `10⁻¹²`, `x₀`, `≤`. Formulas that one may
/// type again, which have `*`, keep their exponents.
#[must_use]
pub fn unicode(text: &str) -> String {
    let quoted = |(text, is_code)| if is_code { format!("`{text}`") } else { text };
    let line = |line| pieces(line).into_iter().map(quoted).collect();
    text.split('\n').map(line).collect::<Vec<String>>().join("\n")
}

/// The same of a line in pieces, each with whether it is code.
pub(crate) fn pieces(text: &str) -> Vec<(String, bool)> {
    let is_formula = text.contains('*');
    let written = |part: Part<'_>| match part {
        Part::Plain(text) | Part::Code(text) => text.to_owned(),
        Part::Minus => "-".to_owned(),
        Part::Scripts { typed, base, below, above } => {
            let small = |script: Option<&str>, of: fn(char) -> Option<char>| {
                script.map_or(Some(String::new()), |script| script.chars().map(of).collect())
            };
            match (small(below, subscript), small(above, superscript)) {
                // Words are names, which one may type again.
                (Some(below), Some(above)) if !is_formula && base.chars().count() < 2 => {
                    format!("{base}{above}{below}")
                }
                _ => typed.to_owned(),
            }
        }
    };
    let piece = |part| (written(part), matches!(part, Part::Code(_)));
    parts(text).into_iter().map(piece).collect()
}

/// Pairs of a sign and its small form.
fn small(c: char, pairs: &[(char, char)]) -> Option<char> {
    pairs.iter().find(|(sign, _)| *sign == c).map(|(_, small)| *small)
}

fn superscript(c: char) -> Option<char> {
    const SIGNS: [(char, char); 19] = [
        ('0', '⁰'),
        ('1', '¹'),
        ('2', '²'),
        ('3', '³'),
        ('4', '⁴'),
        ('5', '⁵'),
        ('6', '⁶'),
        ('7', '⁷'),
        ('8', '⁸'),
        ('9', '⁹'),
        ('-', '⁻'),
        ('−', '⁻'),
        ('+', '⁺'),
        ('c', 'ᶜ'),
        ('i', 'ⁱ'),
        ('j', 'ʲ'),
        ('k', 'ᵏ'),
        ('m', 'ᵐ'),
        ('n', 'ⁿ'),
    ];
    small(c, &SIGNS)
}

fn subscript(c: char) -> Option<char> {
    const SIGNS: [(char, char); 13] = [
        ('0', '₀'),
        ('1', '₁'),
        ('2', '₂'),
        ('3', '₃'),
        ('4', '₄'),
        ('5', '₅'),
        ('6', '₆'),
        ('7', '₇'),
        ('8', '₈'),
        ('9', '₉'),
        ('-', '₋'),
        ('−', '₋'),
        ('+', '₊'),
    ];
    small(c, &SIGNS)
}
