//! `subcert serve`: the page, on this machine alone, whose commands run here with all cores.
//!
//! The server listens on 127.0.0.1. Every path begins with a word that is drawn at random, which only who reads the terminal knows; so no
//! other page of the browser can ask for anything. Commands run in a folder of their own, with the files that the page has sent.

use crate::cli::arguments::ServeArguments;
use crate::cli::console::output::{Failure, Outcome, write};
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::hash::{BuildHasher as _, RandomState};
use std::io::Read as _;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::sync::{Arc, Mutex, PoisonError};
use tiny_http::{Header, Method, Request, Response, Server};

macro_rules! page {
    ($($kind:literal: $($name:literal),+);+) => {
        &[$($(($name, include_str!(concat!("../../../web/", $name)), $kind)),+),+]
    };
}

/// The files of the page, with their types.
const FILES: &[(&str, &str, &str)] = page![
    "text/html; charset=utf-8": "page.html";
    "text/css": "style.css", "scheme.css", "curve.css", "mesh.css", "paper.css";
    "text/javascript": "address.js", "curve-canvas.js", "curve-data.js", "curve.js", "dom.js", "engine.js", "main.js", "mesh-data.js", "mesh-examples.js", "mesh-view.js", "mesh.js", "paper-check.js", "paper-claims.js", "paper-editor.js", "paper-examples.js", "paper-places.js", "paper.js", "scheme-controls.js", "scheme-facts.js", "scheme-parse.js", "scheme-quick.js", "scheme.js", "wasi.js", "worker.js"
];

/// The most bytes of what the page sends.
const MAX_BYTES: u64 = 64 << 20;

/// Commands that write beside the folder of the command, or start others.
const NOT_HERE: [&str; 3] = ["serve", "man", "completions"];

/// The command that runs.
type Running = Arc<Mutex<Option<Child>>>;

pub(crate) fn serve(arguments: &ServeArguments) -> Outcome {
    let port = arguments.port;
    let wrong = |error| Failure::Input(format!("cannot listen on 127.0.0.1, port {port}: {error}"));
    let server = Server::http(("127.0.0.1", port)).map_err(|error| wrong(error.to_string()))?;
    let own = server.server_addr().to_ip().ok_or_else(|| wrong("no address".to_owned()))?;
    let word = word();
    let address = format!("http://{own}/{word}/");
    write(&format!("{address}\nCtrl-C ends it.\n"))?;
    if !arguments.no_open {
        // Without a browser the address is there all the same.
        let _ = open::that_detached(&address);
    }
    let running = Running::default();
    for request in server.incoming_requests() {
        let (word, running, host) = (word.clone(), Arc::clone(&running), own.to_string());
        std::thread::spawn(move || {
            // Who has gone away needs no answer.
            let _ = answer(request, &word, &host, &running);
        });
    }
    Ok(())
}

/// A word that nobody guesses: 128 binary digits that come from the keys of hash tables, which the system draws.
fn word() -> String {
    let half = || RandomState::new().hash_one(0);
    format!("{:016x}{:016x}", half(), half())
}

fn answer(
    mut request: Request,
    word: &str,
    host: &str,
    running: &Running,
) -> Result<(), std::io::Error> {
    let is_here = |header: &&Header| header.field.equiv("Host");
    let named =
        request.headers().iter().find(is_here).map(|header| header.value.as_str().to_owned());
    let path = request.url().split('?').next().unwrap_or_default().to_owned();
    let own = path.strip_prefix('/').and_then(|path| path.strip_prefix(word));
    let own =
        own.and_then(|path| path.strip_prefix('/')).filter(|_| named.as_deref() == Some(host));
    let Some(name) = own.map(str::to_owned) else { return refuse(request, 404) };
    match (request.method(), &*name) {
        (Method::Get, _) => {
            let name = if name.is_empty() { "page.html" } else { &name };
            let Some((_, text, kind)) = FILES.iter().find(|(known, _, _)| *known == name) else {
                return refuse(request, 404);
            };
            let text = text.replacen("<html ", "<html data-served=\"yes\" ", 1);
            request.respond(Response::from_string(text).with_header(header("Content-Type", kind)))
        }
        (Method::Post, "run") => {
            let mut text = String::new();
            let read = request.as_reader().take(MAX_BYTES + 1).read_to_string(&mut text);
            if read.is_err() || text.len() as u64 > MAX_BYTES {
                return refuse(request, 413);
            }
            let said = match serde_json::from_str(&text) {
                Ok(asked) => run(&asked, running).unwrap_or_else(|problem| Said::failed(&problem)),
                Err(error) => Said::failed(&format!("the page asks for no command: {error}")),
            };
            let text = serde_json::to_string(&said).unwrap_or_default();
            let kind = header("Content-Type", "application/json");
            request.respond(Response::from_string(text).with_header(kind))
        }
        (Method::Post, "stop") => {
            if let Some(child) = &mut *lock(running) {
                let _ = child.kill();
            }
            request.respond(Response::empty(204))
        }
        _ => refuse(request, 405),
    }
}

fn refuse(request: Request, code: u16) -> Result<(), std::io::Error> {
    request.respond(Response::empty(code))
}

fn header(name: &str, value: &str) -> Header {
    Header::from_bytes(name, value).expect("letters")
}

fn lock(running: &Running) -> std::sync::MutexGuard<'_, Option<Child>> {
    running.lock().unwrap_or_else(PoisonError::into_inner)
}

/// What the page asks for.
#[derive(Deserialize)]
struct Asked {
    program: String,
    args: Vec<String>,
    files: BTreeMap<String, String>,
}

/// What a command says.
#[derive(Serialize)]
struct Said {
    code: i32,
    text: String,
    errors: String,
    files: BTreeMap<String, String>,
}

impl Said {
    fn failed(problem: &str) -> Said {
        let errors = format!("error: {problem}");
        Said { code: 2, text: String::new(), errors, files: BTreeMap::new() }
    }
}

/// Runs a command in a folder of its own.
fn run(asked: &Asked, running: &Running) -> Result<Said, String> {
    let program = program(&asked.program)?;
    let first = asked.args.first().map_or("", String::as_str);
    // A path that leads out of the folder.
    let leaves = |text: &String| {
        let values = [Some(&**text), text.split_once('=').map(|(_, value)| value)];
        values.into_iter().flatten().any(|path| {
            path.starts_with(['/', '~', '\\'])
                || path.contains(":\\")
                || path.split(['/', '\\']).any(|part| part == "..")
        })
    };
    if NOT_HERE.contains(&first) || asked.args.iter().any(leaves) {
        return Err("the page runs only commands on files that it has sent".to_owned());
    }
    let failed = |error: std::io::Error| format!("cannot run `{}`: {error}", asked.program);
    let folder = tempfile::tempdir().map_err(failed)?;
    for (name, content) in &asked.files {
        if Path::new(name).file_name() != Some(OsStr::new(name)) {
            return Err(format!("`{name}` is no name of a file"));
        }
        let bytes = STANDARD.decode(content).map_err(|error| format!("`{name}`: {error}"))?;
        std::fs::write(folder.path().join(name), bytes).map_err(failed)?;
    }
    let mut command = Command::new(program);
    command.args(&asked.args).current_dir(folder.path()).env("NO_COLOR", "1").stdin(Stdio::null());
    let mut child =
        command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().map_err(failed)?;
    let (output, errors) = (child.stdout.take(), child.stderr.take());
    *lock(running) = Some(child);
    let text = |pipe: Option<Box<dyn std::io::Read + Send>>| {
        let mut bytes = Vec::new();
        if let Some(mut pipe) = pipe {
            let _ = pipe.read_to_end(&mut bytes);
        }
        String::from_utf8_lossy(&bytes).into_owned()
    };
    let errors = std::thread::spawn(move || text(errors.map(|pipe| Box::new(pipe) as _)));
    let output = text(output.map(|pipe| Box::new(pipe) as _));
    let errors = errors.join().unwrap_or_default();
    let child = lock(running).take();
    let status = child.map(Child::wait_with_output).transpose().map_err(failed)?;
    let code = status.and_then(|Output { status, .. }| status.code()).unwrap_or(3);
    let files = written(folder.path(), folder.path(), &asked.files).map_err(failed)?;
    Ok(Said { code, text: output, errors, files })
}

/// The files that are in a folder and were not sent.
fn written(
    root: &Path,
    folder: &Path,
    sent: &BTreeMap<String, String>,
) -> std::io::Result<BTreeMap<String, String>> {
    let mut files = BTreeMap::new();
    for entry in std::fs::read_dir(folder)? {
        let path = entry?.path();
        let name = path.strip_prefix(root).unwrap_or(&path).to_string_lossy().replace('\\', "/");
        if path.is_dir() {
            files.extend(written(root, &path, sent)?);
        } else if !sent.contains_key(&name) {
            files.insert(name, STANDARD.encode(std::fs::read(&path)?));
        }
    }
    Ok(files)
}

/// This program, or the checker beside it.
fn program(name: &str) -> Result<PathBuf, String> {
    let own = std::env::current_exe().map_err(|error| error.to_string())?;
    match name {
        "subcert" => Ok(own),
        "subcert-check" => {
            let beside =
                own.with_file_name(format!("subcert-check{}", std::env::consts::EXE_SUFFIX));
            let missing = || {
                "there is no subcert-check beside this program: `cargo install subcert-check`, or build the workspace"
                    .to_owned()
            };
            beside.is_file().then_some(beside).ok_or_else(missing)
        }
        _ => Err(format!("`{name}` is no program of this page")),
    }
}
