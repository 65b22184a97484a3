//! `docs/stability.md` shows the pictures that are there, and names tests that are there.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn page() -> String {
    read(&root().join("docs/stability.md"))
}

/// The files of a folder.
fn files(folder: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(root().join(folder)).expect("a folder");
    entries.map(|entry| entry.expect("an entry").path()).collect()
}

/// What stands between two marks.
fn between<'t>(text: &'t str, open: &str, close: &str) -> BTreeSet<&'t str> {
    text.split(open).skip(1).filter_map(|rest| rest.split_once(close)).map(|(inside, _)| inside).collect()
}

// Red when a picture is renamed, left out of the page, or no longer drawn.
#[test]
fn the_page_shows_every_picture_of_the_atlas() {
    let page = page();
    let shown: BTreeSet<String> = between(&page, "](atlas/", ")").into_iter().map(str::to_owned).collect();
    let drawn: BTreeSet<String> = files("docs/atlas")
        .iter()
        .filter_map(|path| path.file_name())
        .map(|name| name.to_string_lossy().into_owned())
        .collect();
    assert_eq!(shown, drawn);
}

// Red when a test of the failure suite is renamed or removed and the page's table is not.
#[test]
fn the_tests_that_the_page_names_are_there() {
    let page = page();
    let tests: String = files("tests/stability").iter().map(|path| read(path)).collect();
    let named: Vec<&str> =
        between(&page, "`row_", "`").into_iter().filter(|name| !name.contains(' ')).collect();
    assert!(!named.is_empty());
    for name in named {
        assert!(tests.contains(&format!("fn row_{name}()")), "there is no test row_{name}");
    }
}
