//! Which files a program may touch.

use std::io::{Error, ErrorKind};
use std::path::{Component, Path};
use std::sync::atomic::{AtomicBool, Ordering};

/// The variable of the environment by which `subcert` is told to [`confine`] itself.
pub const VARIABLE: &str = "SUBCERT_CONFINED";

static CONFINED: AtomicBool = AtomicBool::new(false);

/// From now on only files in the current folder, and in folders in it, are read and written: for a program that others tell what to do.
pub fn confine() {
    CONFINED.store(true, Ordering::Relaxed);
}

/// Whether [`confine`] was called.
#[must_use]
pub fn is_confined() -> bool {
    CONFINED.load(Ordering::Relaxed)
}

/// Whether a file may be read or written.
///
/// # Errors
/// When the program is confined, and the path is absolute or has a part `..`.
///
/// ```standalone_crate
/// use subcert::files::{confine, permitted};
///
/// assert!(permitted("/etc/passwd".as_ref()).is_ok());
/// confine();
/// assert!(permitted("../secret".as_ref()).is_err() && permitted("/etc/passwd".as_ref()).is_err());
/// assert!(permitted("mine.toml".as_ref()).is_ok() && permitted("pages/index.html".as_ref()).is_ok());
/// ```
pub fn permitted(path: &Path) -> Result<(), Error> {
    let inside = |part: Component<'_>| matches!(part, Component::Normal(_) | Component::CurDir);
    if !is_confined() || path.components().all(inside) {
        return Ok(());
    }
    let message = "only files of the folder of this command may be touched";
    Err(Error::new(ErrorKind::PermissionDenied, message))
}
