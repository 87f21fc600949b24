//! `subcert certify`.

use crate::cli::arguments::CertifyArguments;
use crate::cli::console::output::{Failure, Outcome, positive, show};
use crate::cli::json::{SCHEMA, certify as form};
use std::fmt::Display;
use subcert::exact::{Enclosed, Real, format::short};
use subcert::float::{
    Certification, CertifyError, CertifyOptions, DepthDecision, LocalCertification, Quantity,
    certify as compare, certify_local_rules, exact, shortest,
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
    show(
        &arguments.output,
        || sheet(&arguments.scheme, &result),
        || form_of(&arguments.scheme, &result),
    )
}

/// The report on a ring, which has constants, and no formula for depths.
fn ring_certificate(ring: &LocalRules, arguments: &CertifyArguments) -> Outcome {
    if arguments.spread.is_some() || !arguments.tolerance.is_empty() {
        let message = "--tolerance and --spread ask for depths by a formula for masks; of a ring, \
                       `subcert depth` gives the exact depth";
        return Err(Failure::Input(message.to_owned()));
    }
    let result = certify_local_rules(ring, arguments.block.levels)
        .map_err(|error| Failure::Input(error.to_string()))?;
    let name = &arguments.scheme;
    show(&arguments.output, || head(name, &result.quantities), || ring_form(name, &result))
}

/// A number type that reports print.
trait Shown: Real + Enclosed + PartialOrd + Display {}

impl<V: Real + Enclosed + PartialOrd + Display> Shown for V {}

fn head<V: Shown>(name: &str, quantities: &[Quantity<V>]) -> Sheet {
    let mut sheet = Sheet::default();
    sheet.heading(1, format!("{name} in f64"));
    let header = ["quantity", "f64", "exact", "error", "ulps", "proven bound", "error/bound"];
    let rows = quantities.iter().map(quantity_row).collect();
    sheet.grid(Grid { header: header.map(str::to_owned).to_vec(), rows, left_columns: 1 });
    let outside = quantities.iter().filter(|q| q.encloses() == Some(false)).count();
    let bounded = quantities.iter().filter(|q| q.bound.is_some()).count();
    sheet.text(format!(
        "{} {} of {bounded} errors lie within the bound proven in advance.",
        if outside == 0 { "✓" } else { "✗" },
        bounded - outside
    ));
    sheet
}

fn sheet(name: &str, result: &Certification) -> Sheet {
    let mut sheet = head(name, &result.quantities);
    let header = ["c", "tolerance", "by logarithms", "k in f64", "k, exactly", "", "margin"];
    let rows = result.depths.iter().map(depth_row).collect();
    sheet.heading(2, "The least k with σβC^k/(1 − C) ≤ ε, C = T_c");
    sheet.grid(Grid { header: header.map(str::to_owned).to_vec(), rows, left_columns: 0 });
    sheet.text(
        "Margin: bound(k)/ε, at most 1, and bound(k−1)/ε, above 1; the nearer to 1, the nearer \
         k is to another. This k is the depth by a formula; `subcert depth` says how many levels it \
         takes indeed.",
    );
    sheet
}

fn quantity_row<V: Shown>(quantity: &Quantity<V>) -> Vec<String> {
    fn digits(value: Option<&impl Enclosed>) -> String {
        value.map_or_else(|| "·".to_owned(), |value| short(value, 3))
    }
    vec![
        quantity.name.clone(),
        shortest(quantity.value),
        short(&quantity.exact, 17),
        digits(quantity.error.as_ref()),
        digits(quantity.ulps.as_ref()),
        digits(quantity.bound.and_then(exact).as_ref()),
        digits(quantity.tightness.and_then(exact).as_ref()),
    ]
}

fn depth_row(depth: &DepthDecision) -> Vec<String> {
    let level = |level: Option<u32>| level.map_or_else(|| "none".to_owned(), |k| k.to_string());
    let margin = depth.margin.as_ref().map_or_else(
        || "·".to_owned(),
        |margin| {
            let before = margin.before.as_ref().map(|before| format!(", {}", short(before, 6)));
            format!("{}{}", short(&margin.at, 6), before.unwrap_or_default())
        },
    );
    vec![
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
    ]
}

fn quantity_form<V: Shown>(quantity: &Quantity<V>) -> form::Quantity<'_> {
    let tightness = quantity.tightness.and_then(exact);
    form::Quantity {
        name: &quantity.name,
        float: shortest(quantity.value),
        exact: quantity.exact.to_string(),
        decimal: short(&quantity.exact, 17),
        error: quantity.error.as_ref().map(V::to_string),
        ulps: quantity.ulps.as_ref().map(|ulps| short(ulps, 6)),
        bound: quantity.bound.map(shortest),
        encloses: quantity.encloses(),
        tightness: tightness.map(|tightness| short(&tightness, 6)),
    }
}

fn ring_form<'a>(name: &'a str, result: &'a LocalCertification) -> form::Certification<'a> {
    form::Certification {
        schema: SCHEMA,
        scheme: name,
        quantities: result.quantities.iter().map(quantity_form).collect(),
        depths: None,
        bounded_up_to_block: result.tracked_block,
    }
}

fn form_of<'a>(name: &'a str, result: &'a Certification) -> form::Certification<'a> {
    form::Certification {
        schema: SCHEMA,
        scheme: name,
        quantities: result.quantities.iter().map(quantity_form).collect(),
        depths: Some(result.depths.iter().map(depth_form).collect()),
        bounded_up_to_block: result.tracked_block,
    }
}

fn depth_form(depth: &DepthDecision) -> form::Depth {
    form::Depth {
        block: depth.block,
        tolerance: depth.tolerance.to_string(),
        logarithm: shortest(depth.logarithm),
        float: depth.float,
        exact: depth.exact.as_ref().ok().copied(),
        note: depth.exact.as_ref().err().map(ToString::to_string),
        agree: depth.agree,
        margin: depth.margin.as_ref().map(|margin| form::Margin {
            at: short(&margin.at, 17),
            before: margin.before.as_ref().map(|before| short(before, 17)),
        }),
    }
}
