//! Formulas: from text to tree.

use crate::decimal::{Decimal, Q};

/// The longest formula of a claim file, in characters.
pub const MAX_LENGTH: usize = 4_096;

/// How deep parentheses, signs, powers and brackets may be nested.
const MAX_NESTING: usize = 64;

/// A formula.
#[derive(Clone, Debug)]
pub enum Expr {
    /// A number.
    Number(Q),
    /// A name.
    Name(String),
    /// A member of a family: `q[2*i-1]`.
    Member(String, Vec<Expr>),
    /// −x.
    Minus(Box<Expr>),
    /// Operators of one precedence, from left to right.
    Chain(Box<Expr>, Vec<(char, Expr)>),
    /// base^exponent.
    Power(Box<Expr>, Box<Expr>),
    /// A function with its arguments and options.
    Call(String, Vec<Expr>, Vec<(String, String)>),
    /// `sum`, `max` or `min` over an index from … to … of a body.
    Over(String, String, Box<[Expr; 3]>),
}

/// Reads a formula of at most `longest` characters.
pub fn parse(text: &str, longest: usize) -> Result<Expr, String> {
    let characters: Vec<char> = text.chars().collect();
    if characters.len() > longest {
        return Err(format!("a formula of more than {longest} characters"));
    }
    let mut parser = Parser { text: &characters, at: 0, depth: 0 };
    parser.space();
    let parsed = parser.sum().and_then(|expr| match parser.peek() {
        None => Ok(expr),
        Some(_) => Err("an operator or the end"),
    });
    parsed.map_err(|expected| {
        format!("expected {expected} at character {} of `{text}`", parser.at + 1)
    })
}

type Parsed<T> = Result<T, &'static str>;

struct Parser<'a> {
    text: &'a [char],
    at: usize,
    depth: usize,
}

fn starts_name(c: char) -> bool {
    c.is_alphabetic() || c == '_'
}

fn continues_name(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// Whether this can be the name of a parameter.
pub fn is_name(text: &str) -> bool {
    text.chars().next().is_some_and(starts_name) && text.chars().all(continues_name)
}

impl Parser<'_> {
    fn peek(&self) -> Option<char> {
        self.text.get(self.at).copied()
    }

    fn space(&mut self) {
        while self.peek().is_some_and(char::is_whitespace) {
            self.at += 1;
        }
    }

    /// Takes one of these characters, and the blanks behind it.
    fn one_of(&mut self, choice: &[char]) -> Option<char> {
        let c = self.peek().filter(|c| choice.contains(c))?;
        self.at += 1;
        self.space();
        Some(c)
    }

    fn expect(&mut self, c: char, expected: &'static str) -> Parsed<()> {
        self.one_of(&[c]).map(|_| ()).ok_or(expected)
    }

    fn take(&mut self, fits: impl Fn(char) -> bool) -> String {
        let start = self.at;
        while self.peek().is_some_and(&fits) {
            self.at += 1;
        }
        self.text[start..self.at].iter().collect()
    }

    fn nested<T>(&mut self, parse: impl Fn(&mut Self) -> Parsed<T>) -> Parsed<T> {
        if self.depth == MAX_NESTING {
            return Err("less nesting");
        }
        self.depth += 1;
        let parsed = parse(self);
        self.depth -= 1;
        parsed
    }

    fn chain(
        &mut self,
        operators: &[char],
        operand: impl Fn(&mut Self) -> Parsed<Expr>,
    ) -> Parsed<Expr> {
        let first = operand(self)?;
        let mut rest = Vec::new();
        while let Some(operator) = self.one_of(operators) {
            let operator = match operator {
                '\u{2212}' => '-',
                '·' => '*',
                other => other,
            };
            rest.push((operator, operand(self)?));
        }
        Ok(if rest.is_empty() { first } else { Expr::Chain(Box::new(first), rest) })
    }

    fn sum(&mut self) -> Parsed<Expr> {
        self.chain(&['+', '-', '\u{2212}'], |parser| parser.chain(&['*', '/', '·'], Self::factor))
    }

    /// `-x^2` is `-(x^2)`, and `x^-2` is `x^(-2)`.
    fn factor(&mut self) -> Parsed<Expr> {
        if self.one_of(&['-', '\u{2212}']).is_some() {
            return Ok(Expr::Minus(Box::new(self.nested(Self::factor)?)));
        }
        let base = self.primary()?;
        if self.one_of(&['^']).is_none() {
            return Ok(base);
        }
        let exponent = self.nested(Self::factor)?;
        Ok(Expr::Power(Box::new(base), Box::new(exponent)))
    }

    fn primary(&mut self) -> Parsed<Expr> {
        if self.one_of(&['(']).is_some() {
            let inner = self.nested(Self::sum)?;
            self.expect(')', "an operator or `)`")?;
            return Ok(inner);
        }
        match self.peek() {
            Some(c) if c.is_ascii_digit() => self.number(),
            Some(c) if starts_name(c) => self.name_or_call(),
            _ => Err("a number, a name or `(`"),
        }
    }

    fn number(&mut self) -> Parsed<Expr> {
        let mut text = self.take(|c| c.is_ascii_digit());
        // `1..3` is a range.
        if self.peek() == Some('.') && self.text.get(self.at + 1) != Some(&'.') {
            self.at += 1;
            text = format!("{text}.{}", self.take(|c| c.is_ascii_digit()));
        }
        if matches!(self.peek(), Some('e' | 'E')) {
            self.at += 1;
            let sign = self.peek().filter(|c| matches!(c, '+' | '-'));
            self.at += usize::from(sign.is_some());
            let sign = if sign == Some('-') { "-" } else { "" };
            text = format!("{text}e{sign}{}", self.take(|c| c.is_ascii_digit()));
        }
        let decimal = Decimal::read(&text).ok_or("a number")?;
        self.space();
        Ok(Expr::Number(decimal.value()))
    }

    fn list(&mut self) -> Parsed<Vec<Expr>> {
        let mut list = vec![self.sum()?];
        while self.one_of(&[',']).is_some() {
            list.push(self.sum()?);
        }
        Ok(list)
    }

    fn name_or_call(&mut self) -> Parsed<Expr> {
        let name = self.take(continues_name);
        self.space();
        if self.one_of(&['[']).is_some() {
            let indices = self.nested(Self::list)?;
            self.expect(']', "`,` or `]`")?;
            return Ok(Expr::Member(name, indices));
        }
        if self.one_of(&['(']).is_none() {
            return Ok(Expr::Name(name));
        }
        let expr = match name.as_str() {
            "sum" | "max" | "min" if name == "sum" || self.assignment().is_some() => {
                self.nested(|parser| parser.over(&name))?
            }
            _ => self.nested(|parser| parser.call(&name))?,
        };
        self.expect(')', "`,` or `)`")?;
        Ok(expr)
    }

    /// The name and the place behind `name =`, if that stands here; takes nothing.
    fn assignment(&mut self) -> Option<(String, usize)> {
        let start = self.at;
        let name = self.take(continues_name);
        self.space();
        let found = is_name(&name) && self.one_of(&['=']).is_some();
        let end = std::mem::replace(&mut self.at, start);
        found.then_some((name, end))
    }

    fn over(&mut self, fold: &str) -> Parsed<Expr> {
        let (index, end) = self.assignment().ok_or("an index, as in sum(h = 1..m, …)")?;
        self.at = end;
        let from = self.sum()?;
        if self.text.get(self.at..self.at + 2) != Some(&['.', '.']) {
            return Err("`..` and the last index");
        }
        self.at += 2;
        self.space();
        let to = self.sum()?;
        self.expect(',', "`,` and what is summed or compared")?;
        let body = self.sum()?;
        Ok(Expr::Over(fold.to_owned(), index, Box::new([from, to, body])))
    }

    fn call(&mut self, name: &str) -> Parsed<Expr> {
        let (mut arguments, mut options) = (Vec::new(), Vec::new());
        while self.peek() != Some(')') {
            if let Some((option, end)) = self.assignment() {
                self.at = end;
                let word = self.take(|c| continues_name(c) || c == '-');
                if word.is_empty() {
                    return Err("a word such as `forward`");
                }
                self.space();
                options.push((option, word));
            } else if options.is_empty() {
                arguments.push(self.sum()?);
            } else {
                return Err("a choice such as `order = forward`");
            }
            if self.one_of(&[',']).is_none() {
                break;
            }
            if self.peek() == Some(')') {
                return Err("an argument");
            }
        }
        Ok(Expr::Call(name.to_owned(), arguments, options))
    }
}
