#!/usr/bin/env python3
"""Tries the recipe of CONTRIBUTING.md, «A kind of claim».

In a copy of the tree it adds the kind `[[total]]`: the coefficients of a mask sum to a printed number. The copy is
compiled, a small paper with a right and a wrong claim is audited and certified, and the checker has to accept the
certificate and refuse an altered one. Prints the files that were touched, and how many of them are code. It fails where
these are more than MOST, and where the text that an insertion stands at is gone.

    python3 .ci/toy_kind.py            # all of this, in target/toy or CARGO_TARGET_DIR
    python3 .ci/toy_kind.py --list     # only the files
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
CLAIMS, REPORTS, CHECKER = "src/claims", "src/reports", "proofs/checker/src/kinds"
TARGET = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target" / "toy")).absolute()
# The crates that Cargo.toml optimises in this profile.
OPTIMISED = [f"subcert-{name}" for name in ["numbers", "schemes", "geometry", "claims", "check"]]
# The most files of code, and of all.
MOST = (17, 19)

NEW = {
    f"{CLAIMS}/claim/total.rs": """\
//! Sums of coefficients.

use super::table::{LocatedReference, Printed};

/// The coefficients of a mask sum to a printed number.
#[derive(Clone, Debug, PartialEq)]
pub struct Total {
    /// Its id within the paper.
    pub id: String,
    /// Where it stands.
    pub locus: String,
    /// Its statement, in words.
    pub title: String,
    /// The scheme.
    pub scheme: LocatedReference,
    /// The sum.
    pub sum: Printed,
    /// A note for the reader.
    pub note: Option<String>,
}
""",
    f"{CLAIMS}/claim/read/total.rs": """\
//! Reading sums of coefficients.

use super::fields::{NumberField, claim_table};
use super::kind::{ClaimTable, Formulas, Named, Placed, of_reference};
use super::reader::{Head, Reader};
use crate::claim::{Paper, Total};
use crate::diagnostic::Diagnostic;
use crate::scheme::Spanned;

claim_table!(TotalTable {
    /// The sum.
    sum: Spanned<NumberField>,
});

impl ClaimTable for TotalTable {
    fn names(&self) -> Vec<(&str, Named)> {
        Vec::new()
    }

    fn read(&self, reader: &Reader<'_>, paper: &mut Paper) -> Result<(), Diagnostic> {
        let Head { id, locus, title, scheme, note } = reader.head(self.common())?;
        let Some(scheme) = scheme else {
            let error = reader.error(self.id.span(), "a sum is that of a mask, and `scheme` is missing");
            return Err(error.with_help("scheme = \\"chaikin\\""));
        };
        let sum = reader.printed(&self.sum)?;
        paper.totals.push(Total { id, locus, title, scheme, sum, note });
        Ok(())
    }
}

impl Formulas for Total {
    fn formulas(&self) -> Vec<Placed<'_>> {
        of_reference(&self.scheme).collect()
    }
}
""",
    f"{CLAIMS}/finding/total.rs": """\
//! The finding about a sum of coefficients.

use super::judgement::{Harm, Judgement};
use crate::claim::Total;
use crate::exact::Rational;
use crate::verdict::Word;

/// The finding about a sum of coefficients.
#[derive(Clone, Debug)]
pub struct TotalFinding<'a> {
    /// `key:total`.
    pub id: String,
    /// The claim.
    pub claim: &'a Total,
    /// The sum.
    pub exact: Rational,
}

impl TotalFinding<'_> {
    pub(crate) fn judgement(&self) -> Judgement<'_> {
        let equal = self.claim.sum.decimal.value() == self.exact;
        let word = if equal { Word::Confirmed } else { Word::Refuted };
        Judgement { word: Some(word), cap: None, harm: Harm::Number }
    }
}
""",
    f"{CLAIMS}/judge/total.rs": """\
//! Judging a sum of coefficients.

use crate::claim::{Paper, Total};
use crate::diagnostic::Diagnostic;
use crate::evaluation::library::Library;
use crate::evaluation::limits::LimitScheme;
use crate::exact::Rational;
use crate::finding::TotalFinding;
use crate::judge::kind::JudgeAlone;
use std::collections::BTreeMap;

impl<'a> JudgeAlone<'a> for Total {
    type Finding = TotalFinding<'a>;

    fn judge_alone(
        &'a self,
        paper: &'a Paper,
        library: &Library<'_>,
    ) -> Result<TotalFinding<'a>, Diagnostic> {
        let scheme = LimitScheme { paper, library, located: &self.scheme, given: &BTreeMap::new() };
        let mask = scheme.mask(None)?;
        let entries = mask.rules().rows().iter().flatten();
        let exact = entries.fold(Rational::zero(), |sum, entry| sum + entry.clone());
        Ok(TotalFinding { id: format!("{}:{}", paper.key, self.id), claim: self, exact })
    }
}
""",
    f"{REPORTS}/report/kinds/total.rs": """\
//! Sums of coefficients in reports.

use crate::audit::{PaperAudit, TotalFinding, Word};
use crate::report::json::{Claim, Details};
use crate::report::told::{Counted, Facts, Told};

static TOTALS: Counted = Counted {
    several: "sums",
    one: "sum",
    column: "sums\\n✓ confirmed ✗",
    wrong: Word::Refuted,
    words: ["is refuted", "are refuted"],
    place: 4,
};

impl<'a> Told<'a> for TotalFinding<'a> {
    fn heading(&self) -> [&'static str; 2] {
        ["Sums", "sums"]
    }

    fn counted(&self) -> Option<&'static Counted> {
        Some(&TOTALS)
    }

    fn outcome(&self) -> String {
        format!("the coefficients sum to {}", self.exact)
    }

    fn states(&self, _: &PaperAudit<'_>) -> Facts {
        let scheme = self.claim.scheme.reference.to_string();
        let facts = [("scheme", scheme), ("sum", self.claim.sum.text.clone())];
        facts.map(|(name, text)| (name.to_owned(), text)).to_vec()
    }

    fn form<'s>(&'s self, _: &'s PaperAudit<'_>) -> Vec<Claim<'s>> {
        let (claim, word) = (self.claim, self.word().name());
        let details = Details::Total { sum: self.exact.to_string() };
        let printed = claim.sum.text.as_str();
        vec![Claim::plain(&self.id, &claim.locus, "total", printed, word, details)]
    }
}
""",
    f"{REPORTS}/certificate/total.rs": """\
//! Sums of coefficients: the sum.

use super::block::{Block, Certified};
use crate::audit::{Finding, TotalFinding};
use crate::claim::Paper;

impl Certified for TotalFinding<'_> {
    fn block(&self, _: &Paper) -> Block {
        let mut block = Block::new("total", &self.claim.id);
        block.restate("scheme", &self.claim.scheme.reference.to_string());
        block.line(format!("sum {}", self.exact));
        block.line(Finding::Total(self).word().map_or("", |word| word.name()));
        block
    }
}
""",
    f"{CHECKER}/total.rs": """\
//! The rule `total`: the coefficients of a mask sum to a printed number.

use super::kind::{Kind, Proof};
use super::smoothness::scope;
use crate::claims::{Paper, printed};
use crate::lines::limits::mask;
use crate::numbers::{Q, read_rational};
use crate::text::{Block, Checked, Reason, Toml, Verdict, agree};

/// Claims of this kind.
pub const KIND: Kind = Kind {
    name: "total",
    fields: "total: claim sum=number",
    names: |_| Vec::new(),
    check: |paper, claim, block| check(paper, claim, block).map(|()| Proof::Other),
};

/// Checks a sum.
fn check<'a>(paper: &'a Paper<'a>, claim: &'a Toml, block: &mut Block<'_>) -> Checked<()> {
    block.restates("scheme", claim.text("scheme"))?;
    let sum: Q = mask(paper, claim, &scope(paper, claim)?)?.into_iter().flatten().sum();
    agree(block.after("sum")?, &sum.to_string(), Reason::Value)?;
    let said = claim.get("sum").and_then(printed).and_then(|(_, read)| read_rational(read));
    let said = said.ok_or(Reason::Malformed("a printed number"))?;
    block.verdict(if said == sum { Verdict::Confirmed } else { Verdict::Refuted })
}
""",
    "proofs/format/total.md": """\
# Sums of coefficients

Fields: `sum`, a printed number.

    total ID
      scheme TEXT
      sum NUMBER
      confirmed                       or
      refuted

The scheme is one rational mask, in the scope of [smoothness](smoothness.md). NUMBER is the sum of its coefficients; `confirmed` if the printed number is equal to it.
""",
}

# A file, a text that stands there once, and what is inserted before it.
INSERTED = [
    (f"{CLAIMS}/claim/kinds.rs", "            /// A theorem.\n", '            /// A sum of coefficients.\n            Total "total" totals Total TotalFinding claim,\n'),
    (f"{CLAIMS}/claim/mod.rs", "mod theorem;\n", "mod total;\n"),
    (f"{CLAIMS}/claim/mod.rs", "pub use theorem::", "pub use total::Total;\n"),
    (f"{CLAIMS}/claim/read/mod.rs", "mod trial;\n", "mod total;\n"),
    (f"{CLAIMS}/claim/read/file.rs", "    ..\n", "    /// Sums of coefficients.\n    total: super::total::TotalTable,\n"),
    (f"{CLAIMS}/finding/mod.rs", "mod witness;\n", "mod total;\n"),
    (f"{CLAIMS}/finding/mod.rs", "pub use witness::", "pub use total::TotalFinding;\n"),
    (f"{CLAIMS}/judge/mod.rs", "\npub use cases::MAX_CASES;", "mod total;\n"),
    (f"{REPORTS}/report/kinds/mod.rs", "mod theorem;\n", "mod total;\n"),
    (f"{REPORTS}/report/json/claim.rs", "    /// Of a theorem.\n    Theorem {", "    /// Of a sum of coefficients.\n    Total {\n        /// The sum.\n        sum: String,\n    },\n"),
    (f"{REPORTS}/certificate/mod.rs", "mod vertex;\n", "mod total;\n"),
    (f"{CHECKER}/mod.rs", "\nuse crate::claims::", "pub mod total;\n"),
    (f"{CHECKER}/mod.rs", "    theorem::KIND,\n", "    total::KIND,\n"),
    ("proofs/FORMAT.md", "| `regularity` |", "| `total` | [Sums of coefficients](format/total.md) |\n"),
]

# A list of the checker says its length.
REPLACED = [(f"{CHECKER}/mod.rs", "pub static KINDS: [Kind; 8]", "pub static KINDS: [Kind; 9]")]

PAPER = """\
key = "toy2026"
[paper]
title = "Sums"
year = "2026"
[[total]]
id = "right"
locus = "(1)"
scheme = "chaikin"
sum = "2"
[[total]]
id = "wrong"
locus = "(2)"
scheme = "b-spline:degree=3"
sum = "3"
"""


def patch(tree: Path) -> list[str]:
    for name, text in NEW.items():
        assert not (tree / name).exists(), f"{name} exists"
        (tree / name).write_text(text, encoding="utf-8")
    changes = [(name, anchor, text + anchor) for name, anchor, text in INSERTED]
    for name, anchor, text in changes + REPLACED:
        before = (tree / name).read_text(encoding="utf-8")
        if before.count(anchor) != 1:
            sys.exit(f"{name}: {anchor!r} stands there {before.count(anchor)} times")
        (tree / name).write_text(before.replace(anchor, text), encoding="utf-8")
    return sorted({*NEW, *(name for name, *_ in changes + REPLACED)})


def left_out(folder: str, names: list[str]) -> list[str]:
    return [name for name in names if name in ("target", ".git") or Path(folder, name) == TARGET]


def run(tree: Path, *command: str, code: int = 0) -> str:
    environment = {**os.environ, "CARGO_TARGET_DIR": str(TARGET)}
    done = subprocess.run(command, cwd=tree, env=environment, stdout=subprocess.PIPE, text=True)
    if done.returncode != code:
        sys.exit(f"{' '.join(command)}: exit code {done.returncode} in place of {code}\n{done.stdout}")
    return done.stdout


def within(said: list[str], text: str) -> None:
    for words in said:
        if words not in text:
            sys.exit(f"{words!r} is not in\n{text}")


def tried(tree: Path) -> None:
    quick = [f"--config=profile.dev.package.{name}.opt-level=0" for name in OPTIMISED]
    run(tree, "cargo", "build", "--offline", "-p", "subcert", "-p", "subcert-check", "--bins", *quick)
    subcert, checker = (str(TARGET / "debug" / name) for name in ["subcert", "subcert-check"])
    (tree / "toy.toml").write_text(PAPER, encoding="utf-8")
    within(["1 of 2 sums", "the coefficients sum to 2"], run(tree, subcert, "audit", "toy.toml"))
    forms = run(tree, subcert, "audit", "toy.toml", "--format", "json")
    within(['"total"', '"confirmed"', '"refuted"'], forms)
    run(tree, subcert, "prove", "toy.toml", "-o", ".")
    certificate = tree / "toy2026.cert"
    text = certificate.read_text(encoding="utf-8")
    within(["2 certified, 0 cited, 0 invalid"], run(tree, checker, "toy.toml", certificate.name))
    certificate.write_text(text.replace("refuted", "confirmed"), encoding="utf-8")
    within(["1 certified, 0 cited, 1 invalid"], run(tree, checker, "toy.toml", certificate.name, code=1))


def main() -> None:
    tree = TARGET / "toy"
    shutil.rmtree(tree, ignore_errors=True)
    shutil.copytree(ROOT, tree, symlinks=True, ignore=left_out)
    files = patch(tree)
    if "--list" not in sys.argv[1:]:
        tried(tree)
    code = [name for name in files if name.endswith(".rs")]
    for name in files:
        print("new    " if name in NEW else "changed", name)
    print(f"{len(files)} files, {len(code)} of code, {sum(name in NEW for name in code)} of these new")
    if len(code) > MOST[0] or len(files) > MOST[1]:
        sys.exit(f"more than {MOST[0]} files of code, or {MOST[1]} of all")


if __name__ == "__main__":
    main()
