//! One number of a table.

use super::expression::Expression;
use super::language::Precision;
use crate::exact::Rational;
use std::ops::Range;

/// How a number is written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Written {
    /// One literal, perhaps with a sign.
    Literal {
        /// The number that its digits say.
        value: Rational,
        /// How many significant digits it has, from the first that is not 0; `None` in hexadecimal.
        digits: Option<usize>,
        /// How many digits it has after the point, with the exponent applied: 3 for `1.5e-2`, −1 for `2e1`; `None` in
        /// hexadecimal.
        places: Option<i64>,
    },
    /// A formula of literals, such as `1.0/6.0`.
    Expression {
        /// The value of the formula, computed exactly; where the language divides integers, it rounds
        /// towards zero here too. `None` after a division by zero.
        value: Option<Rational>,
    },
}

/// One number of a table, and its place in the file.
#[derive(Clone, Debug)]
pub struct Entry {
    pub(super) span: Range<usize>,
    pub(super) line: usize,
    pub(super) expression: Expression,
}

impl Entry {
    /// Its bytes in the file.
    #[must_use]
    pub fn span(&self) -> Range<usize> {
        self.span.clone()
    }

    /// Its line, from 1 on.
    #[must_use]
    pub fn line(&self) -> usize {
        self.line
    }

    /// How it is written.
    #[must_use]
    pub fn written(&self) -> Written {
        match self.expression.literal() {
            Some((sign, number)) => Written::Literal {
                value: if sign { -&number.value } else { number.value.clone() },
                digits: number.digits,
                places: number.places,
            },
            None => Written::Expression { value: self.expression.exact() },
        }
    }

    /// Whether a table of this precision gets another number where the compiler rounds literals to doubles first, as those of HLSL and
    /// WGSL may.
    #[must_use]
    pub fn depends_on_compiler(&self, precision: Precision) -> bool {
        self.expression.depends_on_compiler(precision)
    }

    /// Whether it has a `long double` that is no double: what a table of floating-point numbers gets depends on the machine.
    #[must_use]
    pub fn depends_on_machine(&self) -> bool {
        self.expression.depends_on_machine()
    }

    /// The number that the program holds in a table of this precision: each literal is rounded to
    /// its type (to nearest, half to even), each operation to its own, and the result to that of
    /// the table. An f32 is returned as the f64 of the same value. Not finite after an overflow or a division by zero.
    #[must_use]
    pub fn held(&self, precision: Precision) -> f64 {
        self.expression.held(precision)
    }
}
