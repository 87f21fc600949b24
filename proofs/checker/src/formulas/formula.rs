//! The parser of formulas.

use crate::numbers::{Decimal, Q, Value, is_fraction, read_rational};
use crate::text::{Cursor, Parsed};

/// The longest formula of a claim file, in characters.
pub const MAX_LENGTH: usize = 4_096;

/// How deep parentheses, signs, powers and brackets may be nested.
const MAX_NESTING: usize = 64;

/// A formula.
#[derive(Clone, Debug)]
pub enum Expr {
    /// A number.
    Number(Value),
    /// A name.
    Name(String),
    /// An operation on the values of other formulas.
    Of(Head, Vec<Expr>),
}

/// An operation on values.
#[derive(Clone, Debug)]
pub enum Head {
    /// A member of a family: `q[2*i-1]`.
    Member(String),
    /// −x.
    Minus,
    /// Operators of one precedence that stand between the values, from left to right.
    Chain(Vec<char>),
    /// base^exponent.
    Power,
    /// A function, with its options.
    Call(String, Vec<(String, String)>),
    /// `sum`, `product`, `max` or `min` over an index. The values are the first and last index and the body.
    Over(String, String),
}

impl Expr {
    /// The formula and all of its parts.
    pub fn nodes(&self) -> Vec<&Expr> {
        let mut nodes = vec![self];
        if let Expr::Of(_, parts) = self {
            nodes.extend(parts.iter().flat_map(Expr::nodes));
        }
        nodes
    }
}

/// The parts of `a - b - 4`, or of `a`: the first is a name, the others are names or whole numbers.
pub fn differences(expr: &Expr) -> Option<Vec<String>> {
    match expr {
        Expr::Name(name) => Some(vec![name.clone()]),
        Expr::Of(Head::Chain(operators), parts) if operators.iter().all(|sign| *sign == '-') => {
            let mut names = Vec::with_capacity(parts.len());
            for part in parts {
                let whole = |value: &Value| value.rational().filter(Q::is_integer);
                names.push(match part {
                    Expr::Name(name) => name.clone(),
                    Expr::Number(value) if !names.is_empty() => whole(value)?.to_string(),
                    _ => return None,
                });
            }
            Some(names)
        }
        _ => None,
    }
}

/// Reads a formula of at most `longest` characters.
pub fn parse(text: &str, longest: usize) -> Result<Expr, String> {
    if text.chars().count() > longest {
        return Err(format!("a formula of more than {longest} characters"));
    }
    let mut parser = Parser { text: Cursor::new(text), depth: 0 };
    parser.text.space();
    let parsed = parser.sum().and_then(|expr| match parser.text.peek() {
        None => Ok(expr),
        Some(_) => Err("an operator or the end"),
    });
    parsed.map_err(|what| format!("{} of `{text}`", parser.text.expected(what)))
}

struct Parser {
    text: Cursor,
    depth: usize,
}

fn starts_name(c: char) -> bool {
    c.is_alphabetic() || c == '_'
}

fn continues_name(c: char) -> bool {
    (c.is_alphanumeric() || c == '_') && !is_fraction(c)
}

/// Whether this can be the name of a parameter.
pub fn is_name(text: &str) -> bool {
    text.starts_with(starts_name) && text.chars().all(continues_name)
}

/// The number that the word of an option is: an integer, a decimal or a fraction of integers.
pub fn number_of(word: &str) -> Option<Q> {
    let plain = word.bytes().all(|b| b.is_ascii_digit() || b"-./".contains(&b));
    plain.then(|| read_rational(word)).flatten()
}

impl Parser {
    fn expect(&mut self, token: &str, expected: &'static str) -> Parsed<()> {
        if self.text.token(token) { Ok(()) } else { Err(expected) }
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
        operators: &[(&str, char)],
        operand: impl Fn(&mut Self) -> Parsed<Expr>,
    ) -> Parsed<Expr> {
        let (mut found, mut operands) = (Vec::new(), vec![operand(self)?]);
        while let Some((_, operator)) = operators.iter().find(|(token, _)| self.text.token(token)) {
            found.push(*operator);
            operands.push(operand(self)?);
        }
        Ok(match operands.pop() {
            Some(only) if found.is_empty() => only,
            last => {
                operands.extend(last);
                Expr::Of(Head::Chain(found), operands)
            }
        })
    }

    fn sum(&mut self) -> Parsed<Expr> {
        const SUM: [(&str, char); 3] = [("+", '+'), ("-", '-'), ("\u{2212}", '-')];
        const PRODUCT: [(&str, char); 6] =
            [("*", '*'), ("/", '/'), ("·", '*'), ("×", '*'), ("\u{2044}", '/'), ("\u{2215}", '/')];
        self.chain(&SUM, |parser| parser.chain(&PRODUCT, Self::factor))
    }

    /// `-x^2` is `-(x^2)`, and `x^-2` is `x^(-2)`.
    fn factor(&mut self) -> Parsed<Expr> {
        if self.text.token("+") {
            return self.nested(Self::factor);
        }
        if ["-", "\u{2212}", "\u{2013}"].iter().any(|minus| self.text.token(minus)) {
            return Ok(Expr::Of(Head::Minus, vec![self.nested(Self::factor)?]));
        }
        let base = self.primary()?;
        if !self.text.token("^") {
            return Ok(base);
        }
        Ok(Expr::Of(Head::Power, vec![base, self.nested(Self::factor)?]))
    }

    fn primary(&mut self) -> Parsed<Expr> {
        if self.text.token("(") {
            let inner = self.nested(Self::sum)?;
            self.expect(")", "an operator or `)`")?;
            return Ok(inner);
        }
        match self.text.peek() {
            Some(c) if c.is_ascii_digit() || c == '.' || is_fraction(c) => self.number(),
            Some(c) if starts_name(c) => self.name_or_call(),
            Some(_) if self.text.token("√") => {
                let of = self.nested(Self::primary)?;
                Ok(Expr::Of(Head::Call("sqrt".to_owned(), Vec::new()), vec![of]))
            }
            _ => Err("a number, a name or `(`"),
        }
    }

    fn number(&mut self) -> Parsed<Expr> {
        let digits = |c: char| c.is_ascii_digit();
        let mut text = self.text.take(digits);
        if self.text.peek().is_some_and(is_fraction) {
            text.extend(self.text.next());
            let value = read_rational(&text).ok_or("a number")?;
            self.text.space();
            return Ok(Expr::Number(value.into()));
        }
        // `1..3` is a range.
        if !self.text.is_at("..") && self.text.eat(".") {
            text = format!("{text}.{}", self.text.take(digits));
        }
        if self.text.eat("e") || self.text.eat("E") {
            let sign = if self.text.eat("-") { "-" } else { "" };
            if sign.is_empty() {
                self.text.eat("+");
            }
            text = format!("{text}e{sign}{}", self.text.take(digits));
        }
        let decimal = Decimal::read(&text).ok_or("a number")?;
        self.text.space();
        Ok(Expr::Number(decimal.value.into()))
    }

    fn list(&mut self) -> Parsed<Vec<Expr>> {
        let mut list = vec![self.sum()?];
        while self.text.token(",") {
            list.push(self.sum()?);
        }
        Ok(list)
    }

    fn name_or_call(&mut self) -> Parsed<Expr> {
        let name = self.text.take(continues_name);
        self.text.space();
        if self.text.token("[") {
            let indices = self.nested(Self::list)?;
            self.expect("]", "`,` or `]`")?;
            return Ok(Expr::Of(Head::Member(name), indices));
        }
        if !self.text.token("(") {
            return Ok(Expr::Name(if name == "π" { "pi".to_owned() } else { name }));
        }
        let fold = ["sum", "product", "max", "min"].contains(&name.as_str());
        let index = if fold { self.assigned() } else { None };
        let expr = match index {
            Some(index) => self.nested(|parser| parser.over(&name, &index))?,
            None if name == "sum" => return Err("an index, as in sum(h = 1..m, …)"),
            None if name == "product" => return Err("an index, as in product(h = 1..m, …)"),
            None if name == "root" => self.nested(Self::root)?,
            None => self.nested(|parser| parser.call(&name))?,
        };
        self.expect(")", "`,` or `)`")?;
        Ok(expr)
    }

    /// Takes `name =` if it stands here.
    fn assigned(&mut self) -> Option<String> {
        let start = self.text.at();
        let name = self.text.take(continues_name);
        self.text.space();
        let found = is_name(&name) && self.text.token("=");
        if !found {
            self.text.back(start);
        }
        found.then_some(name)
    }

    fn over(&mut self, fold: &str, index: &str) -> Parsed<Expr> {
        let from = self.sum()?;
        self.expect("..", "`..` and the last index")?;
        let to = self.sum()?;
        self.expect(",", "`,` and what is summed or compared")?;
        let body = self.sum()?;
        Ok(Expr::Of(Head::Over(fold.to_owned(), index.to_owned()), vec![from, to, body]))
    }

    /// `[c0, c1, …], i`: the coefficients and the number of the root become the arguments.
    fn root(&mut self) -> Parsed<Expr> {
        self.expect("[", "a list of coefficients, as in root([-3, 0, 1], 2)")?;
        let mut arguments = self.nested(Self::list)?;
        self.expect("]", "`,` or `]`")?;
        self.expect(",", "`,` and the number of the root")?;
        arguments.push(self.sum()?);
        Ok(Expr::Of(Head::Call("root".to_owned(), Vec::new()), arguments))
    }

    fn call(&mut self, name: &str) -> Parsed<Expr> {
        let (mut arguments, mut options) = (Vec::new(), Vec::new());
        while self.text.peek() != Some(')') {
            if let Some(option) = self.assigned() {
                let mut word = self.text.take(|c| continues_name(c) || c == '-');
                if word.is_empty() {
                    return Err("a word such as `forward`");
                }
                // `0.5` and `1/16`.
                word += &self.text.take(|c| c.is_ascii_digit() || matches!(c, '.' | '/'));
                self.text.space();
                options.push((option, word));
            } else if options.is_empty() {
                arguments.push(self.sum()?);
            } else {
                return Err("a choice such as `order = forward`");
            }
            if !self.text.token(",") {
                break;
            }
            if self.text.peek() == Some(')') {
                return Err("an argument");
            }
        }
        Ok(Expr::Of(Head::Call(name.to_owned(), options), arguments))
    }
}
