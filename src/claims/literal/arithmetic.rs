//! Numbers: literals, and formulas of them.

use super::expression::Expression;
use super::language::{Language, Precision};
use super::number::number;
use super::reader::{MAX_DEPTH, MAX_OPERATIONS, Reader};
use super::token::Kind;
use crate::diagnostic::Diagnostic;

impl Reader<'_> {
    /// A number, or sums and products of numbers.
    pub(super) fn sum(&mut self, depth: usize) -> Result<Expression, Diagnostic> {
        let mut left = self.product(depth)?;
        while let Some(Kind::Sign(sign @ ('+' | '-'))) = self.peek() {
            if self.is_next_in_row() || self.ends_row() {
                break;
            }
            self.at += 1;
            left = self.operation(sign, left, |reader| reader.product(depth))?;
        }
        Ok(left)
    }

    fn product(&mut self, depth: usize) -> Result<Expression, Diagnostic> {
        let mut left = self.factor(depth)?;
        while let Some(Kind::Sign(sign @ ('*' | '/'))) = self.peek() {
            if self.ends_row() {
                break;
            }
            self.at += 1;
            left = self.operation(sign, left, |reader| reader.factor(depth))?;
        }
        Ok(left)
    }

    fn operation(
        &mut self,
        sign: char,
        left: Expression,
        right: impl FnOnce(&mut Self) -> Result<Expression, Diagnostic>,
    ) -> Result<Expression, Diagnostic> {
        self.operations += 1;
        if self.operations > MAX_OPERATIONS {
            return Err(self.wrong(format!("more than {MAX_OPERATIONS} operations in a number")));
        }
        let repeated = matches!(self.peek(), Some(Kind::Sign('*' | '/')));
        if repeated {
            return Err(self.wrong("`**` and `//` are not computed".to_owned()));
        }
        let right = right(self)?;
        Expression::operation(sign, left, right, self.language).map_err(|why| self.wrong(why))
    }

    fn factor(&mut self, depth: usize) -> Result<Expression, Diagnostic> {
        if depth > MAX_DEPTH {
            return Err(self.wrong(format!("more than {MAX_DEPTH} signs or brackets in a number")));
        }
        match self.peek() {
            Some(Kind::Sign('-')) => {
                self.at += 1;
                self.factor(depth + 1)?.minus().map_err(|why| self.wrong(why))
            }
            Some(Kind::Sign('+')) => {
                self.at += 1;
                self.factor(depth + 1)
            }
            Some(Kind::Sign('(')) => match (self.cast(self.at + 1), self.text(self.at + 2)) {
                // `(float)x`
                (Some(precision), ")") if self.language.converts()[0] => {
                    self.at += 3;
                    Ok(Expression::Cast(precision, Box::new(self.factor(depth + 1)?)))
                }
                _ => self.bracket(depth),
            },
            // `float(x)`
            Some(Kind::Name) if self.text(self.at + 1) == "(" => match self.cast(self.at) {
                Some(precision) => {
                    self.at += 1;
                    Ok(Expression::Cast(precision, Box::new(self.bracket(depth)?)))
                }
                None => Err(self.wrong(format!("a call of `{}`", self.text(self.at)))),
            },
            Some(Kind::Number) => {
                let number = number(self.text(self.at), self.language)
                    .map_err(|reason| self.wrong(format!("`{}`: {reason}", self.text(self.at))))?;
                self.at += 1;
                Ok(Expression::Number(number))
            }
            Some(Kind::Directive) => Err(self.wrong("a line for the preprocessor".to_owned())),
            Some(Kind::Name) => {
                let name = self.text(self.at);
                let missing = if self.language.has_preprocessor() {
                    ", and has no `#define`".to_owned()
                } else {
                    String::new()
                };
                Err(self.wrong(format!("the name `{name}` is no number{missing}")))
            }
            Some(_) => Err(self.wrong(format!("`{}` is no number", self.text(self.at)))),
            None => Err(self.wrong("a number is missing at the end".to_owned())),
        }
    }

    fn bracket(&mut self, depth: usize) -> Result<Expression, Diagnostic> {
        self.at += 1;
        // Blanks part nothing within round brackets.
        let in_row = std::mem::take(&mut self.in_row);
        let inner = self.sum(depth + 1)?;
        self.in_row = in_row;
        if self.peek() != Some(Kind::Sign(')')) {
            return Err(self.wrong("`)` is missing".to_owned()));
        }
        self.at += 1;
        Ok(inner)
    }

    pub(super) fn cast(&self, at: usize) -> Option<Precision> {
        match self.text(at) {
            _ if !self.language.converts()[1] => None,
            // In Python, float is a double.
            "float" if self.language == Language::Python => Some(Precision::Double),
            "single" if self.language == Language::Matlab => Some(Precision::Single),
            "f32" if self.language == Language::Wgsl => Some(Precision::Single),
            "float" if self.language.is_native() => Some(Precision::Single),
            "double" if self.language.is_native() || self.language == Language::Matlab => {
                Some(Precision::Double)
            }
            _ => None,
        }
    }
}
