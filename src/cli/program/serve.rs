//! `subcert serve`: the page, on this machine alone, whose commands run here with all cores.
//!
//! The server listens on 127.0.0.1. Every path begins with a word that is drawn at random, which only who reads the terminal knows; so no
//! other page of the browser can ask for anything. Commands run in a folder of their own, with the files that the page has sent, and touch no others.

use crate::cli::arguments::ServeArguments;
use crate::cli::console::line::PREFIX;
use crate::cli::console::output::{Failure, Outcome, write};
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::hash::{BuildHasher as _, RandomState};
use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use subcert::files::{VARIABLE, is_confined};
use tempfile::NamedTempFile;
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
    "text/javascript": "address.js", "curve-canvas.js", "curve-data.js", "curve.js", "dom.js", "engine.js", "main.js", "mesh-data.js", "mesh-examples.js", "mesh-view.js", "mesh.js", "numbers.js", "paper-check.js", "paper-claims.js", "paper-editor.js", "paper-examples.js", "paper-places.js", "paper.js", "scheme-controls.js", "scheme-facts.js", "scheme-parse.js", "scheme-quick.js", "scheme.js", "wasi.js", "worker.js"
];

/// The most bytes of what the page sends.
const MAX_BYTES: u64 = 64 << 20;

/// The most requests that are answered at a time.
const MAX_REQUESTS: usize = 32;

/// The most runs that are stopped before they have begun.
const MAX_EARLY: usize = 64;

/// What the checker is told beside files.
const CHECKER_WORDS: [&str; 6] = ["--only", "--accept", "cited", "open", "--radius", "--depth"];

/// The commands that run, by the ids that the page gives them; `None` for one that was stopped before it has begun.
type Running = Arc<Mutex<BTreeMap<String, Option<Run>>>>;

/// A command that runs.
struct Run {
    child: Child,
    /// The last line of its progress.
    progress: String,
}

pub(crate) fn serve(arguments: &ServeArguments) -> Outcome {
    if is_confined() {
        return Err(Failure::Input("a command of the page opens no page".to_owned()));
    }
    let port = arguments.port;
    let wrong = |error| Failure::Input(format!("cannot listen on 127.0.0.1, port {port}: {error}"));
    let server = Server::http(("127.0.0.1", port)).map_err(|error| wrong(error.to_string()))?;
    let own = server.server_addr().to_ip().ok_or_else(|| wrong("no address".to_owned()))?;
    let word = word();
    let address = format!("http://{own}/{word}/");
    write(&format!("{address}\nCtrl-C ends it.\n"))?;
    // Without a browser the address is there all the same.
    let _door = (!arguments.no_open).then(|| door(&address).ok());
    let (running, busy) = (Running::default(), Arc::new(AtomicUsize::new(0)));
    for request in server.incoming_requests() {
        let (word, running, host) = (word.clone(), Arc::clone(&running), own.to_string());
        let busy = Arc::clone(&busy);
        if busy.fetch_add(1, Ordering::AcqRel) >= MAX_REQUESTS {
            busy.fetch_sub(1, Ordering::AcqRel);
            let _ = refuse(request, 503);
            continue;
        }
        std::thread::spawn(move || {
            // Who has gone away needs no answer.
            let _ = answer(request, &word, &host, &running);
            busy.fetch_sub(1, Ordering::AcqRel);
        });
    }
    Ok(())
}

/// Opens the page by a file that only this user may read: the arguments of programs, such as an address, are seen by all.
fn door(address: &str) -> std::io::Result<NamedTempFile> {
    let mut file = tempfile::Builder::new().prefix("subcert-").suffix(".html").tempfile()?;
    write!(file, "<!doctype html><meta http-equiv=\"refresh\" content=\"0; url={address}\">")?;
    open::that_detached(file.path())?;
    Ok(file)
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
            let response = Response::from_string(text).with_header(header("Content-Type", kind));
            request.respond(response.with_chunked_threshold(usize::MAX))
        }
        (Method::Post, "run") => {
            let Some(text) = body(&mut request, MAX_BYTES) else { return refuse(request, 413) };
            let said = match serde_json::from_str(&text) {
                Ok(asked) => run(&asked, running).unwrap_or_else(|problem| Said::failed(&problem)),
                Err(error) => Said::failed(&format!("the page asks for no command: {error}")),
            };
            json(request, &said)
        }
        (Method::Post, "stop" | "progress") => {
            let text = body(&mut request, MAX_ID + 64);
            let asked = text.and_then(|text| serde_json::from_str::<Known>(&text).ok());
            let Some(Known { id }) = asked else { return refuse(request, 400) };
            if name == "stop" {
                stop(id, running);
                return request.respond(Response::empty(204));
            }
            let running =
                lock(running).get(&id).and_then(|run| Some(run.as_ref()?.progress.clone()));
            json(request, &running.unwrap_or_default())
        }
        _ => refuse(request, 405),
    }
}

/// What was sent, if it is a text of at most so many bytes.
fn body(request: &mut Request, most: u64) -> Option<String> {
    let mut text = String::new();
    request.as_reader().take(most + 1).read_to_string(&mut text).ok()?;
    (text.len() as u64 <= most).then_some(text)
}

fn json(request: Request, said: &impl Serialize) -> Result<(), std::io::Error> {
    let text = serde_json::to_string(said).unwrap_or_default();
    let response =
        Response::from_string(text).with_header(header("Content-Type", "application/json"));
    request.respond(response.with_chunked_threshold(usize::MAX))
}

fn refuse(request: Request, code: u16) -> Result<(), std::io::Error> {
    request.respond(Response::empty(code))
}

fn header(name: &str, value: &str) -> Header {
    Header::from_bytes(name, value).expect("letters")
}

fn lock(running: &Running) -> MutexGuard<'_, BTreeMap<String, Option<Run>>> {
    running.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Ends a command, also one whose request comes after this.
fn stop(id: String, running: &Running) {
    let mut running = lock(running);
    let early = running.values().filter(|run| run.is_none()).count();
    match running.get_mut(&id) {
        // The thread that waits for it takes it out.
        Some(Some(run)) => drop(run.child.kill()),
        None if early < MAX_EARLY => drop(running.insert(id, None)),
        _ => {}
    }
}

/// The most bytes of the id of a run.
const MAX_ID: u64 = 64;

/// The run that the page stops, or asks about.
#[derive(Deserialize)]
struct Known {
    id: String,
}

/// What the page asks for.
#[derive(Deserialize)]
struct Asked {
    id: String,
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

/// Runs a command in a folder of its own. The program refuses all files that are not in it; the checker is told of the files that were sent alone.
fn run(asked: &Asked, running: &Running) -> Result<Said, String> {
    let program = program(&asked.program)?;
    let known = |text: &String| asked.files.contains_key(text) || CHECKER_WORDS.contains(&&**text);
    if asked.program != "subcert" && !asked.args.iter().all(known) {
        return Err(
            "the page has the checker check files that it has sent, and nothing else".to_owned()
        );
    }
    if asked.id.len() as u64 > MAX_ID {
        return Err(format!("the id of a run has at most {MAX_ID} bytes"));
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
    command.args(&asked.args).current_dir(folder.path()).stdin(Stdio::null());
    command.env("NO_COLOR", "1").env(VARIABLE, "1").stdout(Stdio::piped()).stderr(Stdio::piped());
    let (output, errors) = {
        let mut running = lock(running);
        match running.get(&asked.id) {
            Some(Some(_)) => return Err("there is a run with this id".to_owned()),
            Some(None) => {
                running.remove(&asked.id);
                return Err("stopped".to_owned());
            }
            None => {}
        }
        let mut child = command.spawn().map_err(failed)?;
        let pipes = (child.stdout.take(), child.stderr.take());
        running.insert(asked.id.clone(), Some(Run { child, progress: String::new() }));
        pipes
    };
    let (known, id) = (Arc::clone(running), asked.id.clone());
    let errors = std::thread::spawn(move || messages(errors, &known, &id));
    let output = text(output);
    if output.is_none() {
        stop(asked.id.clone(), running);
    }
    let errors = errors.join().unwrap_or_default();
    let run = lock(running).remove(&asked.id).flatten();
    let status = run.map(|mut run| run.child.wait()).transpose().map_err(failed)?;
    let code = status.and_then(|status| status.code()).unwrap_or(3);
    let long = || {
        format!(
            "the answer has more than {} MiB; run the command in a terminal, or take a lower level",
            MAX_BYTES >> 20
        )
    };
    let text = output.ok_or_else(long)?;
    let files = written(folder.path(), folder.path(), &asked.files).map_err(failed)?;
    Ok(Said { code, text, errors, files })
}

/// What comes from a pipe; nothing if it is too much.
fn text(pipe: Option<impl std::io::Read>) -> Option<String> {
    let mut bytes = Vec::new();
    if let Some(pipe) = pipe {
        let _ = pipe.take(MAX_BYTES + 1).read_to_end(&mut bytes);
    }
    (bytes.len() as u64 <= MAX_BYTES).then(|| String::from_utf8_lossy(&bytes).into_owned())
}

/// The messages of a run, up to a cap. Lines of progress are none: the last one stands with the run.
fn messages(pipe: Option<impl std::io::Read>, running: &Running, id: &str) -> String {
    let mut messages = String::new();
    let lines = pipe.map(|pipe| BufReader::new(pipe.take(MAX_BYTES)).split(b'\n'));
    for line in lines.into_iter().flatten().map_while(Result::ok) {
        let line = String::from_utf8_lossy(&line);
        match line.strip_prefix(PREFIX) {
            Some(progress) => {
                if let Some(Some(run)) = lock(running).get_mut(id) {
                    progress.clone_into(&mut run.progress);
                }
            }
            None => messages.extend([&*line, "\n"]),
        }
    }
    messages
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
