//! The tokens of a formula, and the errors of its parser.

use super::ast::{Expr, Node, Span};
use super::error::{FormulaErrorKind, MAX_NESTING};
use crate::exact::{is_vulgar, parse_rational};
use winnow::Parser;
use winnow::combinator::{alt, not, opt};
use winnow::error::{ErrMode, ParserError};
use winnow::stream::{LocatingSlice, Location, Stateful};
use winnow::token::{one_of, take_while};

/// The formula's text, with the nesting depth of the parser as state.
pub(super) type Input<'a> = Stateful<LocatingSlice<&'a str>, usize>;
/// The result of a parser.
pub(super) type Parsed<T> = Result<T, ErrMode<Failure>>;

/// Whether `text` can be the name of a parameter: a letter or `_`, then letters,
/// digits and `_`.
#[must_use]
pub fn is_identifier(text: &str) -> bool {
    let mut characters = text.chars();
    characters.next().is_some_and(starts_name) && characters.all(continues_name)
}

/// Whether a name can start with `c`.
#[must_use]
pub fn starts_name(c: char) -> bool {
    c.is_alphabetic() || c == '_'
}

/// Whether `c` can stand in a name after its first character.
#[must_use]
pub fn continues_name(c: char) -> bool {
    (c.is_alphanumeric() || c == '_') && !is_vulgar(c)
}

/// The token that starts at byte `at`, which error messages underline; empty at the end
/// of the text.
pub(super) fn token_at(text: &str, at: usize) -> Span {
    let rest = &text[at..];
    let word: usize = rest.chars().take_while(|c| continues_name(*c)).map(char::len_utf8).sum();
    let length = if word > 0 { word } else { rest.chars().next().map_or(0, char::len_utf8) };
    at..at + length
}

/// The place where parsing stopped, and what was expected there.
#[derive(Clone, Debug)]
pub(super) struct Failure {
    pub(super) at: usize,
    pub(super) kind: Option<FormulaErrorKind>,
    pub(super) span: Option<Span>,
}

impl<'a> ParserError<Input<'a>> for Failure {
    type Inner = Failure;
    fn from_input(input: &Input<'a>) -> Failure {
        Failure { at: input.current_token_start(), kind: None, span: None }
    }
    fn or(self, other: Failure) -> Failure {
        if self.at > other.at { self } else { other }
    }
    fn into_inner(self) -> Result<Failure, Failure> {
        Ok(self)
    }
}

/// Runs `parser`; if it does not match, parsing ends with the error that `what` was
/// expected.
pub(super) fn required<'a, T>(
    what: &'static str,
    mut parser: impl Parser<Input<'a>, T, ErrMode<Failure>>,
) -> impl Parser<Input<'a>, T, ErrMode<Failure>> {
    move |input: &mut Input<'a>| {
        parser.parse_next(input).map_err(|error| match error {
            ErrMode::Backtrack(mut failure) => {
                failure.kind = Some(FormulaErrorKind::Expected(what));
                ErrMode::Cut(failure)
            }
            other => other,
        })
    }
}

/// Skips white space, if there is any.
pub(super) fn space(input: &mut Input<'_>) -> Parsed<()> {
    take_while(0.., char::is_whitespace).void().parse_next(input)
}

/// A character, and white space after it.
pub(super) fn symbol<'a>(character: char) -> impl Parser<Input<'a>, (), ErrMode<Failure>> {
    (character, space).void()
}

/// The node that `parser` returns, with its place.
pub(super) fn located<'a>(
    mut parser: impl Parser<Input<'a>, Node, ErrMode<Failure>>,
) -> impl Parser<Input<'a>, Expr, ErrMode<Failure>> {
    move |input: &mut Input<'a>| {
        let start = input.current_token_start();
        let node = parser.parse_next(input)?;
        Ok(Expr { node, span: start..input.previous_token_end() })
    }
}

/// Runs `parser` one level deeper; an error beyond [`MAX_NESTING`].
pub(super) fn nested<'a, T>(
    mut parser: impl Parser<Input<'a>, T, ErrMode<Failure>>,
) -> impl Parser<Input<'a>, T, ErrMode<Failure>> {
    move |input: &mut Input<'a>| {
        if input.state >= MAX_NESTING {
            let at = input.current_token_start();
            let kind = Some(FormulaErrorKind::TooDeep);
            return Err(ErrMode::Cut(Failure { at, kind, span: None }));
        }
        input.state += 1;
        let result = parser.parse_next(input);
        input.state -= 1;
        result
    }
}

/// Skips the white space after `expr`, and returns `expr`.
pub(super) fn skip_space(input: &mut Input<'_>, expr: Expr) -> Parsed<Expr> {
    space(input)?;
    Ok(expr)
}

fn digits<'a>(input: &mut Input<'a>) -> Parsed<&'a str> {
    take_while(1.., '0'..='9').parse_next(input)
}

/// Whether a number can start with `c`.
pub(super) fn starts_number(c: char) -> bool {
    c.is_ascii_digit() || c == '.' || is_vulgar(c)
}

/// The exponent of a decimal.
fn power(input: &mut Input<'_>) -> Parsed<()> {
    let exponent = (one_of(['e', 'E']), opt(one_of(['+', '-'])), required("a digit", digits));
    exponent.void().parse_next(input)
}

/// A decimal number, or a fraction of one character such as `½`, perhaps with a whole number before it.
pub(super) fn number(input: &mut Input<'_>) -> Parsed<Node> {
    let start = input.current_token_start();
    // `1..3` is a range; it does not start with the number `1.`.
    let after = opt(('.', not('.'), opt(digits)));
    let decimal = (digits, after, opt(power)).void();
    let point = ('.', required("a digit", digits), opt(power)).void();
    let fraction = (opt(digits), one_of(is_vulgar)).void();
    let text = alt((fraction, decimal, point)).take().parse_next(input)?;
    parse_rational(text).map(Node::Number).map_err(|error| {
        let span = Some(start..start + text.len());
        let kind = Some(FormulaErrorKind::Number(error));
        ErrMode::Cut(Failure { at: start, kind, span })
    })
}

/// A name.
pub(super) fn identifier<'a>(input: &mut Input<'a>) -> Parsed<&'a str> {
    (one_of(starts_name), take_while(0.., continues_name)).take().parse_next(input)
}
