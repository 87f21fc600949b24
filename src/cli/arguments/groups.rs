//! The commands in groups, for the help text of the program.

use clap::Command;
use std::fmt::Write as _;

/// A title, an example, and commands.
type Group = (&'static str, &'static str, &'static [&'static str]);

/// The groups in their order. Every command stands in one of them at least.
const GROUPS: [Group; 5] = [
    (
        "Audit a paper, or the constants of a program",
        "subcert audit paper.toml",
        &["audit", "explain", "errata", "coverage", "new", "prove"],
    ),
    (
        "Look up a scheme",
        "subcert constants six-point:w=3/256",
        &[
            "schemes",
            "scheme",
            "atlas",
            "plot",
            "constants",
            "depth",
            "range",
            "smoothness",
            "spectrum",
            "jsr",
        ],
    ),
    (
        "Meshes, nets and solids",
        "subcert depth catmull-clark --mesh cube.obj --tolerance 1/100",
        &["depth", "refine", "limit"],
    ),
    (
        "For programs",
        "subcert oracle four-point --format csv",
        &["oracle", "table", "certify", "completions", "man", "help"],
    ),
    ("In a browser", "subcert serve", &["serve"]),
];

/// The blanks before what a command does.
const INDENT: usize = 15;

/// The columns of a line.
const WIDTH: usize = 96;

/// The command line of a program, with its commands in groups.
pub(in crate::cli) fn grouped(command: Command) -> Command {
    let mut built = command.clone();
    built.build();
    let mut text = String::from("{about}\n\n{usage-heading} {usage}\n");
    for (title, example, names) in GROUPS {
        writeln!(text, "\n{title} (`{example}`):").expect("a text in memory");
        for name in names {
            let found = built.find_subcommand(name).and_then(Command::get_about);
            let about = found.map(ToString::to_string).unwrap_or_default();
            let mut line = format!("  {name:<width$}", width = INDENT - 2);
            for word in about.split_whitespace() {
                if line.chars().count() + 1 + word.chars().count() > WIDTH {
                    writeln!(text, "{}", line.trim_end()).expect("a text in memory");
                    line = " ".repeat(INDENT);
                }
                if line.len() > INDENT {
                    line.push(' ');
                }
                line += word;
            }
            writeln!(text, "{}", line.trim_end()).expect("a text in memory");
        }
    }
    command.help_template(text + "\nOptions:\n{options}{after-help}")
}
