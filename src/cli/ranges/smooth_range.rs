//! `subcert range --smoothness`.

use super::sets::Parameter;
use crate::cli::arguments::RangeArguments;
use crate::cli::console::output::{Failure, Outcome, show};
use crate::cli::console::progress::Progress;
use crate::cli::json::{SCHEMA, range as form};
use crate::cli::smoothness::radius::up;
use subcert::bound::polynomial_rules;
use subcert::exact::{IntervalSet, Polynomial};
use subcert::report::{Grid, Sheet, reduction};
use subcert::scheme::Mask;
use subcert::smoothness::{SmoothRange, smooth_range as computed};

pub(crate) fn smooth_range(
    arguments: &RangeArguments,
    parameter: &str,
    mask: &Mask<Polynomial>,
    m: usize,
) -> Outcome {
    let input = |error: &dyn std::fmt::Display| Failure::Input(error.to_string());
    let rules = polynomial_rules(mask.rules(), parameter).map_err(|e| input(&e))?;
    let progress = Progress::of_search(true);
    let range = computed(&rules, m, arguments.block.levels).map_err(|e| input(&e))?;
    drop(progress);
    let report = Report { arguments, parameter, m, range };
    show(&arguments.output, || report.sheet(), || report.form())
}

struct Report<'a> {
    arguments: &'a RangeArguments,
    parameter: &'a str,
    m: usize,
    range: SmoothRange,
}

impl Report<'_> {
    fn parameter(&self) -> Parameter<'_> {
        Parameter(self.parameter)
    }

    fn sheet(&self) -> Sheet {
        let (m, param, range) = (self.m, self.parameter(), &self.range);
        let mut sheet = Sheet::default();
        sheet.heading(1, format!("{}: where the limits are C^{m}", self.arguments.scheme));
        let open = IntervalSet::everything().without(&range.inside).without(&range.outside);
        let open = match &range.gap {
            Some(gap) if gap.is_zero() => "nothing, but for single values at most".to_owned(),
            Some(gap) => format!("the rest, of the length {} at most", up(gap)),
            None => param.set(&open),
        };
        let fact = |name: &str, text: String| (name.to_owned(), text);
        sheet.facts(vec![
            fact("inside", param.found(&range.inside)),
            fact("outside", param.found(&range.outside)),
            fact("open", open),
        ]);
        sheet.heading(2, "By contraction");
        let rows = (1_u32..).zip(&range.contraction.levels);
        let rows = rows.map(|(c, set)| vec![c.to_string(), param.set(set)]).collect();
        let what = if m == 0 { "the scheme".to_owned() } else { format!("derived scheme {m}") };
        let header = vec!["c".to_owned(), format!("the differences of {what} contract")];
        sheet.grid(Grid { header, rows, left_columns: 2 });
        let sets = [&range.inside, &range.outside].into_iter().chain(&range.contraction.levels);
        let ends = sets.flat_map(IntervalSet::ends).map(|(end, _)| end);
        let ends = param.irrational(ends);
        if !ends.is_empty() {
            sheet.heading(2, "Irrational numbers");
            sheet.facts(ends);
        }
        sheet.text(
            "Inside, all limits have this smoothness: by contraction, and by invariant hulls on intervals \
             with rational ends. Outside, some limit does not have it, or the scheme diverges: a product of \
             matrices of the differences has too large an eigenvalue.",
        );
        let mut whose = "the basic limit function";
        if !range.reduction.is_empty() {
            sheet.text(format!("{}.", reduction(range, self.parameter)));
            whose = "this solution";
        }
        if range.but_finitely_many {
            sheet.text(format!(
                "Finitely many parameters outside may be exceptions: those where the shifts of {whose} are linearly \
                 dependent.",
            ));
        }
        sheet
    }

    fn form(&self) -> form::SmoothRange<'_> {
        let (param, range) = (self.parameter(), &self.range);
        let levels = (1_u32..).zip(&range.contraction.levels);
        let level = |(c, set)| form::Level { c, intervals: param.set_form(set), function: None };
        form::SmoothRange {
            schema: SCHEMA,
            scheme: &self.arguments.scheme,
            parameter: self.parameter,
            smoothness: self.m,
            inside: param.set_form(&range.inside),
            outside: param.set_form(&range.outside),
            but_finitely_many: range.but_finitely_many,
            gap: range.gap.as_ref().map(up),
            levels: levels.map(level).collect(),
        }
    }
}
