//! One number of a table as its source has it: a literal, or an expression of literals.

use super::held::{Kind, Target};
use super::language::Language;
use super::number::{Literal, Written, literal};
use super::rounding::Type;
use crate::numbers::Q;
use crate::text::{Checked, Cursor, Reason, Stop, Text};

/// The most characters.
const MAX_LENGTH: usize = 2_000;

/// The languages with `(float)x` and `double(x)`.
const NATIVE: [Language; 3] = [Language::C, Language::Shader, Language::Hlsl];

/// How deep signs and brackets may be nested.
const MAX_NESTING: usize = 64;

/// A number of a table.
#[derive(Clone, Debug)]
pub struct Shipped {
    /// What is written, if it is one decimal literal, perhaps with signs and conversions.
    pub written: Option<Written>,
    /// The number that the program holds. `None` if it is not finite.
    pub held: Option<Q>,
}

/// What is wrong with a text: it is no number, or what it does is not known.
enum Wrong {
    Text(&'static str),
    Stop(Stop),
}

impl From<&'static str> for Wrong {
    fn from(what: &'static str) -> Wrong {
        Wrong::Text(what)
    }
}

/// Reads the text of a number in a table of this type.
pub fn read(text: &str, language: Language, target: Target) -> Checked<Shipped> {
    let read = |wide: bool| read_as(text, language, wide, target);
    let shipped = read(false)?;
    if language.may_widen() && matches!(target, Type::Binary(_)) && read(true)?.held != shipped.held
    {
        return Err(Stop::Capped(
            "a number that depends on whether a compiler rounds literals to doubles",
        )
        .into());
    }
    Ok(shipped)
}

/// As [`read`]; `wide` where the compiler rounds literals to doubles first.
fn read_as(text: &str, language: Language, wide: bool, target: Target) -> Checked<Shipped> {
    let mut parser = Parser { text: Cursor::new(text), language, wide, target, depth: 0 };
    let read = if text.chars().count() > MAX_LENGTH {
        Err("a text that is not too long".into())
    } else {
        parser.text.space();
        parser.sum().and_then(|value| match parser.text.peek() {
            None => Ok(value),
            Some(_) => Err("an operator or the end".into()),
        })
    };
    let (written, held) = read.map_err(|wrong| match wrong {
        Wrong::Text(what) => Reason::NoLiteral(Text(text.to_owned()), what),
        Wrong::Stop(stop) => Reason::Stopped(stop),
    })?;
    Ok(Shipped { written, held: held.stored(target) })
}

struct Parser {
    text: Cursor,
    language: Language,
    /// Whether literals are rounded to doubles first.
    wide: bool,
    target: Target,
    depth: usize,
}

type Parsed = Result<Literal, Wrong>;

impl Parser {
    fn sum(&mut self) -> Parsed {
        self.chain(['+', '-'], |parser| parser.chain(['*', '/'], Self::factor))
    }

    fn chain(&mut self, signs: [char; 2], part: impl Fn(&mut Self) -> Parsed) -> Parsed {
        let mut left = part(self)?;
        while let Some(sign) = self.text.peek().filter(|sign| signs.contains(sign)) {
            self.text.next();
            if matches!(self.text.peek(), Some('*' | '/')) {
                return Err("a number: `**`, `//` and comments are not read".into());
            }
            self.text.space();
            let (_, right) = part(self)?;
            let held = left.1.operate(sign, right, self.language).map_err(Wrong::Stop)?;
            left = (None, held);
        }
        Ok(left)
    }

    fn nested(&mut self, part: impl Fn(&mut Self) -> Parsed) -> Parsed {
        if self.depth == MAX_NESTING {
            return Err("less nesting".into());
        }
        self.depth += 1;
        let parsed = part(self);
        self.depth -= 1;
        parsed
    }

    fn factor(&mut self) -> Parsed {
        if self.text.token("-") {
            let (written, held) = self.nested(Self::factor)?;
            let held = held.negated().map_err(Wrong::Stop)?;
            let written = written.map(|w| Written { value: -w.value, ..w });
            let written = written.filter(|w| !held.is_integer_other_than(&w.value));
            return Ok((written, held));
        }
        if self.text.token("+") {
            return self.nested(Self::factor);
        }
        if self.text.token("(") {
            // `(float)x`
            let start = self.text.at();
            let converts = NATIVE.contains(&self.language);
            let kind = if converts { self.conversion() } else { None };
            if let Some(kind) = kind {
                if self.text.token(")") {
                    return self.cast(kind, Self::factor);
                }
                self.text.back(start);
            }
            return self.bracket();
        }
        if let Some(kind) = self.conversion() {
            if !self.text.token("(") {
                return Err("`(`".into());
            }
            return self.cast(kind, Self::bracket);
        }
        self.number()
    }

    fn cast(&mut self, kind: Kind, part: fn(&mut Self) -> Parsed) -> Parsed {
        let (written, held) = self.nested(part)?;
        Ok((written, held.cast(kind, self.target)))
    }

    /// What follows an opening bracket.
    fn bracket(&mut self) -> Parsed {
        let inner = self.nested(Self::sum)?;
        if self.text.token(")") { Ok(inner) } else { Err("an operator or `)`".into()) }
    }

    /// The type that a number is converted to.
    fn conversion(&mut self) -> Option<Kind> {
        let start = self.text.at();
        let name = self.text.take(|c| c.is_alphanumeric() || c == '_');
        let kind = match (&name[..], self.language) {
            ("float", Language::Python) | ("double", Language::Matlab) => Some(Kind::Double),
            ("f32", Language::Wgsl) | ("single", Language::Matlab) => Some(Kind::Single),
            ("double", language) if NATIVE.contains(&language) => Some(Kind::Double),
            ("float", language) if NATIVE.contains(&language) => Some(Kind::Single),
            _ => None,
        };
        if kind.is_some() {
            self.text.space();
        } else {
            self.text.back(start);
        }
        kind
    }

    fn number(&mut self) -> Parsed {
        let start = self.text.at();
        let word = |c: char| c.is_ascii_alphanumeric() || matches!(c, '.' | '_' | '\'');
        let mut text = self.text.take(word);
        // The sign of an exponent.
        let hexadecimal = text.starts_with("0x") || text.starts_with("0X");
        let marks: &[char] = match self.language {
            _ if hexadecimal => &['p', 'P'],
            Language::Matlab => &['e', 'E', 'd', 'D'],
            _ => &['e', 'E'],
        };
        if text.starts_with(|c: char| c.is_ascii_digit() || c == '.')
            && text.ends_with(marks)
            && let Some(sign) = self.text.peek().filter(|c| matches!(c, '+' | '-'))
        {
            self.text.next();
            text = format!("{text}{sign}{}", self.text.take(word));
        }
        let read = literal(&text, self.language, self.wide, self.target);
        if read.is_err() {
            self.text.back(start);
        }
        self.text.space();
        let read = read?;
        if read.1.depends_on_machine() {
            return Err(Wrong::Stop(Stop::Capped(
                "a long double, whose format depends on the machine",
            )));
        }
        Ok(read)
    }
}

/// Whether two texts say the same, up to blanks.
pub fn same(one: &str, other: &str) -> bool {
    one.split_whitespace().eq(other.split_whitespace())
}

impl Shipped {
    /// The number of the type that is nearest to what is written with the other sign.
    pub fn turned(&self, target: Type) -> Option<Q> {
        self.written.as_ref().and_then(|written| target.nearest(&-&written.value))
    }
}
