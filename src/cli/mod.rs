//! The command line: the only user of clap and of the standard output.

mod arguments;
mod atlas;
mod atlas_pages;
mod audit;
mod audit_output;
mod certified;
mod certify;
mod claim_files;
mod columns;
mod constants;
mod coverage;
mod csv;
mod curve;
mod depth;
mod errata;
mod explain;
mod finding;
mod flags;
mod forms;
mod geometry;
mod interrupt;
mod json;
mod jsr;
mod listing;
mod local_constants;
mod man;
mod mesh;
mod net;
mod new;
mod offset;
mod oracle;
mod output;
mod pages;
mod papers;
mod plot;
mod polygon;
mod progress;
mod projects;
mod prove;
mod radius;
mod range;
mod save;
#[cfg(feature = "schema")]
mod schemas;
mod scheme;
mod schemes;
mod sector;
mod sets;
mod smooth_map;
mod smooth_range;
mod smoothness;
mod solid;
mod spectrum;
mod table;
mod terminal;
mod vertex;
mod vertex_range;

use arguments::{Arguments, Command, grouped};
use clap::{CommandFactory as _, FromArgMatches as _};
use std::process::ExitCode;

/// The exit code of an internal fault.
const FAULT: i32 = 3;

/// Runs the program: 0 done, 1 a stated expectation failed, 2 bad usage or input,
/// 3 an internal fault.
pub(crate) fn run() -> ExitCode {
    let report = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        report(panic);
        std::process::exit(FAULT);
    }));
    let command = grouped(Arguments::command()).color(terminal::early_color(std::env::args_os()));
    let parsed = command.try_get_matches().and_then(|found| Arguments::from_arg_matches(&found));
    let arguments = match parsed {
        Ok(arguments) => arguments,
        Err(error) => {
            // Help and version come this way too, with exit code 0.
            let code = if error.use_stderr() { 2 } else { 0 };
            return match error.print() {
                Ok(()) => ExitCode::from(code),
                Err(_) => ExitCode::from(if code == 0 { output::BROKEN_PIPE } else { code }),
            };
        }
    };
    terminal::set(arguments.color, arguments.quiet);
    let result = match arguments.command {
        Command::Audit(command) => audit::audit(&command),
        Command::Explain(command) => explain::explain(&command),
        Command::Errata(command) => errata::errata(&command),
        Command::Coverage(command) => coverage::coverage(&command),
        Command::Constants(command) => constants::constants(&command),
        Command::Depth(command) => depth::depth(&command),
        Command::Range(command) => range::range(&command),
        Command::Smoothness(command) => smoothness::smoothness(&command),
        Command::Spectrum(command) => match command.sector {
            Some(faces) => sector::sector(&command, faces),
            None => spectrum::spectrum(&command),
        },
        Command::Table(command) => table::table(&command),
        Command::Jsr(command) => jsr::jsr(&command),
        Command::Certify(command) => certify::certify(&command),
        Command::Prove(command) => prove::prove(&command),
        Command::New(command) => new::new(&command),
        Command::Oracle(command) => oracle::oracle(&command),
        Command::Refine(command) => geometry::refine(&command),
        Command::Limit(command) => geometry::limit(&command),
        Command::Schemes(command) => schemes::schemes(&command),
        Command::Scheme(command) => scheme::scheme(&command),
        Command::Plot(command) => plot::plot(&command),
        Command::Atlas(command) => atlas::atlas(&command),
        Command::Flags(output) => flags::flags(&output),
        #[cfg(feature = "schema")]
        Command::Schemas { folder } => schemas::schemas(&folder),
        Command::Man { folder } => man::man(&folder),
        Command::Completions { shell } => man::completions(shell),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}
