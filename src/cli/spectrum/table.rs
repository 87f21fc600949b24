//! `subcert table`.

use super::ring::failure;
use crate::cli::arguments::TableArguments;
use crate::cli::console::output::{Failure, Outcome, note, write_results};
use crate::cli::console::progress::Progress;
use crate::cli::console::save::save;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use subcert::exact::Rational;
use subcert::facts::VALENCES;
use subcert::limit::Limit;
use subcert::report::html::shell_word;
use subcert::scheme::{
    AnyScheme, Mask, SchemeError, parse_algebraic, parse_any_scheme, parse_rules_of_valence,
};
use subcert::spectrum::table::{
    Language, Origin, RealType, Row, TableError, write_mask, write_sectors, write_without,
};
use subcert::spectrum::{Sector, SpectrumError, surroundings};

/// The most valences of a table.
const MAX_VALENCES: usize = 256;

pub(crate) fn table(arguments: &TableArguments) -> Outcome {
    let language = Language::from(arguments.format);
    let types = language.types();
    let real = arguments.real.map_or(types[0], RealType::from);
    if !types.contains(&real) {
        let message =
            format!("{} has no f64: leave out --type, or write --type f32", language.name());
        return Err(Failure::Input(message));
    }
    let text = match (arguments.valences, arguments.sectors) {
        (Some(valences), _) => of_valences(arguments, valences, language, real)?,
        (None, Some(sectors)) => of_sectors(arguments, sectors, language, real)?,
        (None, None) => of_mask(&arguments.scheme, language, real)?.ok_or_else(|| {
            let scheme = &arguments.scheme;
            Failure::Input(format!(
                "`{scheme}` has rules around one vertex or face: name the valences with --valences 3..12"
            ))
        })?,
    };
    let Some(path) = &arguments.output else { return write_results(&text) };
    save(path, &text)
        .map_err(|error| Failure::Input(format!("cannot write {}: {error}", path.display())))
}

fn of_valences(
    arguments: &TableArguments,
    (first, last): (usize, usize),
    language: Language,
    real: RealType,
) -> Result<String, Failure> {
    let count = (last - first).saturating_add(1);
    if count > MAX_VALENCES {
        let message = format!("--valences: {count} valences; a table has at most {MAX_VALENCES}");
        return Err(Failure::Input(message));
    }
    let done = Arc::new(AtomicU64::new(0));
    let progress = Progress::of_spectra(Arc::clone(&done), count, true);
    let text = ring_table(&arguments.scheme, (first, last), language, real, &|| {
        done.fetch_add(1, Ordering::Relaxed);
    });
    drop(progress);
    text.map_err(|error| match error {
        TableError::Spectrum(error) => failure(error),
        other => Failure::Input(other.to_string()),
    })
}

fn of_sectors(
    arguments: &TableArguments,
    (first, last): (usize, usize),
    language: Language,
    real: RealType,
) -> Result<String, Failure> {
    let (scheme, corner) = (&arguments.scheme, arguments.corner);
    // The last number is refused at once if it is too great.
    Sector::of(scheme, last, corner).map_err(failure)?;
    let sectors = (first..=last).map(|faces| Sector::of(scheme, faces, corner));
    let sectors = sectors.collect::<Result<Vec<Sector>, _>>().map_err(failure)?;
    let command = format!(
        "subcert table {scheme} --sectors {first}..{last}{} --format {} --type {}",
        if corner { " --corner" } else { "" },
        language.name(),
        type_name(real),
    );
    Ok(write_sectors(&sectors, language, real, &Origin { scheme, command: &command }))
}

/// The table of rules at these valences.
pub(crate) fn ring_table(
    scheme: &str,
    (first, last): (usize, usize),
    language: Language,
    real: RealType,
    done: &dyn Fn(),
) -> Result<String, TableError> {
    let (mut rows, mut left_out, mut error) = (Vec::new(), Vec::new(), None);
    for valence in first..=last {
        let row = surroundings(scheme, Some(valence)).map_err(TableError::from);
        match row.and_then(|rings| Row::of(&rings)) {
            Ok(row) => rows.push(row),
            // What is wrong with the scheme is wrong at all valences.
            Err(wrong @ TableError::Spectrum(SpectrumError::Scheme(_))) => return Err(wrong),
            Err(wrong) => {
                left_out.push((valence, wrong.to_string()));
                error.get_or_insert(wrong);
            }
        }
        done();
    }
    if let Some(error) = error.filter(|_| rows.is_empty()) {
        return Err(error);
    }
    for (valence, why) in &left_out {
        note(&format!("valence {valence} is left out: {why}"));
    }
    let command = format!(
        "subcert table {scheme} --valences {first}..{last} --format {} --type {}",
        language.name(),
        type_name(real),
    );
    write_without(&rows, &left_out, language, real, &Origin { scheme, command: &command })
}

fn type_name(real: RealType) -> &'static str {
    match real {
        RealType::F32 => "f32",
        RealType::F64 => "f64",
    }
}

/// The table of a mask; `None` of rules around a vertex or on a face.
pub(crate) fn of_mask(
    scheme: &str,
    language: Language,
    real: RealType,
) -> Result<Option<String>, Failure> {
    let command = format!(
        "subcert table {} --format {} --type {}",
        shell_word(scheme),
        language.name(),
        type_name(real)
    );
    let origin = Origin { scheme, command: &command };
    Ok(Some(match parse_any_scheme(scheme) {
        Ok(AnyScheme::LocalRules(_)) => return Ok(None),
        Ok(AnyScheme::Lattice(_)) => {
            return Err(SchemeError::Lattice { scheme: scheme.to_owned() }.into());
        }
        Ok(AnyScheme::Uniform(found)) => {
            let mask = Mask::try_from(found).map_err(|_| {
                Failure::Input(format!(
                    "`{scheme}` is a tensor product: its weights are products of those of its factors, one by one"
                ))
            })?;
            let limit = Limit::new(&mask).ok().and_then(|limit| limit.at(&Rational::zero()).ok());
            write_mask(&mask, limit.as_ref(), language, real, &origin)
        }
        Err(_) if { VALENCES }.any(|n| parse_rules_of_valence(scheme, Some(n)).is_ok()) => {
            return Ok(None);
        }
        Err(error) => {
            // What is wrong with the scheme is wrong in any field, but for roots.
            let mask = parse_algebraic(scheme).map_err(|_| error)?;
            write_mask(&mask, None, language, real, &origin)
        }
    }))
}
