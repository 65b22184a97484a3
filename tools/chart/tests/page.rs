//! `docs/speed-and-accuracy.md` and the front page show the pictures that are there.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn read(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// The pictures of a page, without their folder.
fn shown(page: &str, folder: &str) -> BTreeSet<String> {
    let open = format!("]({folder}");
    let links = page.split(&open).skip(1);
    links.filter_map(|rest| rest.split_once(')')).map(|(name, _)| name.to_owned()).collect()
}

// Red when a picture is renamed, left out of the page, or no longer drawn.
#[test]
fn the_page_shows_every_picture_of_the_chart() {
    let drawn: BTreeSet<String> = fs::read_dir(root().join("docs/chart"))
        .expect("a folder")
        .map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned())
        .filter(|name| name.ends_with(".svg"))
        .collect();
    assert!(!drawn.is_empty());
    assert_eq!(shown(&read("docs/speed-and-accuracy.md"), "chart/"), drawn);
}

// Red when the front page's picture is renamed, or one of its scenes.
#[test]
fn what_the_pages_name_is_there() {
    for name in shown(&read("README.md"), "docs/chart/") {
        assert!(root().join("docs/chart").join(&name).exists(), "README.md shows {name}");
    }
    let page = read("docs/speed-and-accuracy.md");
    let (_, table) = page.split_once("| scene | what it decides |").expect("the scenes' table");
    let rows: Vec<&str> = table.lines().skip(2).take_while(|line| line.starts_with('|')).collect();
    assert!(rows.len() > 5, "{} scenes", rows.len());
    for row in rows {
        let name = row.split('`').nth(1).expect("a name in code");
        assert!(scenes::by_name(name).is_some(), "no scene is called {name}");
    }
}
