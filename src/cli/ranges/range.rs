//! `subcert range`.

use super::best::best;
use super::level::{Function, Level};
use super::sets::{Set, write_irrational};
use super::smooth_map::smooth_map;
use super::smooth_range::{of_lattice, smooth_range};
use super::special::write_special;
use super::vertex_range::of_rules;
use crate::cli::arguments::RangeArguments;
use crate::cli::console::answer::{Answer, SCHEMA, show};
use crate::cli::console::output::{Failure, Outcome, quoted};
use serde::Serialize;
use subcert::bound::{Order, ParameterRange, RangeError, norm_function, polynomial_rules};
use subcert::exact::Polynomial;
use subcert::report::json::SpecialForm;
use subcert::report::{Grid, Sheet};
use subcert::scheme::{
    Mask, find_definition, open_parameters, parse_lattice_in_parameter, parse_parametric,
};
use subcert::smoothness::SpecialValues;
use subcert::suggestion::known;

pub(crate) fn range(arguments: &RangeArguments) -> Outcome {
    let named = [&arguments.names[..], &arguments.param[..]].concat();
    if let Some(what) = arguments.best {
        let named = if named.is_empty() { vec![the_parameter(&arguments.scheme)?] } else { named };
        return best(arguments, &named, what);
    }
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
    if find_definition(&arguments.scheme)?.is_lattice() {
        if arguments.function {
            let message = "`--function` belongs to masks of curves";
            return Err(Failure::Input(message.to_owned()));
        }
        let mask = parse_lattice_in_parameter(&arguments.scheme, parameter)?;
        return of_lattice(arguments, parameter, &mask);
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
    let answer =
        Range::of(arguments, parameter, &mask).map_err(|e| Failure::Input(e.to_string()))?;
    show(&arguments.output, &answer)
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
                "the mask of `{scheme}` may depend on {}: name one, as in `subcert range {} {last}`",
                names.join(", "),
                quoted(scheme)
            )))
        }
    }
}

/// Where in a parameter T_c < 1.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct Range<'a> {
    /// The version of this form.
    schema: u32,
    /// The scheme as it was given.
    scheme: &'a str,
    /// The parameter.
    parameter: &'a str,
    /// The sets for c = 1, 2, …
    levels: Vec<Level>,
    /// The union of these sets.
    union: Set,
    /// The values at which the sum rules are of a higher order, or the support is shorter.
    special: Vec<SpecialForm>,
}

impl<'a> Range<'a> {
    fn of(
        arguments: &'a RangeArguments,
        parameter: &'a str,
        mask: &Mask<Polynomial>,
    ) -> Result<Range<'a>, RangeError> {
        let difference = polynomial_rules(&mask.difference(), parameter)?;
        let found = ParameterRange::new(&difference, arguments.block.levels)?;
        let level = |(c, set)| {
            let function = || norm_function(&difference, c, Order::Adjoint);
            let function = arguments.function.then(function).transpose()?;
            let function = function.as_ref().map(|found| Function::of(found, parameter));
            Ok(Level { c, intervals: Set::of(set, parameter), function })
        };
        let levels = (1..).zip(&found.levels).map(level).collect::<Result<_, RangeError>>()?;
        let union = Set::of(&found.union, parameter);
        let special = SpecialValues::of(&polynomial_rules(mask.rules(), parameter)?);
        let special = SpecialForm::all(&special, parameter);
        Ok(Range { schema: SCHEMA, scheme: &arguments.scheme, parameter, levels, union, special })
    }
}

impl Answer for Range<'_> {
    const NAME: &'static str = "range";

    fn sheet(&self) -> Sheet {
        let Range { scheme, parameter, levels, union, .. } = self;
        let mut sheet = Sheet::titled(format!("{scheme}: where T_c < 1"));
        let row = |level: &Level| {
            let name = if level.c == 1 { "1 (δ)".to_owned() } else { level.c.to_string() };
            vec![name, level.intervals.words()]
        };
        let mut rows: Vec<Vec<String>> = levels.iter().map(row).collect();
        rows.push(vec!["any of these".to_owned(), union.words()]);
        let header = vec!["c".to_owned(), format!("T_c < 1 for these {parameter}")];
        sheet.grid(Grid::of(header, rows, 2));
        let special = self.special.iter().map(|one| &one.place);
        let functions =
            || levels.iter().filter_map(|level| Some((level.c, level.function.as_ref()?)));
        let breaks = functions().flat_map(|(_, function)| &function.places);
        let sets = levels.iter().map(|level| &level.intervals);
        write_special(&mut sheet, &self.special, parameter);
        write_irrational(&mut sheet, parameter, sets, breaks.chain(special));
        sheet.text(
            "The sets are exact; a decimal that ends in … is cut. The scheme converges in each of \
             them. The set of c is a part of that of every multiple of c.",
        );
        for (c, function) in functions() {
            sheet.heading(2, format!("T_{c} as a function of {parameter}"));
            sheet.grid(function.grid());
        }
        sheet
    }
}
