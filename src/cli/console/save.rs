//! Files that are written whole or not at all.

use super::interrupt::writing;
use std::fs::{File, create_dir_all, remove_file, rename};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use subcert::cores::THREADS;
use subcert::files::permitted;

/// Writes a file into a folder, which is made if it is missing, as [`save`] does.
pub(crate) fn save_in(folder: &Path, name: &str, text: &str) -> io::Result<()> {
    let path = folder.join(name);
    permitted(&path)?;
    create_dir_all(path.parent().unwrap_or(folder))?;
    save(&path, text)
}

/// The folder that a file is to be written into.
///
/// # Errors
/// When there is none: a file is named in a folder that exists, and only a folder that is named as such is made.
pub(crate) fn folder_of(path: &Path) -> io::Result<&Path> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    let folder = folder.unwrap_or(Path::new("."));
    if folder.is_dir() {
        return Ok(folder);
    }
    let message = format!("there is no folder `{}`", folder.display());
    Err(io::Error::new(io::ErrorKind::NotFound, message))
}

/// Writes a file; if that fails, a file that was there before is unchanged. A link is followed, and what is no regular
/// file, such as a pipe, is written into.
pub(crate) fn save(path: &Path, text: &str) -> io::Result<()> {
    permitted(path)?;
    let path = &target(path)?;
    let _writing = writing();
    if path.metadata().is_ok_and(|data| !data.is_file() && !data.is_dir()) {
        return File::options().write(true).open(path)?.write_all(text.as_bytes());
    }
    let folder = folder_of(path)?;
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    // WebAssembly has no processes, and so no others that write.
    let process = if THREADS { std::process::id() } else { 0 };
    let draft = folder.join(format!(".{name}.{process}"));
    let mut file = File::create_new(&draft)?;
    let written = file.write_all(text.as_bytes()).and_then(|()| file.sync_all());
    drop(file);
    let done = written.and_then(|()| rename(&draft, path));
    if done.is_err() {
        // The error of writing is reported, not that of cleaning up.
        let _ = remove_file(&draft);
    }
    done
}

/// As many links are followed, one from the other, as Linux follows.
const MAX_LINKS: usize = 40;

/// What a path leads to, also if nothing is there yet.
fn target(path: &Path) -> io::Result<PathBuf> {
    if let Ok(found) = path.canonicalize() {
        return Ok(found);
    }
    let mut path = path.to_path_buf();
    for _ in 0..MAX_LINKS {
        let Ok(next) = path.read_link() else { return Ok(path) };
        path = path.parent().unwrap_or(Path::new("")).join(next);
    }
    Err(io::Error::other("the link leads to itself"))
}
