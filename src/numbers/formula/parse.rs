//! Parsing of formulas, with winnow.

use super::angle::PI;
use super::ast::{Expr, Fold, Node, Operator, OptionWord};
use super::error::{FormulaError, FormulaErrorKind, MAX_FORMULA_LENGTH};
use super::root::{ROOT, SQUARE_ROOT};
use super::token::{
    Failure, Input, Parsed, continues_name, identifier, located, nested, number, required,
    skip_space, space, starts_name, starts_number, symbol, token_at,
};
use winnow::Parser;
use winnow::combinator::{cut_err, delimited, opt, peek, preceded, repeat};
use winnow::error::{ErrMode, ParserError};
use winnow::stream::{LocatingSlice, Location, Stateful, Stream};
use winnow::token::{any, one_of, take_while};

/// `√3` is `sqrt(3)`; it binds as a call does: `√3/2` is `sqrt(3)/2`.
const ROOT_SIGN: char = '√';

/// Another name of `pi`.
const PI_SIGN: &str = "π";

/// Parses a formula.
///
/// # Errors
/// When the text does not follow the grammar of [the module](super), or exceeds the caps
/// on length and nesting.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::formula::{Parameters, evaluate, parse};
///
/// let formula = parse("9/16 + 2*w")?;
/// let w = Parameters::from([("w", Rational::new(3, 256))]);
/// assert_eq!(evaluate(&formula, &w)?, Rational::new(75, 128));
/// assert_eq!(parse("2 w").unwrap_err().span, 2..3);
/// # Ok::<(), subcert::formula::FormulaError>(())
/// ```
pub fn parse(text: &str) -> Result<Expr, FormulaError> {
    if text.len() > MAX_FORMULA_LENGTH {
        let kind = FormulaErrorKind::TooLong(text.len());
        return Err(FormulaError { kind, span: 0..text.len(), definition: None });
    }
    let input = Stateful { input: LocatingSlice::new(text), state: 0 };
    preceded(space, expression).parse(input).map_err(|error| {
        let failure = error.into_inner();
        let at = failure.at.min(text.len());
        let kind = match failure.kind.unwrap_or(FormulaErrorKind::Expected(OR_END)) {
            FormulaErrorKind::Expected(OR_END | OR_CLOSE) if is_factor(&text[at..]) => {
                FormulaErrorKind::Expected(PRODUCT)
            }
            kind => kind,
        };
        let span = failure.span.unwrap_or_else(|| token_at(text, at));
        FormulaError { kind, span, definition: None }
    })
}

/// What stands after a factor.
const OR_END: &str = "an operator or the end";
const OR_CLOSE: &str = "an operator or `)`";

/// The same where another factor stands there.
const PRODUCT: &str = "an operator; a product is written with `*`, as 2*w";

/// Whether a text begins as a factor that is no number, such as the w of 2w.
fn is_factor(text: &str) -> bool {
    text.starts_with(|next: char| next == '(' || next == ROOT_SIGN || starts_name(next))
}

fn expression(input: &mut Input<'_>) -> Parsed<Expr> {
    chain(input, additive, term)
}

fn term(input: &mut Input<'_>) -> Parsed<Expr> {
    chain(input, multiplicative, factor)
}

fn additive(input: &mut Input<'_>) -> Parsed<Operator> {
    let sign = one_of(['+', '-', '\u{2212}']);
    let operator = sign.map(|c| if c == '+' { Operator::Add } else { Operator::Subtract });
    (operator, space).map(|(operator, ())| operator).parse_next(input)
}

fn multiplicative(input: &mut Input<'_>) -> Parsed<Operator> {
    // The fraction slash and the division slash divide too.
    let sign = one_of(['*', '/', '·', '×', '\u{2044}', '\u{2215}']);
    let times = |c| matches!(c, '*' | '·' | '×');
    let operator = sign.map(move |c| if times(c) { Operator::Multiply } else { Operator::Divide });
    (operator, space).map(|(operator, ())| operator).parse_next(input)
}

fn chain<'a>(
    input: &mut Input<'a>,
    operator: fn(&mut Input<'a>) -> Parsed<Operator>,
    mut operand: fn(&mut Input<'a>) -> Parsed<Expr>,
) -> Parsed<Expr> {
    let first = operand.parse_next(input)?;
    let rest: Vec<(Operator, Expr)> = repeat(0.., (operator, operand)).parse_next(input)?;
    let Some((_, last)) = rest.last() else { return Ok(first) };
    let span = first.span.start..last.span.end;
    Ok(Expr { node: Node::Chain(Box::new(first), rest), span })
}

/// `-x^2` is `-(x^2)`; `x^-2` is `x^(-2)`.
fn factor(input: &mut Input<'_>) -> Parsed<Expr> {
    // A sign may be an en dash, which between two numbers could be a range.
    let minus = (one_of(['-', '\u{2212}', '\u{2013}']), space);
    let start = input.current_token_start();
    if opt(symbol('+')).parse_next(input)?.is_some() {
        return nested(factor).parse_next(input);
    }
    if opt(minus).parse_next(input)?.is_some() {
        let operand = nested(factor).parse_next(input)?;
        let span = start..operand.span.end;
        return Ok(Expr { node: Node::Negate(Box::new(operand)), span });
    }
    let base = primary(input)?;
    if opt(symbol('^')).parse_next(input)?.is_none() {
        return Ok(base);
    }
    let exponent = nested(factor).parse_next(input)?;
    let span = base.span.start..exponent.span.end;
    Ok(Expr { node: Node::Power(Box::new(base), Box::new(exponent)), span })
}

fn primary(input: &mut Input<'_>) -> Parsed<Expr> {
    let next = required("a number, a name or `(`", peek(any)).parse_next(input)?;
    if next == '(' {
        let start = input.current_token_start();
        let close = required(OR_CLOSE, ')');
        let inner = delimited(symbol('('), nested(expression), close).parse_next(input)?;
        let span = start..input.previous_token_end();
        space(input)?;
        return Ok(Expr { node: inner.node, span });
    }
    if starts_number(next) {
        return located(number).parse_next(input).and_then(|expr| skip_space(input, expr));
    }
    if starts_name(next) {
        return name_or_call(input);
    }
    if next == ROOT_SIGN {
        let start = input.current_token_start();
        symbol(ROOT_SIGN).parse_next(input)?;
        let of = nested(primary).parse_next(input)?;
        let span = start..of.span.end;
        let function = SQUARE_ROOT.to_owned();
        let node = Node::Call { function, arguments: vec![of], options: Vec::new() };
        return Ok(Expr { node, span });
    }
    required("a number, a name or `(`", winnow::combinator::fail).parse_next(input)
}

fn name_or_call(input: &mut Input<'_>) -> Parsed<Expr> {
    let start = input.current_token_start();
    let name = identifier(input)?;
    let end = input.previous_token_end();
    space(input)?;
    if opt(symbol('[')).parse_next(input)?.is_some() {
        let indices = nested(indices).parse_next(input)?;
        required("`,` or `]`", ']').parse_next(input)?;
        let end = input.previous_token_end();
        space(input)?;
        return Ok(Expr {
            node: Node::Indexed { name: name.to_owned(), indices },
            span: start..end,
        });
    }
    if opt(symbol('(')).parse_next(input)?.is_none() {
        let name = if name == PI_SIGN { PI } else { name };
        return Ok(Expr { node: Node::Name(name.to_owned()), span: start..end });
    }
    let node = match Fold::named(name) {
        Some(fold)
            if matches!(fold, Fold::Sum | Fold::Product)
                || peek(opt(index)).parse_next(input)?.is_some() =>
        {
            nested(|input: &mut Input<'_>| over_range(input, fold)).parse_next(input)?
        }
        _ if name == ROOT => nested(root).parse_next(input)?,
        _ => nested(|input: &mut Input<'_>| call(input, name)).parse_next(input)?,
    };
    let has_options = matches!(&node, Node::Call { options, .. } if !options.is_empty());
    let expected = if has_options {
        "`,` or `)`, since the value of an option is a word, a name or a number,"
    } else {
        "`,` or `)`"
    };
    required(expected, ')').parse_next(input)?;
    let end = input.previous_token_end();
    space(input)?;
    Ok(Expr { node, span: start..end })
}

fn indices(input: &mut Input<'_>) -> Parsed<Vec<Expr>> {
    let mut indices = vec![expression(input)?];
    while opt(symbol(',')).parse_next(input)?.is_some() {
        indices.push(expression(input)?);
    }
    Ok(indices)
}

/// `h =`
fn index<'a>(input: &mut Input<'a>) -> Parsed<&'a str> {
    (identifier, space, symbol('=')).map(|(index, ..)| index).parse_next(input)
}

fn over_range(input: &mut Input<'_>, fold: Fold) -> Parsed<Node> {
    let index = required("an index, as in sum(h = 1..m, …)", identifier).parse_next(input)?;
    space(input)?;
    required("`=`", symbol('=')).parse_next(input)?;
    let from = expression(input)?;
    required("`..` and the last index", ("..", space)).parse_next(input)?;
    let to = expression(input)?;
    required("`,` and what is summed or compared", symbol(',')).parse_next(input)?;
    let body = cut_err(expression).parse_next(input)?;
    let index = index.to_owned();
    Ok(Node::Fold { fold, index, from: Box::new(from), to: Box::new(to), body: Box::new(body) })
}

fn call(input: &mut Input<'_>, function: &str) -> Parsed<Node> {
    let mut arguments = Vec::new();
    let mut options = Vec::new();
    if peek(opt(')')).parse_next(input)?.is_none() {
        loop {
            match opt(option_word).parse_next(input)? {
                Some(option) => options.push(option),
                None if options.is_empty() => arguments.push(expression(input)?),
                None => {
                    let what = "a choice such as `order = forward`; arguments come first";
                    return required(what, winnow::combinator::fail).parse_next(input);
                }
            }
            if opt(symbol(',')).parse_next(input)?.is_none() {
                break;
            }
        }
    }
    Ok(Node::Call { function: function.to_owned(), arguments, options })
}

/// `[c0, c1, …], i`
fn root(input: &mut Input<'_>) -> Parsed<Node> {
    required("a list of coefficients, as in root([-3, 0, 1], 2)", symbol('[')).parse_next(input)?;
    let mut arguments = nested(indices).parse_next(input)?;
    required("`,` or `]`", symbol(']')).parse_next(input)?;
    required("`,` and the number of the root", symbol(',')).parse_next(input)?;
    arguments.push(cut_err(expression).parse_next(input)?);
    Ok(Node::Call { function: ROOT.to_owned(), arguments, options: Vec::new() })
}

fn option_word(input: &mut Input<'_>) -> Parsed<OptionWord> {
    let start = input.checkpoint();
    let offset = input.current_token_start();
    let name = identifier(input)?;
    space(input)?;
    if opt(symbol('=')).parse_next(input)?.is_none() {
        input.reset(&start);
        return Err(ErrMode::Backtrack(Failure::from_input(input)));
    }
    // A word, or the value of a parameter: `forward`, `n`, `3`, `0.5`, `1/16`.
    let digits = || take_while(1.., |c: char| c.is_ascii_digit());
    let word = take_while(1.., |c| continues_name(c) || c == '-');
    let word = (word, opt(('.', digits())), opt(('/', digits()))).take();
    let word = required("a word such as `forward`", word).parse_next(input)?;
    let span = offset..input.previous_token_end();
    space(input)?;
    Ok(OptionWord { name: name.to_owned(), word: word.to_owned(), span })
}
