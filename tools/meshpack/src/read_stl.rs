//! Reads STL, text and binary.

use crate::error::{Error, Problem};
use crate::model::{Corner, Model, Welder};
use crate::scan_obj::{numbers, text};
use std::fmt::Write;
use std::fs;
use std::io::Cursor;
use std::path::Path;

/// Bytes before the first triangle of a binary file: a free text and the number of triangles.
const HEADER: usize = 84;
/// Bytes of a triangle in a binary file.
const TRIANGLE: usize = 50;

/// Reads an STL file. Corners at one point become one vertex with a smooth normal: the normals of the file are not
/// used, because many programs write them wrong.
///
/// # Errors
/// A file that cannot be read, is empty, is no STL, is cut off, or has a coordinate that is not finite.
pub fn read_stl(path: impl AsRef<Path>) -> Result<Model, Error> {
    let path = path.as_ref();
    let mut bytes = fs::read(path).map_err(|error| Error::Read(path.into(), error))?;
    if bytes.is_empty() {
        return Err(Error::file(path, Problem::Empty));
    }
    let mut warnings = Vec::new();
    let bytes = if is_text(&bytes) {
        plain_text(path, text(path, &bytes)?)?.into_bytes()
    } else {
        let needed = check_binary(path, &bytes)?;
        if bytes.len() > needed {
            warnings.push(format!(
                "{}: {} bytes after the last triangle",
                path.display(),
                bytes.len() - needed
            ));
        }
        // The reader takes each file that starts with "solid" for text, and the first 80 bytes mean nothing.
        bytes[..5].fill(b' ');
        bytes
    };
    let mesh = stl_io::read_stl(&mut Cursor::new(bytes))
        .map_err(|error| Error::file(path, Problem::Parser(error.to_string())))?;

    let mut welder = Welder::default();
    for (number, face) in mesh.faces.iter().enumerate() {
        let corners = face.vertices.map(|index| {
            let position = mesh.vertices[index].0.map(f64::from);
            Corner { position, ..Corner::default() }
        });
        if let Some(value) =
            corners.iter().flat_map(|corner| corner.position).find(|value| !value.is_finite())
        {
            let keyword = format!("triangle {}", number + 1);
            return Err(Error::file(path, Problem::NotFinite { keyword, value: value.to_string() }));
        }
        welder.face(corners, None);
    }
    Ok(Model { warnings, ..welder.finish(path) })
}

/// Binary files may start with "solid" as well, but then their length is the one that their count demands.
fn is_text(bytes: &[u8]) -> bool {
    let start = bytes.trim_ascii_start();
    let named = start.get(..5).is_some_and(|word| word.eq_ignore_ascii_case(b"solid"));
    named && binary_length(bytes) != Some(bytes.len())
}

/// The length that the header of a binary file demands.
fn binary_length(bytes: &[u8]) -> Option<usize> {
    let (header, _) = bytes.split_first_chunk::<HEADER>()?;
    let count = header.last_chunk().copied().map(u32::from_le_bytes)?;
    usize::try_from(count).ok()?.checked_mul(TRIANGLE)?.checked_add(HEADER)
}

fn check_binary(path: &Path, bytes: &[u8]) -> Result<usize, Error> {
    let given = bytes.len();
    let needed = match binary_length(bytes) {
        None => format!("neither text nor binary STL: {given} bytes, and the header alone is {HEADER}"),
        Some(HEADER) => return Err(Error::file(path, Problem::NotAMesh("triangle"))),
        Some(length) if length <= given => return Ok(length),
        Some(length) => {
            let count = (length - HEADER) / TRIANGLE;
            format!("the header counts {count} triangles, {length} bytes, and {given} bytes are there")
        }
    };
    Err(Error::file(path, Problem::Truncated { needed }))
}

/// The words that each line of a triangle starts with, in their order.
const TRIANGLE_LINES: [&str; 7] =
    ["facet normal", "outer loop", "vertex", "vertex", "vertex", "endloop", "endfacet"];

/// Checks a text file line by line and writes it out as one solid, because the reader names no lines, stops after the
/// first solid, and minds the case of letters.
fn plain_text(path: &Path, text: &str) -> Result<String, Error> {
    let mut plain = String::from("solid mesh\n");
    let mut state = 0;
    let (mut inside, mut last) = (false, 0);
    for (index, line) in text.lines().enumerate() {
        last = index + 1;
        let line = line.trim();
        let lower = line.to_ascii_lowercase();
        let mut words = lower.split_whitespace();
        let Some(word) = words.next() else { continue };
        let fail = |problem| Error::line(path, last, problem);
        match word {
            "solid" if !inside => inside = true,
            "endsolid" if inside && state == 0 => inside = false,
            _ => {
                let expected = if inside { TRIANGLE_LINES[state] } else { "solid" };
                let mut named = std::iter::once(word).chain(words);
                if !inside || !expected.split(' ').all(|needed| named.next() == Some(needed)) {
                    return Err(fail(Problem::Expected { needed: expected, given: line.into() }));
                }
                write_line(&mut plain, expected, named).map_err(fail)?;
                state = (state + 1) % TRIANGLE_LINES.len();
            }
        }
    }
    if inside {
        let expected = if state == 0 { "endsolid" } else { TRIANGLE_LINES[state] };
        return Err(Error::line(
            path,
            last,
            Problem::Truncated { needed: format!("'{expected}' should follow") },
        ));
    }
    plain += "endsolid mesh\n";
    Ok(plain)
}

fn write_line<'w>(
    plain: &mut String,
    keyword: &str,
    words: impl Iterator<Item = &'w str>,
) -> Result<(), Problem> {
    let written = match keyword {
        // Triangles without area often have no number for a normal, and no normal is read anyway.
        "facet normal" => writeln!(plain, "facet normal 0 0 0"),
        "vertex" => match *numbers(keyword, words, 3)? {
            // The reader keeps coordinates as f32.
            [x, y, z, ..] if [x, y, z].iter().all(|value| (*value as f32).is_finite()) => {
                writeln!(plain, "vertex {x:?} {y:?} {z:?}")
            }
            ref all => {
                return Err(Problem::NotFinite { keyword: keyword.into(), value: format!("{all:?}") });
            }
        },
        _ => writeln!(plain, "{keyword}"),
    };
    written.expect("a String takes all text");
    Ok(())
}
