//! `subcert certify`.

use crate::cli::arguments::CertifyArguments;
use crate::cli::console::answer::{Answer, SCHEMA, show};
use crate::cli::console::output::{Failure, Outcome, positive};
use serde::Serialize;
use std::fmt::Display;
use subcert::exact::{Enclosed, Real, format::short};
use subcert::float::{
    self, CertifyError, CertifyOptions, DepthDecision, certify as compare, certify_local_rules,
    exact, shortest,
};
use subcert::report::{Grid, Sheet};
use subcert::scheme::{AnyScheme, LocalRules, parse_any_scheme};

pub(crate) fn certify(arguments: &CertifyArguments) -> Outcome {
    let scheme = match parse_any_scheme(&arguments.scheme)? {
        AnyScheme::Uniform(scheme) => scheme,
        AnyScheme::LocalRules(ring) => return ring_certificate(&ring, arguments),
    };
    let mut options = CertifyOptions {
        max_block: arguments.block.levels,
        spread: positive("--spread", arguments.spread.as_deref().unwrap_or("1"))?,
        ..CertifyOptions::default()
    };
    if !arguments.tolerance.is_empty() {
        let read = |text: &String| positive("--tolerance", text);
        options.tolerances = arguments.tolerance.iter().map(read).collect::<Result<_, _>>()?;
    }
    let result = compare(&scheme, &options)
        .map_err(|error: CertifyError| Failure::Input(error.to_string()))?;
    let answer = Certification {
        schema: SCHEMA,
        scheme: &arguments.scheme,
        quantities: result.quantities.iter().map(Quantity::of).collect(),
        depths: Some(result.depths.iter().map(Depth::of).collect()),
        bounded_up_to_block: result.tracked_block,
    };
    show(&arguments.output, &answer)
}

/// The report on a ring, which has constants, and no formula for depths.
fn ring_certificate(ring: &LocalRules, arguments: &CertifyArguments) -> Outcome {
    if arguments.spread.is_some() || !arguments.tolerance.is_empty() {
        let message = "--tolerance and --spread ask for depths by a formula for masks; for a ring, \
                       `subcert depth` gives the exact depth";
        return Err(Failure::Input(message.to_owned()));
    }
    let result = certify_local_rules(ring, arguments.block.levels)
        .map_err(|error| Failure::Input(error.to_string()))?;
    let answer = Certification {
        schema: SCHEMA,
        scheme: &arguments.scheme,
        quantities: result.quantities.iter().map(Quantity::of).collect(),
        depths: None,
        bounded_up_to_block: result.tracked_block,
    };
    show(&arguments.output, &answer)
}

/// A number type that reports print.
trait Shown: Real + Enclosed + PartialOrd + Display {}

impl<V: Real + Enclosed + PartialOrd + Display> Shown for V {}

/// The f64 path of a scheme against the exact one.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct Certification<'a> {
    /// The version of this form.
    schema: u32,
    /// The scheme as it was given.
    scheme: &'a str,
    /// The constants.
    quantities: Vec<Quantity>,
    /// The depths by the formula; missing of a ring, for which there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    depths: Option<Vec<Depth>>,
    /// The greatest block length for which an error bound is proven in advance.
    bounded_up_to_block: u32,
}

/// A constant in f64.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Quantity {
    /// Which constant.
    name: String,
    /// Its value in f64.
    #[serde(rename = "f64")]
    float: String,
    /// Its exact value.
    exact: String,
    /// That value as a decimal.
    decimal: String,
    /// The difference of the two; null where f64 has no number.
    error: Option<String>,
    /// That difference in units in the last place.
    ulps: Option<String>,
    /// The bound of the error that is proven in advance.
    bound: Option<String>,
    /// Whether the error is within the bound.
    encloses: Option<bool>,
    /// The error as a part of the bound.
    tightness: Option<String>,
    /// It in a table.
    #[serde(skip)]
    row: Vec<String>,
}

/// The least k with σβC^k/(1 − C) ≤ ε, C = T_c, in f64 and exactly: a depth by a formula, not the
/// exact depth that `subcert depth` gives.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Depth {
    /// The block length c.
    block: u32,
    /// The tolerance.
    tolerance: String,
    /// The formula with logarithms, before it is rounded up.
    logarithm: String,
    /// The k that f64 gives.
    #[serde(rename = "f64")]
    float: Option<u32>,
    /// The k, exactly.
    exact: Option<u32>,
    /// Why there is no k.
    note: Option<String>,
    /// Whether the two agree.
    agree: Option<bool>,
    /// How clearly k is decided.
    margin: Option<Margin>,
    /// It in a table.
    #[serde(skip)]
    row: Vec<String>,
}

/// How clearly k is decided: the bound at k and at k − 1, as parts of the tolerance.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Margin {
    /// The bound at k divided by the tolerance: at most 1.
    at: String,
    /// The bound at k − 1 divided by the tolerance: more than 1.
    before: Option<String>,
}

impl Quantity {
    fn of<V: Shown>(quantity: &float::Quantity<V>) -> Quantity {
        fn digits(value: Option<&impl Enclosed>) -> String {
            value.map_or_else(|| "·".to_owned(), |value| short(value, 3))
        }
        let tightness = quantity.tightness.and_then(exact);
        Quantity {
            name: quantity.name.clone(),
            float: shortest(quantity.value),
            exact: quantity.exact.to_string(),
            decimal: short(&quantity.exact, 17),
            error: quantity.error.as_ref().map(V::to_string),
            ulps: quantity.ulps.as_ref().map(|ulps| short(ulps, 6)),
            bound: quantity.bound.map(shortest),
            encloses: quantity.encloses(),
            tightness: tightness.as_ref().map(|tightness| short(tightness, 6)),
            row: vec![
                quantity.name.clone(),
                shortest(quantity.value),
                short(&quantity.exact, 17),
                digits(quantity.error.as_ref()),
                digits(quantity.ulps.as_ref()),
                digits(quantity.bound.and_then(exact).as_ref()),
                digits(tightness.as_ref()),
            ],
        }
    }
}

impl Depth {
    fn of(depth: &DepthDecision) -> Depth {
        let level = |level: Option<u32>| level.map_or_else(|| "none".to_owned(), |k| k.to_string());
        let margin = depth.margin.as_ref().map_or_else(
            || "·".to_owned(),
            |margin| {
                let before = margin.before.as_ref().map(|before| format!(", {}", short(before, 6)));
                format!("{}{}", short(&margin.at, 6), before.unwrap_or_default())
            },
        );
        Depth {
            block: depth.block,
            tolerance: depth.tolerance.to_string(),
            logarithm: shortest(depth.logarithm),
            float: depth.float,
            exact: depth.exact.as_ref().ok().copied(),
            note: depth.exact.as_ref().err().map(ToString::to_string),
            agree: depth.agree,
            margin: depth.margin.as_ref().map(|margin| Margin {
                at: short(&margin.at, 17),
                before: margin.before.as_ref().map(|before| short(before, 17)),
            }),
            row: vec![
                depth.block.to_string(),
                short(&depth.tolerance, 6),
                exact(depth.logarithm).map_or_else(|| "·".to_owned(), |value| short(&value, 6)),
                level(depth.float),
                level(depth.exact.as_ref().ok().copied()),
                match depth.agree {
                    Some(true) => "✓",
                    Some(false) => "✗",
                    None => "·",
                }
                .to_owned(),
                margin,
            ],
        }
    }
}

impl Answer for Certification<'_> {
    const NAME: &'static str = "certify";

    fn sheet(&self) -> Sheet {
        let quantities = &self.quantities;
        let mut sheet = Sheet::default();
        sheet.heading(1, format!("{} in f64", self.scheme));
        let header = ["quantity", "f64", "exact", "error", "ulps", "proven bound", "error/bound"];
        let rows = quantities.iter().map(|one| one.row.clone()).collect();
        sheet.grid(Grid { header: header.map(str::to_owned).to_vec(), rows, left_columns: 1 });
        let outside = quantities.iter().filter(|q| q.encloses == Some(false)).count();
        let bounded = quantities.iter().filter(|q| q.bound.is_some()).count();
        sheet.text(format!(
            "{} {} of {bounded} errors lie within the bound proven in advance.",
            if outside == 0 { "✓" } else { "✗" },
            bounded - outside
        ));
        let Some(depths) = &self.depths else { return sheet };
        let header = ["c", "tolerance", "by logarithms", "k in f64", "k, exactly", "", "margin"];
        let rows = depths.iter().map(|one| one.row.clone()).collect();
        sheet.heading(2, "The least k with σβC^k/(1 − C) ≤ ε, C = T_c");
        sheet.grid(Grid { header: header.map(str::to_owned).to_vec(), rows, left_columns: 0 });
        sheet.text(
            "Margin: bound(k)/ε, at most 1, and bound(k−1)/ε, above 1; the nearer to 1, the nearer \
         k is to another. This k is the depth by a formula; `subcert depth` gives the number of \
         levels that is really needed.",
        );
        sheet
    }
}
