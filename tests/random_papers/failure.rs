//! What becomes of a property that fails.

use crate::random_papers::draft::Draft;
use proptest::test_runner::TestCaseError;
use std::collections::hash_map::DefaultHasher;
use std::hash::{Hash, Hasher};

/// A claim file for which a property does not hold.
#[derive(Debug)]
pub struct Failure {
    /// What does not hold, in words that are the same for failures of one cause.
    pub what: String,
    pub file: String,
    /// What program and checker say.
    pub said: String,
}

impl Failure {
    pub fn new(what: impl Into<String>, file: &str, said: impl Into<String>) -> Failure {
        Failure { what: what.into(), file: file.to_owned(), said: said.into() }
    }
}

pub type Checked = Result<(), Failure>;

/// Stops at a failure; or, where `SUBCERT_FINDINGS` names a folder, keeps the shortest file of each kind
/// of failure there, and goes on.
pub fn settled(draft: &Draft, property: fn(&Draft) -> Checked) -> Result<(), TestCaseError> {
    let Err(Failure { what, file, said }) = property(draft) else { return Ok(()) };
    let double = draft.names.double.as_ref().map(|double| format!(", where {double}"));
    let what = what + &double.unwrap_or_default();
    let Some(folder) = std::env::var_os("SUBCERT_FINDINGS") else {
        return Err(TestCaseError::fail(format!("{what}\n{file}\n{said}")));
    };
    let mut hasher = DefaultHasher::new();
    what.hash(&mut hasher);
    let name = format!("{:016x}", hasher.finish());
    let path = std::path::Path::new(&folder).join(name);
    let known = std::fs::read_to_string(path.with_extension("toml"));
    if known.is_ok_and(|known| known.len() <= file.len()) {
        return Ok(());
    }
    let written = std::fs::write(path.with_extension("toml"), &file)
        .and_then(|()| std::fs::write(path.with_extension("md"), format!("{what}\n\n{said}\n")));
    written.map_err(|error| TestCaseError::fail(error.to_string()))
}
