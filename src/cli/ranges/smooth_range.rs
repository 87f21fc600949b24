//! `subcert range --smoothness`.

use super::level::Level;
use super::sets::{Set, write_irrational};
use super::special::{higher, write_special};
use crate::cli::arguments::RangeArguments;
use crate::cli::console::answer::{Answer, SCHEMA, show};
use crate::cli::console::output::{Failure, Outcome, quoted};
use crate::cli::console::progress::Progress;
use serde::Serialize;
use subcert::bound::polynomial_rules;
use subcert::exact::{IntervalSet, Polynomial, Rational, RationalPolynomial};
use subcert::lattice::{MAX_ORDER, lattice_range};
use subcert::report::json::SpecialForm;
use subcert::report::{Grid, Sheet, reduction, up};
use subcert::scheme::{LatticeMask, Mask};
use subcert::smoothness::{SmoothRangeError, SpecialValues, smooth_range as computed};

pub(crate) fn smooth_range(
    arguments: &RangeArguments,
    parameter: &str,
    mask: &Mask<Polynomial>,
    m: usize,
) -> Outcome {
    let input = |error: &dyn std::fmt::Display| Failure::Input(error.to_string());
    let rules = polynomial_rules(mask.rules(), parameter).map_err(|e| input(&e))?;
    let progress = Progress::of_search(true);
    let special = SpecialValues::of(&rules);
    let range = computed(&rules, m, arguments.block.levels).map_err(|error| match &error {
        SmoothRangeError::SumRules { needed, .. } => {
            let scheme = quoted(&arguments.scheme);
            let places = higher(&special, parameter, *needed).map(|places| {
                format!("; single values have them: {places}; `subcert range {scheme} --param {parameter}` says more")
            });
            input(&format!("{error}{}", places.unwrap_or_default()))
        }
        _ => input(&error),
    })?;
    drop(progress);
    let levels = (1_u32..).zip(&range.contraction.levels);
    let level = |(c, set)| Level { c, intervals: Set::of(set, parameter), function: None };
    let answer = SmoothRange {
        levels: levels.map(level).collect(),
        special: SpecialForm::all(&special, parameter),
        reduction: (!range.reduction.is_empty()).then(|| reduction(&range, parameter)),
        ..SmoothRange::of(
            arguments,
            (parameter, m),
            [&range.inside, &range.outside],
            range.but_finitely_many,
            range.gap.as_ref(),
        )
    };
    show(&arguments.output, &answer)
}

/// m, if C^m is asked for of a mask on Z^d.
pub(super) fn lattice_order(m: usize) -> Result<u32, Failure> {
    u32::try_from(m).ok().filter(|m| *m < MAX_ORDER).ok_or_else(|| {
        Failure::Input(format!("--smoothness {m}: of masks on Z^d it is below {MAX_ORDER}"))
    })
}

/// The same of a mask on Z^d.
pub(crate) fn of_lattice(
    arguments: &RangeArguments,
    parameter: &str,
    mask: &LatticeMask<RationalPolynomial>,
) -> Outcome {
    let m = arguments.smoothness.unwrap_or(0);
    let order = lattice_order(m)?;
    let progress = Progress::of_search(true);
    let range = lattice_range(mask, order).map_err(|error| Failure::Input(error.to_string()))?;
    drop(progress);
    let answer = SmoothRange::of(
        arguments,
        (parameter, m),
        [&range.inside, &range.outside],
        range.but_finitely_many,
        range.gap.as_ref(),
    );
    show(&arguments.output, &answer)
}

/// Where in a parameter the limits are C^m.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct SmoothRange<'a> {
    /// The version of this form.
    schema: u32,
    /// The scheme as it was given.
    scheme: &'a str,
    /// The parameter.
    parameter: &'a str,
    /// m.
    smoothness: usize,
    /// There all limits are C^m.
    inside: Set,
    /// There not all limits are C^m, or the scheme diverges.
    outside: Set,
    /// Whether finitely many parameters of `outside` may be exceptions.
    but_finitely_many: bool,
    /// The length of what is in neither, a decimal that is rounded upwards; null where it is unbounded.
    gap: Option<String>,
    /// For c = 1, 2, … the part of `inside` where the differences contract in c levels; none of masks on Z^d.
    levels: Vec<Level>,
    /// The values at which the sum rules are of a higher order, or the support is shorter.
    special: Vec<SpecialForm>,
    /// Whether the length of what is in neither is 0.
    #[serde(skip)]
    is_complete: bool,
    /// Why, and by what, another symbol decides.
    #[serde(skip)]
    reduction: Option<String>,
}

impl<'a> SmoothRange<'a> {
    /// The sets inside and outside for C^m, without levels and special values.
    fn of(
        arguments: &'a RangeArguments,
        (parameter, m): (&'a str, usize),
        [inside, outside]: [&IntervalSet; 2],
        but_finitely_many: bool,
        gap: Option<&Rational>,
    ) -> SmoothRange<'a> {
        SmoothRange {
            schema: SCHEMA,
            scheme: &arguments.scheme,
            parameter,
            smoothness: m,
            inside: Set::of(inside, parameter),
            outside: Set::of(outside, parameter),
            but_finitely_many,
            gap: gap.map(up),
            levels: Vec::new(),
            special: Vec::new(),
            is_complete: gap.is_some_and(Rational::is_zero),
            reduction: None,
        }
    }
}

impl Answer for SmoothRange<'_> {
    const NAME: &'static str = "range-smoothness";

    fn sheet(&self) -> Sheet {
        let SmoothRange { scheme, parameter, smoothness: m, inside, outside, levels, .. } = self;
        let mut sheet = Sheet::titled(format!("{scheme}: where the limits are C^{m}"));
        let open = match &self.gap {
            Some(_) if self.is_complete => "nothing, but for single values at most".to_owned(),
            Some(gap) => format!("the rest, of length at most {gap}"),
            None => {
                let open = IntervalSet::everything().without(&inside.0).without(&outside.0);
                Set::of(&open, parameter).words()
            }
        };
        let fact = |name: &str, text: String| (name.to_owned(), text);
        sheet.facts(vec![
            fact("inside", inside.proved(outside)),
            fact("outside", outside.found()),
            fact("open", open),
        ]);
        if !levels.is_empty() {
            sheet.heading(2, "By contraction");
            let rows =
                levels.iter().map(|level| vec![level.c.to_string(), level.intervals.words()]);
            let what =
                if *m == 0 { "the scheme".to_owned() } else { format!("derived scheme {m}") };
            let header = vec!["c".to_owned(), format!("the differences of {what} contract")];
            sheet.grid(Grid::of(header, rows, 2));
        }
        let sets = [inside, outside].into_iter().chain(levels.iter().map(|level| &level.intervals));
        write_special(&mut sheet, &self.special, parameter);
        write_irrational(&mut sheet, parameter, sets, self.special.iter().map(|one| &one.place));
        sheet.text(
            "Inside, all limits have this smoothness: by contraction, and by invariant hulls on intervals \
             with rational ends. Outside, some limit does not have it, or the scheme diverges: a product of \
             matrices of the differences has too large an eigenvalue.",
        );
        let mut whose = "the basic limit function";
        if let Some(reduction) = &self.reduction {
            sheet.text(format!("{reduction}."));
            whose = "this solution";
        }
        if self.but_finitely_many {
            sheet.text(format!(
                "Finitely many parameters outside may be exceptions: those where the shifts of {whose} are linearly \
                 dependent.",
            ));
        }
        sheet
    }
}
