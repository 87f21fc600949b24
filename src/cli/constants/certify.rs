//! `subcert certify`.

use crate::cli::arguments::CertifyArguments;
use crate::cli::console::answer::{Answer, SCHEMA, show};
use crate::cli::console::output::{Failure, Outcome, positive};
use crate::cli::console::quantity::{Digits, Float, Number, Text};
use serde::Serialize;
use subcert::bound::DepthError;
use subcert::exact::{Enclosed, Rational, Real};
use subcert::float::{
    self, CertifyError, CertifyOptions, DepthDecision, certify as compare, certify_local_rules,
    shortest,
};
use subcert::report::{Grid, Sheet};
use subcert::scheme::{AnyScheme, LocalRules, SchemeError, notes, parse_any_scheme};

pub(crate) fn certify(arguments: &CertifyArguments) -> Outcome {
    let scheme = match parse_any_scheme(&arguments.scheme)? {
        AnyScheme::Uniform(scheme) => scheme,
        AnyScheme::Lattice(_) => {
            return Err(SchemeError::Lattice { scheme: arguments.scheme.clone() }.into());
        }
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
        notes: notes(&arguments.scheme),
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
        notes: notes(&arguments.scheme),
        quantities: result.quantities.iter().map(Quantity::of).collect(),
        depths: None,
        bounded_up_to_block: result.tracked_block,
    };
    show(&arguments.output, &answer)
}

/// The f64 path of a scheme against the exact one.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct Certification<'a> {
    /// The version of this form.
    schema: u32,
    /// The scheme as it was given.
    scheme: &'a str,
    /// What is to be told of the numbers, such as that they are those of several steps; missing where there is nothing.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    notes: Vec<String>,
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
    float: Float,
    /// Its exact value; its fields stand here.
    #[serde(flatten)]
    exact: Number,
    /// The difference of the two; null where f64 has no number.
    error: Option<Text<Number>>,
    /// That difference in units in the last place.
    ulps: Option<Digits<6>>,
    /// The bound of the error that is proven in advance.
    bound: Option<Float>,
    /// Whether the error is within the bound.
    encloses: Option<bool>,
    /// The error as a part of the bound.
    tightness: Option<Digits<6>>,
}

/// The least k with σβC^k/(1 − C) ≤ ε, C = T_c, in f64 and exactly: a depth by a formula, not the
/// exact depth that `subcert depth` gives.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Depth {
    /// The block length c.
    block: u32,
    /// The tolerance.
    tolerance: Text<Number>,
    /// The formula with logarithms, before it is rounded up.
    logarithm: Float,
    /// The k that f64 gives.
    #[serde(rename = "f64")]
    float: Option<u32>,
    /// The k, exactly.
    exact: Option<u32>,
    /// Why there is no k.
    note: Option<String>,
    /// Whether it is beyond the caps.
    #[serde(skip)]
    too_deep: bool,
    /// Whether the two agree.
    agree: Option<bool>,
    /// How clearly k is decided.
    margin: Option<Margin>,
}

/// How clearly k is decided: the bound at k and at k − 1, as parts of the tolerance.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Margin {
    /// The bound at k divided by the tolerance: at most 1.
    at: Digits<17>,
    /// The bound at k − 1 divided by the tolerance: more than 1.
    before: Option<Digits<17>>,
}

/// A number in so many significant digits, where there is one.
fn digits(value: Option<&Number>, digits: u32) -> String {
    value.map_or_else(|| "·".to_owned(), |value| value.short(digits))
}

impl Quantity {
    fn of<V>(found: &float::Quantity<V>) -> Quantity
    where
        V: Real + Enclosed + PartialOrd,
        Number: for<'v> From<&'v V>,
    {
        Quantity {
            name: found.name.clone(),
            float: Float(found.value),
            exact: (&found.exact).into(),
            error: found.error.as_ref().map(|error| Text(error.into())),
            ulps: found.ulps.as_ref().map(|ulps| Digits(ulps.into())),
            bound: found.bound.map(Float),
            encloses: found.encloses(),
            tightness: found.tightness.and_then(|part| Float(part).number()).map(Digits),
        }
    }

    fn row(&self) -> Vec<String> {
        let Quantity { name, float, exact, error, ulps, bound, tightness, .. } = self;
        vec![
            name.clone(),
            shortest(float.0),
            exact.short(17),
            digits(error.as_ref().map(|Text(error)| error), 3),
            digits(ulps.as_ref().map(|Digits(ulps)| ulps), 3),
            bound.map_or_else(|| "·".to_owned(), |bound| bound.up(3)),
            digits(tightness.as_ref().map(|Digits(part)| part), 3),
        ]
    }
}

impl Depth {
    fn of(depth: &DepthDecision) -> Depth {
        let number = |value: &Rational| Digits(value.into());
        Depth {
            block: depth.block,
            tolerance: Text((&depth.tolerance).into()),
            logarithm: Float(depth.logarithm),
            float: depth.float,
            exact: depth.exact.as_ref().ok().copied(),
            note: depth.exact.as_ref().err().map(ToString::to_string),
            too_deep: depth.exact == Err(DepthError::TooDeep),
            agree: depth.agree,
            margin: depth.margin.as_ref().map(|margin| Margin {
                at: number(&margin.at),
                before: margin.before.as_ref().map(number),
            }),
        }
    }

    fn row(&self) -> Vec<String> {
        let none = if self.too_deep { "beyond the caps" } else { "none" };
        let level = |level: Option<u32>| level.map_or_else(|| none.to_owned(), |k| k.to_string());
        let margin = self.margin.as_ref().map(|Margin { at, before }| {
            let numbers = std::iter::once(at).chain(before);
            numbers.map(|Digits(part)| part.short(6)).collect::<Vec<String>>().join(", ")
        });
        vec![
            self.block.to_string(),
            self.tolerance.0.short(6),
            digits(self.logarithm.number().as_ref(), 6),
            level(self.float),
            level(self.exact),
            self.agree.map_or("·", |agree| if agree { "✓" } else { "✗" }).to_owned(),
            margin.unwrap_or_else(|| "·".to_owned()),
        ]
    }
}

impl Answer for Certification<'_> {
    const NAME: &'static str = "certify";

    fn sheet(&self) -> Sheet {
        let quantities = &self.quantities;
        let mut sheet = Sheet::titled(format!("{} in f64", self.scheme));
        sheet.notes(&self.notes);
        let header = ["quantity", "f64", "exact", "error", "ulps", "proven bound", "error/bound"];
        sheet.grid(Grid::of(header, quantities.iter().map(Quantity::row), 1));
        let outside = quantities.iter().filter(|q| q.encloses == Some(false)).count();
        let bounded = quantities.iter().filter(|q| q.bound.is_some()).count();
        sheet.text(format!(
            "{} {} of {bounded} errors lie within the bound proven in advance.",
            if outside == 0 { "✓" } else { "✗" },
            bounded - outside
        ));
        let Some(depths) = &self.depths else { return sheet };
        let header = ["c", "tolerance", "by logarithms", "k in f64", "k, exactly", "", "margin"];
        sheet.heading(2, "The least k with σβC^k/(1 − C) ≤ ε, C = T_c");
        sheet.grid(Grid::of(header, depths.iter().map(Depth::row), 0));
        sheet.text(
            "Margin: bound(k)/ε, at most 1, and bound(k−1)/ε, above 1; the nearer to 1, the nearer \
         k is to another. This k is the depth by a formula; `subcert depth` gives the number of \
         levels that is really needed.",
        );
        sheet
    }
}
