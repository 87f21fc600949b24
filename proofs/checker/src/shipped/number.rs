//! Literals of numbers in the languages of programs.

use super::held::{Held, Kind, Target};
use super::language::Language;
use super::rounding::ten;
use super::whole::Whole;
use crate::numbers::Q;
use num_bigint::BigInt;
use num_traits::{One, Zero};

/// The greatest absolute value of an exponent.
const MAX_EXPONENT: i64 = 5_000;

/// A decimal as it is written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Written {
    /// The value.
    pub value: Q,
    /// The number of digits from the first that is not 0.
    pub digits: usize,
    /// How many digits stand after the point, with the exponent applied.
    pub places: i64,
}

/// A literal: what is written, of a decimal, and what the program holds.
pub type Literal = (Option<Written>, Held);

/// Reads a literal without a sign. The error says what is wrong.
///
/// A compiler that rounds literals to doubles first is `wide`.
pub fn literal(
    text: &str,
    language: Language,
    wide: bool,
    target: Target,
) -> Result<Literal, &'static str> {
    let joined =
        language.joined(text).ok_or("a separator of digits where the language has none")?;
    let mixed: &[&str] = match language {
        Language::C => &["lL", "Ll"],
        Language::Shader => &["lF", "Lf"],
        _ => &[],
    };
    // In the other languages suffixes are in lower case, and in Rust prefixes.
    let rust =
        language == Language::Rust && joined.contains(['F', 'X']) && !joined.starts_with("0x");
    if rust || mixed.iter().any(|mixed| joined.contains(mixed)) {
        return Err("a letter in the other case");
    }
    let plain = joined.to_ascii_lowercase();
    match plain.strip_prefix("0x") {
        Some(_) if language == Language::Matlab => Err("an integer of a type"),
        Some(digits) => hexadecimal(digits, language, target),
        // `1d-3`
        None if language == Language::Matlab => {
            decimal(&plain.replace('d', "e"), language, false, target)
        }
        None => decimal(&plain, language, wide, target),
    }
}

/// The digits before and after a point, whether there is a point, and what follows.
fn digits(text: &str, radix: u32) -> Result<(&str, &str, bool, &str), &'static str> {
    let end = |text: &str| text.find(|c: char| !c.is_digit(radix)).unwrap_or(text.len());
    let (whole, rest) = text.split_at(end(text));
    let (fraction, rest, point) = match rest.strip_prefix('.') {
        Some(after) => {
            let (fraction, rest) = after.split_at(end(after));
            (fraction, rest, true)
        }
        None => ("", rest, false),
    };
    if whole.is_empty() && fraction.is_empty() {
        return Err("a digit is missing");
    }
    Ok((whole, fraction, point, rest))
}

/// An exponent after its mark, and what follows it.
fn exponent(text: &str, mark: char) -> Result<(Option<i64>, &str), &'static str> {
    let Some(rest) = text.strip_prefix(mark) else { return Ok((None, text)) };
    let (sign, rest) = match rest.strip_prefix('-') {
        Some(rest) => (-1, rest),
        None => (1, rest.strip_prefix('+').unwrap_or(rest)),
    };
    let (size, rest) =
        rest.split_at(rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len()));
    let size: Option<i64> = size.parse().ok().filter(|size| *size <= MAX_EXPONENT);
    Ok((Some(sign * size.ok_or("the exponent is missing or too large")?), rest))
}

fn decimal(
    text: &str,
    language: Language,
    wide: bool,
    target: Target,
) -> Result<Literal, &'static str> {
    let (whole, fraction, point, rest) = digits(text, 10)?;
    let (exponent, suffix) = exponent(rest, 'e')?;
    let is_whole = !point && exponent.is_none();
    if is_whole && whole.len() > 1 && whole.starts_with('0') {
        return Err("an integer that begins with 0");
    }
    let all = format!("{whole}{fraction}");
    let places = i64::try_from(fraction.len()).map_err(|_| "too many digits")?;
    let places = places - exponent.unwrap_or(0);
    let mantissa: BigInt = all.parse().map_err(|_| "no digits")?;
    let value = Q::from_integer(mantissa) * ten(-places);
    let kind = kind(suffix, is_whole.then_some((&value, true)), language, wide)?;
    // A float of WGSL may come from a double.
    let double = Held::new(value.clone(), Kind::Double, target);
    let held = if wide && language == Language::Wgsl && kind == Kind::Single {
        double.cast(kind, target)
    } else {
        Held::new(value.clone(), kind, target)
    };
    let digits = all.trim_start_matches('0').len();
    Ok((Some(Written { value, digits, places }), held))
}

/// A number in hexadecimal; it has no decimal digits.
fn hexadecimal(text: &str, language: Language, target: Target) -> Result<Literal, &'static str> {
    let (whole, fraction, point, rest) = digits(text, 16)?;
    let (exponent, suffix) = exponent(rest, 'p')?;
    let is_float = point || exponent.is_some();
    if is_float && (language != Language::C || exponent.is_none()) {
        return Err("a number in hexadecimal of a form that the language does not have");
    }
    let mantissa = BigInt::parse_bytes(format!("{whole}{fraction}").as_bytes(), 16);
    let places = i64::try_from(fraction.len()).map_err(|_| "too many digits")? * 4;
    let power = exponent.unwrap_or(0) - places;
    let scale = Q::from_integer(BigInt::one() << power.unsigned_abs());
    let value = Q::from_integer(mantissa.unwrap_or_else(BigInt::zero));
    let value = if power < 0 { value / scale } else { value * scale };
    let kind = kind(suffix, (!is_float).then_some((&value, false)), language, false)?;
    Ok((None, Held::new(value, kind, target)))
}

/// What a literal is by its suffix; `whole` is the value of an integer, and whether it is decimal.
/// In JavaScript, all numbers are doubles.
fn kind(
    suffix: &str,
    whole: Option<(&Q, bool)>,
    language: Language,
    wide: bool,
) -> Result<Kind, &'static str> {
    use Language::{C, Hlsl, JavaScript, Matlab, Python, Rust, Shader, Wgsl};
    let suffixes: &[&str] = match language {
        C => &["", "u", "l", "ul", "lu", "ll", "ull", "llu"],
        Shader | Hlsl => &["", "u"],
        Python | Wgsl => &[""],
        JavaScript | Rust | Matlab => &[],
    };
    if let Some((value, decimal)) = whole.filter(|_| suffixes.contains(&suffix)) {
        return Ok(Kind::Integer(Whole::of(value, suffix, decimal, language)?));
    }
    Ok(match (language, suffix) {
        (Rust, "") => Kind::Table,
        (Hlsl | Wgsl, "") if wide => Kind::Literal,
        (Hlsl, "l") if whole.is_none() => Kind::Double,
        (C | JavaScript | Python | Matlab, "") | (Rust, "f64") | (Shader, "lf") => Kind::Double,
        (C, "f") if whole.is_some() => return Err("a suffix of floating point after an integer"),
        (C, "f") | (Rust, "f32") | (Shader | Hlsl | Wgsl, "" | "f") => Kind::Single,
        (C, "l") => Kind::Long,
        _ => return Err("the language has no such suffix"),
    })
}
