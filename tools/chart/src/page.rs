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

#[cfg(test)]
mod tests {
    use super::*;

    // Red when what stood between the marks stays, or what stands around them goes.
    #[test]
    fn only_what_is_between_the_marks_changes() {
        let page = "a\n<!-- table: t -->\n\nold\n<!-- end of table -->\nb";
        let new = filled(page, |name| (name == "t").then(|| "new".into())).unwrap();
        assert_eq!(new, "a\n<!-- table: t -->\n\nnew\n<!-- end of table -->\nb");
        assert_eq!(filled(&new, |_| Some("new".into())).unwrap(), new);
        assert!(filled(page, |_| None).unwrap_err().contains("no such table"));
        assert!(filled("<!-- table: t -->", |_| Some(String::new())).unwrap_err().contains("no end mark"));
    }
}
