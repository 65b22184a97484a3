//! The command line.

use std::path::PathBuf;

use clap::Parser;
use clap::builder::PossibleValuesParser;
use embedded_graphics::geometry::Size;
use scenes::{Method, Scene, Shade, View};
use topleft::Viewport;

use crate::load;

/// Draws a scene or a mesh on a simulated display: a PNG, an animated GIF, and what it took.
#[derive(Debug, Parser)]
#[command(name = "viewer")]
pub(crate) struct Options {
    /// Draw this mesh, turning over a floor, instead of a scene
    #[arg(long, value_name = "FILE.obj|.stl", conflicts_with = "scene")]
    mesh: Option<PathBuf>,

    /// Lay this image on the mesh: its sizes must be powers of two up to 1024
    #[arg(long, value_name = "FILE")]
    texture: Option<PathBuf>,

    /// Draw this scene
    #[arg(long, value_name = "NAME", default_value = "teapot")]
    scene: String,

    /// List the scenes
    #[arg(long)]
    list: bool,

    /// Size of the display in pixels
    #[arg(long, value_name = "WxH", default_value = "240x240", value_parser = size)]
    pub(crate) size: Size,

    /// Frames of the animation
    #[arg(long, value_name = "N", default_value_t = 60, value_parser = clap::value_parser!(u16).range(1..=3600))]
    pub(crate) frames: u16,

    /// Rows drawn at a time
    #[arg(long, value_name = "ROWS", default_value_t = 16, value_parser = clap::value_parser!(u16).range(1..))]
    pub(crate) strip: u16,

    /// Shade everything so, instead of each object its own way
    #[arg(long, value_parser = PossibleValuesParser::new(Shade::ALL.map(Shade::name)))]
    shade: Option<String>,

    /// Find texels so
    #[arg(long, value_parser = PossibleValuesParser::new(Method::ALL.map(Method::name)))]
    method: Option<String>,

    /// Where the files go
    #[arg(long, value_name = "DIR", default_value = "target/viewer")]
    pub(crate) out: PathBuf,

    /// Open a window: drag or arrows turn, the wheel or + and - zoom, S, M and R change shading, method and rows,
    /// P saves a picture, Escape closes
    #[arg(long)]
    window: bool,
}

/// What to do.
pub(crate) enum Task {
    List,
    Animate(Scene),
    #[cfg(feature = "window")]
    Window(Scene),
}

impl Options {
    /// The options as given; `--help` and mistakes in them end the program here.
    pub(crate) fn from_command_line() -> Result<Self, String> {
        Self::try_parse().map_err(|error| {
            if error.use_stderr() {
                // One line: what is wrong, and what would be right. The rest is in --help.
                let text = error.to_string();
                let mut lines = text.lines().map(str::trim);
                let what = lines.next().unwrap_or_default().trim_start_matches("error: ");
                let choice =
                    lines.find(|line| line.starts_with("[possible values")).unwrap_or("(see --help)");
                return format!("{what} {choice}");
            }
            error.exit()
        })
    }

    /// What to do, with all files read.
    pub(crate) fn task(&self) -> Result<Task, String> {
        if self.list {
            return Ok(Task::List);
        }
        let texture = self.texture.as_ref().map(load::texture).transpose()?;
        let scene = match &self.mesh {
            Some(path) => load::mesh(path, texture)?,
            None => {
                let scene = scenes::by_name(&self.scene)
                    .ok_or_else(|| format!("--scene {}: there is no such scene (see --list)", self.scene))?;
                load::with_texture(*scene, texture)
            }
        };
        if self.window {
            return window_task(scene);
        }
        Ok(Task::Animate(scene))
    }

    /// The view that the animation starts with.
    pub(crate) fn view(&self) -> View {
        let shade = self.shade.as_ref().and_then(|name| Shade::ALL.into_iter().find(|s| s.name() == name));
        let method = self.method.as_ref().and_then(|name| Method::ALL.into_iter().find(|m| m.name() == name));
        View { shade, method, ..View::default() }
    }
}

#[cfg(feature = "window")]
fn window_task(scene: Scene) -> Result<Task, String> {
    Ok(Task::Window(scene))
}

#[cfg(not(feature = "window"))]
fn window_task(_: Scene) -> Result<Task, String> {
    Err("--window: this build has no window; run it with `--features window` (it needs SDL 2)".into())
}

/// Width and height with an x between, of a display that can be drawn to.
fn size(text: &str) -> Result<Size, String> {
    let parts = text.split_once('x').and_then(|(w, h)| Some((w.parse().ok()?, h.parse().ok()?)));
    let Some((width, height)) = parts else { return Err("a size looks like 240x240".into()) };
    if width == 0 || height == 0 {
        return Err("a display has at least one pixel".into());
    }
    let size = Size::new(width, height);
    match Viewport::new(size) {
        Ok(_) => Ok(size),
        Err(_) => Err("too large: at most 2^23 pixels, 8190 columns and 4094 rows".into()),
    }
}
