//! Draws a scene, or a mesh of yours, on a simulated display: a picture, an animation, and what it took.
//!
//! `cargo run --release --example viewer -- --help` lists what it can do.

mod animate;
mod figures;
mod load;
mod options;
mod stage;
#[cfg(feature = "window")]
mod window;

use std::process::ExitCode;

use options::{Options, Task};

fn main() -> ExitCode {
    match Options::from_command_line().and_then(|options| run(&options)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::from(2)
        }
    }
}

/// Does what was asked for; or says in one line why not.
fn run(options: &Options) -> Result<(), String> {
    match options.task()? {
        Task::List => {
            for scene in scenes::SCENES {
                println!("{:10} {}", scene.name, scene.about);
            }
            Ok(())
        }
        Task::Animate(scene) => animate::animate(&scene, options),
        #[cfg(feature = "window")]
        Task::Window(scene) => window::show(&scene, options),
    }
}
