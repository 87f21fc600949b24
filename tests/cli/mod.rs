//! The program as a person runs it: real output, exit codes, bad input.

mod bad_input;
mod output;

use snapbox::cmd::{Command, cargo_bin};

/// The program with these arguments, in the project's folder.
fn subcert<'a>(arguments: impl IntoIterator<Item = &'a str>) -> Command {
    Command::new(cargo_bin!("subcert"))
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .env_remove("CLICOLOR_FORCE")
        .env_remove("NO_COLOR")
        .args(arguments)
}
