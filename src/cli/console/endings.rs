//! What the ending of a file says about the format of what is written into it.

use super::output::{Failure, Outcome};
use super::save::folder_of;
use crate::cli::arguments::{Command, FindingFormat, FindingOutput, Output};
use clap::ValueEnum;
use std::path::{Path, PathBuf};

/// Endings, and the names of formats.
const ENDINGS: [(&str, &str); 18] = [
    ("txt", "text"),
    ("json", "json"),
    ("md", "markdown"),
    ("csv", "csv"),
    ("tex", "latex"),
    ("html", "html"),
    ("htm", "html"),
    ("m", "matlab"),
    ("c", "c"),
    ("h", "c"),
    ("rs", "rust"),
    ("obj", "obj"),
    ("off", "off"),
    ("ply", "ply"),
    ("stl", "stl"),
    ("usda", "usda"),
    ("vtk", "vtk"),
    ("mesh", "medit"),
];

/// The one of these formats that the ending of a file names; none without a file or an ending.
pub(crate) fn format_of<F: ValueEnum>(
    file: Option<&Path>,
    formats: &[F],
) -> Result<Option<F>, Failure> {
    let Some((path, ending)) = ending_of(file) else { return Ok(None) };
    let known: Vec<(&str, &F)> = known(formats).collect();
    if let Some((_, format)) = known.iter().find(|(known, _)| ending.eq_ignore_ascii_case(known)) {
        return Ok(Some((*format).clone()));
    }
    let all: Vec<&str> = known.iter().map(|(known, _)| *known).collect();
    Err(unknown(path, &all, "; --format says what to write into a file of another ending"))
}

/// The endings of these formats.
fn known<F: ValueEnum>(formats: &[F]) -> impl Iterator<Item = (&'static str, &F)> {
    let named = |name: &str, format: &F| {
        format.to_possible_value().is_some_and(|value| value.get_name() == name)
    };
    ENDINGS.iter().filter_map(move |(ending, name)| {
        Some((*ending, formats.iter().find(|format| named(name, format))?))
    })
}

/// The ending of a file that is no folder, and is to be written.
fn ending_of(file: Option<&Path>) -> Option<(&Path, String)> {
    let path = file.filter(|path| path.as_os_str() != "-" && !path.is_dir())?;
    let ending = path.extension()?.to_string_lossy().into_owned();
    Some((path, ending))
}

fn unknown(path: &Path, endings: &[&str], more: &str) -> Failure {
    let endings: Vec<String> = endings.iter().map(|ending| format!(".{ending}")).collect();
    let endings = match &endings[..] {
        [one] => one.clone(),
        [all @ .., last] => format!("{} or {last}", all.join(", ")),
        [] => String::new(),
    };
    let path = path.display();
    Failure::Input(format!("`{path}`: name a file that ends in {endings}{more}"))
}

/// Lets the ending of the file decide the format, unless one is `given`, and refuses a file that cannot be written, before
/// anything is computed.
pub(crate) fn settle(command: &mut Command, given: bool) -> Outcome {
    match command {
        Command::Constants(command) => of_text(&mut command.output, given),
        Command::Coverage(command) => of_text(&mut command.output, given),
        Command::Range(command) => of_text(&mut command.output, given),
        Command::Spectrum(command) => of_text(&mut command.output, given),
        Command::Jsr(command) => of_text(&mut command.output, given),
        Command::Certify(command) => of_text(&mut command.output, given),
        Command::Schemes(command) => of_text(&mut command.output, given),
        Command::Flags(output) => of_text(output, given),
        Command::Explain(command) => of_finding(&mut command.output, given),
        Command::Depth(command) => of_finding(&mut command.output, given),
        Command::Scheme(command) => of_finding(&mut command.output, given),
        Command::Smoothness(command) => of_finding(&mut command.output, given),
        Command::Audit(command) => of_many(&mut command.format, command.file.as_ref(), given),
        Command::Atlas(command) => of_many(&mut command.format, command.file.as_ref(), given),
        Command::Oracle(command) => decide(&mut command.format, command.file.as_ref(), given),
        Command::Refine(command) => in_folder(command.output.file.as_ref()),
        Command::Limit(command) => in_folder(command.output.file.as_ref()),
        Command::Table(command) => in_folder(command.output.as_ref()),
        Command::Plot(command) => only("svg", command.file.as_ref()),
        Command::New(command) => only("toml", command.output.as_ref()),
        // These write into folders, which they make, or to the standard output alone.
        #[cfg(not(target_family = "wasm"))]
        Command::Serve(_) => Ok(()),
        Command::Errata(_)
        | Command::Prove(_)
        | Command::Completions { .. }
        | Command::Man { .. } => Ok(()),
        #[cfg(feature = "schema")]
        Command::Schemas { .. } => Ok(()),
    }
}

fn of_text(output: &mut Output, given: bool) -> Outcome {
    decide(&mut output.format, output.file.as_ref(), given)
}

fn of_finding(output: &mut FindingOutput, given: bool) -> Outcome {
    let file = output.file.as_ref();
    // A page in a file ends so, and otherwise a folder is named, which is made.
    let is_page = |(_, ending): (&Path, String)| ["html", "htm"].contains(&&*ending.to_lowercase());
    if output.is_page() && !ending_of(file.map(PathBuf::as_path)).is_some_and(is_page) {
        return Ok(());
    }
    decide(&mut output.format, file, given)
}

/// Of several findings, pages go into a folder, which is made, and no ending asks for them.
fn of_many(format: &mut FindingFormat, file: Option<&PathBuf>, given: bool) -> Outcome {
    if *format == FindingFormat::Html {
        return Ok(());
    }
    decide(format, file, given)?;
    match ending_of(file.map(PathBuf::as_path)).filter(|_| *format == FindingFormat::Html) {
        None => Ok(()),
        Some((path, _)) => {
            let formats: Vec<FindingFormat> = { FindingFormat::value_variants().iter().copied() }
                .filter(|format| *format != FindingFormat::Html)
                .collect();
            let more = ", or add --format html and name a folder for the pages with -o DIR";
            Err(unknown(path, &known(&formats).map(|(ending, _)| ending).collect::<Vec<_>>(), more))
        }
    }
}

fn decide<F: ValueEnum>(format: &mut F, file: Option<&PathBuf>, given: bool) -> Outcome {
    let path = file.map(PathBuf::as_path);
    if !given && let Some(found) = format_of(path, F::value_variants())? {
        *format = found;
    }
    in_folder(file)
}

/// A file of one form.
fn only(ending: &str, file: Option<&PathBuf>) -> Outcome {
    match ending_of(file.map(PathBuf::as_path)) {
        Some((path, other)) if !other.eq_ignore_ascii_case(ending) => {
            Err(unknown(path, &[ending], ", which is the only form that is written"))
        }
        _ => in_folder(file),
    }
}

/// Refuses a file in a folder that does not exist.
fn in_folder(file: Option<&PathBuf>) -> Outcome {
    let Some(path) = file.filter(|path| path.as_os_str() != "-") else { return Ok(()) };
    folder_of(path).map(|_| ()).map_err(|error| {
        Failure::Input(format!(
            "cannot write `{}`: {error}; name another file with -o FILE",
            path.display()
        ))
    })
}
