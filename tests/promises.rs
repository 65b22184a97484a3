//! The promises on the crate's front page: the tests that they name are there, and their figures are those of the tables.
//! So are the figures of the README.

use std::fs;
use std::path::Path;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn read(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// The front page from its promises to the next heading.
fn promises() -> String {
    let page = read("src/lib.rs");
    let (_, after) = page.split_once("//! # Promises\n").expect("the front page has promises");
    let (promises, _) = after.split_once("//! # ").expect("something follows the promises");
    promises.lines().map(|line| line.trim_start_matches("//!").to_owned() + "\n").collect()
}

/// A table's lines, as cells by the names of their columns.
fn table(name: &str) -> Vec<Vec<(String, String)>> {
    let text = read(&format!("docs/measured/{name}.csv"));
    let mut lines = text.lines().filter(|line| !line.starts_with('#'));
    let columns: Vec<&str> = lines.next().expect("a table has columns").split(',').collect();
    let cells = |line: &str| {
        columns.iter().zip(line.split(',')).map(|(column, cell)| ((*column).into(), cell.into())).collect()
    };
    lines.map(cells).collect()
}

/// A line of the front page's table: promise, table and row, measured, bound, unit.
fn figures(promises: &str) -> Vec<[String; 5]> {
    let cells = |line: &str| -> Vec<String> {
        line.trim().trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect()
    };
    promises
        .lines()
        .filter(|line| line.trim().starts_with('|'))
        .skip(2)
        .map(|line| cells(line).try_into().unwrap_or_else(|_| panic!("five cells are needed: {line}")))
        .collect()
}

/// What a table says instead of a figure of the front page, if it says something else.
fn wrong([promise, row, measured, bound, unit]: &[String; 5]) -> Option<String> {
    let (name, keys) = row.split_once(": ").expect("a table and its row");
    let keys: Vec<&str> = keys.split(", ").collect();
    let named = |line: &Vec<(String, String)>| match name {
        "accuracy" => {
            let metric = line.iter().find(|(column, _)| column == "metric").map(|(_, cell)| cell.as_str());
            line[..3].iter().map(|(_, cell)| cell.as_str()).chain(metric).eq(keys.iter().copied())
        }
        _ => line[..keys.len()].iter().map(|(_, cell)| cell.as_str()).eq(keys.iter().copied()),
    };
    let lines: Vec<_> = table(name).into_iter().filter(named).collect();
    let [line] = &lines[..] else {
        return Some(format!("{promise}: docs/measured/{name}.csv has {} rows for {keys:?}", lines.len()));
    };
    let cell = |name: &str| line.iter().find(|(column, _)| column == name).map(|(_, cell)| cell.clone());
    let found = match name {
        "accuracy" => [cell("measured_max"), cell("bound"), cell("unit")],
        _ => [cell(unit), Some(String::new()), Some(unit.clone())],
    };
    let said = [measured, bound, unit].map(|cell| Some(cell.clone()));
    (found != said).then(|| format!("{promise}, {row}: the page says {said:?}, the table {found:?}"))
}

/// Turned red by: a table that is measured anew and differs, a row that is no longer there.
#[test]
fn the_figures_of_the_front_page_are_those_of_the_tables() {
    let figures = figures(&promises());
    let wrong: Vec<String> = figures.iter().filter_map(wrong).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    for promise in ["1", "2", "3", "5"] {
        assert!(figures.iter().any(|figure| figure[0] == promise), "promise {promise} has no figure");
    }
}

/// The README's lines between a heading and the next.
fn section(heading: &str) -> String {
    let page = read("README.md");
    let (_, after) =
        page.split_once(&format!("\n## {heading}\n")).unwrap_or_else(|| panic!("no section {heading}"));
    after.split("\n## ").next().unwrap_or_default().to_owned()
}

/// Turned red by: a table that is measured anew and differs, a row that is no longer there, a column that is renamed.
#[test]
fn the_figures_of_the_readme_are_those_of_the_tables() {
    let section = section("What it costs");
    let rows: Vec<Vec<&str>> = section
        .lines()
        .filter(|line| line.starts_with('|'))
        .skip(2)
        .map(|line| line.trim_matches('|').split('|').map(str::trim).collect())
        .collect();
    let wrong: Vec<String> = rows
        .iter()
        .filter_map(|row| {
            let [what, said, unit, place] = row[..] else {
                return Some(format!("four cells are needed: {row:?}"));
            };
            wrong(&[what, place, said, "", unit].map(str::to_owned))
        })
        .collect();
    assert!(wrong.is_empty(), "README.md, what it costs:\n{}", wrong.join("\n"));
    for table in ["turn: ", "panel: ", "ram: ", "flash: ", "rp2040: "] {
        assert!(rows.iter().any(|row| row[3].starts_with(table)), "no figure of {table}");
    }
}

/// Turned red by: a test that is renamed or removed.
#[test]
fn the_tests_of_the_front_page_are_there() {
    let promises = promises();
    let list = promises.split("What was measured").next().unwrap_or_default();
    for promise in ["1. **", "2. **", "3. **", "4. **", "5. **"] {
        let (_, text) = list.split_once(promise).unwrap_or_else(|| panic!("there is no promise {promise}"));
        let end = text.find(". **").map_or(text.len(), |end| end - 1);
        let named: Vec<&str> = text[..end]
            .split('`')
            .skip(1)
            .step_by(2)
            .filter(|code| ["tests/", "tools/", "firmware/"].iter().any(|folder| code.starts_with(folder)))
            .collect();
        assert!(!named.is_empty(), "no test holds promise {promise}");
        for path in named {
            assert!(root().join(path).exists(), "{path}, of promise {promise}, is not there");
        }
    }
}
