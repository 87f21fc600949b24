//! The type that a source gives to the numbers of a table.

use super::directive::words;
use super::entry::Entry;
use super::language::{Language, Precision};
use super::token::{Kind, Token};
use crate::diagnostic::{Diagnostic, SourceText};
use crate::exact::{Integer, Rational};
use crate::float::exact;
use std::ops::Range;
use std::sync::Arc;

/// The type of the numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Element {
    Float(Precision),
    /// Integers, of at least so many bits.
    Whole {
        bits: u32,
        signed: bool,
    },
    /// The type of the literals: `auto`.
    Deduced,
    /// Another, such as of 16 bits.
    Other,
}

/// A type, and the word that says it.
pub(super) type Typed = (Element, Range<usize>);

/// What the type of this name has in it, and how many numbers: `vec3` has three floats.
pub(super) fn element(word: &str, language: Language) -> Option<(Element, usize)> {
    use Element::{Deduced, Float, Other, Whole};
    let [single, double] = [Float(Precision::Single), Float(Precision::Double)];
    let whole = |bits, signed| Some((Whole { bits, signed }, 1));
    let typed = word.strip_suffix("Array").filter(|_| language == Language::JavaScript);
    let bits = |rest: &str| rest.strip_suffix("_t").unwrap_or(rest).parse().ok();
    match (typed.unwrap_or(word), language) {
        ("Float32", Language::JavaScript)
        | ("f32", Language::Rust | Language::Wgsl)
        | ("float32" | "float32_t" | "GLfloat" | "single", _) => return Some((single, 1)),
        ("Float64", Language::JavaScript)
        | ("f64", Language::Rust)
        | ("float", Language::Python)
        | ("float64" | "float64_t" | "GLdouble", _) => return Some((double, 1)),
        ("auto", Language::C) => return Some((Deduced, 1)),
        (
            "lowp" | "mediump" | "min16float" | "min10float" | "bool" | "_Bool" | "fixed" | "f16"
            | "bf16" | "Float16" | "_Float16" | "__half" | "__fp16" | "float16" | "float16_t"
            | "__float128" | "_Float128" | "_Complex" | "Uint8Clamped",
            _,
        ) => return Some((Other, 1)),
        ("unsigned" | "usize" | "size_t", _) => return whole(32, false),
        ("signed" | "long" | "isize", _) => return whole(32, true),
        ("char", Language::C) => return whole(8, true),
        ("short", _) => return whole(16, true),
        (word, _) => {
            let begins = ["uint", "Uint", "BigUint", "u", "int", "Int", "BigInt", "i"];
            let found = begins.iter().find_map(|begin| {
                let bits: u32 = bits(word.strip_prefix(begin)?)?;
                if begin.len() == 1 && !matches!(language, Language::Rust | Language::Wgsl) {
                    return None;
                }
                Some((bits, begin.to_ascii_lowercase().contains('u')))
            });
            if let Some((bits @ (8 | 16 | 32 | 64 | 128), unsigned)) = found {
                return whole(bits, !unsigned);
            }
        }
    }
    vector(word, language)
}

/// Numbers, vectors and matrices of C and of shaders.
fn vector(word: &str, language: Language) -> Option<(Element, usize)> {
    use Element::{Float, Other, Whole};
    let [single, double] = [Float(Precision::Single), Float(Precision::Double)];
    if language == Language::Wgsl {
        // `vec3f`, `mat2x2h`
        let last = word.chars().next_back()?;
        let element = match last {
            'f' => single,
            'h' => Other,
            'i' | 'u' => Whole { bits: 32, signed: last == 'i' },
            _ => return None,
        };
        let size = word.strip_suffix(last)?;
        let size = size.strip_prefix("vec").or_else(|| size.strip_prefix("mat"))?;
        return count(size, false).filter(|_| !size.is_empty()).map(|n| (element, n));
    }
    if !language.is_native() {
        return None;
    }
    let integers = |signed| Whole { bits: 32, signed };
    let shader = language == Language::Shader;
    let begins = [
        ("float", single),
        ("double", double),
        ("int", integers(true)),
        ("uint", integers(false)),
        ("half", Other),
        ("f16vec", Other),
        ("dvec", double),
        ("dmat", double),
        ("ivec", integers(true)),
        ("uvec", integers(false)),
        ("bvec", Other),
        // Elsewhere than in a shader these are names of the program's own.
        ("vec", single),
        ("mat", single),
    ];
    let (begin, rest, element) = begins
        .iter()
        .find_map(|(begin, element)| Some((*begin, word.strip_prefix(begin)?, *element)))?;
    if !shader && matches!(begin, "vec" | "mat") {
        return None;
    }
    let composed = begin.ends_with("vec") || begin.ends_with("mat");
    count(rest, begin.ends_with("mat"))
        .filter(|_| !composed || !rest.is_empty())
        .map(|n| (element, n))
}

/// How many numbers a size has: 1, `3`, `3x4`; `3` of a matrix is `3x3`.
pub(super) fn count(rest: &str, square: bool) -> Option<usize> {
    let size =
        |text: &str| text.parse().ok().filter(|size| (2..=4).contains(size) && text.len() == 1);
    match rest.split_once('x') {
        None if rest.is_empty() => Some(1),
        None => size(rest).map(|n: usize| if square { n * n } else { n }),
        Some((rows, columns)) => Some(size(rows)? * size(columns)?),
    }
}

/// The types in the declaration of the name at `at`, whose value begins at `begin`.
pub(super) fn declared(
    source: &SourceText,
    language: Language,
    tokens: &[Token],
    at: usize,
    begin: usize,
) -> Vec<Typed> {
    let range = match language {
        _ if language.is_native() => statement(tokens, at)..at,
        // An annotation of Python converts nothing.
        Language::Python | Language::Matlab => return Vec::new(),
        _ => at + 1..begin,
    };
    let native = language.is_native();
    let mut found = Vec::new();
    // Neither sizes nor other names' values count.
    let (mut inside, mut size, mut value) = (0_usize, false, false);
    for token in &tokens[range] {
        match token.kind {
            Kind::Sign('(' | '{') => inside += 1,
            Kind::Sign(')' | '}') => inside = inside.saturating_sub(1),
            Kind::Sign('[') if native => inside += 1,
            Kind::Sign(']') if native => inside = inside.saturating_sub(1),
            // `[f32; N as usize]`
            Kind::Sign(';') => size = true,
            Kind::Sign(']') => size = false,
            Kind::Sign('=') => value = true,
            Kind::Sign(',') if inside == 0 => value = false,
            Kind::Name if inside == 0 && !size && !value => {
                let word = &source.text[token.span.clone()];
                found.extend(element(word, language).map(|(kind, _)| (kind, token.span.clone())));
            }
            _ => {}
        }
    }
    found
}

/// Where the declaration of the name at `at` begins: behind a semicolon, a brace, a colon, a bracket that is open, or a line
/// for the preprocessor.
pub(super) fn statement(tokens: &[Token], at: usize) -> usize {
    let sign = |at: usize| tokens.get(at).map(|token| token.kind);
    let mut depth = 0_usize;
    let mut start = at;
    let mut comma = None;
    while let Some(before) = start.checked_sub(1) {
        match tokens[before].kind {
            Kind::Directive => break,
            Kind::Sign('}') if depth == 0 && sign(start) != Some(Kind::Sign(',')) => break,
            Kind::Sign(')' | ']' | '}' | '>') => depth += 1,
            // A parameter has its own type.
            Kind::Sign('(') if depth == 0 => {
                let typed =
                    |&comma: &usize| tokens[comma..at].iter().any(|token| token.kind == Kind::Name);
                return comma.filter(typed).unwrap_or(start);
            }
            Kind::Sign(';' | '{' | '[') if depth == 0 => break,
            Kind::Sign(':')
                if depth == 0
                    && ![before.checked_sub(1), Some(start)]
                        .iter()
                        .flatten()
                        .any(|&at| sign(at) == Some(Kind::Sign(':'))) =>
            {
                break;
            }
            Kind::Sign('(' | '[' | '{' | '<') => depth = depth.saturating_sub(1),
            Kind::Sign(',') if depth == 0 => comma = comma.or(Some(start)),
            _ => {}
        }
        start = before;
    }
    start
}

/// The type of the numbers that the program holds, if the source says it.
///
/// # Errors
/// When there are two types, one that is not computed with, or a number that a table of integers does not hold.
pub(super) fn decide(
    source: &Arc<SourceText>,
    types: &[Typed],
    entries: &[Entry],
    directives: &[Token],
) -> Result<Option<(Precision, Range<usize>)>, Diagnostic> {
    let help = "type the numbers that the program holds into the claim file, as `cells`";
    let word = |span: &Range<usize>| &source.text[span.clone()];
    let wrong = |span: &Range<usize>, message| {
        Err(Diagnostic::new(source, span.clone(), message).with_help(help))
    };
    for (_, span) in types {
        let again = |token| {
            let words = words(source, token);
            words.first() == Some(&"define") && words.get(1) == Some(&word(span))
        };
        if directives.iter().any(again) {
            return wrong(span, format!("`{}` is a macro in this file", word(span)));
        }
    }
    if let Some((_, span)) = types.iter().find(|(kind, _)| *kind == Element::Other) {
        return wrong(span, format!("`{}` is no type of numbers with 32 or 64 bits", word(span)));
    }
    let Some(((mut first, span), others)) =
        types.split_first().map(|(first, rest)| (first.clone(), rest))
    else {
        return Ok(None);
    };
    for (other, place) in others {
        first = match (first, *other) {
            (Element::Whole { bits, signed }, Element::Whole { bits: b, signed: s }) => {
                Element::Whole { bits: bits.min(b), signed: signed && s }
            }
            (Element::Deduced, other) | (other, Element::Deduced) => other,
            (first, other) if first == other => first,
            _ => {
                let [one, two] = [word(&span), word(place)];
                return wrong(
                    place,
                    format!("the numbers pass through `{one}` and `{two}`, which is not computed"),
                );
            }
        };
    }
    match first {
        Element::Float(precision) => Ok(Some((precision, span))),
        Element::Deduced | Element::Other => {
            let alike = |entry: &Entry| {
                entry.held(Precision::Single).to_bits() == entry.held(Precision::Double).to_bits()
            };
            Ok((!entries.iter().all(alike)).then_some((Precision::Double, span)))
        }
        Element::Whole { bits, signed } => {
            let limit = Rational::from(Integer::from(2_i64).pow(bits - u32::from(signed)));
            for entry in entries {
                let value = entry.expression.exact().filter(|value| {
                    let least =
                        if signed { -limit.clone() } else { Rational::from(Integer::zero()) };
                    value.is_integer() && *value >= least && *value < limit
                });
                if value.is_none() || value != exact(entry.held(Precision::Double)) {
                    let message = format!(
                        "`{}`, the type of the table, does not hold this number",
                        word(&span)
                    );
                    return wrong(&entry.span, message);
                }
            }
            Ok(None)
        }
    }
}
