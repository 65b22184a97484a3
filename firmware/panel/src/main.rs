//! Compares the frames of an emulated panel with those that the host draws, byte for byte, and prints a table of them.
//!
//! Usage: `panel FRAMES [--pictures FOLDER] [--check-pictures FOLDER] [--gif FILE]`, where `FRAMES` is what
//! `emulator/panel.js` wrote; or `panel --scenes`, for how many scenes there are. Exit status 1 where something differs, 2
//! where something cannot be read or written.

mod host;
mod picture;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// What is asked for.
struct Options {
    frames: PathBuf,
    pictures: Option<PathBuf>,
    check: Option<PathBuf>,
    gif: Option<PathBuf>,
}

const USAGE: &str =
    "Usage: panel FRAMES [--pictures FOLDER] [--check-pictures FOLDER] [--gif FILE], or panel --scenes";

/// Why there is no table.
enum Failure {
    /// The panel does not show what it should.
    Differs(String),
    /// A file, or the command line.
    Unusable(String),
}

fn main() -> ExitCode {
    let (status, text) = match options(std::env::args().skip(1)).and_then(|options| run(&options)) {
        Ok(()) => return ExitCode::SUCCESS,
        Err(Failure::Differs(text)) => (1, text),
        Err(Failure::Unusable(text)) => (2, text),
    };
    eprintln!("{text}");
    ExitCode::from(status)
}

fn options(mut words: impl Iterator<Item = String>) -> Result<Options, Failure> {
    let usage = || Failure::Unusable(USAGE.into());
    let mut options =
        Options { frames: words.next().ok_or_else(usage)?.into(), pictures: None, check: None, gif: None };
    while let Some(word) = words.next() {
        let place = match word.as_str() {
            "--pictures" => &mut options.pictures,
            "--check-pictures" => &mut options.check,
            "--gif" => &mut options.gif,
            _ => return Err(usage()),
        };
        *place = Some(words.next().ok_or_else(usage)?.into());
    }
    Ok(options)
}

fn run(options: &Options) -> Result<(), Failure> {
    if options.frames.as_os_str() == "--scenes" {
        println!("{}", host::scenes());
        return Ok(());
    }
    let table = read(&options.frames.join("frames.csv"))?;
    let table = String::from_utf8_lossy(&table);
    let mut host = host::Host::default();
    let mut animation = Vec::new();
    println!("scene,frame,left_out,cycles,crc");
    for line in table.lines().skip(1) {
        let cells: Vec<_> = line.split(',').filter_map(|cell| cell.parse::<usize>().ok()).collect();
        let [number, frame, cycles] = cells[..] else {
            return Err(Failure::Unusable(format!("frames.csv: not a frame: {line}")));
        };
        let shown = picture::words(&read(&options.frames.join(format!("{number}-{frame}.rgb565")))?);
        let drawn = host.draw(number, frame);
        let scene = drawn.scene;
        if let Some(difference) = picture::difference(&shown, drawn.frame) {
            return Err(Failure::Differs(format!("{scene}, frame {frame}: {difference}")));
        }
        println!("{scene},{frame},{},{cycles},{:08x}", drawn.left_out, picture::crc(&shown));
        let name = format!("panel-{scene}.png");
        if let (0, Some(folder)) = (frame, &options.pictures) {
            picture::write_png(&folder.join(&name), &shown).map_err(Failure::Unusable)?;
        }
        if let (0, Some(folder)) = (frame, &options.check) {
            let committed = picture::read_png(&folder.join(&name)).map_err(Failure::Unusable)?;
            if committed != picture::rgb(&shown) {
                return Err(Failure::Differs(format!("{name} shows another picture than the panel")));
            }
        }
        if options.gif.is_some() {
            animation.push(shown);
        }
    }
    match &options.gif {
        Some(file) => picture::write_gif(file, &animation).map_err(Failure::Unusable),
        None => Ok(()),
    }
}

fn read(path: &Path) -> Result<Vec<u8>, Failure> {
    std::fs::read(path).map_err(|error| Failure::Unusable(format!("{}: {error}", path.display())))
}
