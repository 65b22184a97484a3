//! Draws `docs/chart`: what each method costs against how far off it is, and fills the tables of
//! `docs/speed-and-accuracy.md`.

mod plot;
mod table;

#[path = "../../../tests/against_reference/patches.rs"]
#[allow(dead_code, reason = "the tests have use for all of it")]
mod patches;
#[path = "../../../tests/against_reference/probe.rs"]
#[allow(dead_code, reason = "the tests have use for all of it")]
mod probe;
#[path = "../../../tests/against_reference/random.rs"]
#[allow(dead_code, reason = "the tests have use for all of it")]
mod random;
#[path = "../../../tests/support/tolerance.rs"]
#[allow(dead_code, reason = "the tests have use for all of it")]
mod tolerance;

mod method;
mod spy;

mod colour;
mod cost;
mod depth;
mod host;
mod ram;
mod texels;
mod traversal;
mod within;

mod figures;
mod gather;
mod output;
mod page;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Parser;

/// Measures errors, reads costs, and draws the charts of docs/speed-and-accuracy.md.
#[derive(Debug, Parser)]
#[command(version)]
struct Options {
    /// The repository.
    #[arg(long, value_name = "FOLDER", default_value = concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))]
    root: PathBuf,
    /// Compare with the files that are there, and write none. Columns of the host are not compared.
    #[arg(long)]
    check: bool,
    /// Keep the columns of the host as they are.
    #[arg(long)]
    keep_host: bool,
}

fn main() -> ExitCode {
    let options = Options::parse();
    match run(&options) {
        Ok(wrong) if wrong.is_empty() => ExitCode::SUCCESS,
        Ok(wrong) => {
            wrong.iter().for_each(|line| eprintln!("{line}"));
            eprintln!("`cargo run --release -p chart` writes them again");
            ExitCode::FAILURE
        }
        Err(line) => {
            eprintln!("{line}");
            ExitCode::from(2)
        }
    }
}

/// What differs, where that is asked for; an error where a file cannot be read or written, or where a promise that is
/// checked is not kept.
fn run(options: &Options) -> Result<Vec<String>, String> {
    let root: &Path = &options.root;
    let inputs = gather::Inputs::read(root)?;
    let tables = gather::tables(&inputs, options.check || options.keep_host)?;
    let files = output::files(root, &tables, &inputs)?;
    if !options.check {
        return output::write(root, &files).map(|()| Vec::new());
    }
    within::kept(&tables.within)?;
    output::check(root, &files)
}
