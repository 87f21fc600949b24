//! Certificates of what is said of constants that programs ship.

use super::block::{Block, words};
use super::{Certificate, Omission, VERSION};
use crate::audit::Word;
use crate::shipped::{Early, ProjectAudit, Reading, ShippedFinding, Verdict};

/// How fine the checker's enclosures have to be, beyond what the digits of a type ask for.
const BITS: u64 = 512;

/// The finest enclosures that the format knows.
const MAX_BITS: u64 = 20_000;

/// The certificate of the constants of a project.
///
/// ```
/// use subcert::certificate::project_certificate;
/// use subcert::diagnostic::SourceText;
/// use subcert::shipped::{audit_project, read_project};
///
/// let file = r#"
/// key = "mine"
/// project = { name = "Mine", repository = "local", commit = "0000000000000000000000000000000000000000", licence = "MIT" }
/// [[shipped]]
/// id = "third"
/// locus = "mine.c, third"
/// type = "f32"
/// equals = '1/3'
/// cells = ["0.33333334f"]
/// "#;
/// let project = read_project(&SourceText::new("mine.toml", file))?;
/// let text = project_certificate(&audit_project(&project)?).text;
/// assert!(text.starts_with("subcert-certificate 4\nproject mine\n"));
/// assert!(text.contains("\nshipped third\n  bits 512\n  cell \"0.33333334f\" nearest\n  outcome nearest\n"));
/// # Ok::<(), subcert::diagnostic::Errors>(())
/// ```
#[must_use]
pub fn project_certificate(audit: &ProjectAudit<'_>) -> Certificate {
    let project = audit.project;
    let mut text = format!("{VERSION}\nproject {}\n# {}\n", project.key, words(&project.name));
    let (mut blocks, mut omitted) = (0, Vec::new());
    for finding in &audit.findings {
        match block(finding).text() {
            Ok(lines) => {
                text.push_str(&lines);
                blocks += 1;
            }
            Err(why) => {
                let why = words(&why);
                text.extend(["# nothing of ", &finding.claim.id, ": ", &why, "\n"]);
                omitted.push(Omission { id: finding.id.clone(), why });
            }
        }
    }
    text.extend(["end ", &blocks.to_string(), "\n"]);
    Certificate { key: project.key.clone(), text, blocks, omitted }
}

fn block(finding: &ShippedFinding<'_>) -> Block {
    let claim = finding.claim;
    let mut block = Block::new("shipped", &claim.id);
    block.line(format!("bits {}", bits(finding)));
    if let Some(reading) = &finding.reading {
        block.line(match reading {
            // Certificates count from 1, as the claim file's reader does.
            Reading::Convention(number) => format!("convention {}", number + 1),
            Reading::Early(name, Early::Places(digits)) => format!("early {name} {digits}"),
            Reading::Early(name, Early::Cut(digits)) => format!("early {name} cut {digits}"),
            Reading::Early(name, Early::Single) => format!("early {name} single"),
        });
    }
    for (place, cell) in finding.cells.iter().enumerate() {
        let at = claim.at(place).into_iter().map(|(_, index)| format!("{index} "));
        let text = &claim.numbers[place].text;
        if text.contains(['"', '\\']) {
            block.give_up(format!("the number {text} has a quotation mark or a backslash"));
        }
        let at: String = at.collect();
        block.line(format!("cell {at}\"{text}\" {}", verdict(cell.verdict)));
    }
    block.line(format!("outcome {}", finding.outcome.word()));
    block
}

/// How fine enclosures have to be so that the verdicts of the numbers are decided: the least such number that the
/// audit itself has used, with a reserve.
fn bits(finding: &ShippedFinding<'_>) -> u64 {
    let deciding = if finding.cells.iter().any(|cell| cell.verdict == Verdict::Open) {
        MAX_BITS
    } else {
        BITS
    };
    deciding.min(MAX_BITS)
}

fn verdict(verdict: Verdict) -> String {
    match verdict {
        Verdict::Nearest => "nearest".to_owned(),
        Verdict::Rounded(digits) => format!("rounded {digits}"),
        Verdict::Cut(digits) => format!("cut {digits}"),
        Verdict::Ulps(units) => format!("ulps {units}"),
        Verdict::Misprint(slip) => format!("misprint {}", slip.name()),
        Verdict::Refuted(agree) => format!("refuted {agree}"),
        Verdict::Open => Word::Open.into(),
    }
}
