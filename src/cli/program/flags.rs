//! `subcert flags`: which command takes which flags, as clap knows them.

use crate::cli::arguments::{Arguments, Output};
use crate::cli::console::answer::{Answer, SCHEMA, show};
use crate::cli::console::output::Outcome;
use clap::CommandFactory as _;
use serde::Serialize;
use subcert::report::{Grid, Sheet};

/// The flags that every command has, and that stand in no row.
const EVERYWHERE: [&str; 5] = ["help", "version", "color", "quiet", "seconds"];

pub(crate) fn flags(output: &Output) -> Outcome {
    show(output, &Flags { schema: SCHEMA, commands: commands() })
}

/// The flags of all commands.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct Flags {
    /// The version of this form.
    schema: u32,
    /// The commands.
    commands: Vec<Command>,
}

/// A command with its flags.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Command {
    /// Its name.
    name: String,
    /// The long names of its flags, but for those that every command has.
    flags: Vec<String>,
    /// The values of `--format`.
    formats: Vec<String>,
}

impl Answer for Flags {
    const NAME: &'static str = "flags";

    fn sheet(&self) -> Sheet {
        let mut sheet = Sheet::titled("Flags of the commands");
        sheet.text(
            "Every command takes --help, --color, --quiet and --seconds too. A flag means the same wherever it stands.",
        );
        let row = |command: &Command| {
            let flags = command.flags.iter().map(|name| format!("--{name}"));
            let flags: Vec<String> = flags.collect();
            vec![command.name.clone(), flags.join(" "), command.formats.join(" ")]
        };
        let header = ["command", "flags", "values of --format"].map(str::to_owned);
        sheet.grid(Grid::of(header, self.commands.iter().map(row), 3));
        sheet
    }
}

/// The commands that are shown, in their order.
fn commands() -> Vec<Command> {
    let mut program = Arguments::command();
    program.build();
    let shown = program.get_subcommands().filter(|command| !command.is_hide_set());
    let shown = shown.filter(|command| command.get_name() != "help");
    shown
        .map(|command| {
            let named = command.get_arguments().filter_map(|flag| Some((flag, flag.get_long()?)));
            let own = named.filter(|(_, name)| !EVERYWHERE.contains(name));
            let flags: Vec<_> = own.collect();
            let format = flags.iter().find(|(_, name)| *name == "format");
            let values = format.map(|(flag, _)| flag.get_possible_values()).unwrap_or_default();
            Command {
                name: command.get_name().to_owned(),
                flags: flags.iter().map(|(_, name)| (*name).to_owned()).collect(),
                formats: values.iter().map(|value| value.get_name().to_owned()).collect(),
            }
        })
        .collect()
}
