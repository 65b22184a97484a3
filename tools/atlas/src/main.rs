//! Draws `docs/atlas`: what each naive method does where it fails, beside the library and the reference, and maps of
//! where methods break.

mod axis;
mod canvas;
mod file;

#[path = "../../../tests/against_reference/patches.rs"]
#[allow(dead_code, reason = "the tests have use for all of it")]
mod patches;
#[path = "../../../tests/against_reference/probe.rs"]
#[allow(dead_code, reason = "the tests have use for all of it")]
mod probe;
#[path = "../../../tests/against_reference/random.rs"]
#[allow(dead_code, reason = "the tests have use for all of it")]
mod random;
#[path = "../../../tests/stability/planes.rs"]
mod planes;
#[path = "../../../tests/support/tolerance.rs"]
#[allow(dead_code, reason = "the tests have use for all of it")]
mod tolerance;

mod map;
mod maps;

mod drawn;
mod strip;
mod strips;

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{fs, io};

use canvas::Canvas;
use clap::Parser;
use indicatif::{ProgressBar, ProgressStyle};

/// Draws the pictures of docs/stability.md.
#[derive(Parser)]
#[command(version)]
struct Options {
    /// The folder that gets them.
    #[arg(long, value_name = "FOLDER", default_value = "docs/atlas")]
    out: PathBuf,
    /// Compare with the pictures in the folder, and write none.
    #[arg(long)]
    check: bool,
    /// Draw only pictures whose names have this in them.
    #[arg(long, value_name = "TEXT", default_value = "")]
    only: String,
}

/// A picture's file without `.png`, and what draws it.
type Entry = (&'static str, fn() -> Canvas);

fn main() -> ExitCode {
    let options = Options::parse();
    let entries: Vec<Entry> = [maps::ALL, strips::ALL]
        .concat()
        .into_iter()
        .filter(|(name, _)| name.contains(&options.only))
        .collect();
    if entries.is_empty() {
        eprintln!("--only {}: no picture has that in its name", options.only);
        return ExitCode::from(2);
    }
    let style = ProgressStyle::with_template("{bar:30} {pos}/{len} {msg}").expect("a template");
    let bar = ProgressBar::new(entries.len() as u64).with_style(style);
    let mut wrong = Vec::new();
    let mut bytes = 0;
    for &(name, draw) in &entries {
        bar.set_message(name);
        let path = options.out.join(name).with_extension("png");
        let file = file::png(&draw());
        bytes += file.len();
        let done = if options.check { check(&path, &file) } else { write(&path, &file) };
        wrong.extend(done.err().map(|reason| format!("{}: {reason}", path.display())));
        bar.inc(1);
    }
    bar.finish_and_clear();
    if options.check && options.only.is_empty() {
        wrong.extend(strangers(&options.out, &entries));
    }
    for line in &wrong {
        eprintln!("{line}");
    }
    match (wrong.is_empty(), options.check) {
        (true, true) => println!("atlas: {} pictures are as drawn here", entries.len()),
        (true, false) => println!("atlas: {} pictures, {} kB", entries.len(), bytes.div_ceil(1000)),
        (false, true) => eprintln!("`cargo run --release -p atlas` draws them again"),
        (false, false) => return ExitCode::from(2),
    }
    if wrong.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

fn write(path: &Path, file: &[u8]) -> io::Result<()> {
    path.parent().map_or(Ok(()), fs::create_dir_all)?;
    fs::write(path, file)
}

fn check(path: &Path, file: &[u8]) -> io::Result<()> {
    if fs::read(path)? == file { Ok(()) } else { Err(io::Error::other("is not what is drawn here")) }
}

/// Pictures in the folder that nothing draws.
fn strangers(folder: &Path, entries: &[Entry]) -> Vec<String> {
    let files = fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
    files
        .filter(|path| {
            path.extension().is_some_and(|extension| extension == "png")
                && !entries.iter().any(|&(name, _)| path.file_stem().is_some_and(|stem| stem == name))
        })
        .map(|path| format!("{}: nothing draws it", path.display()))
        .collect()
}
