//! `subcert oracle`.

use super::arguments::{BoundaryArgument, OracleArguments, OracleFormat};
use super::output::{Failure, Outcome, write};
use std::path::Path;
use subcert::diagnostic::{Diagnostic, SourceText, read_text};
use subcert::exact::{Rational, parse_rational};
use subcert::oracle::{
    Boundary, Control, LocalRequest, OracleError, OracleRequest, OracleValues, reference_values,
    ring_reference_values, to_csv, to_json,
};
use subcert::scheme::{AnyScheme, LocalRules, Scheme, parse_any_scheme};

/// The largest control polygon file that is read, in bytes.
const MAX_POLYGON_BYTES: u64 = 16 << 20;

/// How many points a seeded polygon has, when nobody says.
const SEEDED_POINTS: usize = 8;

pub(super) fn oracle(arguments: &OracleArguments) -> Outcome {
    let values = match parse_any_scheme(&arguments.scheme)? {
        AnyScheme::Uniform(scheme) => uniform(&scheme, arguments)?,
        AnyScheme::LocalRules(ring) => of_ring(&ring, arguments)?,
    };
    write(&match arguments.format {
        OracleFormat::Json => to_json(&values),
        OracleFormat::Csv => to_csv(&values),
    })
}

fn refused(error: &OracleError) -> Failure {
    Failure::Input(error.to_string())
}

fn uniform(scheme: &Scheme, arguments: &OracleArguments) -> Result<OracleValues, Failure> {
    let request = OracleRequest {
        scheme: arguments.scheme.clone(),
        max_block: arguments.block.levels,
        control: control(arguments, scheme)?,
        level: arguments.level,
        boundary: match arguments.boundary.unwrap_or(BoundaryArgument::Closed) {
            BoundaryArgument::Closed => Boundary::Closed,
            BoundaryArgument::Open => Boundary::Open,
        },
    };
    reference_values(scheme, &request).map_err(|error| refused(&error))
}

fn of_ring(ring: &LocalRules, arguments: &OracleArguments) -> Result<OracleValues, Failure> {
    let points = ring.point_count();
    if arguments.points.is_some() || arguments.boundary.is_some() {
        return Err(Failure::Input(format!(
            "--points and --boundary are for polygons; this ring has {points} points, and no ends"
        )));
    }
    let request = LocalRequest {
        scheme: arguments.scheme.clone(),
        max_block: arguments.block.levels,
        control: match &arguments.polygon {
            Some(path) => read_control(path, false)?,
            None => Control::seeded_polygon(arguments.seed, points),
        },
        level: arguments.level,
    };
    ring_reference_values(ring, &request).map_err(|error| refused(&error))
}

/// The control polygon or grid: from a file, or seeded.
fn control(arguments: &OracleArguments, scheme: &Scheme) -> Result<Control, Failure> {
    let surface = matches!(scheme, Scheme::Tensor(..));
    if let Some(path) = &arguments.polygon {
        return read_control(path, surface);
    }
    let (seed, points) = (arguments.seed, arguments.points.unwrap_or(SEEDED_POINTS));
    Ok(if surface {
        Control::seeded_grid(seed, points, points)
    } else {
        Control::seeded_polygon(seed, points)
    })
}

/// Reads exact numbers separated by commas or white space; `#` begins a comment.
/// For a surface, each line is a row.
fn read_control(path: &Path, surface: bool) -> Result<Control, Failure> {
    let name = path.display().to_string();
    let text = read_text(path, MAX_POLYGON_BYTES)
        .map_err(|reason| Failure::Input(format!("cannot read `{name}`: {reason}")))?;
    let source = SourceText::new(name, text);
    let mut rows: Vec<Vec<Rational>> = Vec::new();
    let mut start = 0;
    for line in source.text.split_inclusive('\n') {
        let numbers = line.split('#').next().unwrap_or_default();
        let mut row = Vec::new();
        let mut at = start;
        for piece in numbers.split(|c: char| c == ',' || c.is_whitespace()) {
            if !piece.is_empty() {
                let span = at..at + piece.len();
                row.push(parse_rational(piece).map_err(|error| {
                    Failure::from(Diagnostic::new(&source, span, error.to_string()))
                })?);
            }
            at += piece.len() + 1;
        }
        start += line.len();
        if row.is_empty() {
            continue;
        }
        if surface && rows.first().is_some_and(|first| first.len() != row.len()) {
            let span = start - line.len()..start;
            let message =
                format!("{} numbers in this row, and {} in the first", row.len(), rows[0].len());
            return Err(Failure::from(Diagnostic::new(&source, span, message)));
        }
        rows.push(row);
    }
    let columns = rows.first().map_or(0, Vec::len);
    let values: Vec<Rational> = rows.into_iter().flatten().collect();
    if values.is_empty() {
        return Err(Failure::from(
            Diagnostic::new(&source, 0..source.text.len(), "there is no number in this file")
                .with_help("write exact numbers such as 3, 0.25 or 1/3, separated by commas"),
        ));
    }
    if !surface {
        return Ok(Control::polygon(values));
    }
    let ragged = || Failure::Input("the rows have different lengths".to_owned());
    Control::grid(values, columns).ok_or_else(ragged)
}
