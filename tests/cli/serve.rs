//! `serve`: the page and its commands, for nobody else.

use super::temporary;
use serde_json::{Value, json};
use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::net::TcpStream;
use std::process::{Child, Command, Stdio};
use std::time::Duration;

/// A server, which ends with this.
struct Server {
    child: Child,
    host: String,
    word: String,
}

impl Drop for Server {
    fn drop(&mut self) {
        self.child.kill().expect("it runs");
        self.child.wait().expect("it ends");
    }
}

impl Server {
    fn start() -> Server {
        let mut command = Command::new(snapbox::cmd::cargo_bin!("subcert"));
        command.args(["serve", "--no-open"]).stdout(Stdio::piped());
        let mut child = command.spawn().expect("a program");
        let mut line = String::new();
        let output = child.stdout.take().expect("a pipe");
        BufReader::new(output).read_line(&mut line).expect("a line");
        let address = line.trim().strip_prefix("http://").expect("an address");
        let (host, word) = address.split_once('/').expect("a path");
        let word = word.trim_end_matches('/').to_owned();
        Server { host: host.to_owned(), word, child }
    }

    /// The code and the body of an answer.
    fn ask(&self, method: &str, path: &str, host: &str, body: &str) -> (u16, String) {
        let mut stream = TcpStream::connect(&self.host).expect("it listens");
        let length = body.len();
        let text = format!(
            "{method} {path} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\nContent-Length: {length}\r\n\r\n{body}"
        );
        stream.write_all(text.as_bytes()).expect("it reads");
        let mut answer = Vec::new();
        stream.read_to_end(&mut answer).expect("it answers");
        let answer = String::from_utf8(answer).expect("text");
        let (head, body) = answer.split_once("\r\n\r\n").expect("a head");
        (head[9..12].parse().expect("a code"), body.to_owned())
    }

    fn get(&self, name: &str) -> (u16, String) {
        self.ask("GET", &format!("/{}/{name}", self.word), &self.host, "")
    }

    fn run(&self, args: &[&str], files: &Value) -> Value {
        self.run_as("one", "subcert", args, files)
    }

    fn run_as(&self, id: &str, program: &str, args: &[&str], files: &Value) -> Value {
        let asked = json!({ "id": id, "program": program, "args": args, "files": files });
        let (code, body) = self.post("run", &asked);
        assert_eq!(code, 200, "{body}");
        serde_json::from_str(&body).expect("JSON")
    }

    fn post(&self, name: &str, asked: &Value) -> (u16, String) {
        self.ask("POST", &format!("/{}/{name}", self.word), &self.host, &asked.to_string())
    }
}

/// Whether a name is that of a part of the page.
fn is_part(name: &str) -> bool {
    let end = name.rsplit_once('.').map(|(_, end)| end);
    name != "index.html" && end.is_some_and(|end| ["html", "css", "js"].contains(&end))
}

#[test]
fn the_page_and_its_commands() {
    let server = Server::start();
    let (code, page) = server.get("");
    assert!(code == 200 && page.contains("data-served=\"yes\""), "{page}");
    let mut count = 0;
    for entry in std::fs::read_dir("web").expect("a folder") {
        let name = entry.expect("an entry").file_name().into_string().expect("UTF-8");
        if is_part(&name) {
            let text = std::fs::read_to_string(format!("web/{name}")).expect("text");
            let (code, served) = server.get(&name);
            assert_eq!(code, 200, "{name}");
            assert!(name == "page.html" || served == text, "{name} is another one");
            count += 1;
        }
    }
    assert!(count > 5);
    let said = server.run(&["constants", "chaikin", "-c", "1", "--format", "json"], &json!({}));
    assert_eq!((&said["code"], &said["errors"]), (&json!(0), &json!("")), "{said}");
    let own = super::written(["constants", "chaikin", "-c", "1", "--format", "json"]);
    assert_eq!(said["text"], json!(own));
    // `[1, 3, 3, 1]/4`, as a file.
    let file = json!({ "own.toml": "bmFtZSA9ICdvJwptYXNrID0gJ1sxLCAzLCAzLCAxXS80Jwo=" });
    let said = server.run(&["plot", "own.toml", "-o", "o.svg"], &file);
    assert_eq!(said["code"], json!(0), "{said}");
    assert!(
        said["files"]["o.svg"].is_string() && said["files"].as_object().expect("files").len() == 1
    );
}

#[test]
fn nobody_else_is_served() {
    let server = Server::start();
    for path in
        ["/", "/run", "/page.html", &format!("/{}", server.word), &format!("/x{}/", server.word)]
    {
        assert_eq!(server.ask("GET", path, &server.host, "").0, 404, "{path}");
    }
    // A name of another host that leads to this address.
    let page = format!("/{}/", server.word);
    assert_eq!(server.ask("GET", &page, "example.org", "").0, 404);
    assert_eq!(server.get("../Cargo.toml").0, 404);
    assert_eq!(server.ask("DELETE", &page, &server.host, "").0, 405);
    let refused = |args: &[&str], files: &Value| {
        let said = server.run(args, files);
        assert_eq!(said["code"], json!(2), "{said}");
        said["errors"].as_str().expect("text").to_owned()
    };
    // Paths that lead out of the folder, also within schemes, claim files and after short flags.
    let secret = temporary("secret.toml");
    std::fs::write(&secret, "secret_token = 1\n").expect("a file");
    let path = secret.to_str().expect("UTF-8");
    let product = format!("chaikin x {path}");
    let blank = format!(" {path}");
    let glued = format!("-o{path}");
    for args in [
        &["plot", "chaikin", "-o", path][..],
        &["plot", "chaikin", "-o", "../x.svg"],
        &["plot", "chaikin", &glued],
        &["-q", "man", path],
        &["errata", "-o", path],
        &["new", "k", "-o", path],
        &["smoothness", path],
        &["smoothness", &product],
        &["smoothness", &blank],
        &["smoothness", "chaikin x ../x.toml"],
        &["depth", "chaikin", "--polygon", path],
        &["audit", path],
        &["-q", "serve", "--no-open"],
    ] {
        let said = refused(args, &json!({}));
        assert!(!said.contains("secret_token"), "{args:?}: {said}");
    }
    let kept = std::fs::read_to_string(&secret).expect("it is there");
    assert_eq!(kept, "secret_token = 1\n");
    std::fs::remove_file(&secret).expect("it is there");
    let checker = |args: &[&str]| {
        let said = server.run_as("two", "subcert-check", args, &json!({}));
        said["errors"].as_str().expect("text").to_owned()
    };
    let said = checker(&["/etc/passwd", "/etc/passwd"]);
    assert!(said.contains("nothing else") || said.contains("there is no subcert-check"), "{said}");
    for name in ["../x", "/x", "a/b", "..", ""] {
        assert!(
            refused(&["schemes"], &json!({ name: "" })).contains("no name of a file"),
            "{name}"
        );
    }
    assert!(refused(&["constants", "nonsense"], &json!({})).contains("unknown scheme"));
}

/// What takes several seconds.
const LONG: [&str; 6] = ["range", "butterfly-regular", "--param", "w", "--smoothness", "1"];

/// A run ends when it is stopped, and none that comes after it, whichever request is read first.
#[test]
fn runs_are_stopped_one_by_one() {
    let server = Server::start();
    std::thread::scope(|scope| {
        let run = scope.spawn(|| server.run_as("long", "subcert", &LONG, &json!({})));
        let quick = ["constants", "chaikin", "-c", "1"];
        for _ in 0..5 {
            assert_eq!(server.run_as("quick", "subcert", &quick, &json!({}))["code"], json!(0));
        }
        assert_eq!(server.post("stop", &json!({ "id": "long" })).0, 204);
        assert_eq!(run.join().expect("an answer")["code"], json!(3));
    });
    assert_eq!(server.post("stop", &json!({ "id": "later" })).0, 204);
    let said = server.run_as("later", "subcert", &LONG, &json!({}));
    assert_eq!((&said["code"], &said["text"]), (&json!(2), &json!("")), "{said}");
    assert_eq!(server.post("stop", &json!("nonsense")).0, 400);
}

/// While a run goes on, the page learns how far it is; this is no part of its messages.
#[test]
fn a_run_says_how_far_it_is() {
    let server = Server::start();
    std::thread::scope(|scope| {
        let run = scope.spawn(|| server.run_as("long", "subcert", &LONG, &json!({})));
        let asked = json!({ "id": "long" });
        let progress = loop {
            assert!(!run.is_finished(), "the run took no time");
            let (code, said) = server.post("progress", &asked);
            assert_eq!(code, 200, "{said}");
            if said != "\"\"" {
                break said;
            }
            std::thread::sleep(Duration::from_millis(50));
        };
        assert!(progress.contains("searching"), "{progress}");
        assert_eq!(server.post("progress", &json!({ "id": "other" })), (200, "\"\"".to_owned()));
        server.post("stop", &asked);
        let said = run.join().expect("an answer");
        assert!(!said["errors"].as_str().expect("text").contains("searching"), "{said}");
    });
}

/// The examples in the page are those of the folder, word for word.
#[test]
fn examples_of_the_page() {
    let page = std::fs::read_to_string("web/paper-examples.js").expect("text");
    for name in ["first-paper", "my-paper"] {
        let text = std::fs::read_to_string(format!("examples/{name}.toml")).expect("text");
        let written = text.replace('\\', "\\\\").replace('`', "\\`").replace("${", "\\${");
        assert!(page.contains(&format!("text: `{written}`")), "{name}");
    }
}
