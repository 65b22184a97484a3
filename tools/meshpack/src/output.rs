//! Files that appear whole and together, or not at all.

use crate::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

/// Writes all files, or leaves all of them as they were: each is written beside its place, and only when all of them
/// are there do they take their places.
///
/// # Errors
/// The file that cannot be written, and why.
pub fn write_all(files: &[(PathBuf, Vec<u8>)]) -> Result<(), Error> {
    let beside: Vec<PathBuf> = files.iter().map(|(path, _)| temporary(path)).collect();
    let written = files.iter().zip(&beside).try_for_each(|((path, bytes), beside)| {
        if path.is_dir() {
            let reason = std::io::Error::from(std::io::ErrorKind::IsADirectory);
            return Err(Error::Write(path.clone(), reason));
        }
        fs::write(beside, bytes).map_err(|reason| Error::Write(path.clone(), reason))
    });
    let moved = written.and_then(|()| {
        files.iter().zip(&beside).try_for_each(|((path, _), beside)| {
            fs::rename(beside, path).map_err(|reason| Error::Write(path.clone(), reason))
        })
    });
    if moved.is_err() {
        for path in &beside {
            // What was never written cannot be removed, and the first error is the one to tell.
            let _ = fs::remove_file(path);
        }
    }
    moved
}

fn temporary(path: &Path) -> PathBuf {
    let mut name = path.file_name().unwrap_or_default().to_os_string();
    name.push(format!(".{}.part", std::process::id()));
    path.with_file_name(name)
}
