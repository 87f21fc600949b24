//! The names of claims and of cells: `KEY:CLAIM` and `KEY:CLAIM:ROW:COLUMN`.

use std::fmt;

/// What a text such as `khan2019-newton:table-1:2:3` names: a paper, a claim of it, and a cell of a table or
/// another part of the claim.
///
/// ```
/// use subcert::claim::Target;
///
/// let target = Target::of("khan2019-newton:table-1:2:3");
/// assert_eq!((target.key, target.claim, target.cell()), ("khan2019-newton", "table-1", Some((1, 2))));
/// assert_eq!(target.to_string(), "khan2019-newton:table-1:2:3");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Target<'t> {
    /// The key of the paper.
    pub key: &'t str,
    /// The id of the claim within the paper; empty where the text names a paper.
    pub claim: &'t str,
    /// What follows the id of the claim: of a cell its row and column, from 1.
    pub part: Option<&'t str>,
}

impl<'t> Target<'t> {
    /// What a text names.
    #[must_use]
    pub fn of(text: &'t str) -> Target<'t> {
        let (key, claim) = text.split_once(':').unwrap_or((text, ""));
        match claim.split_once(':') {
            Some((claim, part)) => Target { key, claim, part: Some(part) },
            None => Target { key, claim, part: None },
        }
    }

    /// Whether it names a paper and no claim.
    #[must_use]
    pub fn names_paper(&self) -> bool {
        self.claim.is_empty() && self.part.is_none()
    }

    /// The row and the column that it names, counted from 0.
    #[must_use]
    pub fn cell(&self) -> Option<(usize, usize)> {
        let (row, column) = self.part?.split_once(':')?;
        // A cell has one name: neither `01` nor `+1` is a row.
        let plain = |text: &str| text.parse::<usize>().ok().filter(|n| n.to_string() == text);
        let place = |text: &str| plain(text)?.checked_sub(1);
        Some((place(row)?, place(column)?))
    }

    /// Its name within the paper, without the key: also the anchor on the page of the paper.
    #[must_use]
    pub fn within(&self) -> String {
        self.part.map_or(self.claim.to_owned(), |part| format!("{}:{part}", self.claim))
    }
}

impl fmt::Display for Target<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.key)?;
        if self.names_paper() { Ok(()) } else { write!(f, ":{}", self.within()) }
    }
}
