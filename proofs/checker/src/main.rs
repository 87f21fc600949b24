//! The program `subcert-check CLAIMS CERT…`. It prints a line for each claim and a last one with
//! the counts.

use std::io::Write;
use std::process::ExitCode;
use subcert_check::{Outcome, Reason, check};

const USAGE: &str = "usage: subcert-check [--only KIND-OR-ID]… [--accept WHAT]… CLAIMS CERTIFICATE…

Checks certificates against their claim file. It checks all claims, or with --only the claims of
a kind (table, equation, function, range, theorem) or with an id.
Valid claims pass. With --accept cited, claims pass that a statement of THEOREMS.md decides; with
--accept open, theorems pass that a certificate calls open. They are listed as such.
The exit code is 0 if all these claims pass, 1 if one does not, and 2 if a file cannot be read.";

/// Removes an option from the arguments and gives its values.
fn values(arguments: &mut Vec<String>, option: &str) -> Vec<String> {
    let mut values = Vec::new();
    while let Some(at) = arguments.iter().position(|argument| argument == option) {
        values.extend(arguments.drain(at..arguments.len().min(at + 2)).skip(1));
    }
    values
}

fn main() -> ExitCode {
    let mut arguments: Vec<String> = std::env::args().skip(1).collect();
    let only = values(&mut arguments, "--only");
    let accept = values(&mut arguments, "--accept");
    let files = arguments;
    let read = |path: &String| {
        std::fs::read_to_string(path).map_err(|error| format!("cannot read `{path}`: {error}"))
    };
    let run = || -> Result<bool, String> {
        let [claims, certificates @ ..] = &files[..] else { return Err(USAGE.to_owned()) };
        let accepts = |what: &str| accept.iter().any(|accepted| accepted == what);
        let known = accept.iter().all(|what| what == "cited" || what == "open");
        if !known || files.iter().any(|file| file.starts_with('-')) {
            return Err(USAGE.to_owned());
        }
        let claim_text = read(claims)?;
        let texts = certificates.iter().map(read).collect::<Result<Vec<String>, String>>()?;
        let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
        let report = check(&claim_text, &texts).map_err(|error| format!("`{claims}`: {error}"))?;
        let (mut lines, mut counts, mut open) = (Vec::new(), [0; 4], 0);
        for (place, rejection) in &report.broken {
            let path = &certificates[*place];
            lines.push(format!("invalid     {path}:{}: {}", rejection.line, rejection.reason));
            counts[2] += 1;
        }
        for (kind, id, outcome) in &report.claims {
            if !only.is_empty() && !only.iter().any(|name| name == kind || name == id) {
                continue;
            }
            let name = format!("{}:{id}", report.key);
            let (place, line) = match outcome {
                Outcome::Valid => (0, format!("valid       {name}")),
                Outcome::Cited(statement) => (1, format!("cited       {name}: {statement}")),
                Outcome::Invalid(at, rejection) => {
                    let (path, line) = (&certificates[*at], rejection.line);
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
        let [valid, cited, invalid, incomplete] = counts;
        lines.push(format!(
            "{valid} valid, {cited} cited, {invalid} invalid, {incomplete} incomplete"
        ));
        // A closed pipe is no failure of the check.
        let _ = writeln!(std::io::stdout(), "{}", lines.join("\n"));
        let mut left = invalid + incomplete;
        left += if accepts("cited") { 0 } else { cited };
        left -= if accepts("open") { open } else { 0 };
        Ok(valid + cited > 0 && left == 0)
    };
    match run() {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::from(1),
        Err(message) => {
            let _ = writeln!(std::io::stderr(), "{message}");
            ExitCode::from(2)
        }
    }
}
