//! `subcert certify`.

use super::Outcome;
use super::arguments::CertifyArguments;
use super::output::{Failure, positive, show};
use serde_json::{Value, json};
use subcert::exact::{Rational, format::short};
use subcert::float::{
    Certification, CertifyError, CertifyOptions, DepthDecision, Quantity, certify as compare,
    exact, shortest,
};
use subcert::report::{Grid, Sheet};
use subcert::scheme::parse_scheme;

pub(super) fn certify(arguments: &CertifyArguments) -> Outcome {
    let scheme = parse_scheme(&arguments.scheme)?;
    let mut options = CertifyOptions {
        max_block: arguments.block.levels,
        spread: positive("--spread", &arguments.spread.spread)?,
        ..CertifyOptions::default()
    };
    if !arguments.tolerance.is_empty() {
        let read = |text: &String| positive("--tolerance", text);
        options.tolerances = arguments.tolerance.iter().map(read).collect::<Result<_, _>>()?;
    }
    let result = compare(&scheme, &options)
        .map_err(|error: CertifyError| Failure::Input(error.to_string()))?;
    show(
        arguments.output.format,
        || sheet(&arguments.scheme, &result),
        || json_of(&arguments.scheme, &result),
    )
}

fn sheet(name: &str, result: &Certification) -> Sheet {
    let mut sheet = Sheet::default();
    sheet.heading(1, format!("{name} in f64"));
    let header = ["quantity", "f64", "exact", "error", "ulps", "proven bound", "error/bound"];
    let rows = result.quantities.iter().map(quantity_row).collect();
    sheet.grid(Grid { header: header.map(str::to_owned).to_vec(), rows, left_columns: 1 });
    let outside = result.quantities.iter().filter(|q| q.encloses() == Some(false)).count();
    let bounded = result.quantities.iter().filter(|q| q.bound.is_some()).count();
    sheet.text(format!(
        "{} {} of {bounded} errors lie within the bound proven in advance.",
        if outside == 0 { "✓" } else { "✗" },
        bounded - outside
    ));
    let header = ["c", "tolerance", "by logarithms", "f64 depth", "exact depth", "", "margin"];
    let rows = result.depths.iter().map(depth_row).collect();
    sheet.heading(2, "Depths σβC^k/(1 − C) ≤ ε, one power of C = T_c for each k");
    sheet.grid(Grid { header: header.map(str::to_owned).to_vec(), rows, left_columns: 0 });
    sheet.text(
        "Margin: bound(k)/ε, at most 1, and bound(k−1)/ε, above 1; the nearer to 1, the nearer \
         the depth is to another.",
    );
    sheet
}

fn quantity_row(quantity: &Quantity) -> Vec<String> {
    let digits = |value: &Option<Rational>| {
        value.as_ref().map_or_else(|| "·".to_owned(), |value| short(value, 3))
    };
    vec![
        quantity.name.clone(),
        shortest(quantity.value),
        short(&quantity.exact, 17),
        digits(&quantity.error),
        digits(&quantity.ulps),
        digits(&quantity.bound.and_then(exact)),
        digits(&quantity.tightness.and_then(exact)),
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

fn json_of(name: &str, result: &Certification) -> Value {
    let text = |value: &Option<Rational>| value.as_ref().map(Rational::to_string);
    let quantities = result.quantities.iter().map(|quantity| {
        json!({
            "name": quantity.name,
            "f64": shortest(quantity.value),
            "exact": quantity.exact.to_string(),
            "decimal": short(&quantity.exact, 17),
            "error": text(&quantity.error),
            "ulps": quantity.ulps.as_ref().map(|ulps| short(ulps, 6)),
            "bound": quantity.bound.map(shortest),
            "encloses": quantity.encloses(),
            "tightness": quantity.tightness.and_then(exact).map(|tightness| short(&tightness, 6)),
        })
    });
    let depths = result.depths.iter().map(|depth| {
        json!({
            "block": depth.block,
            "tolerance": depth.tolerance.to_string(),
            "logarithm": shortest(depth.logarithm),
            "f64": depth.float,
            "exact": depth.exact.as_ref().ok(),
            "note": depth.exact.as_ref().err().map(ToString::to_string),
            "agree": depth.agree,
            "margin": depth.margin.as_ref().map(|margin| json!({
                "at": short(&margin.at, 17),
                "before": margin.before.as_ref().map(|before| short(before, 17)),
            })),
        })
    });
    json!({
        "schema": 1,
        "scheme": name,
        "quantities": quantities.collect::<Vec<Value>>(),
        "depths": depths.collect::<Vec<Value>>(),
        "bounded_up_to_block": result.tracked_block,
    })
}
