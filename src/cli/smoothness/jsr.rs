//! `subcert jsr`.

use super::radius::{Radius, apart, write_certificate};
use crate::cli::arguments::JsrArguments;
use crate::cli::console::answer::{Answer, SCHEMA, show};
use crate::cli::console::interrupt::Interrupt;
use crate::cli::console::output::{Failure, Outcome, positive};
use crate::cli::console::progress::Progress;
use crate::cli::console::quantity::Text;
use serde::Serialize;
use subcert::certificate::radius_certificate;
use subcert::diagnostic::read_text;
use subcert::exact::{Rational, parse_rational};
use subcert::joint::{MatrixSet, joint_radius_below, joint_radius_until};
use subcert::report::Sheet;
use subcert::stop::Stop;

/// The largest file of matrices, in bytes.
const MAX_BYTES: u64 = 1 << 20;

pub(crate) fn jsr(arguments: &JsrArguments) -> Outcome {
    let file = &*arguments.file.display().to_string();
    let text = read_text(&arguments.file, MAX_BYTES)
        .map_err(|reason| Failure::Input(format!("cannot read `{file}`: {reason}")))?;
    let set = read(&text).map_err(|reason| Failure::Input(format!("{file}: {reason}")))?;
    let goal = arguments.below.as_ref().map(|below| positive("--below", below)).transpose()?;
    let progress = Progress::of_search(true);
    let stop = Stop::default();
    let interrupt = Interrupt::stops_search(&stop);
    let radius = match &goal {
        Some(goal) => joint_radius_below(&set, goal, &stop),
        None => joint_radius_until(&set, &stop),
    };
    drop((interrupt, progress));
    if let Some(path) = &arguments.certificate {
        write_certificate(path, radius_certificate(&set, &radius))?;
    }
    let below = goal.map(|goal| Below { holds: radius.is_below(&goal), goal: Text(goal) });
    let radius = Radius::of(&set, 'M', None, &radius);
    show(&arguments.output, &JointRadius { schema: SCHEMA, file, below, radius })
}

/// What `subcert jsr` writes.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct JointRadius<'a> {
    /// The version of this form.
    schema: u32,
    /// The file.
    file: &'a str,
    /// What `--below` asked for; absent without it.
    #[serde(skip_serializing_if = "Option::is_none")]
    below: Option<Below>,
    /// The radius.
    #[serde(flatten)]
    radius: Radius,
}

/// Whether the radius is below a number.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Below {
    /// The number.
    goal: Text<Rational>,
    /// Whether it is; null where that is open.
    holds: Option<bool>,
}

impl Answer for JointRadius<'_> {
    const NAME: &'static str = "jsr";

    fn sheet(&self) -> Sheet {
        let JointRadius { file, below, radius, .. } = self;
        let mut sheet = Sheet::titled(format!("{file}: the joint spectral radius"));
        let size = radius.size;
        let mut facts =
            vec![("matrices".to_owned(), format!("{}, {size}×{size}", radius.matrices.len()))];
        if radius.at_most.is_some() {
            facts.extend(radius.facts());
        } else {
            facts.push(("ϱ".to_owned(), format!("0: every product of {size} factors is 0")));
        }
        if let Some(Below { goal, holds }) = below {
            let said = match holds {
                Some(true) => "yes",
                Some(false) => "no",
                None => "open",
            };
            facts.push((format!("ϱ < {}", goal.0), said.to_owned()));
        }
        sheet.facts(facts);
        let decided = below.as_ref().is_some_and(|below| below.holds.is_some());
        if !radius.exact && !decided {
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
