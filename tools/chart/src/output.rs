//! The files: written, or compared.

use std::fs;
use std::path::{Path, PathBuf};

use crate::figures::{self, Tables};
use crate::gather::Inputs;
use crate::page;
use crate::table::Table;

/// Where they are, in the repository.
const FOLDER: &str = "docs/chart";
const PAGE: &str = "docs/speed-and-accuracy.md";
/// Columns that no check compares: their names begin so.
const HOST: &str = "host_";

/// A file and what it should hold.
#[derive(Clone, Debug)]
pub(crate) enum File {
    Text(PathBuf, String),
    Table(PathBuf, Table),
}

/// All files.
///
/// # Errors
/// A line that says what is wrong with the page.
pub(crate) fn files(root: &Path, tables: &Tables, _: &Inputs) -> Result<Vec<File>, String> {
    let named = [
        ("texels", &tables.texels),
        ("picks", &tables.picks),
        ("within", &tables.within),
        ("depth-resolution", &tables.resolution),
        ("depth-inversions", &tables.inversions),
        ("setup-and-fill", &tables.setup_and_fill),
        ("parts", &tables.parts),
        ("ram", &tables.ram),
        ("colour", &tables.colour),
        ("traversal", &tables.traversal),
    ];
    let folder = Path::new(FOLDER);
    let mut files: Vec<File> = named
        .iter()
        .map(|(name, table)| File::Table(folder.join(format!("{name}.csv")), (*table).clone()))
        .collect();
    files.extend(figures::all(tables).into_iter().map(|(name, text)| File::Text(folder.join(name), text)));
    let path = root.join(PAGE);
    let text = fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
    let shown = |name: &str| {
        let table = named.iter().find(|(known, _)| *known == name).map(|(_, table)| *table);
        let table = if name == "peers" { tables.peers.as_ref() } else { table };
        table.map(Table::markdown)
    };
    let filled = page::filled(&text, shown).map_err(|reason| format!("{PAGE}: {reason}"))?;
    files.push(File::Text(PAGE.into(), filled));
    Ok(files)
}

/// # Errors
/// A line that says what cannot be written.
pub(crate) fn write(root: &Path, files: &[File]) -> Result<(), String> {
    let mut bytes = 0;
    for file in files {
        let (path, text) = match file {
            File::Text(path, text) => (path, text.clone()),
            File::Table(path, table) => (path, table.csv()),
        };
        bytes += text.len();
        let path = root.join(path);
        let folder = path.parent().map_or(Ok(()), fs::create_dir_all);
        folder
            .and_then(|()| fs::write(&path, text))
            .map_err(|error| format!("{}: {error}", path.display()))?;
    }
    println!("chart: {} files, {} kB", files.len(), bytes.div_ceil(1000));
    Ok(())
}

/// What differs, a line each; and files that nothing writes.
///
/// # Errors
/// A line that says which folder cannot be read.
pub(crate) fn check(root: &Path, files: &[File]) -> Result<Vec<String>, String> {
    let mut wrong = Vec::new();
    for file in files {
        let (path, same) = match file {
            File::Text(path, text) => (path, fs::read_to_string(root.join(path)).map(|there| there == *text)),
            File::Table(path, table) => {
                let there = Table::read(&root.join(path));
                (path, there.map(|there| there.without(HOST) == table.without(HOST)))
            }
        };
        match same {
            Ok(true) => {}
            Ok(false) => wrong.push(format!("{}: is not what is measured and drawn here", path.display())),
            Err(error) => wrong.push(format!("{}: {error}", path.display())),
        }
    }
    let folder = root.join(FOLDER);
    let entries = fs::read_dir(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    for name in entries.flatten().map(|entry| entry.file_name()) {
        let path = Path::new(FOLDER).join(&name);
        let known =
            |file: &File| matches!(file, File::Text(known, _) | File::Table(known, _) if *known == path);
        // The others' table is written by a package of its own.
        if name != "peers.csv" && !files.iter().any(known) {
            wrong.push(format!("{}: nothing writes it", path.display()));
        }
    }
    if wrong.is_empty() {
        println!("chart: {} files are as measured and drawn here", files.len());
    }
    Ok(wrong)
}
