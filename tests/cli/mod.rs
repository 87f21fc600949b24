//! The program as a person runs it: real output, exit codes, bad input.

mod bad_input;
mod depth_bounds;
mod errors;
mod facts;
mod flags;
mod mesh_files;
mod meshes;
mod names;
mod nets;
mod new;
mod offset;
mod output;
mod own_file;
mod pages;
mod plot;
mod polygons;
mod projects;
mod readings;
mod serve;
mod smoothness;
mod solids;
mod spectrum;
mod tables;
mod terminal;
mod time;

use snapbox::cmd::{Command, cargo_bin};
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The program with these arguments, in the project's folder.
fn subcert<'a>(arguments: impl IntoIterator<Item = &'a str>) -> Command {
    Command::new(cargo_bin!("subcert"))
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .env_remove("CLICOLOR_FORCE")
        .env_remove("NO_COLOR")
        .env_remove("COLUMNS")
        .env_remove("LINES")
        .args(arguments)
}

/// Runs the program on bad input and gives its message.
fn refused<'a>(arguments: impl IntoIterator<Item = &'a str>) -> String {
    let assert = subcert(arguments).assert().code(2);
    let output = assert.get_output();
    let out = String::from_utf8_lossy(&output.stdout);
    assert!(out.is_empty(), "half-written: {out}");
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// What the program writes to the standard output when it succeeds.
fn written<'a>(arguments: impl IntoIterator<Item = &'a str>) -> String {
    let assert = subcert(arguments).assert().success();
    String::from_utf8_lossy(&assert.get_output().stdout).into_owned()
}

fn assert_parts(message: &str, parts: &[&str]) {
    for part in parts {
        assert!(message.contains(part), "no `{part}` in: {message}");
    }
}

/// A path for a test alone, which ends with this name: tests run side by side, and use the same names.
fn temporary(name: &str) -> PathBuf {
    static COUNT: AtomicUsize = AtomicUsize::new(0);
    let (process, count) = (std::process::id(), COUNT.fetch_add(1, Ordering::Relaxed));
    std::env::temp_dir().join(format!("subcert-{process}-{count}-{name}"))
}

/// A file with this text, which is gone when this is dropped.
struct TemporaryFile(PathBuf);

impl TemporaryFile {
    fn new(name: &str, text: &str) -> TemporaryFile {
        let path = temporary(name);
        std::fs::write(&path, text).expect("a temporary file");
        TemporaryFile(path)
    }

    fn path(&self) -> &str {
        self.0.to_str().expect("a UTF-8 path")
    }
}

impl Drop for TemporaryFile {
    fn drop(&mut self) {
        let _ = std::fs::remove_file(&self.0);
    }
}
