//! What `subcert flags` writes.

use serde::Serialize;

/// The flags of all commands.
#[derive(Serialize)]
pub struct Flags<'a> {
    /// The version of this form.
    pub schema: u32,
    /// The commands.
    pub commands: &'a [Command],
}

/// A command with its flags.
#[derive(Serialize)]
pub struct Command {
    /// Its name.
    pub name: String,
    /// The long names of its flags, but for those that every command has.
    pub flags: Vec<String>,
    /// The values of `--format`.
    pub formats: Vec<String>,
}
