//! The program `subcert`: parses its arguments, runs a command, and turns the
//! outcome into an exit code.

mod cli;

fn main() -> std::process::ExitCode {
    cli::run()
}
