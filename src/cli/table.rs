//! `subcert table`.

use super::arguments::TableArguments;
use super::output::{Failure, Outcome, write_results};
use super::progress::Progress;
use super::save::save;
use super::spectrum::failure;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use subcert::spectrum::surroundings;
use subcert::spectrum::table::{Language, Origin, Row, TableError, write};

/// The most valences of a table.
const MAX_VALENCES: usize = 256;

pub(super) fn table(arguments: &TableArguments) -> Outcome {
    let (first, last) = arguments.valences;
    let count = (last - first).saturating_add(1);
    if count > MAX_VALENCES {
        let message = format!("--valences: {count} valences; a table has at most {MAX_VALENCES}");
        return Err(Failure::Input(message));
    }
    let done = Arc::new(AtomicU64::new(0));
    let progress = Progress::of_spectra(Arc::clone(&done), count, true);
    let row = |valence: usize| {
        let row = Row::of(&surroundings(&arguments.scheme, Some(valence))?)?;
        done.fetch_add(1, Ordering::Relaxed);
        Ok(row)
    };
    let rows: Result<Vec<Row>, TableError> = (first..=last).map(row).collect();
    drop(progress);
    let language = Language::from(arguments.format);
    let command = format!(
        "subcert table {} --valences {first}..{last} --format {} --type {}",
        arguments.scheme,
        language.name(),
        if arguments.real == super::arguments::TypeArgument::F32 { "f32" } else { "f64" },
    );
    let origin = Origin { scheme: &arguments.scheme, command: &command };
    let text = rows
        .and_then(|rows| write(&rows, language, arguments.real.into(), &origin))
        .map_err(refused)?;
    let Some(path) = &arguments.output else { return write_results(&text) };
    save(path, &text)
        .map_err(|error| Failure::Input(format!("cannot write {}: {error}", path.display())))
}

fn refused(error: TableError) -> Failure {
    match error {
        TableError::Spectrum(error) => failure(error),
        other => Failure::Input(other.to_string()),
    }
}
