//! Tables as text: rows of named columns, read and written.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;
use std::{fs, io};

/// A table: a header and rows of as many cells.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Table {
    pub(crate) header: Vec<String>,
    pub(crate) rows: Vec<Vec<String>>,
}

impl Table {
    pub(crate) fn new(header: &[&str]) -> Self {
        Self { header: header.iter().map(|&name| name.to_owned()).collect(), rows: Vec::new() }
    }

    /// Of a file. Lines that start with `#` are left out; cells may stand in quotes.
    pub(crate) fn read(path: &Path) -> io::Result<Self> {
        let text = fs::read_to_string(path)?;
        let mut lines = text.lines().filter(|line| !line.starts_with('#')).map(cells);
        let header = lines.next().unwrap_or_default();
        let rows: Vec<_> = lines.collect();
        match rows.iter().find(|row| row.len() != header.len()) {
            Some(row) => Err(io::Error::other(format!("{} cells in a row of {}", row.len(), header.len()))),
            None => Ok(Self { header, rows }),
        }
    }

    /// The same, or nothing where there is no such file.
    pub(crate) fn read_if_there(path: &Path) -> io::Result<Option<Self>> {
        match Self::read(path) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
            other => other.map(Some),
        }
    }

    /// As text of a file.
    pub(crate) fn csv(&self) -> String {
        let mut text = String::new();
        for row in std::iter::once(&self.header).chain(&self.rows) {
            let quoted: Vec<String> = row
                .iter()
                .map(|cell| if cell.contains(',') { format!("\"{cell}\"") } else { cell.clone() })
                .collect();
            let _ = writeln!(text, "{}", quoted.join(","));
        }
        text
    }

    /// As a table of Markdown.
    pub(crate) fn markdown(&self) -> String {
        let mut text = String::new();
        let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
        text += &line(&self.header);
        let numeric = |column: usize| {
            let filled = || self.rows.iter().map(|row| &row[column]).filter(|cell| !cell.is_empty());
            filled().count() > 0 && filled().all(|cell| cell.parse::<f64>().is_ok())
        };
        let rule = |column| if numeric(column) { "---:" } else { "---" }.to_owned();
        text += &line(&(0..self.header.len()).map(rule).collect::<Vec<_>>());
        self.rows.iter().for_each(|row| text += &line(row));
        text
    }

    /// The rows with these values in these columns, as maps from column to cell.
    pub(crate) fn find(&self, wanted: &[(&str, &str)]) -> std::vec::IntoIter<BTreeMap<&str, &str>> {
        let is_wanted =
            |row: &BTreeMap<&str, &str>| wanted.iter().all(|(column, value)| row.get(column) == Some(value));
        self.records().filter(is_wanted).collect::<Vec<_>>().into_iter()
    }

    /// All rows as maps from column to cell.
    pub(crate) fn records(&self) -> impl Iterator<Item = BTreeMap<&str, &str>> {
        self.rows
            .iter()
            .map(|row| self.header.iter().map(String::as_str).zip(row.iter().map(String::as_str)).collect())
    }

    /// The same table without the columns whose names start so.
    pub(crate) fn without(&self, prefix: &str) -> Self {
        let kept: Vec<usize> =
            (0..self.header.len()).filter(|&column| !self.header[column].starts_with(prefix)).collect();
        let of = |row: &Vec<String>| kept.iter().map(|&column| row[column].clone()).collect();
        Self { header: of(&self.header), rows: self.rows.iter().map(of).collect() }
    }
}

/// The number in a column of a row, if one is there.
pub(crate) fn number(row: &BTreeMap<&str, &str>, column: &str) -> Option<f64> {
    row.get(column)?.parse().ok()
}

fn cells(line: &str) -> Vec<String> {
    let (mut cells, mut quoted) = (vec![String::new()], false);
    for c in line.chars() {
        match c {
            '"' => quoted = !quoted,
            ',' if !quoted => cells.push(String::new()),
            _ => cells.last_mut().expect("there is one").push(c),
        }
    }
    cells
}

/// Four significant digits, and no exponent from 1e-5 up.
pub(crate) fn figure(value: f64) -> String {
    if value == 0.0 {
        return "0".into();
    }
    let power = value.abs().log10().floor() as i32;
    if power < -5 {
        return format!("{value:.3e}");
    }
    format!("{value:.*}", (3 - power).max(0) as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    // Red when a comma inside quotes cuts a cell, or a cell with one is written without them.
    #[test]
    fn cells_with_commas_come_back() {
        let mut table = Table::new(&["a", "b"]);
        table.rows.push(vec!["one, two".into(), "3".into()]);
        let text = table.csv();
        assert_eq!(text, "a,b\n\"one, two\",3\n");
        assert_eq!(cells("\"one, two\",3"), ["one, two", "3"]);
    }

    // Red when columns are found by what is in them, or all are kept.
    #[test]
    fn columns_of_the_host_are_left_out() {
        let mut table = Table::new(&["a", "host_b", "c"]);
        table.rows.push(vec!["1".into(), "2".into(), "3".into()]);
        let without = table.without("host_");
        assert_eq!(
            (without.header, without.rows),
            (vec!["a".into(), "c".into()], vec![vec!["1".into(), "3".into()]])
        );
    }

    // Red when digits after the point do not follow the power of ten.
    #[test]
    fn figures_have_four_digits() {
        let figures = [233.456, 16.7149, 0.017_038_2, 0.000_001_234_56, 0.0, 57_600.4].map(figure);
        assert_eq!(figures, ["233.5", "16.71", "0.01704", "1.235e-6", "0", "57600"]);
    }
}
