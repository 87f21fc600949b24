//! `subcert range`.

use super::sets::{Parameter, number};
use super::smooth_map::smooth_map;
use super::smooth_range::smooth_range;
use super::vertex_range::of_rules;
use crate::cli::arguments::RangeArguments;
use crate::cli::console::output::{Failure, Outcome, show};
use crate::cli::json::{SCHEMA, range as form};
use subcert::bound::{Order, ParameterRange, RangeError, norm_function, polynomial_rules};
use subcert::exact::{IntervalSet, PiecewisePolynomial, RationalPolynomial, RealAlgebraic};
use subcert::report::{Grid, Sheet};
use subcert::scheme::{open_parameters, parse_parametric};
use subcert::suggestion::known;

pub(crate) fn range(arguments: &RangeArguments) -> Outcome {
    let named = [&arguments.names[..], &arguments.param[..]].concat();
    let parameter = match &named[..] {
        [] => &the_parameter(&arguments.scheme)?,
        [parameter] => parameter,
        [first, second] => return smooth_map(arguments, [first, second]),
        more => {
            let count = more.len();
            let message = format!("{count} parameters; there are maps of up to two");
            return Err(Failure::Input(message));
        }
    };
    if arguments.bounds.is_some() || arguments.boxes.is_some() {
        let message =
            "`--bounds` and `--boxes` belong to a map of two parameters: give `--param` twice";
        return Err(Failure::Input(message.to_owned()));
    }
    if let Some(outcome) = of_rules(arguments, parameter) {
        return outcome;
    }
    if arguments.valences.is_some() {
        let message = "`--valences` belongs to rules around a vertex or on a face";
        return Err(Failure::Input(message.to_owned()));
    }
    let mask = parse_parametric(&arguments.scheme, parameter).map_err(|error| {
        let open = open_parameters(&arguments.scheme).unwrap_or_default();
        if open.is_empty() || open.contains(parameter) {
            return Failure::from(error);
        }
        let known = known(parameter, open.iter().map(String::as_str));
        Failure::Input(format!(
            "`{}` leaves no parameter `{parameter}` open{known}",
            arguments.scheme
        ))
    })?;
    if let Some(m) = arguments.smoothness {
        return smooth_range(arguments, parameter, &mask, m);
    }
    let report = Report::of(arguments, parameter, &mask.difference())
        .map_err(|e| Failure::Input(e.to_string()))?;
    show(&arguments.output, || report.sheet(), || report.form())
}

/// The one parameter that SCHEME leaves open.
fn the_parameter(scheme: &str) -> Result<String, Failure> {
    let mut open = open_parameters(scheme)?;
    match (open.pop(), open.is_empty()) {
        (Some(name), true) => Ok(name),
        (None, _) => {
            let message = format!(
                "`{scheme}` leaves no parameter open; give the scheme without a value for the parameter"
            );
            Err(Failure::Input(message))
        }
        (Some(last), false) => {
            let names = open.iter().chain([&last]).map(|name| format!("`{name}`"));
            let names: Vec<String> = names.collect();
            Err(Failure::Input(format!(
                "the mask of `{scheme}` may depend on {}: name one, as in `subcert range {scheme} {last}`",
                names.join(", ")
            )))
        }
    }
}

struct Report<'a> {
    arguments: &'a RangeArguments,
    parameter: &'a str,
    range: ParameterRange,
    /// T_c for each c, when it is asked for.
    functions: Vec<PiecewisePolynomial>,
}

impl Report<'_> {
    fn parameter(&self) -> Parameter<'_> {
        Parameter(self.parameter)
    }

    fn of<'a>(
        arguments: &'a RangeArguments,
        parameter: &'a str,
        difference: &subcert::scheme::Rules<subcert::exact::Polynomial>,
    ) -> Result<Report<'a>, RangeError> {
        let difference = polynomial_rules(difference, parameter)?;
        let levels = arguments.block.levels;
        let range = ParameterRange::new(&difference, levels)?;
        let asked = if arguments.function { levels } else { 0 };
        let function = |c| norm_function(&difference, c, Order::Adjoint);
        let functions = (1..=asked).map(function).collect::<Result<Vec<_>, RangeError>>()?;
        Ok(Report { arguments, parameter, range, functions })
    }

    fn sheet(&self) -> Sheet {
        let scheme = &self.arguments.scheme;
        let param = self.parameter();
        let mut sheet = Sheet::default();
        sheet.heading(1, format!("{scheme}: where T_c < 1"));
        let levels = (1..).zip(&self.range.levels);
        let mut rows: Vec<Vec<String>> = levels
            .map(|(c, set): (u32, _)| {
                let name = if c == 1 { "1 (δ)".to_owned() } else { c.to_string() };
                vec![name, param.set(set)]
            })
            .collect();
        rows.push(vec!["any of these".to_owned(), param.set(&self.range.union)]);
        let header = vec!["c".to_owned(), format!("T_c < 1 for these {}", param.0)];
        sheet.grid(Grid { header, rows, left_columns: 2 });
        let ends = self.range.levels.iter().flat_map(IntervalSet::ends).map(|(end, _)| end);
        let breaks = self.functions.iter().flat_map(PiecewisePolynomial::breakpoints);
        let ends = param.irrational(ends.chain(breaks));
        if !ends.is_empty() {
            sheet.heading(2, "Irrational numbers");
            sheet.facts(ends);
        }
        sheet.text(
            "The sets are exact, and their decimals correctly rounded. The scheme converges in \
             each of them. The set of c is a part of that of every multiple of c.",
        );
        for (c, function) in (1_u32..).zip(&self.functions) {
            sheet.heading(2, format!("T_{c} as a function of {}", param.0));
            sheet.grid(self.pieces(function));
        }
        sheet
    }

    fn pieces(&self, function: &PiecewisePolynomial) -> Grid {
        let param = self.parameter;
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
            intervals: self.parameter().set_form(intervals),
            function: function.map(|function| self.function_form(function)),
        });
        form::Range {
            schema: SCHEMA,
            scheme: &self.arguments.scheme,
            parameter: self.parameter,
            levels: levels.collect(),
            union: self.parameter().set_form(&self.range.union),
        }
    }

    fn function_form(&self, function: &PiecewisePolynomial) -> form::Function {
        let param = self.parameter;
        let pieces = function.pieces().iter();
        form::Function {
            breaks: function
                .breakpoints()
                .iter()
                .map(|place| self.parameter().number_form(place))
                .collect(),
            pieces: pieces.map(|piece| piece.describe(param)).collect(),
        }
    }
}
