//! Row 17: what moves slowly, by 1/64 px a frame.

use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use reference::naive::{snap, triangles};
use reference::raster::covers;
use reference::setup::{self, Triangle};
use reference::varying::linear;
use topleft::{Attribute, Length, Point as Corner, ShadedTriangle, point};

use crate::carried::{SIDE, in_strips};
use crate::probe::slopes;
use crate::random::Random;
use crate::support::counter::StrictDisplay;
use crate::support::tolerance::{REACHED, clip, interpolation, vertex_on_screen};

/// Over one pixel on each axis, and the way that is most often taken: both.
const FRAMES: u32 = 64;
const STEP: f64 = 1.0 / FRAMES as f64;
/// The furthest that rounding moves a corner on each axis, in pixels.
const SNAP: f64 = 0.5 / 256.0;
/// Places of corners are in 1/1024 px, from -32 to 32.
const HALF: u32 = 32;

/// A triangle that moves to the right and down, in pixels, and a value at each corner.
#[derive(Clone, Copy, Debug)]
struct Moving {
    corners: [[f64; 2]; 3],
    values: [f64; 3],
}

impl Moving {
    fn at(&self, frame: u32) -> [[f64; 2]; 3] {
        self.corners.map(|corner| corner.map(|c| c + f64::from(frame) * STEP))
    }

    /// On whole pixels.
    fn whole(&self, frame: u32) -> Triangle {
        self.at(frame).map(|corner| corner.map(|c| snap::rounded(setup::snap(c).expect("a number"), 0)))
    }

    /// As the library takes it: places of 16 fraction bits and less than 64 px are exact in `f32`.
    fn points(&self, frame: u32) -> [Corner; 3] {
        self.at(frame).map(|[x, y]| point(x as f32, y as f32))
    }

    /// The steps of its plane to the right and down, both positive.
    fn slopes(&self) -> [f64; 2] {
        // In 1/65536 px there is nothing to round.
        let fine = self.corners.map(|corner| corner.map(|c| (c * 65_536.0) as i32));
        slopes(fine, self.values).map(|slope| slope.abs() * 256.0)
    }

    /// The plane through the corners where they are, at a pixel's centre.
    fn exact(&self, frame: u32, x: i32, y: i32) -> f64 {
        let [a, b, c] = self.at(frame);
        let to = |p: [f64; 2], q: [f64; 2]| [q[0] - p[0], q[1] - p[1]];
        let cross = |p: [f64; 2], q: [f64; 2]| p[0] * q[1] - p[1] * q[0];
        let centre = [f64::from(x) + 0.5, f64::from(y) + 0.5];
        let area = cross(to(a, b), to(a, c));
        let [second, third] = [cross(to(a, centre), to(a, c)) / area, cross(to(a, b), to(a, centre)) / area];
        self.values[0]
            + second * (self.values[1] - self.values[0])
            + third * (self.values[2] - self.values[0])
    }
}

/// A texture of one texel a pixel on large triangles.
fn textured(random: &mut Random) -> Moving {
    let near = |at: f64, random: &mut Random| at + (4.0 * random.unit() * 1024.0).floor() / 1024.0;
    let corners = [[2.0, 2.0], [50.0, 6.0], [12.0, 55.0]].map(|corner| corner.map(|c| near(c, random)));
    let (sin, cos) = (random.unit() * std::f64::consts::TAU).sin_cos();
    Moving { corners, values: corners.map(|[x, y]| x * cos + y * sin) }
}

/// How far texels are from the exact track at most, and how much they change from frame to frame: with no sub-pixel bits,
/// by the library, and the largest share that the library has of its bounds.
pub(crate) fn swim() -> [[f64; 3]; 2] {
    let (mut worst, mut random) = ([[0.0_f64; 3]; 2], Random::new(17));
    // Elements of the camera are 1 at most, of the pose the half; a row's four are 2 together.
    let moved = vertex_on_screen(clip(HALF.into(), 2.0), 1.0, 32.0, 46.0) / 256.0;
    for _ in 0..40 {
        let moving = textured(&mut random);
        let [gx, gy] = moving.slopes();
        // A corner that is moved moves the plane at a pixel by no more than itself, times the slope there.
        let swim = (gx + gy) * (SNAP + moved) + interpolation(16, 2 * 64, 128.0);
        let corners = moving.corners.map(|corner| corner.map(|c| ((c - 32.0) * 1024.0) as i16));
        let mut before: Option<[Vec<Option<f64>>; 2]> = None;
        for frame in 0..=FRAMES {
            let whole = moving.whole(frame);
            let mut shown = [vec![None; (SIDE * SIDE) as usize], vec![None; (SIDE * SIDE) as usize]];
            let values = moving.values.map(Attribute::from_num);
            let way = [Length::from_num(f64::from(frame) * STEP); 2];
            let [ours] = in_strips(corners, HALF, way, values, [SIDE]);
            for (at, value) in ours.colours.iter().enumerate() {
                let Some(value) = value.0 else { continue };
                let (x, y) = (at as i32 % SIDE, at as i32 / SIDE);
                shown[1][at] = Some(f64::from(value) / 65_536.0);
                shown[0][at] = Some(linear(whole, moving.values, x.into(), y.into()));
                let off =
                    [0, 1].map(|which| (shown[which][at].unwrap_or(0.0) - moving.exact(frame, x, y)).abs());
                worst[0] = [worst[0][0].max(off[0]), worst[0][1].max(off[1]), worst[0][2].max(off[1] / swim)];
            }
            for which in 0..2 {
                let pairs = before.iter().flat_map(|before| before[which].iter().zip(&shown[which]));
                let changes =
                    pairs.filter_map(|(before, after)| Some((after.as_ref()? - before.as_ref()?).abs()));
                let most = changes.fold(0.0, f64::max);
                worst[1][which] = worst[1][which].max(most);
                if which == 1 {
                    worst[1][2] = worst[1][2].max(most / ((gx + gy) * STEP + 2.0 * swim));
                }
            }
            before = Some(shown);
        }
    }
    worst
}

// Red when positions are rounded to fewer bits, or towards one side: `Projection::project`.
#[test]
fn row_17_a_texture_swims_and_jumps_without_sub_pixel_bits() {
    let [track, change] = swim();
    println!(
        "row 17, whole pixels: texels up to {:.3} from their track, {:.3} a frame; topleft {:.4} ({:.2} of its bound) and {:.4} ({:.2})",
        track[0], change[0], track[1], track[2], change[1], change[2]
    );
    // Half a pixel on each axis is 0.71 texel along a diagonal; a pixel at once is up to 1.41.
    assert!(track[0] > 0.5 && change[0] > 0.9);
    assert!(track[2] <= 1.0 && change[2] <= 1.0);
    // The bounds are not loose: three corners seldom err all in one direction, but a pixel near one has most of its error.
    assert!(track[2] > REACHED && change[2] > REACHED);
}

/// A fan of greys drawn to a display frame by frame: the largest change of a pixel from frame to frame in codes of 255,
/// with no sub-pixel bits, by the library, and the library's bound.
pub(crate) fn pixel_changes() -> [f64; 3] {
    let mut random = Random::new(1717);
    // Dark in the middle and white within ten pixels: 25 codes a pixel.
    let hub = [31 * 256 + 77, 31 * 256 + 201];
    let ring = triangles::ring(hub, 10.0, 9, 0.2, 1);
    // Beside the lattice, each corner otherwise.
    let mut beside =
        |place: [i32; 2]| place.map(|c| (f64::from(c) + random.within(0, 255) as f64 / 256.0) / 256.0);
    let hub = beside(hub);
    let ring: Vec<[f64; 2]> = ring.into_iter().map(beside).collect();
    let parts: Vec<Moving> = (0..ring.len())
        .map(|i| Moving { corners: [hub, ring[i], ring[(i + 1) % ring.len()]], values: [0.0, 255.0, 255.0] })
        .collect();
    let steepest = parts.iter().map(|part| part.slopes().iter().sum::<f64>()).fold(0.0, f64::max);
    // What moves, what rounding moves in both frames, and each frame's rounding to a code.
    let bound = steepest * (STEP + 2.0 * SNAP) + 2.0 * interpolation(16, 2 * 64, 255.0) + 1.0;
    let naive = |frame: u32| {
        let mut pixels = vec![None; (SIDE * SIDE) as usize];
        for part in &parts {
            let whole = part.whole(frame);
            for (x, y) in (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y))) {
                if covers(whole, x.into(), y.into()) {
                    pixels[(y * SIDE + x) as usize] =
                        Some(linear(whole, part.values, x.into(), y.into()).round());
                }
            }
        }
        pixels
    };
    let ours = |frame: u32| {
        let size = Size::new(SIDE.unsigned_abs(), SIDE.unsigned_abs());
        let mut display = StrictDisplay::new(Rectangle::new(Point::zero(), size));
        for part in &parts {
            let colours = part.values.map(|grey| Rgb888::new(grey as u8, grey as u8, grey as u8));
            let triangle = ShadedTriangle::new(part.points(frame), colours);
            triangle.draw(&mut display).expect("this display does not fail");
        }
        display.pixels.iter().map(|pixel| pixel.map(|colour| f64::from(colour.r()))).collect::<Vec<_>>()
    };
    let change = |frame: &dyn Fn(u32) -> Vec<Option<f64>>| {
        let frames: Vec<_> = (0..=FRAMES).map(frame).collect();
        let pairs = frames.iter().zip(&frames[1..]).flat_map(|(before, after)| before.iter().zip(after));
        pairs
            .filter_map(|(before, after)| Some((before.as_ref()? - after.as_ref()?).abs()))
            .fold(0.0, f64::max)
    };
    [change(&naive), change(&ours), bound]
}

// Red when positions are rounded to 4 bits (`steps` in src/point.rs), and when a colour depends on where its triangle
// stands within a pixel (`Gradients::offset`).
#[test]
fn row_17_pixels_jump_without_sub_pixel_bits() {
    let [naive, ours, bound] = pixel_changes();
    println!(
        "row 17, whole pixels: a pixel changes by up to {naive} codes of 255 a frame; topleft {ours}, bound {bound:.2}"
    );
    // All of a pixel's slope at once, and not a 64th of it.
    assert!(naive > 4.0 * bound);
    assert!(ours <= bound);
}
