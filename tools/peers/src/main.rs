//! Draws `grid240` with topleft and with other rasterizers, in turn, and writes how long each takes and which pixels it
//! misses or draws more than once to `docs/chart/peers.csv`.

mod draw;
mod grid;
mod peer;

use std::fmt::Write as _;
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::{Duration, Instant};
use std::{fs, io};

use clap::Parser;
use grid::Coverage;
use indicatif::{ProgressBar, ProgressStyle};

/// Times topleft beside other rasterizers and counts the pixels that they miss or draw twice.
#[derive(Parser)]
#[command(version)]
struct Options {
    /// The table that is written.
    #[arg(long, value_name = "FILE", default_value = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/chart/peers.csv"))]
    out: PathBuf,
    /// Times that each draws the grid.
    #[arg(long, value_name = "N", default_value_t = 600, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    rounds: u32,
}

fn main() -> ExitCode {
    let options = Options::parse();
    let table = measure(options.rounds);
    print!("{table}");
    match write(&options.out, &table) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{}: {error}", options.out.display());
            ExitCode::from(2)
        }
    }
}

fn write(path: &std::path::Path, text: &str) -> io::Result<()> {
    path.parent().map_or(Ok(()), fs::create_dir_all)?;
    fs::write(path, text)
}

/// Rounds go round all of them, so that what slows the machine down for a while slows all down. The least time of each
/// is what it takes; the ratio is the median of each round's.
fn measure(rounds: u32) -> String {
    let (faces, mut peers) = (grid::faces(), draw::all());
    let style = ProgressStyle::with_template("{bar:30} {pos}/{len} {msg}").expect("a template");
    let bar = ProgressBar::new(u64::from(rounds) + peers.len() as u64).with_style(style);
    bar.set_message("coverage");
    let coverage: Vec<Coverage> = peers
        .iter_mut()
        .map(|peer| {
            bar.inc(1);
            grid::coverage(faces.len(), |range| {
                peer.run(&faces[range], &mut |draw| draw());
                peer.pixels()
            })
        })
        .collect();
    bar.set_message("rounds");
    let mut times = vec![Vec::with_capacity(rounds as usize); peers.len()];
    for _ in 0..rounds {
        for (peer, times) in peers.iter_mut().zip(&mut times) {
            peer.run(&faces, &mut |draw| {
                let start = Instant::now();
                draw();
                times.push(start.elapsed());
            });
        }
        bar.inc(1);
    }
    bar.finish_and_clear();

    let mut table = String::from("peer,version,work,given,missing,doubled,host_us,host_ratio\n");
    for (k, peer) in peers.iter().enumerate() {
        let least = times[k].iter().min().copied().unwrap_or_default();
        // Against ours from the list that does the same work.
        let ours = peers
            .iter()
            .position(|other| other.name().ends_with("from the list") && other.work() == peer.work());
        let ratio = ours.map_or(1.0, |ours| median(&times[k], &times[ours]));
        let Coverage { missing, doubled } = coverage[k];
        let _ = writeln!(
            table,
            "\"{}\",{},{},{},{missing},{doubled},{:.1},{ratio:.2}",
            peer.name(),
            peer.version(),
            peer.work(),
            peer.given(),
            least.as_secs_f64() * 1e6
        );
    }
    table
}

/// The median ratio of times of the same round.
fn median(times: &[Duration], ours: &[Duration]) -> f64 {
    let mut ratios: Vec<f64> =
        times.iter().zip(ours).map(|(time, ours)| time.as_secs_f64() / ours.as_secs_f64()).collect();
    ratios.sort_by(f64::total_cmp);
    ratios.get(ratios.len() / 2).copied().unwrap_or(1.0)
}
