//! `subcert jsr`.

use super::radius::{
    apart, between, product_text, radius_form, root_text, upper_text, write_certificate,
};
use crate::cli::arguments::JsrArguments;
use crate::cli::console::output::{Failure, Outcome, show};
use crate::cli::console::progress::Progress;
use crate::cli::json::{SCHEMA, smoothness as form};
use subcert::certificate::radius_certificate;
use subcert::diagnostic::read_text;
use subcert::exact::{Rational, parse_rational};
use subcert::joint::{JointRadius, MatrixSet, joint_radius};
use subcert::report::Sheet;

/// The largest file of matrices, in bytes.
const MAX_BYTES: u64 = 1 << 20;

pub(crate) fn jsr(arguments: &JsrArguments) -> Outcome {
    let path = arguments.file.display().to_string();
    let text = read_text(&arguments.file, MAX_BYTES)
        .map_err(|reason| Failure::Input(format!("cannot read `{path}`: {reason}")))?;
    let set = read(&text).map_err(|reason| Failure::Input(format!("{path}: {reason}")))?;
    let progress = Progress::of_search(true);
    let radius = joint_radius(&set);
    drop(progress);
    if let Some(path) = &arguments.certificate {
        write_certificate(path, radius_certificate(&set, &radius))?;
    }
    show(
        &arguments.output,
        || sheet(&path, &set, &radius),
        || form::JointRadius {
            schema: SCHEMA,
            file: &path,
            radius: radius_form(&set, None, &radius),
        },
    )
}

/// Matrices: one row on a line, the numbers separated by blanks or commas, and an empty line between two
/// matrices. What follows `#` is a comment.
fn read(text: &str) -> Result<MatrixSet, String> {
    let mut matrices: Vec<Vec<Vec<Rational>>> = vec![Vec::new()];
    for (number, line) in (1..).zip(text.lines()) {
        let numbers = line.split('#').next().unwrap_or_default();
        let is_comment = numbers.len() < line.len();
        let words = numbers.split(|c: char| c.is_whitespace() || c == ',');
        let words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
        let last = matrices.last_mut().expect("at least one");
        if !words.is_empty() {
            let row = words.iter().map(|word| {
                parse_rational(word).map_err(|error| format!("line {number}: `{word}`: {error}"))
            });
            last.push(row.collect::<Result<Vec<Rational>, String>>()?);
        } else if !is_comment && !last.is_empty() {
            matrices.push(Vec::new());
        }
    }
    matrices.retain(|matrix| !matrix.is_empty());
    MatrixSet::new(matrices).map_err(|error| {
        format!("{error}. Write one row on a line, and an empty line between two matrices")
    })
}

fn sheet(path: &str, set: &MatrixSet, radius: &JointRadius) -> Sheet {
    let mut sheet = Sheet::default();
    sheet.heading(1, format!("{path}: the joint spectral radius"));
    let size = set.size();
    let mut facts =
        vec![("matrices".to_owned(), format!("{}, {size}×{size}", set.matrices().len()))];
    match &radius.hull {
        None => {
            facts.push(("ϱ".to_owned(), format!("0: every product of {size} factors is 0")));
        }
        Some(hull) => {
            let low = radius.root_enclosure();
            facts.push(("ϱ".to_owned(), between(low.lower(), &radius.upper())));
            facts.push((
                "at least".to_owned(),
                format!("{}: of the product {}", root_text(radius), product_text(radius, "M")),
            ));
            facts.push(("at most".to_owned(), upper_text(size, radius, hull)));
        }
    }
    sheet.facts(facts);
    if !radius.exact {
        sheet.text(apart(""));
    }
    sheet
}
