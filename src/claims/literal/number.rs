//! One literal: its digits and its suffix.

use super::language::{Language, Precision};
use super::whole::{Whole, Width};
use crate::exact::{Integer, Rational};

/// What a literal is in its language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Type {
    /// An integer of this type.
    Integer(Width),
    /// A number of this precision.
    Float(Precision),
    /// A number of the precision of the table.
    Table,
    /// A `long double`.
    Long,
    /// A number that a compiler may round to a double first: a float then, or a literal that becomes what is needed.
    Either { typed: bool },
}

/// A literal.
#[derive(Clone, Debug)]
pub(super) struct Number {
    pub(super) value: Rational,
    pub(super) kind: Type,
    /// How many significant digits it has; `None` of one in hexadecimal.
    pub(super) digits: Option<usize>,
    /// How many digits stand after the point, with the exponent applied, so that it may be negative; `None` of one in hexadecimal.
    pub(super) places: Option<i64>,
}

/// The most digits of a literal, and the greatest exponent.
const MAX_DIGITS: usize = 2_000;
const MAX_EXPONENT: u32 = 5_000;

/// Reads a literal. The error says what is wrong with it.
pub(super) fn number(text: &str, language: Language) -> Result<Number, String> {
    if text.len() > MAX_DIGITS {
        return Err(format!("a literal of more than {MAX_DIGITS} characters"));
    }
    if !separators_are_right(text, language) {
        return Err("a separator of digits stands where the language has none".to_owned());
    }
    let plain: String = text.chars().filter(|&c| Some(c) != language.separator()).collect();
    let mut lower = plain.to_ascii_lowercase();
    if language == Language::Matlab {
        // `1d-3`
        lower = lower.replace('d', "e");
    }
    let (body, base) = match lower.strip_prefix("0x") {
        Some(body) => (body, 16),
        None => (lower.as_str(), 10),
    };
    let parts = Parts::read(body, base).ok_or_else(|| "this is no number".to_owned())?;
    if base == 16 && language == Language::Matlab {
        return Err("a number in hexadecimal has a type of integers here".to_owned());
    }
    if base == 16 && language != Language::C && (parts.has_point || parts.has_exponent) {
        return Err("in hexadecimal, the language has integers only".to_owned());
    }
    let suffix = &plain[plain.len() - parts.suffix.len()..];
    let mixed = match language {
        Language::C => suffix.contains("lL") || suffix.contains("Ll"),
        Language::Shader => suffix == "lF" || suffix == "Lf",
        Language::Hlsl | Language::Matlab => false,
        // The prefix of hexadecimal too.
        _ => suffix != parts.suffix || language == Language::Rust && plain.starts_with("0X"),
    };
    if mixed {
        return Err(format!("`{suffix}` is not written so in the language"));
    }
    if base == 16 && parts.has_point && !parts.has_exponent {
        return Err(
            "a number in hexadecimal with a point needs an exponent, as in 0x1.8p0".to_owned()
        );
    }
    let whole = !parts.has_point && !parts.has_exponent;
    if whole && base == 10 && parts.digits.len() > 1 && parts.digits.starts_with('0') {
        return Err("an integer with a leading 0, which some languages read in octal".to_owned());
    }
    let value = parts.value(base)?;
    let kind = if let Some(kind) = kind(parts.suffix, whole, language)? {
        kind
    } else {
        let whole = Whole::literal(value.numerator(), parts.suffix, base == 10, language)?;
        Type::Integer(whole.width)
    };
    Ok(Number {
        value,
        kind,
        digits: (base == 10).then(|| parts.significant()),
        places: parts.places().filter(|_| base == 10),
    })
}

/// Whether each separator stands where the language allows it: between two digits; in Python also after `0x`; in Rust
/// anywhere behind the first digit or `0x`, but not right after the point.
fn separators_are_right(text: &str, language: Language) -> bool {
    let Some(separator) = language.separator() else { return true };
    let bytes = text.as_bytes();
    let hexadecimal = text.starts_with("0x") || text.starts_with("0X");
    let power = text.find(['p', 'P']).filter(|_| hexadecimal).unwrap_or(text.len());
    let base = |at: usize| if hexadecimal && at < power { 16 } else { 10 };
    let digit = |at: Option<usize>| {
        let Some(at) = at else { return false };
        // The x of 0x is no digit.
        bytes.get(at).is_some_and(|&byte| char::from(byte).is_digit(base(at)))
    };
    text.match_indices(separator).all(|(at, _)| match language {
        Language::Rust => at > 0 && bytes[at - 1] != b'.',
        Language::Python if hexadecimal && at == 2 => digit(Some(3)),
        _ => digit(at.checked_sub(1)) && digit(at.checked_add(1)),
    })
}

/// The type that a suffix gives; `None` of an integer. In JavaScript, all numbers are doubles.
fn kind(suffix: &str, whole: bool, language: Language) -> Result<Option<Type>, String> {
    use Language::{C, Hlsl, JavaScript, Matlab, Python, Rust, Shader, Wgsl};
    let single = Ok(Some(Type::Float(Precision::Single)));
    let double = Ok(Some(Type::Float(Precision::Double)));
    match (suffix, language) {
        ("", Rust) => Ok(Some(Type::Table)),
        ("", JavaScript | Matlab) => double,
        ("", _) if whole => Ok(None),
        ("", Shader) | ("f32", Rust) => single,
        ("f", C | Shader | Hlsl) if !whole || language != C => single,
        ("", C | Python) | ("lf", Shader) | ("f64", Rust) => double,
        ("l", Hlsl) if !whole => double,
        ("" | "f", Hlsl | Wgsl) => Ok(Some(Type::Either { typed: suffix == "f" })),
        ("l", C) if !whole => Ok(Some(Type::Long)),
        ("u" | "l" | "ul" | "lu" | "ll" | "ull" | "llu", C) | ("u", Shader | Hlsl) if whole => {
            Ok(None)
        }
        _ => Err(format!("the suffix `{suffix}` is not one of numbers here")),
    }
}

/// A literal in parts, in lower case.
struct Parts<'a> {
    /// The digits on both sides of the point.
    digits: String,
    /// How many of them stand after the point.
    after: usize,
    exponent: i64,
    has_point: bool,
    has_exponent: bool,
    suffix: &'a str,
}

impl Parts<'_> {
    fn read(body: &str, base: u32) -> Option<Parts<'_>> {
        let run =
            |text: &str, base: u32| text.find(|c: char| !c.is_digit(base)).unwrap_or(text.len());
        let whole = run(body, base);
        let mut digits = body[..whole].to_owned();
        let (mut rest, mut after) = (&body[whole..], 0);
        let has_point = rest.starts_with('.');
        if has_point {
            after = run(&rest[1..], base);
            digits.push_str(&rest[1..=after]);
            rest = &rest[after + 1..];
        }
        if digits.is_empty() {
            return None;
        }
        let mark = if base == 16 { 'p' } else { 'e' };
        let (mut exponent, has_exponent) = (0, rest.starts_with(mark));
        if has_exponent {
            let signed = &rest[1..];
            let sign = usize::from(signed.starts_with(['+', '-']));
            let length = sign + run(&signed[sign..], 10);
            exponent = signed[..length].parse().ok()?;
            rest = &signed[length..];
        }
        let suffix = rest;
        Some(Parts { digits, after, exponent, has_point, has_exponent, suffix })
    }

    fn value(&self, base: u32) -> Result<Rational, String> {
        let too_large = || format!("an exponent beyond {MAX_EXPONENT}");
        let after = i64::try_from(self.after).map_err(|_| too_large())?;
        let per_digit = if base == 16 { 4 } else { 1 };
        if self.exponent.unsigned_abs() > u64::from(MAX_EXPONENT) {
            return Err(too_large());
        }
        let exponent = self.exponent - after * per_digit;
        let size = u32::try_from(exponent.unsigned_abs()).map_err(|_| too_large())?;
        let radix = Integer::from(if base == 16 { 2_i64 } else { 10 });
        let power = Rational::from(radix.pow(size));
        let mantissa = if base == 16 {
            let digit = |c: char| Integer::from(i64::from(c.to_digit(16).unwrap_or(0)));
            let sixteen = Integer::from(16_i64);
            self.digits.chars().fold(Integer::zero(), |sum, c| &sum * &sixteen + digit(c))
        } else {
            Integer::from_digits(&self.digits).unwrap_or_else(Integer::zero)
        };
        let mantissa = Rational::from(mantissa);
        Ok(if exponent < 0 { mantissa / power } else { mantissa * power })
    }

    /// Digits after the point, with the exponent applied.
    fn places(&self) -> Option<i64> {
        i64::try_from(self.after).ok()?.checked_sub(self.exponent)
    }

    /// Digits from the first that is not 0.
    fn significant(&self) -> usize {
        self.digits.trim_start_matches('0').len()
    }
}
