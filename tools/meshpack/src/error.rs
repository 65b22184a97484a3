//! One line for every way in which packing can fail: the file, the line where one is known, the value.

use std::fmt::{self, Display, Formatter};
use std::io;
use std::path::{Path, PathBuf};

/// Why a file was not packed.
#[derive(Debug)]
pub enum Error {
    /// A file cannot be read.
    Read(PathBuf, io::Error),
    /// A file cannot be written.
    Write(PathBuf, io::Error),
    /// A file was read and cannot be packed.
    Input {
        /// The file.
        path: PathBuf,
        /// The line, counted from 1, where one is known.
        line: Option<usize>,
        /// What is wrong there.
        problem: Problem,
    },
}

/// What is wrong with a file, or with a line of it.
#[derive(Clone, Debug, PartialEq)]
pub enum Problem {
    /// Nothing is in the file.
    Empty,
    /// The bytes are not UTF-8 text.
    NotText,
    /// The file's name ends in neither `.obj` nor `.stl`.
    UnknownType,
    /// The file has none of what makes it a mesh: this.
    NotAMesh(&'static str),
    /// Not a number, where one should stand.
    NotANumber {
        /// The line's keyword.
        keyword: String,
        /// What stands there.
        value: String,
    },
    /// NaN or infinite.
    NotFinite {
        /// Where it stands.
        keyword: String,
        /// What stands there.
        value: String,
    },
    /// Too few numbers, or too few corners, follow a keyword.
    TooFew {
        /// The line's keyword.
        keyword: String,
        /// Needed.
        needed: usize,
        /// Given.
        given: usize,
    },
    /// A face names something that is not there.
    OutOfRange {
        /// What the face names: vertex, texture coordinate or normal.
        what: &'static str,
        /// The index as it stands in the file.
        index: i64,
        /// How many there are.
        count: usize,
    },
    /// A word of a text STL file stands where another should.
    Expected {
        /// The word that should stand there.
        needed: &'static str,
        /// The line as it is.
        given: String,
    },
    /// The file ends too early.
    Truncated {
        /// What is missing.
        needed: String,
    },
    /// More vertices than a `u16` counts.
    TooManyVertices(usize),
    /// An attribute has not one entry for each vertex, or for each face.
    LengthMismatch {
        /// Entries given.
        given: usize,
        /// Entries needed.
        needed: usize,
    },
    /// A coordinate is beyond what the library's lengths hold.
    TooFar(f64),
    /// A texture coordinate is beyond 32 repeats.
    UvTooFar(f64),
    /// An image's width or height is not a power of two up to 1024.
    ImageSize(u32, u32),
    /// The parser of the file's format gives this reason.
    Parser(String),
}

impl Error {
    /// An error in the whole of a file.
    pub(crate) fn file(path: &Path, problem: Problem) -> Self {
        Self::Input { path: path.into(), line: None, problem }
    }

    /// An error in a line of a file.
    pub(crate) fn line(path: &Path, line: usize, problem: Problem) -> Self {
        Self::Input { path: path.into(), line: Some(line), problem }
    }
}

impl Display for Error {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Read(path, reason) => write!(f, "{}: cannot be read: {reason}", path.display()),
            Self::Write(path, reason) => write!(f, "{}: cannot be written: {reason}", path.display()),
            Self::Input { path, line: None, problem } => write!(f, "{}: {problem}", path.display()),
            Self::Input { path, line: Some(line), problem } => {
                write!(f, "{}:{line}: {problem}", path.display())
            }
        }
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Read(_, reason) | Self::Write(_, reason) => Some(reason),
            Self::Input { .. } => None,
        }
    }
}

impl Display for Problem {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => write!(f, "the file is empty"),
            Self::NotText => write!(f, "not UTF-8 text"),
            Self::UnknownType => write!(f, "not a mesh file: the name should end in .obj or .stl"),
            Self::NotAMesh(missing) => write!(f, "not a mesh: no {missing}"),
            Self::NotANumber { keyword, value } => {
                write!(f, "'{keyword}' is followed by '{}', which is not a number", Shortened(value))
            }
            Self::NotFinite { keyword, value } => {
                write!(f, "'{keyword}' is followed by '{}', which is not finite", Shortened(value))
            }
            Self::TooFew { keyword, needed, given } => {
                write!(f, "'{keyword}' needs at least {needed} entries, and {given} are given")
            }
            Self::OutOfRange { what, index, count } => {
                write!(f, "a face names {what} {index}, and there are {count}")
            }
            Self::Expected { needed, given } => {
                write!(f, "'{needed}' should stand here, and not '{}'", Shortened(given))
            }
            Self::Truncated { needed } => write!(f, "the file is cut off: {needed}"),
            Self::TooManyVertices(count) => {
                write!(f, "{count} vertices, and a mesh holds at most {}", topleft::MAX_VERTICES)
            }
            Self::LengthMismatch { given, needed } => {
                write!(f, "{given} entries of an attribute, and {needed} are needed")
            }
            Self::TooFar(value) => {
                write!(f, "coordinate {value} is beyond ±32767 units: give --scale or --fit")
            }
            Self::UvTooFar(value) => write!(f, "texture coordinate {value} is beyond ±32 repeats"),
            Self::ImageSize(width, height) => write!(
                f,
                "{width}x{height} pixels: a texture's width and height are powers of two from 1 to {}",
                topleft::MAX_TEXTURE_SIZE
            ),
            Self::Parser(reason) => write!(f, "{}", Shortened(reason)),
        }
    }
}

/// A value from a file, on one line and of a bearable length.
struct Shortened<'a>(&'a str);

impl Display for Shortened<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        const MOST: usize = 120;
        for character in self.0.chars().take(MOST).flat_map(char::escape_debug) {
            write!(f, "{character}")?;
        }
        if self.0.chars().nth(MOST).is_some() { write!(f, "…") } else { Ok(()) }
    }
}
