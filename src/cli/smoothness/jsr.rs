//! `subcert jsr`.

use super::radius::{Radius, apart, write_certificate};
use crate::cli::arguments::JsrArguments;
use crate::cli::console::answer::{Answer, SCHEMA, show};
use crate::cli::console::interrupt::Interrupt;
use crate::cli::console::output::{Failure, Outcome};
use crate::cli::console::progress::Progress;
use serde::Serialize;
use subcert::certificate::radius_certificate;
use subcert::diagnostic::read_text;
use subcert::exact::{Rational, parse_rational};
use subcert::joint::{MatrixSet, joint_radius_until};
use subcert::report::Sheet;
use subcert::stop::Stop;

/// The largest file of matrices, in bytes.
const MAX_BYTES: u64 = 1 << 20;

pub(crate) fn jsr(arguments: &JsrArguments) -> Outcome {
    let file = &*arguments.file.display().to_string();
    let text = read_text(&arguments.file, MAX_BYTES)
        .map_err(|reason| Failure::Input(format!("cannot read `{file}`: {reason}")))?;
    let set = read(&text).map_err(|reason| Failure::Input(format!("{file}: {reason}")))?;
    let progress = Progress::of_search(true);
    let stop = Stop::default();
    let interrupt = Interrupt::stops_search(&stop);
    let radius = joint_radius_until(&set, &stop);
    drop((interrupt, progress));
    if let Some(path) = &arguments.certificate {
        write_certificate(path, radius_certificate(&set, &radius))?;
    }
    let radius = Radius::of(&set, 'M', None, &radius);
    show(&arguments.output, &JointRadius { schema: SCHEMA, file, radius })
}

/// What `subcert jsr` writes.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct JointRadius<'a> {
    /// The version of this form.
    schema: u32,
    /// The file.
    file: &'a str,
    /// The radius.
    #[serde(flatten)]
    radius: Radius,
}

impl Answer for JointRadius<'_> {
    const NAME: &'static str = "jsr";

    fn sheet(&self) -> Sheet {
        let JointRadius { file, radius, .. } = self;
        let mut sheet = Sheet::titled(format!("{file}: the joint spectral radius"));
        let size = radius.size;
        let mut facts =
            vec![("matrices".to_owned(), format!("{}, {size}×{size}", radius.matrices.len()))];
        if radius.at_most.is_some() {
            facts.extend(radius.facts());
        } else {
            facts.push(("ϱ".to_owned(), format!("0: every product of {size} factors is 0")));
        }
        sheet.facts(facts);
        if !radius.exact {
            sheet.text(apart("", radius));
        }
        sheet
    }
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
