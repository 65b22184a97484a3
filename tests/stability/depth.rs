//! Rows 24 to 26: what is in front, where surfaces are close, far away or steep.

use std::cell::Cell;

use embedded_graphics::prelude::*;
use proptest::prelude::*;
use reference::matrix::Vec4;
use reference::naive::plane;
use reference::raster::covers;
use reference::setup::{Triangle, area2, snap};
use reference::shade::to_rgb565;
use reference::transform::{Viewport, depth, model_position};
use reference::varying::linear;
use topleft::stages::Window;
use topleft::{
    Camera, Cull, Depth16, DepthCode, DepthFloat, DrawList, Flat, Length, ListTriangle, Material, Mesh,
    Perspective, Pose, Spans, Turn,
};

use crate::figure::grouped;
use crate::planes;
use crate::probe::exact;
use crate::support::check;
use crate::support::coded::Coded;
use crate::support::frame::{Frame, Strips, rendered};
use crate::support::tolerance::interpolation;

const SIDE: i64 = 48;
const SIZE: Size = Size::new(48, 48);
const COLOURS: [[u8; 3]; 2] = [[224, 168, 80], [64, 112, 200]];
/// Steps of a position in one unit: its cube reaches to 16.
const UNIT: f64 = 2048.0;

/// Two triangles, or one by two names, of up to six corners.
struct Pair {
    positions: Vec<[i16; 3]>,
    faces: [[u16; 3]; 2],
    camera: Perspective,
}

/// A corner on the screen, and its clip coordinates.
type Face = (Triangle, [Vec4; 3]);

impl Pair {
    fn new(corners: &[[f64; 3]], faces: [[u16; 3]; 2], near: f32) -> Self {
        let positions = corners.iter().map(|corner| corner.map(|c| (c * UNIT).round() as i16)).collect();
        Self { positions, faces, camera: Perspective::new(SIZE, Turn::from_degrees(45), near..40.0) }
    }

    fn mesh(&self) -> Mesh<'_> {
        Mesh::new(&self.positions, &self.faces)
            .map(|mesh| mesh.with_box([Length::ZERO; 3], Length::lit("16")))
            .and_then(|mesh| mesh.with_face_colours(&COLOURS))
            .expect("a mesh")
    }

    fn drawn<D: Strips>(&self) -> Frame {
        let (mut words, mut triangles) = ([0; 512], [ListTriangle::EMPTY; 32]);
        let mut list = DrawList::<u16, D, Spans>::with_traversal(&mut words, &mut triangles);
        list.set_cull(Cull::None);
        list.draw(&self.camera, &self.mesh(), &Pose::new(), &Flat::new(Material::OfMesh)).expect("it fits");
        rendered(&list, SIDE as usize, 0..SIDE as i32, SIDE as usize, 0)
    }

    /// Both faces as the reference has them.
    fn faces(&self) -> [Face; 2] {
        let viewport = Viewport { width: SIZE.width, height: SIZE.height };
        let matrix = exact(self.camera.matrix());
        self.faces.map(|face| {
            let clip = face.map(|index| matrix.apply_point(model_position(&self.mesh(), usize::from(index))));
            let corner = |clip| viewport.to_screen(clip).map(|c| snap(c).expect("a place on the screen"));
            (clip.map(corner), clip)
        })
    }
}

fn pixels() -> impl Iterator<Item = (i64, i64)> {
    (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y)))
}

fn colour(face: usize) -> u16 {
    to_rgb565(COLOURS[face].map(f64::from))
}

/// A corner in front of the camera, and such that all of it is between the planes.
fn corner() -> impl Strategy<Value = [f64; 3]> {
    (-3.0..3.0, -3.0..3.0, -12.0..-6.0).prop_map(|(x, y, z)| [x, y, z])
}

/// Triangles drawn twice, the second time from another corner on: pixels, those where the second is in front by depths in
/// `f32` counted from the given corner, and by the library.
pub(crate) fn drawn_twice() -> [u64; 3] {
    let counts = [const { Cell::new(0) }; 3];
    let add = |which: usize, more: usize| counts[which].set(counts[which].get() + more as u64);
    check(300, &prop::array::uniform3(corner()), |corners| {
        let pair = Pair::new(&corners, [[0, 1, 2], [1, 2, 0]], 5.0);
        let [first, second] = pair.faces();
        if area2(first.0) == 0 {
            return Ok(());
        }
        let naive =
            |(triangle, clip): Face, (x, y)| plane::from_the_given_vertex(triangle, clip.map(depth), x, y);
        let covered = || pixels().filter(|&(x, y)| covers(first.0, x, y));
        add(0, covered().count());
        add(1, covered().filter(|&at| naive(second, at) > naive(first, at)).count());
        let seconds = pair.drawn::<Depth16>().colours.iter().filter(|&&cell| cell == colour(1)).count();
        add(2, seconds);
        if seconds == 0 { Ok(()) } else { Err(format!("{seconds} px are the second's")) }
    });
    counts.map(|count| count.get())
}

// Red when `Setup::sorted` is given vertices in the face's own order, or equal depths pass: `cover`.
#[test]
fn row_24_one_surface_by_two_names_fights_with_itself() {
    let [pixels, naive, ours] = drawn_twice();
    println!(
        "row 24, f32 depth from the given vertex: {} of {} px fight; topleft {ours}",
        grouped(naive),
        grouped(pixels)
    );
    // Two sums that differ in their last bit more often than not; half of those times the second is greater.
    assert!(naive * 10 > pixels);
    assert_eq!(ours, 0);
}

/// Planes that cross ten units away, with the near plane at a distance: pixels that both cover, those that show the wrong
/// one, and those of them where the depths are further apart than the derived bound.
pub(crate) fn crossing<D: Coded>(near: f32) -> [u64; 3] {
    let counts = [const { Cell::new(0) }; 3];
    let add = |which: usize| counts[which].set(counts[which].get() + 1);
    // Slopes of the first plane in units a unit; the second one's are the opposite.
    check(100, &[-0.2..0.2, -0.2..0.2], |[along, up]| {
        let corners = [[-12.0, -10.0], [12.0, -10.0], [0.0, 14.0]];
        let at = |sign: f64| corners.map(|[x, y]| [x, y, -10.0 + sign * (along * x + up * y)]);
        let corners = [at(1.0), at(-1.0)].concat();
        let pair = Pair::new(&corners, [[0, 1, 2], [3, 4, 5]], near);
        let (faces, drawn) = (pair.faces(), pair.drawn::<D>());
        let mut further = 0;
        for (x, y) in pixels().filter(|&(x, y)| faces.iter().all(|face| covers(face.0, x, y))) {
            let nearness = |(triangle, clip): Face| linear(triangle, clip.map(|[.., w]| 1.0 / w), x, y);
            let right = usize::from(nearness(faces[1]) > nearness(faces[0]));
            add(0);
            if drawn.colours[(y * SIDE + x) as usize] != colour(right) {
                add(1);
                // Both rounded down to a code, of planes interpolated over the guard rectangle at most.
                let [a, b] = faces.map(|face| nearness_at(face, x, y));
                let bound = 1.0 + D::bound(a, 2 * 1072, 1.0) + D::bound(b, 2 * 1072, 1.0);
                if (D::code(a) - D::code(b)).abs() > bound + moved::<D>(faces, x, y) {
                    add(2);
                    further += 1;
                }
            }
        }
        if further == 0 {
            Ok(())
        } else {
            Err(format!("the wrong one is in front by more than the bound at {further} px"))
        }
    });
    counts.map(|count| count.get())
}

/// `1 - z / w` at a pixel.
fn nearness_at((triangle, clip): Face, x: i64, y: i64) -> f64 {
    linear(triangle, clip.map(|[.., z, w]| 1.0 - z / w), x, y)
}

/// What a vertex that the library places one step of 1/256 px beside the reference's does to both codes.
fn moved<D: Coded>(faces: [Face; 2], x: i64, y: i64) -> f64 {
    let slope = |face: Face| {
        let code = |x, y| D::code(nearness_at(face, x, y));
        (code(x + 1, y) - code(x, y)).abs() + (code(x, y + 1) - code(x, y)).abs()
    };
    (slope(faces[0]) + slope(faces[1])) / 256.0
}

// Red when depth loses bits: codes of 15 bits leave twice the stairs; and small floats of four octaves less.
#[test]
fn row_25_planes_that_cross_far_away_make_stairs_where_the_near_plane_is_too_near() {
    let [pixels, unfitted, _] = crossing::<Depth16>(0.004);
    let [_, fitted, beyond] = crossing::<Depth16>(1.0);
    let [_, float, beyond_float] = crossing::<DepthFloat>(0.004);
    println!(
        "row 25, near plane at 0.004: {} of {} px show the wrong plane; topleft with the near plane at 1: {}, {beyond} beyond the bound",
        grouped(unfitted),
        grouped(pixels),
        grouped(fitted)
    );
    println!(
        "row 25, near plane at 0.004, small floats: {} px show the wrong plane, {beyond_float} beyond the bound",
        grouped(float)
    );
    // Ten units away a code is w² / (65528 near) deep: 0.38 units, and 0.0015. The planes cross at up to 0.4 a unit, so
    // the first hides the second for about a unit of the eight that are seen; it is half that on average.
    assert!(unfitted * 50 > pixels && unfitted > 20 * fitted);
    assert_eq!(beyond, 0);
    // There a small float is 2^-12 w deep or less: 0.0024 units, 1.6 times the integer's that is fitted.
    assert!(float < 2 * fitted);
    assert_eq!(beyond_float, 0);
}

/// Needles with a bias of their slope: how far above its corners a depth comes at most, and how far the library's comes
/// out of theirs beyond its bound.
pub(crate) fn steep_slivers() -> (f64, f64) {
    let (naive, ours) = (Cell::new(0.0_f64), Cell::new(0.0_f64));
    let needles = ([2..30_i32, 2..30_i32], [8..16_i32, 8..16_i32], [1..4_i32, -4..0_i32]);
    check(500, &(needles, prop::array::uniform3(8.0..65_000.0)), |((from, across, beside), depths)| {
        let needle = reference::naive::triangles::needle(from, across, beside);
        if area2(needle) == 0 {
            return Ok(());
        }
        let most = depths.iter().fold(0.0_f64, |most, &d| most.max(d));
        let least = depths.iter().fold(f64::MAX, |least, &d| least.min(d));
        let mut beyond = 0.0_f64;
        let codes = depths.map(|d| DepthCode::from_bits((d * 65_536.0) as u32));
        planes::values(needle, codes, &Window { columns: 0..64, rows: 0..64 }, |x, y, code: DepthCode| {
            let biased = plane::with_slope_bias(needle, depths, x.into(), y.into());
            naive.set(naive.get().max(biased - most));
            let code = f64::from(code.to_bits()) / 65_536.0;
            beyond = beyond.max(code - most).max(least - code);
        });
        ours.set(ours.get().max(beyond));
        // From its anchor a needle reaches 16 px each way; codes are given to a step.
        let bound = interpolation(16, 32, 65_528.0) + 1.0 / 65_536.0;
        if beyond <= bound { Ok(()) } else { Err(format!("{beyond} codes beyond the corners")) }
    });
    (naive.get(), ours.get())
}

// Red when gradients saturate: `Gradients::plane`. A bias is open: the library has none, so nothing needs a clamp.
#[test]
fn row_26_a_bias_by_slope_puts_steep_slivers_in_front_of_everything() {
    let (naive, ours) = steep_slivers();
    println!("row 26, depth + slope: up to {naive:.0} codes in front of its corners; topleft {ours:.4}");
    // A difference of some 10 000 codes over 1/64 px is a slope beyond all 65 536 codes.
    assert!(naive > 65_536.0);
}
