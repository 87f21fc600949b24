//! The program `subcert-check CLAIMS CERT…`. It prints a line for each claim and a last one with
//! the counts.

use std::fmt::Display;
use std::io::{Read, Write};
use std::process::ExitCode;
use subcert_check::{
    Agreement, DepthRejection, Outcome, RadiusRejection, Reason, Rejection, Report, check,
    check_depth, check_radius, check_theorems,
};

const USAGE: &str = "usage: subcert-check [--only KIND-OR-ID]… [--accept WHAT]… CLAIMS CERTIFICATE…
       subcert-check --radius CERTIFICATE…
       subcert-check --depth CERTIFICATE…
       subcert-check --coq CLAIMS [CERTIFICATE…] THEOREMS.v…

Checks certificates against their claim file. It checks all claims, or with --only the claims of
a kind (table, equation, relation, function, range, smoothness, exponent, theorem, shipped) or with
an id (theorem-1 or KEY:theorem-1).
Certified claims pass: their verdict is shown, which may be that they are wrong. With --accept
cited, claims pass that a statement of THEOREMS.md decides; with --accept open, theorems pass
that a certificate calls open, and relations of which it tries some cases. They are listed as such.
With --radius, the files are certificates of joint spectral radii and of smoothness, which need no
claim file; a line says what each proves.
With --depth, the files are certificates of how many levels a control polygon or a net needs as a set of
points; they need no claim file either.
With --coq, files of theorems in Coq, whose names end in .v, are compared with the claim file: masks,
numbers, levels and places. The certificates give the values of parameters that the paper does not
state. Whether the theorems are true, Coq checks.
The exit code is 0 if all these claims pass, 1 if one does not, and 2 if the arguments are wrong or
a file cannot be read. --help shows this, --version the version.";

/// The most bytes of a file: no certificate may be longer.
const MAX_BYTES: u64 = 64 << 20;

/// The text of a file.
fn read(path: &String) -> Result<String, String> {
    let wrong = |error| format!("cannot read `{path}`: {error}");
    let file = std::fs::File::open(path).map_err(wrong)?;
    let mut bytes = Vec::new();
    // The size that the system says is no bound: there are files without an end.
    file.take(MAX_BYTES + 1).read_to_end(&mut bytes).map_err(wrong)?;
    if bytes.len() as u64 > MAX_BYTES {
        return Err(format!(
            "cannot read `{path}`: this is beyond a cap of the checker: 64 MiB of a file"
        ));
    }
    String::from_utf8(bytes).map_err(|_| format!("cannot read `{path}`: it is no text in UTF-8"))
}

/// The arguments of the program.
#[derive(Default)]
struct Arguments {
    only: Vec<String>,
    accept: Vec<String>,
    files: Vec<String>,
}

impl Arguments {
    fn read(mut arguments: impl Iterator<Item = String>) -> Result<Arguments, String> {
        let mut read = Arguments::default();
        while let Some(argument) = arguments.next() {
            let values = match &argument[..] {
                "--only" => &mut read.only,
                "--accept" => &mut read.accept,
                _ if argument.starts_with('-') => {
                    return Err(format!("`{argument}` is no option\n{USAGE}"));
                }
                _ => {
                    read.files.push(argument);
                    continue;
                }
            };
            let value = arguments.next().filter(|value| !value.starts_with('-'));
            values.push(value.ok_or(format!("`{argument}` needs a value\n{USAGE}"))?);
        }
        if read.files.is_empty() {
            return Err(USAGE.to_owned());
        }
        match read.accept.iter().find(|what| !["cited", "open"].contains(&&what[..])) {
            Some(what) => Err(format!("`--accept {what}`: only cited or open\n{USAGE}")),
            None => Ok(read),
        }
    }

    fn accepts(&self, what: &str) -> bool {
        self.accept.iter().any(|accepted| accepted == what)
    }

    /// Checks the certificates and prints the outcomes. Gives whether all claims pass.
    fn run(&self) -> Result<bool, String> {
        let (claims, certificates) = (&self.files[0], &self.files[1..]);
        let claim_text = read(claims)?;
        let (is, instead) = match claim_text.split_whitespace().next() {
            Some("subcert-certificate") => (
                "a certificate, and the claim file that it is about has to stand before it",
                "CLAIMS.toml",
            ),
            Some("subcert-radius") => {
                ("about a joint spectral radius, which needs no claim file", "--radius")
            }
            Some("subcert-depth") => ("about a depth, which needs no claim file", "--depth"),
            _ => ("", ""),
        };
        if !is.is_empty() {
            return Err(format!("`{claims}` is {is}: subcert-check {instead} {claims}"));
        }
        let texts = certificates.iter().map(read).collect::<Result<Vec<String>, String>>()?;
        let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
        let report = check(&claim_text, &texts).map_err(|error| format!("`{claims}`: {error}"))?;
        self.check_selection(&report)?;
        Ok(self.show(&report))
    }

    /// Checks that every `--only` names something.
    fn check_selection(&self, report: &Report) -> Result<(), String> {
        let names = |name: &&String| {
            report.claims.iter().any(|(kind, id, _)| is_named(name, &report.key, kind, id))
        };
        match self.only.iter().find(|name| !names(name)) {
            Some(name) => {
                Err(format!("`--only {name}`: no claim of `{}` is so called", report.key))
            }
            None => Ok(()),
        }
    }

    fn show(&self, report: &Report) -> bool {
        let (mut lines, mut counts, mut open) = (Vec::new(), [0; 4], 0);
        for (place, rejection) in &report.broken {
            let path = &self.files[place + 1];
            lines.push(format!("invalid     {path}:{}: {}", rejection.line, rejection.reason));
            counts[2] += 1;
        }
        for (kind, id, outcome) in &report.claims {
            let asked = |name: &String| is_named(name, &report.key, kind, id);
            if !self.only.is_empty() && !self.only.iter().any(asked) {
                continue;
            }
            let name = format!("{}:{id}", report.key);
            let verdict = report.verdicts.get(id).map_or("", String::as_str);
            let (place, line) = match outcome {
                Outcome::Valid => (0, format!("certified   {name}: {verdict}")),
                Outcome::Cited(by) => (1, format!("cited       {name}: {verdict}, says {by}")),
                Outcome::Invalid(at, rejection) => {
                    let (path, line) = (&self.files[at + 1], rejection.line);
                    (2, format!("invalid     {name}: {path}:{line}: {}", rejection.reason))
                }
                Outcome::Incomplete(Some(rejection)) => {
                    open += usize::from(rejection.reason == Reason::Open);
                    (3, format!("incomplete  {name}: {}", rejection.reason))
                }
                Outcome::Incomplete(None) => (3, format!("incomplete  {name}: no certificate")),
            };
            lines.push(line);
            counts[place] += 1;
        }
        let [certified, cited, invalid, incomplete] = counts;
        lines.push(format!(
            "{certified} certified, {cited} cited, {invalid} invalid, {incomplete} incomplete"
        ));
        // A closed pipe is no failure of the check.
        let _ = writeln!(std::io::stdout(), "{}", lines.join("\n"));
        let mut left = invalid + incomplete;
        left += if self.accepts("cited") { 0 } else { cited };
        left -= if self.accepts("open") { open } else { 0 };
        certified + cited > 0 && left == 0
    }
}

/// Whether `name` means a claim: by its kind, by its id, or as the lines print it.
fn is_named(name: &str, key: &str, kind: &str, id: &str) -> bool {
    let own = |rest: &str| rest.strip_prefix(':') == Some(id);
    name == kind || name == id || name.strip_prefix(key).is_some_and(own)
}

/// Checks certificates that stand alone; `check` gives the outcome and what follows the file in its line.
fn alone(flag: &str, paths: &[String], check: impl Fn(&str) -> (&'static str, String)) -> ExitCode {
    let mut code = if paths.is_empty() { 2 } else { 0 };
    for path in paths {
        let text = match read(path) {
            Err(message) => {
                let _ = writeln!(std::io::stderr(), "{message}");
                code = 2;
                continue;
            }
            Ok(text) => text,
        };
        let (outcome, said) = check(&text);
        if outcome != "certified" {
            code = code.max(1);
        }
        let _ = writeln!(std::io::stdout(), "{outcome:<12}{path}{said}");
    }
    if paths.is_empty() {
        let _ = writeln!(std::io::stderr(), "`{flag}` needs a file\n{USAGE}");
    }
    ExitCode::from(code)
}

/// The outcome of a certificate that stands alone, and what is said of it.
fn said<R: Display>(
    checked: Result<impl Display, Rejection<R>>,
    given_up: fn(&Rejection<R>) -> bool,
) -> (&'static str, String) {
    match checked {
        Ok(proved) => ("certified", format!(": {proved}")),
        Err(rejection) => {
            let outcome = if given_up(&rejection) { "incomplete" } else { "invalid" };
            (outcome, format!(":{}: {}", rejection.line, rejection.reason))
        }
    }
}

/// Compares files of theorems of Coq with their claim file. Gives whether all agree.
fn theorems(paths: &[String]) -> Result<bool, String> {
    let is_theorems =
        |path: &&String| std::path::Path::new(path).extension().is_some_and(|ending| ending == "v");
    let (files, others): (Vec<&String>, Vec<&String>) = paths.iter().partition(is_theorems);
    let [claims, certificates @ ..] = &others[..] else {
        return Err(format!("`--coq` needs a claim file and theorems\n{USAGE}"));
    };
    if files.is_empty() {
        return Err(format!("`--coq` needs a file whose name ends in .v\n{USAGE}"));
    }
    let texts = |paths: &[&String]| paths.iter().map(|it| read(it)).collect::<Result<Vec<_>, _>>();
    let (certificates, theorems) = (texts(certificates)?, texts(&files)?);
    let certificates: Vec<&str> = certificates.iter().map(String::as_str).collect();
    let theorems: Vec<&str> = theorems.iter().map(String::as_str).collect();
    let compared = check_theorems(&read(claims)?, &certificates, &theorems);
    let compared = compared.map_err(|error| format!("`{claims}`: {error}"))?;
    let (mut agreeing, mut count) = (0, 0);
    for (path, compared) in files.iter().zip(&compared) {
        let line = match compared {
            Ok(Agreement { id, theorems, recovered, .. }) => {
                (agreeing, count) = (agreeing + 1, count + theorems);
                let values = recovered.iter().map(|(name, value)| format!(", {name} = {value}"));
                format!(
                    "agrees      {path}: {id}, {theorems} theorems{}",
                    values.collect::<String>()
                )
            }
            Err(Rejection { line, reason }) => format!("differs     {path}:{line}: {reason}"),
        };
        // A closed pipe is no failure of the check.
        let _ = writeln!(std::io::stdout(), "{line}");
    }
    let all = files.len();
    let said = format!("{count} theorems in {agreeing} of {all} files agree with the claim file");
    let _ = writeln!(std::io::stdout(), "{said}");
    Ok(agreeing == all)
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let has = |flags: [&str; 2]| arguments.iter().any(|argument| flags.contains(&&argument[..]));
    let asked = match () {
        () if has(["-h", "--help"]) => Some(USAGE),
        () if has(["-V", "--version"]) => {
            Some(concat!("subcert-check ", env!("CARGO_PKG_VERSION")))
        }
        () => None,
    };
    if let Some(text) = asked {
        let _ = writeln!(std::io::stdout(), "{text}");
        return ExitCode::SUCCESS;
    }
    let radius = |text: &str| said(check_radius(text), RadiusRejection::given_up);
    let depth = |text: &str| said(check_depth(text), DepthRejection::given_up);
    let outcome = match arguments.first() {
        Some(first) if first == "--radius" => return alone(first, &arguments[1..], radius),
        Some(first) if first == "--depth" => return alone(first, &arguments[1..], depth),
        Some(first) if first == "--coq" => theorems(&arguments[1..]),
        _ => Arguments::read(arguments.into_iter()).and_then(|arguments| arguments.run()),
    };
    match outcome {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::from(1),
        Err(message) => {
            let _ = writeln!(std::io::stderr(), "{message}");
            ExitCode::from(2)
        }
    }
}
