//! The order of the stages, and what no file of the library may hold, read from `src/` itself.
//!
//! The order is that of the `mod` lines in `src/lib.rs`. A stage imports only from those before it; `math` comes first.

use std::fs;
use std::path::{Path, PathBuf};

const MOST_LINES: usize = 400;
/// Ways to stop a program. What is evaluated in a `const` stops the compiler instead: none of it is needed so far.
const STOPS: [&str; 8] =
    ["unsafe", ".unwrap()", ".expect(", "panic!", "unreachable!", "todo!", "unimplemented!", "assert"];
/// Where floats may enter.
const WITH_FLOATS: [&str; 2] = ["camera.rs", "point.rs"];

/// A file of the library, up to its unit tests.
struct Source {
    /// Its path in `src/`.
    name: String,
    /// The modules that it lies in, from the root: `["raster", "spans"]`.
    module: Vec<String>,
    /// Its lines as they are, and with comments and the inside of strings blanked.
    lines: usize,
    code: String,
}

fn sources() -> Vec<Source> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut folders = vec![root.clone()];
    let mut sources = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("src is a folder") {
            let path = entry.expect("an entry of a folder").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                sources.push(Source::read(&root, &path));
            }
        }
    }
    sources.sort_by(|a, b| a.name.cmp(&b.name));
    sources
}

impl Source {
    fn read(root: &Path, path: &Path) -> Self {
        let text = fs::read_to_string(path).expect("a file of src is text");
        Self::new(path.strip_prefix(root).expect("a path in src"), &text)
    }

    fn new(path: &Path, text: &str) -> Self {
        let text = text.split("\n#[cfg(test)]\nmod ").next().unwrap_or_default();
        let mut module: Vec<String> =
            path.with_extension("").iter().map(|part| part.to_string_lossy().into_owned()).collect();
        if module.last().is_some_and(|last| last == "mod" || last == "lib") {
            module.pop();
        }
        Self {
            name: path.iter().map(|part| part.to_string_lossy()).collect::<Vec<_>>().join("/"),
            module,
            lines: text.lines().count(),
            code: blanked(text),
        }
    }

    /// The stages that the file names, each with its line: by `crate::`, or by `super::` from a stage's own file.
    fn imports(&self) -> Vec<(usize, String)> {
        let mut imports = Vec::new();
        for (at, _) in self.code.match_indices("crate::") {
            self.names(at, &self.code[at + "crate::".len()..], &mut imports);
        }
        for (at, _) in self.code.match_indices("super::") {
            // Only the first `super` of a row of them counts.
            let before = self.code[..at].trim_end_matches("super::").len();
            let supers = (at - before) / "super::".len() + 1;
            let rest = &self.code[at + "super::".len()..];
            if supers == self.module.len() && !rest.starts_with("super::") {
                self.names(at, rest, &mut imports);
            }
        }
        imports
    }

    /// The names that follow a path to the root: one, or those of a group.
    fn names(&self, at: usize, rest: &str, imports: &mut Vec<(usize, String)>) {
        let line = self.code[..at].matches('\n').count() + 1;
        let name = |text: &str| -> String {
            text.trim_start().chars().take_while(|c| c.is_alphanumeric() || *c == '_' || *c == '*').collect()
        };
        let Some(group) = rest.strip_prefix('{') else {
            imports.push((line, name(rest)));
            return;
        };
        let mut depth = 1;
        let mut start = 0;
        for (i, c) in group.char_indices() {
            match c {
                '{' => depth += 1,
                '}' => depth -= 1,
                _ => {}
            }
            if (c == ',' && depth == 1) || depth == 0 {
                imports.push((line, name(&group[start..i])));
                start = i + 1;
            }
            if depth == 0 {
                break;
            }
        }
        imports.retain(|(_, name)| !name.is_empty());
    }
}

/// The text with comments and the inside of strings and of character literals as spaces, line by line as it was.
fn blanked(text: &str) -> String {
    let mut blanked = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let length = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if rest.starts_with("/*") {
            rest.find("*/").map_or(rest.len(), |end| end + 2)
        } else if first == '"' {
            let mut escaped = false;
            let end = rest[1..].find(|c| {
                let ends = c == '"' && !escaped;
                escaped = c == '\\' && !escaped;
                ends
            });
            end.map_or(rest.len(), |end| end + 2)
        } else if rest.starts_with("'\"'") {
            3
        } else {
            blanked.push(first);
            rest = &rest[first.len_utf8()..];
            continue;
        };
        let (gone, after) = rest.split_at(length);
        blanked.extend(gone.chars().map(|c| if c == '\n' { '\n' } else { ' ' }));
        rest = after;
    }
    blanked
}

/// The stages in the order of the root's `mod` lines.
fn stages(sources: &[Source]) -> Vec<String> {
    let root = sources.iter().find(|source| source.name == "lib.rs").expect("src/lib.rs");
    let stage = |line: &str| {
        Some(line.trim_start_matches("pub ").strip_prefix("mod ")?.strip_suffix(';')?.to_owned())
    };
    root.code.lines().filter_map(stage).collect()
}

/// What a file imports from its own right, or by a way round.
fn wrong_imports(source: &Source, stages: &[String]) -> Vec<String> {
    // The root itself exports everything.
    let Some(own) = source.module.first() else { return Vec::new() };
    let place = |name: &str| stages.iter().position(|stage| stage == name);
    let Some(here) = place(own) else { return vec![format!("{}: no `mod {own};` in lib.rs", source.name)] };
    let wrong = |(line, name): (usize, String)| match place(&name) {
        Some(there) if there <= here => None,
        Some(_) => {
            Some(format!("src/{}:{line}: `{own}` imports `{name}`, which is to its right", source.name))
        }
        None => Some(format!(
            "src/{}:{line}: `{name}` is imported through the root, which hides its stage",
            source.name
        )),
    };
    source.imports().into_iter().filter_map(wrong).collect()
}

/// The lines that hold a word which is not part of a longer one.
fn holding<'a>(source: &'a Source, word: &'a str) -> impl Iterator<Item = String> + 'a {
    let part = |c: Option<char>| c.is_some_and(|c| c.is_alphanumeric() || c == '_');
    source.code.match_indices(word).filter_map(move |(at, _)| {
        let (before, after) = (&source.code[..at], &source.code[at + word.len()..]);
        // `assert` stands for the whole family.
        let open = word == "assert" || word.ends_with(['!', '(', ')']);
        let inside = (!word.starts_with('.') && part(before.chars().next_back()))
            || (!open && part(after.chars().next()));
        let line = before.matches('\n').count() + 1;
        (!inside).then(|| format!("src/{}:{line}: {word}", source.name))
    })
}

// Red when any file of src/ imports from a stage below it in src/lib.rs, as `use crate::target::Strip;` in raster.
#[test]
fn stages_import_only_from_their_left() {
    let sources = sources();
    let stages = stages(&sources);
    assert_eq!(stages.first().map(String::as_str), Some("math"), "numbers come before all stages");
    assert!(stages.len() > 15, "{stages:?}");
    let imports: usize = sources.iter().map(|source| source.imports().len()).sum();
    println!("{} files, {} stages, {imports} imports", sources.len(), stages.len());
    assert!(imports > 80, "imports are not found: {imports}");
    let wrong: Vec<String> = sources.iter().flat_map(|source| wrong_imports(source, &stages)).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

// Red when a file of src/ grows beyond 400 lines before its tests.
#[test]
fn files_are_short() {
    for source in sources() {
        assert!(source.lines <= MOST_LINES, "src/{} has {} lines", source.name, source.lines);
    }
}

// Red when a file of src/ can stop a program: any `unsafe`, `unwrap`, `expect`, assertion or panic outside its tests.
#[test]
fn nothing_stops_a_program() {
    let mut sources = sources();
    for source in &mut sources {
        // What is asserted of types is asserted by the compiler.
        source.code = source.code.replace("const { assert!(", "const { (");
    }
    let found = sources.iter().flat_map(|source| STOPS.iter().flat_map(|word| holding(source, word)));
    let found: Vec<String> = found.collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
}

/// The lines that hold a float: its type, alone or after a number, or a number with a point.
///
/// Clippy knows the types only: a literal that a `fixed` type is compared with links soft-float code unseen.
fn floats(source: &Source) -> Vec<String> {
    let code = &source.code;
    let word = |c: char| c.is_alphanumeric() || c == '_';
    let number = |word: &str| word.starts_with(|c: char| c.is_ascii_digit());
    let mut lines = Vec::new();
    for (at, text) in ["f32", "f64", "."].into_iter().flat_map(|text| code.match_indices(text)) {
        let (before, after) = (&code[..at], &code[at + text.len()..]);
        let start = before.trim_end_matches(word).len();
        let float = if text == "." {
            // Not the fields of a tuple in a tuple: `pair.0.1`.
            number(&before[start..]) && !before[..start].ends_with('.') && number(after)
        } else {
            (start == at || number(&before[start..])) && !after.starts_with(word)
        };
        if float {
            let line = before.matches('\n').count();
            let text = code.lines().nth(line).unwrap_or_default().trim();
            lines.push(format!("src/{}:{}: {text}", source.name, line + 1));
        }
    }
    lines
}

// Red when a float is named or written anywhere but in camera.rs and point.rs.
#[test]
fn floats_stay_at_the_edge() {
    let sources = sources();
    let fenced = sources.iter().filter(|source| !WITH_FLOATS.contains(&source.name.as_str()));
    let found: Vec<String> = fenced.flat_map(floats).collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
    for name in WITH_FLOATS {
        assert!(sources.iter().any(|source| source.name == name && !floats(source).is_empty()), "{name}");
    }
}

// Red when this file's own reading misses a form of import, or sees one in a comment or a string.
#[test]
fn all_forms_of_import_are_seen() {
    let text = "//! crate::no\nuse crate::{a::B, c::{D, e}, f};\nuse super::g::H;\nlet s = \"crate::no\"; // super::no\n\
                crate::i::j(super::super::k);\n\n#[cfg(test)]\nmod tests {\n    use crate::no;\n}\n";
    let names = |path: &str| {
        let imports = Source::new(&PathBuf::from(path), text).imports();
        imports.into_iter().map(|(_, name)| name).collect::<Vec<_>>()
    };
    assert_eq!(names("x.rs"), ["a", "c", "f", "i", "g"]);
    assert_eq!(names("x/mod.rs"), ["a", "c", "f", "i", "g"]);
    assert_eq!(names("x/y.rs"), ["a", "c", "f", "i", "k"]);
    let stages = ["a", "c", "f", "g", "x", "i"].map(String::from);
    let source = Source::new(&PathBuf::from("x.rs"), text);
    assert_eq!(wrong_imports(&source, &stages), ["src/x.rs:5: `x` imports `i`, which is to its right"]);
    let text = "a.unwrap();\nlet unsafely = f32::MAX; // panic!()\ndebug_assert!(x);\nlet y = pair.0.1 + half_f64(1..2);\n\
                z > 0.25 && 1_f64 != lit(\"1.5\")\n";
    let held = Source::new(&PathBuf::from("x.rs"), text);
    let found = STOPS.iter().flat_map(|word| holding(&held, word)).collect::<Vec<_>>();
    assert_eq!(found, ["src/x.rs:1: .unwrap()"]);
    let lines: Vec<String> = floats(&held).iter().map(|line| line[..10].to_owned()).collect();
    assert_eq!(lines, ["src/x.rs:2", "src/x.rs:5", "src/x.rs:5"]);
}
