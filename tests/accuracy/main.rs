//! The table of errors, `docs/measured/accuracy.csv`: measured by the functions that the tests assert with.
//!
//! `cargo test --test accuracy` measures and compares with the table, `cargo test --test accuracy -- --write` writes it.
//! Other arguments are those of `cargo test` for its own harness, and are not looked at.
#![allow(clippy::disallowed_types, reason = "the reference computes with floats")]
#![allow(dead_code, unused_imports, reason = "what only asserts is left out here")]

#[path = "../support/mod.rs"]
mod support;

#[path = "../coverage/fans.rs"]
mod fans;
#[path = "../coverage/many.rs"]
mod many;
#[path = "../coverage/triangles.rs"]
mod triangles;

#[path = "../against_reference/patches.rs"]
mod patches;
#[path = "../against_reference/probe.rs"]
mod probe;
#[path = "../against_reference/random.rs"]
mod random;

#[path = "../against_reference/colour.rs"]
mod colour;
#[path = "../against_reference/depth.rs"]
mod depth;
#[path = "../against_reference/frames.rs"]
mod frames;
#[path = "../against_reference/interpolation.rs"]
mod interpolation;
#[path = "../against_reference/light.rs"]
mod light;
#[path = "../against_reference/methods.rs"]
mod methods;
#[path = "../against_reference/numbers.rs"]
mod numbers;
#[path = "../against_reference/texels.rs"]
mod texels;
#[path = "../against_reference/vertices.rs"]
mod vertices;

use std::collections::BTreeSet;
use std::path::Path;
use std::process::ExitCode;
use std::{env, fs};

use indicatif::{ProgressBar, ProgressStyle};
use random::Kind;
use scenes::SCENES;
use support::measured::Row;
use support::tolerance::DERIVED;
use support::{measured, tolerance};

const TABLE: &str = "docs/measured/accuracy.csv";

/// One part of the table: what the progress bar says, and what measures it.
type Part = (String, Box<dyn Fn() -> Vec<Row>>);

fn part(name: impl Into<String>, rows: impl Fn() -> Vec<Row> + 'static) -> Part {
    (name.into(), Box::new(rows))
}

/// The table's parts, in the order of the data.
fn parts() -> Vec<Part> {
    let mut parts = vec![
        part("camera", || [numbers::matrices(), vec![numbers::rotations(), numbers::sines()]].concat()),
        part("vertices", vertices::at_every_distance),
    ];
    parts.extend(
        SCENES.iter().map(|scene| part(format!("vertices: {}", scene.name), || vertices::of_scene(scene))),
    );
    parts.extend([
        part("coverage: triangles", || {
            vec![
                triangles::ties(),
                triangles::middle_sized(),
                triangles::needles(),
                triangles::as_large_as_the_guard(),
            ]
        }),
        part("coverage: fans", || vec![fans::on_half_pixels(), fans::on_the_finest_lattice()]),
        part("coverage: meshes", || vec![many::meshes()]),
    ]);
    parts.extend(
        Kind::ALL.map(|kind| {
            part(format!("interpolation: {}", kind.name()), move || interpolation::of_kind(kind))
        }),
    );
    parts.push(part("interpolation: whole path", || vec![interpolation::whole_path()]));
    parts.push(part("depth", depth::in_buffer));
    parts.extend(
        texels::KINDS
            .map(|kind| part(format!("texels: {}", kind.name()), move || texels::per_pixel_of(kind))),
    );
    parts.push(part("texels: affine", || {
        let on_planes = texels::KINDS.map(texels::affine_of);
        let shortcut = texels::RATIOS.map(texels::affine_for_perspective);
        on_planes.into_iter().chain(shortcut).collect()
    }));
    parts.extend(
        methods::KINDS.map(|kind| {
            part(format!("texels: subspans, {}", kind.name()), move || methods::subspans_of(kind))
        }),
    );
    parts.push(part("texels: divided", || methods::KINDS.map(methods::divided_of).to_vec()));
    parts.extend(methods::ALLOWED.map(|allowed| {
        part(format!("texels: within {}", allowed.1), move || vec![methods::within_error(allowed)])
    }));
    parts.push(part("texels: whole path", || vec![texels::whole_path()]));
    parts.push(part("light", || [light::on_vertices(), light::on_faces()].concat()));
    parts.extend(
        colour::ALLOWED
            .map(|allowed| part(format!("colour: within {allowed}"), move || colour::within(allowed))),
    );
    parts.extend(
        SCENES.iter().map(|scene| part(format!("frames: {}", scene.name), || frames::of_scene(scene))),
    );
    parts.extend(
        frames::SMOOTH
            .map(|name| part(format!("frames: {name} in one colour"), move || frames::within_colour(name))),
    );
    parts
}

/// Measures all parts. Panics where a bound does not hold, or is not reached where it should be.
fn measure() -> Vec<Row> {
    let parts = parts();
    let style = ProgressStyle::with_template("{bar:30} {pos}/{len} {msg}").expect("a template");
    let bar = ProgressBar::new(parts.len() as u64).with_style(style);
    let mut rows = Vec::new();
    for (name, part) in parts {
        bar.set_message(name);
        rows.extend(part());
        bar.inc(1);
    }
    bar.finish_and_clear();
    rows.iter().for_each(Row::hold);
    rows
}

/// What a row is about: no two rows have the same.
fn keys(rows: &[Row]) -> BTreeSet<[&str; 4]> {
    rows.iter().map(|row| [row.stage, &row.scene, &row.method, row.metric]).collect()
}

/// Every row has a derivation, and every derivation a row; each row is told from all others.
fn check_derivations(rows: &[Row]) -> Result<(), String> {
    let measured: BTreeSet<_> = rows.iter().map(|row| (row.stage, row.metric)).collect();
    let derived: BTreeSet<_> = DERIVED.iter().map(|&(stage, metric, _)| (stage, metric)).collect();
    if let Some((stage, metric)) = measured.difference(&derived).next() {
        return Err(format!("{stage}, {metric} has no derivation in tests/support/tolerance.rs"));
    }
    if let Some((stage, metric)) = derived.difference(&measured).next() {
        return Err(format!("{stage}, {metric} is derived in tests/support/tolerance.rs, and not measured"));
    }
    if keys(rows).len() < rows.len() {
        return Err("two rows have the same stage, scene, method and metric".into());
    }
    Ok(())
}

/// The lines that differ, both ways.
fn compare(committed: &str, measured: &str) -> Result<(), String> {
    if committed == measured {
        return Ok(());
    }
    let lines = |text: &str| text.lines().map(str::to_owned).collect::<BTreeSet<_>>();
    let (committed, measured) = (lines(committed), lines(measured));
    let only = |a: &BTreeSet<String>, b: &BTreeSet<String>, sign: &str| -> String {
        a.difference(b).map(|line| format!("{sign} {line}\n")).collect()
    };
    let differences = only(&committed, &measured, "-") + &only(&measured, &committed, "+");
    Err(format!(
        "{TABLE} is not what is measured here:\n{differences}`cargo test --test accuracy -- --write` writes it"
    ))
}

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let has = |argument: &str| arguments.iter().any(|given| given == argument);
    if has("--list") {
        return ExitCode::SUCCESS;
    }
    // The names of tests to run, as `cargo test NAME` hands them to every target.
    let names: Vec<_> = arguments.iter().filter(|argument| !argument.starts_with('-')).collect();
    if !names.is_empty() && !names.iter().any(|&name| "accuracy".contains(name.as_str())) {
        return ExitCode::SUCCESS;
    }
    let rows = measure();
    let table: String = [Row::COLUMNS.to_owned()]
        .into_iter()
        .chain(rows.iter().map(Row::to_string))
        .map(|line| line + "\n")
        .collect();
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(TABLE);
    let result = check_derivations(&rows).and_then(|()| {
        if has("--write") {
            fs::write(&path, &table).map_err(|error| format!("{TABLE}: {error}"))
        } else {
            let committed = fs::read_to_string(&path).map_err(|error| format!("{TABLE}: {error}"))?;
            compare(&committed, &table)
        }
    });
    match result {
        Ok(()) => {
            let worst = rows.iter().map(|row| row.ratio).fold(0.0, f64::max);
            println!("accuracy: {} rows, none above {worst:.4} of its bound", rows.len());
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}
