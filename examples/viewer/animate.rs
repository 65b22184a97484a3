//! The animation: a PNG of its first frame, a GIF of all, and figures.

use std::fs;
use std::io::Cursor;
use std::path::Path;
use std::time::Duration;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};
use gif::{Encoder, Frame, Repeat};
use image::ImageFormat;
use indicatif::{ProgressBar, ProgressStyle};
use scenes::{Scene, View};
use topleft::Turn;

use crate::figures::Pixels;
use crate::options::Options;
use crate::stage::{Stage, Took};

/// Hundredths of a second a frame of the GIF is shown.
const FRAME_TIME: u16 = 4;
/// How hard the palette is sought: 1 is best, 30 fastest.
const PALETTE_SPEED: i32 = 10;

/// Draws the whole animation, writes it, and prints what it took.
pub(crate) fn animate(scene: &Scene, options: &Options) -> Result<(), String> {
    let mut stage = Stage::new(scene, options.size, options.strip);
    let mut display = SimulatorDisplay::<Rgb565>::new(options.size);
    let bar = ProgressBar::new(u64::from(options.frames));
    let style = "{msg} [{bar:40}] {pos}/{len} frames, {eta} left";
    bar.set_style(
        ProgressStyle::with_template(style).map_err(|error| error.to_string())?.progress_chars("=> "),
    );
    bar.set_message(scene.name);
    let mut animation = Vec::new();
    let mut total = Total::default();
    let mut first = Vec::new();
    {
        let (width, height) = (options.size.width as u16, options.size.height as u16);
        let mut encoder =
            Encoder::new(&mut animation, width, height, &[]).map_err(|error| error.to_string())?;
        encoder.set_repeat(Repeat::Infinite).map_err(|error| error.to_string())?;
        for frame in 0..options.frames {
            let turn = Turn::new((u32::from(frame) * 65_536 / u32::from(options.frames)) as u16);
            let view = View { turn, ..options.view() };
            total.add(stage.draw(&view, &mut display)?, Pixels::count(&mut stage, &view)?);
            let image = display.to_rgb_output_image(&OutputSettings::default());
            let rgb = image.as_image_buffer().as_raw().to_vec();
            let mut picture = Frame::from_rgb_speed(width, height, &rgb, PALETTE_SPEED);
            picture.delay = FRAME_TIME;
            encoder.write_frame(&picture).map_err(|error| error.to_string())?;
            if frame == 0 {
                first = rgb;
            }
            bar.inc(1);
        }
    }
    bar.finish_and_clear();
    let png = options.out.join(format!("{}.png", scene.name));
    let gif = options.out.join(format!("{}.gif", scene.name));
    let picture = image::RgbImage::from_raw(options.size.width, options.size.height, first)
        .ok_or_else(|| String::from("no frame was drawn"))?;
    fs::create_dir_all(&options.out).map_err(|error| format!("{}: {error}", options.out.display()))?;
    let mut still = Cursor::new(Vec::new());
    picture.write_to(&mut still, ImageFormat::Png).map_err(|error| error.to_string())?;
    write(&png, still.get_ref())?;
    write(&gif, &animation)?;
    total.print(scene, options);
    println!("files      {}\n           {}", png.display(), gif.display());
    Ok(())
}

/// Writes a file whole: under another name first.
fn write(path: &Path, bytes: &[u8]) -> Result<(), String> {
    let unfinished = path.with_extension("part");
    fs::write(&unfinished, bytes)
        .and_then(|()| fs::rename(&unfinished, path))
        .map_err(|error| format!("{}: {error}", path.display()))
}

/// Sums over all frames.
#[derive(Default)]
struct Total {
    frames: usize,
    faces: usize,
    culled: usize,
    outside: usize,
    clipped: usize,
    drawn: usize,
    covered: usize,
    overdraw: f64,
    vertices: Duration,
    pixels: Duration,
}

impl Total {
    fn add(&mut self, took: Took, pixels: Pixels) {
        self.frames += 1;
        self.faces += took.stats.faces;
        self.culled += took.stats.culled;
        self.outside += took.stats.outside;
        self.clipped += took.stats.clipped;
        self.drawn += took.stats.drawn;
        self.covered += pixels.covered;
        self.overdraw += pixels.overdraw();
        self.vertices += took.vertices;
        self.pixels += took.pixels;
    }

    fn print(&self, scene: &Scene, options: &Options) {
        let mean = |sum: usize| sum as f64 / self.frames as f64;
        let time = |sum: Duration| sum.as_secs_f64() * 1000.0 / self.frames as f64;
        println!(
            "{}: {}x{}, {} frames, strips of {} rows; means of a frame:",
            scene.name, options.size.width, options.size.height, self.frames, options.strip
        );
        println!(
            "triangles  {:.0} in, {:.0} culled, {:.0} outside, {:.0} clipped, {:.0} drawn",
            mean(self.faces),
            mean(self.culled),
            mean(self.outside),
            mean(self.clipped),
            mean(self.drawn)
        );
        println!(
            "pixels     {:.0} covered, overdraw {:.2}",
            mean(self.covered),
            self.overdraw / self.frames as f64
        );
        println!(
            "time       {:.3} ms: {:.3} vertices, {:.3} pixels and display (on this computer)",
            time(self.vertices + self.pixels),
            time(self.vertices),
            time(self.pixels)
        );
    }
}
