//! What the program and the checker say of a file.

use crate::random_papers::naive::Q;
use subcert::audit::{PaperAudit, audit};
use subcert::certificate::certificate;
use subcert::claim::{Paper, read_paper};
use subcert::diagnostic::SourceText;
use subcert_check::{Outcome, Reason, Stop, check};

/// The claim file, read; or why the program refuses it.
pub fn read(text: &str) -> Result<Paper, String> {
    read_paper(&SourceText::new("random", text)).map_err(|error| error.to_string())
}

pub fn judged(paper: &Paper) -> Result<PaperAudit<'_>, String> {
    audit(paper).map_err(|error| error.to_string())
}

/// The certificate that the program writes; none if it refuses the file, or a formula in it.
pub fn written(text: &str) -> Option<String> {
    let paper = read(text).ok()?;
    let audit = judged(&paper).ok()?;
    Some(certificate(&audit).text)
}

/// A block of a certificate: kind, id and text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Block {
    pub kind: String,
    pub id: String,
    pub text: String,
}

/// The lines under which points are elsewhere than at i/n^k.
const PLACES: [&str; 2] = ["naturally", "in-every-shift"];

impl Block {
    /// The lines under the head, without the blanks before them.
    pub fn lines(&self) -> Vec<&str> {
        self.text.lines().skip(1).map(str::trim).collect()
    }

    /// What stands behind a word in the first line that begins with it.
    pub fn after(&self, word: &str) -> Option<&str> {
        self.lines().into_iter().find_map(|line| line.strip_prefix(word)?.strip_prefix(' '))
    }

    /// The last line.
    pub fn verdict(&self) -> &str {
        self.lines().last().copied().unwrap_or_default()
    }

    /// The lines about points at i/n^k, and those about points at their natural parameters and in every
    /// shift, if there are such, as blocks of their own; with the lines that they stand under.
    pub fn parts(&self) -> Vec<(&'static str, Block)> {
        let (mut parts, mut part, mut own) = (Vec::new(), Vec::new(), "");
        for line in self.lines() {
            match PLACES.iter().find(|word| **word == line) {
                Some(word) => {
                    parts.push((own, std::mem::take(&mut part)));
                    own = word;
                }
                None => part.push(line.to_owned()),
            }
        }
        parts.push((own, part));
        parts.into_iter().map(|(own, part)| (own, self.with_lines(&part))).collect()
    }

    /// The same block without what it says of points elsewhere.
    pub fn indexed(&self) -> Block {
        let lines = self.lines();
        let (Some(end), Some(verdict)) =
            (lines.iter().position(|line| PLACES.contains(line)), lines.last())
        else {
            return self.clone();
        };
        let kept = lines[..end].iter().chain([verdict]);
        self.with_lines(&kept.map(|line| (*line).to_owned()).collect::<Vec<String>>())
    }

    /// The same head with other lines.
    pub fn with_lines(&self, lines: &[String]) -> Block {
        let head = format!("{} {}\n", self.kind, self.id);
        let lines: Vec<String> = lines.iter().map(|line| format!("  {line}\n")).collect();
        Block { text: head + &lines.concat(), ..self.clone() }
    }
}

/// The blocks of a certificate.
pub fn blocks(certificate: &str) -> Vec<Block> {
    let mut blocks: Vec<Block> = Vec::new();
    for line in certificate.lines().skip(2).filter(|line| !line.starts_with('#')) {
        if line.starts_with(' ') {
            if let Some(block) = blocks.last_mut() {
                block.text += &format!("{line}\n");
            }
        } else if !line.starts_with("end ") {
            let (kind, id) = line.split_once(' ').expect("a head");
            let (kind, id) = (kind.to_owned(), id.to_owned());
            blocks.push(Block { kind, id, text: format!("{line}\n") });
        }
    }
    blocks
}

/// A certificate of these blocks.
pub fn bound(blocks: &[&Block]) -> String {
    let texts: String = blocks.iter().map(|block| &block.text[..]).collect();
    format!("subcert-certificate 4\npaper random\n{texts}end {}\n", blocks.len())
}

/// What the checker says of the claims that a certificate is about; or why it refuses the file.
pub fn checked(text: &str, certificate: &str) -> Result<Vec<(String, Outcome)>, String> {
    let report = check(text, &[certificate])?;
    let broken = report.broken.iter().map(|(_, rejection)| {
        ("the certificate".to_owned(), Outcome::Invalid(0, rejection.clone()))
    });
    let claims = report.claims.into_iter().map(|(_, id, outcome)| (id, outcome));
    Ok(broken.chain(claims).collect())
}

/// What the checker says of a single block.
pub fn accepts(text: &str, block: &Block) -> bool {
    let outcomes = checked(text, &bound(&[block])).unwrap_or_default();
    outcomes.contains(&(block.id.clone(), Outcome::Valid))
}

/// Whether a claim was left open for want of time or space, or since the program leaves it open.
pub fn left_open(outcome: &Outcome) -> bool {
    match outcome {
        Outcome::Incomplete(None) => true,
        Outcome::Incomplete(Some(why)) => {
            matches!(why.reason, Reason::Open | Reason::Stopped(Stop::Capped(_)))
        }
        _ => false,
    }
}

/// The exact values of the cells of the only table of a file; where there is none, 1/3.
pub fn cells(text: &str, count: usize) -> Vec<Q> {
    let third = || Q::new(1.into(), 3.into());
    let values = read(text).and_then(|paper| {
        let audit = judged(&paper)?;
        let cells = audit.tables[0].cells.iter().flatten().map(|cell| {
            let value = cell.exact.as_ref().and_then(|exact| exact.as_rational())?;
            value.to_string().parse::<Q>().ok()
        });
        Ok(cells.map(|value| value.unwrap_or_else(third)).collect())
    });
    values.unwrap_or_else(|_| vec![third(); count])
}
