//! The interactive window.

use std::fs;
use std::time::Instant;

use embedded_graphics::mono_font::MonoTextStyle;
use embedded_graphics::mono_font::ascii::FONT_5X8;
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_graphics::text::{Baseline, Text};
use embedded_graphics_simulator::sdl2::Keycode;
use embedded_graphics_simulator::{OutputSettingsBuilder, SimulatorDisplay, SimulatorEvent, Window};
use scenes::{Method, Scene, Shade, View};
use topleft::{Length, Turn};

use crate::options::Options;
use crate::stage::Stage;

/// Strip heights that R goes through; the last is a whole frame.
const ROWS: [u16; 5] = [8, 16, 32, 64, u16::MAX];
/// How far the scene turns by itself in a frame.
const SPIN: u16 = 200;
/// How far an arrow key or a dragged pixel turns the camera.
const STEP: u16 = 256;
/// The camera goes from nearly overhead to nearly below.
const STEEPEST: i32 = 12_000;

/// Shows a scene until the window is closed.
pub(crate) fn show(scene: &Scene, options: &Options) -> Result<(), String> {
    let mut display = SimulatorDisplay::<Rgb565>::new(options.size);
    let scale = (960 / options.size.width.max(options.size.height)).max(1);
    let settings = OutputSettingsBuilder::new().scale(scale).build();
    let mut window = Window::new(&format!("topleft: {}", scene.name), &settings);
    let mut stage = Stage::new(scene, options.size, options.strip);
    let mut control = Control {
        view: options.view(),
        rows: options.strip,
        drag: None,
        spinning: true,
        pitch: 0,
        pictures: 0,
    };
    let mut frame_time = 0.0;
    loop {
        let start = Instant::now();
        let took = stage.draw(&control.view, &mut display)?;
        frame_time += (start.elapsed().as_secs_f64() - frame_time) * 0.1;
        let figures = format!(
            "{:.2} ms {} tri {} {} {} rows",
            frame_time * 1000.0,
            took.stats.drawn,
            control.view.shade.map_or("own", Shade::name),
            control.view.method.map_or("own", Method::name),
            control.rows.min(options.size.height as u16),
        );
        let style = MonoTextStyle::new(&FONT_5X8, Rgb565::WHITE);
        let Ok(_) = Text::with_baseline(&figures, Point::new(2, 2), style, Baseline::Top).draw(&mut display);
        window.update(&display);
        for event in window.events().collect::<Vec<_>>() {
            if event == SimulatorEvent::Quit {
                return Ok(());
            }
            if control.take(&event) {
                fs::create_dir_all(&options.out).map_err(|error| error.to_string())?;
                let path = options.out.join(format!("{}-{}.png", scene.name, control.pictures));
                display
                    .to_rgb_output_image(&Default::default())
                    .save_png(&path)
                    .map_err(|error| error.to_string())?;
                println!("{}", path.display());
            }
            stage.set_rows(control.rows);
        }
        if control.spinning {
            control.view.turn = control.view.turn + Turn::new(SPIN);
        }
    }
}

/// What keys and mouse have set.
struct Control {
    view: View,
    rows: u16,
    /// Where the mouse was when it was last seen with its button down.
    drag: Option<Point>,
    spinning: bool,
    /// Above the scene's own pitch, in steps of a turn.
    pitch: i32,
    pictures: u32,
}

impl Control {
    /// Follows an event; true if a picture is wanted.
    fn take(&mut self, event: &SimulatorEvent) -> bool {
        match *event {
            SimulatorEvent::KeyDown { keycode, .. } => return self.key(keycode),
            SimulatorEvent::MouseButtonDown { point, .. } => self.drag = Some(point),
            SimulatorEvent::MouseButtonUp { .. } => self.drag = None,
            SimulatorEvent::MouseMove { point } => {
                if let Some(from) = self.drag.replace(point) {
                    self.turn(from.x - point.x, point.y - from.y);
                } else {
                    self.drag = None;
                }
            }
            SimulatorEvent::MouseWheel { scroll_delta, .. } => self.zoom(scroll_delta.y),
            _ => {}
        }
        false
    }

    fn key(&mut self, key: Keycode) -> bool {
        match key {
            Keycode::Left => self.turn(-8, 0),
            Keycode::Right => self.turn(8, 0),
            Keycode::Up => self.turn(0, 8),
            Keycode::Down => self.turn(0, -8),
            Keycode::Plus | Keycode::Equals | Keycode::KpPlus => self.zoom(1),
            Keycode::Minus | Keycode::KpMinus => self.zoom(-1),
            Keycode::Space => self.spinning = !self.spinning,
            Keycode::S => self.view.shade = following(self.view.shade, &Shade::ALL),
            Keycode::M => self.view.method = following(self.view.method, &Method::ALL),
            Keycode::R => self.rows = ROWS.into_iter().find(|&rows| rows > self.rows).unwrap_or(ROWS[0]),
            Keycode::P => {
                self.pictures += 1;
                return true;
            }
            _ => {}
        }
        false
    }

    fn turn(&mut self, right: i32, up: i32) {
        self.view.yaw = self.view.yaw + Turn::new((right * i32::from(STEP)) as u16);
        self.pitch = (self.pitch + up * i32::from(STEP)).clamp(-STEEPEST, STEEPEST);
        self.view.pitch = Turn::new(self.pitch as u16);
    }

    fn zoom(&mut self, steps: i32) {
        let factor = if steps > 0 { Length::lit("0.9") } else { Length::lit("1.111") };
        for _ in 0..steps.unsigned_abs().min(8) {
            self.view.distance = (self.view.distance * factor).clamp(Length::lit("0.2"), Length::lit("5"));
        }
    }
}

/// The value after this one; each object's own after the last.
fn following<T: Copy + PartialEq>(current: Option<T>, all: &[T]) -> Option<T> {
    match current {
        None => all.first().copied(),
        Some(current) => all.iter().skip_while(|&&other| other != current).nth(1).copied(),
    }
}
