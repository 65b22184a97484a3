//! The page that shows the pictures: its tables stand between marks, and are written from the files.

/// The mark before a table, with its file's name.
const OPEN: &str = "<!-- table: ";
const CLOSE: &str = "<!-- end of table -->";

/// The page with each table between its marks as `table` gives it.
///
/// # Errors
/// A mark without an end, or a name that `table` does not know.
pub(crate) fn filled(page: &str, table: impl Fn(&str) -> Option<String>) -> Result<String, String> {
    let mut parts = page.split(OPEN);
    let mut text = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (name, rest) = part.split_once(" -->").ok_or("a mark of a table has no end")?;
        let (_, after) =
            rest.split_once(CLOSE).ok_or_else(|| format!("{name}: the table has no end mark"))?;
        let rows = table(name).ok_or_else(|| format!("{name}: there is no such table"))?;
        text += &format!("{OPEN}{name} -->\n\n{rows}\n{CLOSE}{after}");
    }
    Ok(text)
}
