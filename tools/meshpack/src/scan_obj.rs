//! Checks an OBJ file line by line and writes it out again in the plain form that the parser reads without surprises.
//!
//! The parser names no lines, takes polylines for faces, mixes up attributes that only some faces have, and refuses
//! comments after numbers, continued lines and tabs in front of names: real files have all of these.

use crate::error::{Error, Problem};
use crate::polygon::split_dented;
use std::fmt::Write;
use std::path::Path;

/// Repeats of a texture that its coordinates may span, either way.
const MOST_REPEATS: f64 = 32.0;

/// An OBJ file in plain form.
#[derive(Debug, Default)]
pub(crate) struct Plain {
    /// The text for the parser.
    pub(crate) text: String,
    /// Whether faces have texture coordinates. Where they lack them, they name one more that is 0 0.
    pub(crate) uvs: bool,
    /// Whether faces have normals. Where they lack them, they name one more that is 0 0 0.
    pub(crate) normals: bool,
    /// Whether every vertex has a colour, and the value that is full brightness.
    pub(crate) colours: Option<f64>,
}

/// One corner of a face: vertex, texture coordinate and normal, counted from 1.
type Corner = [Option<usize>; 3];

enum Line<'a> {
    Face(Vec<Corner>),
    Name(&'static str, &'a str),
}

#[derive(Default)]
struct Scan<'a> {
    vertices: Vec<[f64; 3]>,
    colours: Vec<[f64; 3]>,
    uvs: Vec<[f64; 2]>,
    normals: Vec<[f64; 3]>,
    lines: Vec<(usize, Line<'a>)>,
    uvs_used: bool,
    normals_used: bool,
}

/// Checks the text of an OBJ file and makes it plain.
pub(crate) fn plain(path: &Path, bytes: &[u8]) -> Result<Plain, Error> {
    let text = text(path, bytes)?;
    let joined = join_continued(text);
    let mut scan = Scan::default();
    for (number, line) in &joined {
        scan.line(*number, line).map_err(|problem| Error::line(path, *number, problem))?;
    }
    if scan.vertices.is_empty() {
        return Err(Error::file(path, Problem::NotAMesh("vertex ('v' line)")));
    }
    if !scan.lines.iter().any(|(_, line)| matches!(line, Line::Face(_))) {
        return Err(Error::file(path, Problem::NotAMesh("face ('f' line)")));
    }
    scan.check_indices().map_err(|(number, problem)| Error::line(path, number, problem))?;
    Ok(scan.write())
}

/// The bytes as text, without a byte order mark.
pub(crate) fn text<'a>(path: &Path, bytes: &'a [u8]) -> Result<&'a str, Error> {
    let text = std::str::from_utf8(bytes).map_err(|error| {
        let before = &bytes[..error.valid_up_to()];
        let line = before.iter().filter(|&&byte| byte == b'\n').count() + 1;
        Error::line(path, line, Problem::NotText)
    })?;
    let text = text.trim_start_matches('\u{FEFF}');
    if text.trim().is_empty() { Err(Error::file(path, Problem::Empty)) } else { Ok(text) }
}

/// The lines with the number of each, those that end in a backslash joined to the next.
fn join_continued(text: &str) -> Vec<(usize, String)> {
    let mut joined: Vec<(usize, String)> = Vec::new();
    let mut continued = false;
    for (index, line) in text.lines().enumerate() {
        let (part, more) = match line.trim_end().strip_suffix('\\') {
            Some(part) => (part, true),
            None => (line, false),
        };
        match joined.last_mut() {
            Some((_, start)) if continued => {
                start.push(' ');
                start.push_str(part);
            }
            _ => joined.push((index + 1, part.to_owned())),
        }
        continued = more;
    }
    joined
}

impl<'a> Scan<'a> {
    fn line(&mut self, number: usize, line: &'a str) -> Result<(), Problem> {
        let line = line.trim();
        let (keyword, rest) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
        let words = rest.split_whitespace().take_while(|word| !word.starts_with('#'));
        match keyword {
            "v" => self.vertex(words),
            "vt" => self.uv(words),
            "vn" => {
                self.normals.push(three("vn", words)?.0);
                Ok(())
            }
            "f" | "fo" => self.face(number, words),
            "o" | "g" => self.name(number, "g", rest),
            "usemtl" => self.name(number, "usemtl", rest),
            "mtllib" => self.name(number, "mtllib", rest),
            _ => Ok(()),
        }
    }

    fn name(&mut self, number: usize, keyword: &'static str, rest: &'a str) -> Result<(), Problem> {
        if !rest.trim().is_empty() || keyword == "g" {
            self.lines.push((number, Line::Name(keyword, rest.trim())));
        }
        Ok(())
    }

    fn vertex<'w>(&mut self, words: impl Iterator<Item = &'w str>) -> Result<(), Problem> {
        let (mut position, more) = three("v", words)?;
        match *more {
            // A fourth number divides the other three.
            [w] if position.iter().all(|coordinate| (coordinate / w).is_finite()) => {
                position = position.map(|coordinate| coordinate / w);
            }
            [w] => return Err(Problem::NotFinite { keyword: "v".into(), value: format!("1/{w}") }),
            [r, g, b, ..] => self.colours.push([r, g, b]),
            _ => {}
        }
        self.vertices.push(position);
        Ok(())
    }

    fn uv<'w>(&mut self, words: impl Iterator<Item = &'w str>) -> Result<(), Problem> {
        let numbers = numbers("vt", words, 1)?;
        let [u, v] = [numbers[0], numbers.get(1).copied().unwrap_or_default()];
        // v is turned upside down later: 1 - v has to fit as well.
        if u.abs() > MOST_REPEATS {
            return Err(Problem::UvTooFar(u));
        }
        if (1.0 - v).abs() > MOST_REPEATS {
            return Err(Problem::UvTooFar(v));
        }
        self.uvs.push([u, v]);
        Ok(())
    }

    fn face<'w>(&mut self, number: usize, words: impl Iterator<Item = &'w str>) -> Result<(), Problem> {
        let face = words.map(|word| self.corner(word)).collect::<Result<Vec<Corner>, Problem>>()?;
        if face.len() < 3 {
            return Err(Problem::TooFew { keyword: "f".into(), needed: 3, given: face.len() });
        }
        self.uvs_used |= face.iter().any(|corner| corner[1].is_some());
        self.normals_used |= face.iter().any(|corner| corner[2].is_some());
        self.lines.push((number, Line::Face(face)));
        Ok(())
    }

    /// A corner such as `7`, `7/2`, `7//3` or `-1/-1/-1`: indices below 0 count back from the last.
    fn corner(&self, word: &str) -> Result<Corner, Problem> {
        let not_a_number = || Problem::NotANumber { keyword: "f".into(), value: word.into() };
        let counts = [self.vertices.len(), self.uvs.len(), self.normals.len()];
        let mut corner = [None; 3];
        for (place, part) in word.split('/').enumerate() {
            let slot = corner.get_mut(place).ok_or_else(not_a_number)?;
            if part.is_empty() {
                continue;
            }
            let index: i64 = part.parse().map_err(|_| not_a_number())?;
            let absolute = if index < 0 { index.saturating_add(counts[place] as i64 + 1) } else { index };
            if absolute < 1 {
                return Err(Problem::OutOfRange { what: WHAT[place], index, count: counts[place] });
            }
            *slot = Some(absolute as usize);
        }
        if corner[0].is_none() { Err(not_a_number()) } else { Ok(corner) }
    }

    /// Faces may name what comes later in the file, so the upper end is checked last.
    fn check_indices(&self) -> Result<(), (usize, Problem)> {
        let counts = [self.vertices.len(), self.uvs.len(), self.normals.len()];
        for (number, line) in &self.lines {
            let Line::Face(face) = line else { continue };
            for (place, what) in WHAT.into_iter().enumerate() {
                let largest = face.iter().filter_map(|corner| corner[place]).max().unwrap_or_default();
                if largest > counts[place] {
                    let index = i64::try_from(largest).unwrap_or(i64::MAX);
                    return Err((*number, Problem::OutOfRange { what, index, count: counts[place] }));
                }
            }
        }
        Ok(())
    }

    fn positions(&self, face: &[Corner]) -> Vec<[f64; 3]> {
        face.iter().filter_map(|corner| self.vertices.get(corner[0]? - 1)).copied().collect()
    }

    fn write(&self) -> Plain {
        let mut text = String::new();
        let mut put = |line: std::fmt::Arguments<'_>| {
            text.write_fmt(line).expect("a String takes all text");
            text.push('\n');
        };
        let coloured = self.colours.len() == self.vertices.len();
        for (index, [x, y, z]) in self.vertices.iter().enumerate() {
            match self.colours.get(index).filter(|_| coloured) {
                Some([r, g, b]) => put(format_args!("v {x:?} {y:?} {z:?} {r:?} {g:?} {b:?}")),
                None => put(format_args!("v {x:?} {y:?} {z:?}")),
            }
        }
        // One more of each, for the corners that have none.
        let (last_uv, last_normal) = (self.uvs.len() + 1, self.normals.len() + 1);
        for [u, v] in self.uvs.iter().chain([&[0.0, 0.0]]) {
            put(format_args!("vt {u:?} {v:?}"));
        }
        for [x, y, z] in self.normals.iter().chain([&[0.0, 0.0, 0.0]]) {
            put(format_args!("vn {x:?} {y:?} {z:?}"));
        }
        for (_, line) in &self.lines {
            match line {
                Line::Name(keyword, name) => put(format_args!("{keyword} {name}")),
                Line::Face(face) => {
                    let corner = |[v, vt, vn]: &Corner| {
                        let v = v.unwrap_or_default();
                        let (vt, vn) = (vt.unwrap_or(last_uv), vn.unwrap_or(last_normal));
                        format!(" {v}/{vt}/{vn}")
                    };
                    let written: Vec<String> = face.iter().map(corner).collect();
                    // The parser makes fans, which a polygon with a dent does not stand.
                    match split_dented(&self.positions(face)) {
                        None => put(format_args!("f{}", written.concat())),
                        Some(triangles) => {
                            for [a, b, c] in triangles {
                                put(format_args!("f{}{}{}", written[a], written[b], written[c]));
                            }
                        }
                    }
                }
            }
        }
        // Colours are from 0 to 1, or from 0 to 255 in some files.
        let brightest = self.colours.as_flattened().iter().copied().fold(0.0, f64::max);
        let full = if brightest > 1.0 { 255.0 } else { 1.0 };
        Plain { text, uvs: self.uvs_used, normals: self.normals_used, colours: coloured.then_some(full) }
    }
}

/// What the numbers of a corner name, in their order.
const WHAT: [&str; 3] = ["vertex", "texture coordinate", "normal"];

/// Finite numbers, at least `needed`.
pub(crate) fn numbers<'w>(
    keyword: &str,
    words: impl Iterator<Item = &'w str>,
    needed: usize,
) -> Result<Vec<f64>, Problem> {
    let mut numbers = Vec::new();
    for word in words {
        let (keyword, value) = (keyword.to_owned(), word.to_owned());
        match word.parse::<f64>() {
            Ok(number) if number.is_finite() => numbers.push(number),
            Ok(_) => return Err(Problem::NotFinite { keyword, value }),
            Err(_) => return Err(Problem::NotANumber { keyword, value }),
        }
    }
    if numbers.len() < needed {
        return Err(Problem::TooFew { keyword: keyword.into(), needed, given: numbers.len() });
    }
    Ok(numbers)
}

/// Three numbers, and what follows them.
fn three<'w>(keyword: &str, words: impl Iterator<Item = &'w str>) -> Result<([f64; 3], Vec<f64>), Problem> {
    let mut numbers = numbers(keyword, words, 3)?;
    let more = numbers.split_off(3);
    Ok(([numbers[0], numbers[1], numbers[2]], more))
}
