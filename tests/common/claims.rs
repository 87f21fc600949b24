//! Claim files of tests.

use subcert::audit::{PaperAudit, audit};
use subcert::claim::{Paper, embedded, read_paper};
use subcert::diagnostic::SourceText;

/// The fields of a range of a scheme whose shifts are linearly dependent for all w, and the scheme.
pub const DEPENDENT: &str = "scheme = 'd:w=w'\nvariable = 'w'\nsmoothness = '1'\n";
pub const DEPENDENT_SCHEME: &str = "[[scheme]]\nname = 'd'\nparameters.w = { about = 'weight' }\n\
                                    mask = [['(1+w)/4', '1/2', '(1-w)/4'], ['0', '1/2', '1/2']]\n";

/// What a claim file of a test begins with.
pub const HEAD: &str =
    "key = 'k'\n[paper]\nauthors = ['A']\ntitle = 't'\nvenue = 'v'\nyear = '1'\n";

/// The paper of these claims.
pub fn paper(claims: &str) -> Paper {
    let source = SourceText::new("k.toml", format!("{HEAD}{claims}"));
    read_paper(&source).unwrap_or_else(|error| panic!("{error}"))
}

/// The claims of an embedded paper without its tables.
pub fn without_tables(key: &str) -> Paper {
    let found = embedded().iter().find(|paper| paper.key == key).expect("an embedded paper");
    let mut paper = read_paper(&SourceText::new(found.key, found.text)).expect("a claim file");
    paper.tables.clear();
    paper
}

/// A theorem `t` with these fields.
pub fn theorem(fields: &str) -> String {
    format!("[[theorem]]\nid = 't'\nlocus = 'T'\n{fields}\n")
}

pub fn judged(paper: &Paper) -> PaperAudit<'_> {
    audit(paper).unwrap_or_else(|error| panic!("{error}"))
}
