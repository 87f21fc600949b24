//! `subcert man` and `subcert completions`.

use crate::cli::arguments::Arguments;
use crate::cli::console::output::{Failure, Outcome, write, write_results};
use clap::CommandFactory as _;
use std::path::Path;
use subcert::files::permitted;

pub(crate) fn man(folder: &Path) -> Outcome {
    let command = Arguments::command();
    let written = permitted(folder)
        .and_then(|()| std::fs::create_dir_all(folder))
        .and_then(|()| clap_mangen::generate_to(command, folder));
    written.map_err(|error| {
        Failure::Input(format!("cannot write man pages to `{}`: {error}", folder.display()))
    })?;
    let folder = folder.display();
    write_results(&format!("{folder}: man pages of subcert and its commands\n"))
}

pub(crate) fn completions(shell: clap_complete::Shell) -> Outcome {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Arguments::command(), "subcert", &mut script);
    write(&String::from_utf8_lossy(&script))
}
