//! `subcert range`.

use super::arguments::RangeArguments;
use super::json::{SCHEMA, range as form};
use super::output::{Failure, Outcome, show};
use std::ops::Bound;
use subcert::bound::{Order, ParameterRange, RangeError, norm_function, polynomial_rules};
use subcert::exact::{
    Enclosed, Integer, Interval, IntervalSet, PiecewisePolynomial, Rational, RationalPolynomial,
    RealAlgebraic, SturmSequence,
    format::{fixed, short},
};
use subcert::report::{Grid, Sheet, json::Exact};
use subcert::scheme::parse_parametric;

/// The digits of a decimal in the text.
const DIGITS: u32 = 12;

/// The longest exact fraction that stands in the text in place of its decimal.
const SHOWN_LENGTH: usize = 16;

pub(super) fn range(arguments: &RangeArguments) -> Outcome {
    let mask = parse_parametric(&arguments.scheme, &arguments.param)?;
    let report =
        Report::of(arguments, &mask.difference()).map_err(|e| Failure::Input(e.to_string()))?;
    show(arguments.output.format, || report.sheet(), || report.form())
}

struct Report<'a> {
    arguments: &'a RangeArguments,
    range: ParameterRange,
    /// T_c for each c, when it is asked for.
    functions: Vec<PiecewisePolynomial>,
}

impl Report<'_> {
    fn of<'a>(
        arguments: &'a RangeArguments,
        difference: &subcert::scheme::Rules<subcert::exact::Polynomial>,
    ) -> Result<Report<'a>, RangeError> {
        let difference = polynomial_rules(difference, &arguments.param)?;
        let levels = arguments.block.levels;
        let range = ParameterRange::new(&difference, levels)?;
        let asked = if arguments.function { levels } else { 0 };
        let function = |c| norm_function(&difference, c, Order::Adjoint);
        let functions = (1..=asked).map(function).collect::<Result<Vec<_>, RangeError>>()?;
        Ok(Report { arguments, range, functions })
    }

    fn sheet(&self) -> Sheet {
        let RangeArguments { scheme, param, .. } = self.arguments;
        let mut sheet = Sheet::default();
        sheet.heading(1, format!("{scheme}: where T_c < 1"));
        let levels = (1..).zip(&self.range.levels);
        let mut rows: Vec<Vec<String>> = levels
            .map(|(c, set): (u32, _)| {
                let name = if c == 1 { "1 (δ)".to_owned() } else { c.to_string() };
                vec![name, self.set(set)]
            })
            .collect();
        rows.push(vec!["any of these".to_owned(), self.set(&self.range.union)]);
        let header = vec!["c".to_owned(), format!("T_c < 1 for these {param}")];
        sheet.grid(Grid { header, rows, left_columns: 2 });
        let ends = self.irrational_ends();
        if !ends.is_empty() {
            sheet.heading(2, "Irrational numbers");
            sheet.facts(ends);
        }
        sheet.text(
            "The sets are exact, and their decimals correctly rounded. The scheme converges in \
             each of them. The set of c is a part of that of every multiple of c.",
        );
        for (c, function) in (1_u32..).zip(&self.functions) {
            sheet.heading(2, format!("T_{c} as a function of {param}"));
            sheet.grid(self.pieces(function));
        }
        sheet
    }

    fn set(&self, set: &IntervalSet) -> String {
        let param = &self.arguments.param;
        if set.is_empty() {
            return format!("no {param}");
        }
        let interval = |interval: &Interval| match (&interval.low, &interval.high) {
            (Bound::Unbounded, Bound::Unbounded) => format!("every {param}"),
            (low, high) => {
                let low = place(low).map(|low| format!("{} < ", number(low)));
                let high = place(high).map(|high| format!(" < {}", number(high)));
                format!("{}{param}{}", low.unwrap_or_default(), high.unwrap_or_default())
            }
        };
        set.intervals().iter().map(interval).collect::<Vec<String>>().join("\n")
    }

    /// The irrational ends and breaks, each by its decimal, as roots.
    fn irrational_ends(&self) -> Vec<(String, String)> {
        let ends = self.range.levels.iter().flat_map(IntervalSet::ends).map(|(end, _)| end);
        let breaks = self.functions.iter().flat_map(PiecewisePolynomial::breakpoints);
        let mut ends: Vec<&RealAlgebraic> =
            ends.chain(breaks).filter(|end| end.as_rational().is_none()).collect();
        ends.sort();
        ends.dedup();
        let fact = |end: &RealAlgebraic| {
            let root = format!("root of {}", self.polynomial(end));
            let (low, high) = decimal_enclosure(end);
            (number(end), format!("{root}\nthe only one between {low} and {high}"))
        };
        ends.into_iter().map(fact).collect()
    }

    /// The minimal polynomial of a number.
    fn polynomial(&self, number: &RealAlgebraic) -> String {
        let (polynomial, note) = match number.minimal_polynomial() {
            Some(minimal) => (minimal, ""),
            None => (number.polynomial(), ", which may have factors"),
        };
        let polynomial = RationalPolynomial::over(&polynomial, &Integer::one());
        format!("{}{note}", polynomial.describe(&self.arguments.param))
    }

    fn pieces(&self, function: &PiecewisePolynomial) -> Grid {
        let param = &self.arguments.param;
        let breaks = function.breakpoints();
        let text = |place: Option<&RealAlgebraic>| place.map_or_else(String::new, number);
        let row = |(i, piece): (usize, &RationalPolynomial)| {
            let low = i.checked_sub(1).map(|below| &breaks[below]);
            vec![text(low), text(breaks.get(i)), piece.describe(param)]
        };
        let header = ["from".to_owned(), "to".to_owned(), "T_c".to_owned()].to_vec();
        let rows = function.pieces().iter().enumerate().map(row).collect();
        Grid { header, rows, left_columns: 3 }
    }

    fn form(&self) -> form::Range<'_> {
        let functions = self.functions.iter().map(Some).chain(std::iter::repeat(None));
        let levels = (1_u32..).zip(&self.range.levels).zip(functions);
        let levels = levels.map(|((c, intervals), function)| form::Level {
            c,
            intervals: self.set_form(intervals),
            function: function.map(|function| self.function_form(function)),
        });
        form::Range {
            schema: SCHEMA,
            scheme: &self.arguments.scheme,
            parameter: &self.arguments.param,
            levels: levels.collect(),
            union: self.set_form(&self.range.union),
        }
    }

    fn set_form(&self, set: &IntervalSet) -> Vec<form::Interval> {
        let end = |end: &Bound<RealAlgebraic>| place(end).map(|end| self.number_form(end));
        let interval = |interval: &Interval| form::Interval {
            low: end(&interval.low),
            high: end(&interval.high),
        };
        set.intervals().iter().map(interval).collect()
    }

    fn number_form(&self, number: &RealAlgebraic) -> form::Number {
        let (low, high) = number.bounds();
        form::Number {
            value: Exact::of(number),
            minimal_polynomial: self.polynomial(number),
            enclosure: [low.to_string(), high.to_string()],
        }
    }

    fn function_form(&self, function: &PiecewisePolynomial) -> form::Function {
        let param = &self.arguments.param;
        let pieces = function.pieces().iter();
        form::Function {
            breaks: function.breakpoints().iter().map(|place| self.number_form(place)).collect(),
            pieces: pieces.map(|piece| piece.describe(param)).collect(),
        }
    }
}

fn place(end: &Bound<RealAlgebraic>) -> Option<&RealAlgebraic> {
    match end {
        Bound::Unbounded => None,
        Bound::Included(place) | Bound::Excluded(place) => Some(place),
    }
}

/// Short decimals below and above an irrational number, with no other root of its
/// polynomial between them.
fn decimal_enclosure(number: &RealAlgebraic) -> (String, String) {
    let sturm = SturmSequence::new(&number.polynomial());
    let mut places = 1;
    loop {
        let unit = Rational::power_of_ten(-places);
        let below = number.step(|x| (x / &unit).floor());
        let (low, high) =
            (Rational::from(below.clone()) * &unit, Rational::from(below) * &unit + &unit);
        if sturm.count_roots(&low, &high) == 1 {
            let text = |x: &Rational| fixed(x, places.unsigned_abs());
            return (text(&low), text(&high));
        }
        places += 1;
    }
}

fn number(number: &RealAlgebraic) -> String {
    match number.as_rational().map(ToString::to_string) {
        Some(exact) if exact.len() <= SHOWN_LENGTH => exact,
        _ => short(number, DIGITS),
    }
}
