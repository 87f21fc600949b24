//! Which findings are theorems of Coq that the project compiles.

use crate::claim::{Paper, embedded, embedded_paper};
use crate::finding::{
    CellFinding, Finding, Kept, KernelProof, Naturally, PaperAudit, Sound, TheoremFinding,
    TheoremVerdict,
};

/// The key of a paper, the id of a claim, the row and column of a cell from 1, and what is proved.
type Proved = (&'static str, &'static str, Option<(usize, usize)>, KernelProof);

/// Every theorem of the folder `proofs/coq/papers`: `build.rs` lists them.
const PROVED: &[Proved] = &include!(concat!(env!("OUT_DIR"), "/theorems.rs"));

/// How many findings of a kind Coq's kernel accepts, and how many there are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Share {
    /// Those that it accepts.
    pub proved: usize,
    /// All.
    pub all: usize,
}

/// How many findings of a paper Coq's kernel accepts, kind by kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct KernelCounts {
    /// Values of cells.
    pub values: Share,
    /// Sound bounds and depths.
    pub sound: Share,
    /// Broken promises.
    pub broken: Share,
    /// Promises that are broken at natural parameters too.
    pub broken_naturally: Share,
    /// Refuted theorems.
    pub refuted: Share,
    /// Theorems that are refuted at natural parameters too.
    pub refuted_naturally: Share,
    /// Theorems that are proved or open, equations, functions, ranges and claims about smoothness. Coq proves
    /// none of these.
    pub others: Share,
}

impl Share {
    fn count(&mut self, says: bool, proved: bool) {
        self.all += usize::from(says);
        self.proved += usize::from(says && proved);
    }

    fn plus(self, other: Share) -> Share {
        Share { proved: self.proved + other.proved, all: self.all + other.all }
    }
}

impl KernelCounts {
    /// The findings of all kinds.
    #[must_use]
    pub fn total(&self) -> Share {
        let KernelCounts { values, sound, broken, broken_naturally, .. } = *self;
        [sound, broken, broken_naturally, self.refuted, self.refuted_naturally, self.others]
            .into_iter()
            .fold(values, Share::plus)
    }
}

impl PaperAudit<'_> {
    /// How many findings of the paper Coq's kernel accepts.
    ///
    /// ```
    /// use subcert::audit::audit;
    /// use subcert::claim::{embedded, embedded_papers, read_paper};
    /// use subcert::diagnostic::SourceText;
    ///
    /// let papers = embedded_papers()?;
    /// let bajaj = audit(&papers[0])?.kernel_counts().refuted;
    /// assert_eq!((bajaj.proved, bajaj.all), (2, 2));
    /// // The same text in a file of one's own was not compiled.
    /// let own = read_paper(&SourceText::new("own.toml", embedded()[0].text))?;
    /// assert_eq!(audit(&own)?.kernel_counts().refuted.proved, 0);
    /// # Ok::<(), subcert::diagnostic::Diagnostic>(())
    /// ```
    #[must_use]
    pub fn kernel_counts(&self) -> KernelCounts {
        let mut counts = KernelCounts::default();
        for cell in self.tables.iter().flat_map(|table| table.cells.iter().flatten()) {
            for (share, proof) in [
                (&mut counts.values, KernelProof::Value),
                (&mut counts.sound, KernelProof::Sound),
                (&mut counts.broken, KernelProof::Broken),
                (&mut counts.broken_naturally, KernelProof::BrokenNaturally),
            ] {
                share.count(cell_says(cell, proof), cell.by_kernel.contains(&proof));
            }
        }
        for finding in &self.theorems {
            for (share, proof) in [
                (&mut counts.refuted, KernelProof::Refuted),
                (&mut counts.refuted_naturally, KernelProof::RefutedNaturally),
            ] {
                share.count(theorem_says(finding, proof), finding.by_kernel.contains(&proof));
            }
        }
        let others = self.findings().filter(|finding| match finding {
            Finding::Table(_) => false,
            Finding::Theorem(finding) => finding.verdict != TheoremVerdict::Refuted,
            _ => true,
        });
        counts.others.all += others.count();
        counts
    }
}

/// Notes of each finding what Coq's kernel accepts of it. Only the papers that are part of the program have
/// theorems: those of a file have none, whatever its key is, nor has a paper that was changed.
pub(crate) fn kernel(audit: &mut PaperAudit<'_>) {
    let key = &audit.paper.key;
    let own: Vec<&Proved> = PROVED.iter().filter(|(paper, ..)| paper == key).collect();
    if own.is_empty() || !is_embedded(audit.paper) {
        return;
    }
    let of = |claim: &str, place: Option<(usize, usize)>| {
        let proved = own.iter().filter(|(_, id, at, _)| *id == claim && *at == place);
        let mut proofs: Vec<KernelProof> = proved.map(|(.., proof)| *proof).collect();
        proofs.sort_unstable();
        proofs
    };
    for finding in &mut audit.tables {
        let id = &finding.table.id;
        for (row, cells) in finding.cells.iter_mut().enumerate() {
            for (column, cell) in cells.iter_mut().enumerate() {
                let mut proved = of(id, Some((row + 1, column + 1)));
                proved.retain(|proof| cell_says(cell, *proof));
                cell.by_kernel = proved;
            }
        }
    }
    for finding in &mut audit.theorems {
        let mut proved = of(&finding.theorem.id, None);
        proved.retain(|proof| theorem_says(finding, *proof));
        finding.by_kernel = proved;
    }
}

/// Whether a paper is one of the program's, unchanged.
fn is_embedded(paper: &Paper) -> bool {
    let own = embedded().iter().find(|own| own.key == paper.key);
    own.is_some_and(|own| embedded_paper(own).is_ok_and(|own| own == *paper))
}

/// Whether the finding about a cell says this at all.
fn cell_says(cell: &CellFinding, proof: KernelProof) -> bool {
    match proof {
        KernelProof::Value => cell.exact.is_some(),
        KernelProof::Constant => true,
        KernelProof::Sound => matches!(cell.sound, Some(Sound::Depth { .. } | Sound::Bound(_))),
        KernelProof::Broken => matches!(cell.kept, Some(Kept::No(_))),
        KernelProof::BrokenNaturally => matches!(cell.kept_naturally, Some(Kept::No(_))),
        KernelProof::Refuted | KernelProof::RefutedNaturally => false,
    }
}

/// Whether the finding about a theorem says this at all. Some are refuted by a proof by hand, without data.
fn theorem_says(finding: &TheoremFinding<'_>, proof: KernelProof) -> bool {
    let natural = finding.refutation.as_ref().and_then(|found| found.natural.as_ref());
    match proof {
        KernelProof::Refuted => finding.verdict == TheoremVerdict::Refuted,
        KernelProof::RefutedNaturally => matches!(natural, Some(Naturally::Refuted { .. })),
        _ => false,
    }
}
