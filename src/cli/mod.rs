//! The command line: the only user of clap and of the standard output.

mod arguments;
mod console;
mod constants;
mod depth;
mod geometry;
mod papers;
mod program;
mod ranges;
mod schemes;
mod smoothness;
mod spectrum;

use arguments::{Arguments, Command, grouped, with_hint, with_masks};
use clap::parser::ValueSource;
use clap::{CommandFactory as _, FromArgMatches as _};
use console::output::{Failure, Outcome};
use console::{endings, interrupt, output, terminal};
use std::process::ExitCode;
use subcert::files::{VARIABLE, confine};

/// The exit code of an internal fault.
const FAULT: i32 = 3;

/// The exit code of bad usage or input, and of too little time.
const INPUT: i32 = 2;

/// Runs the program: 0 done, 1 a stated expectation failed, 2 bad usage or input, or too
/// little time, 3 an internal fault.
pub(crate) fn run() -> ExitCode {
    let report = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        report(panic);
        std::process::exit(FAULT);
    }));
    if std::env::var_os(VARIABLE).is_some() {
        confine();
    }
    let command = grouped(Arguments::command()).color(terminal::early_color(std::env::args_os()));
    let parsed = command.try_get_matches_from(with_masks(std::env::args_os())).and_then(|found| {
        let arguments = Arguments::from_arg_matches(&found)?;
        let given = found.subcommand().is_some_and(|(_, own)| {
            let ids = own.ids().any(|id| id == "format");
            ids && own.value_source("format") == Some(ValueSource::CommandLine)
        });
        let name = found.subcommand_name().unwrap_or_default().to_owned();
        Ok((arguments, given, name))
    });
    let (mut arguments, given, name) = match parsed {
        Ok(parsed) => parsed,
        Err(error) => {
            let typed: Vec<String> = std::env::args().collect();
            let error = with_hint(error, &typed);
            // Help and version come this way too, with exit code 0.
            let code = if error.use_stderr() { 2 } else { 0 };
            return match error.print() {
                Ok(()) => ExitCode::from(code),
                Err(_) => ExitCode::from(if code == 0 { output::BROKEN_PIPE } else { code }),
            };
        }
    };
    terminal::set(arguments.color, arguments.quiet);
    if let Err(failure) = endings::settle(&mut arguments.command, given) {
        return failure.report();
    }
    let seconds = arguments.seconds.or(arguments.command.seconds());
    let less = arguments.command.takes_less();
    let failure = move || given_up(&name, seconds, less);
    let late = failure.clone();
    let leave = move || {
        let _ = late().report();
        std::process::exit(INPUT);
    };
    let result = interrupt::within(seconds, leave, || done(arguments.command));
    match result.unwrap_or_else(|_| Err(failure())) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}

/// That a command had too little time.
fn given_up(name: &str, seconds: Option<u32>, less: &str) -> Failure {
    let seconds = interrupt::in_seconds(seconds.unwrap_or_default());
    Failure::Input(format!(
        "`subcert {name}` was given up after {seconds}, and has no answer; what takes less time: {less}"
    ))
}

/// Does what a command asks for.
fn done(command: Command) -> Outcome {
    match command {
        Command::Audit(command) => papers::audit(&command),
        Command::Explain(command) => papers::explain(&command),
        Command::Errata(command) => papers::errata(&command),
        Command::Coverage(command) => papers::coverage(&command),
        Command::Constants(command) => constants::constants(&command),
        Command::Depth(command) => depth::depth(&command),
        Command::Range(command) => ranges::range(&command),
        Command::Smoothness(command) => smoothness::smoothness(&command),
        Command::Spectrum(command) => match command.sector {
            Some(faces) => spectrum::sector(&command, faces),
            None => spectrum::spectrum(&command),
        },
        Command::Table(command) => spectrum::table(&command),
        Command::Jsr(command) => smoothness::jsr(&command),
        Command::Certify(command) => constants::certify(&command),
        Command::Prove(command) => papers::prove(&command),
        Command::New(command) => papers::new(&command),
        Command::Oracle(command) => geometry::oracle(&command),
        Command::Refine(command) => geometry::refine(&command),
        Command::Limit(command) => geometry::limit(&command),
        Command::Schemes(command) => schemes::schemes(&command),
        Command::Scheme(command) => schemes::scheme(&command),
        Command::Plot(command) => schemes::plot(&command),
        Command::Atlas(command) => schemes::atlas(&command),
        Command::Flags(output) => program::flags(&output),
        #[cfg(feature = "schema")]
        Command::Schemas { folder } => program::schemas(&folder),
        #[cfg(not(target_family = "wasm"))]
        Command::Serve(arguments) => program::serve(&arguments),
        Command::Man { folder } => program::man(&folder),
        Command::Completions { shell } => program::completions(shell),
    }
}
