//! Every value that a pixel is given, against exact barycentrics at the same snapped vertices.

use embedded_graphics_core::geometry::Size;
use reference::raster::covers;
use reference::setup::{Triangle, area2};
use reference::varying::linear;
use topleft::stages::Varying;
use topleft::{
    Attribute, Camera, Cull, Depth16, DepthCode, DrawList, Inverse, Length, ListTriangle, Matrix,
    MatrixCamera, Mesh, Pose, Strip,
};

use crate::measured::{Errors, Row, hold};
use crate::probe::{Covered, Probe, SIZE, UNSEEN, exact_camera, range, sampled, slopes, snapped};
use crate::random::{Kind, Random};
use crate::tolerance::{REACHED, interpolation, interpolation_by_design};

/// A format under test: how to make one of 32 random bits, and how to read it as a number.
trait Format: Varying {
    const BITS: u32;
    fn from_random(random: u64) -> Self;
    fn value(self) -> f64;
}

impl Format for Attribute {
    const BITS: u32 = 16;

    fn from_random(random: u64) -> Self {
        // 8 steps from the ends of the range: the errors of interpolation are allowed to use them.
        Self::from_bits((random as u32 as i32).clamp(i32::MIN + (1 << 19), i32::MAX - (1 << 19)))
    }

    fn value(self) -> f64 {
        f64::from(self.to_bits()) / 65_536.0
    }
}

impl Format for DepthCode {
    const BITS: u32 = 16;

    fn from_random(random: u64) -> Self {
        Self::from_bits((random as u32).clamp(4 << 16, u32::MAX - (4 << 16)))
    }

    fn value(self) -> f64 {
        f64::from(self.to_bits()) / 65_536.0
    }
}

impl Format for Inverse {
    const BITS: u32 = 31;

    fn from_random(random: u64) -> Self {
        Self::from_bits((random as u32 >> 1).min(i32::MAX as u32 - 4096) as i32)
    }

    fn value(self) -> f64 {
        f64::from(self.to_bits()) / f64::from(1_u32 << 31)
    }
}

/// A colour of 8 bits, of 32 random bits.
fn colour(random: u64) -> Attribute {
    Attribute::from_bits(((u64::from(random as u32) * (255 << 16)) >> 32) as i32)
}

/// The errors over `count` triangles of a kind, with values that `from_random` makes of 32 random bits.
fn errors<V: Format>(kind: Kind, count: u32, from_random: fn(u64) -> V) -> Errors {
    let mut random = Random::new(kind as u64 * 77 + u64::from(V::BITS));
    let mut errors = Errors::default();
    for _ in 0..count {
        let covered = Covered::new(kind.triangle(&mut random));
        // Any values, and values that differ by little.
        let narrow = random.within(0, 31) as u32;
        let base = random.next();
        let raw = [(); 3].map(|()| from_random(base ^ (random.next() as u32 >> narrow) as u64));
        let values = raw.map(V::value);
        let gradients = covered.setup.gradients();
        let plane = V::plane(&gradients, raw);
        let [ax, ay] = gradients.anchor();
        let (range, [gx, gy]) = (range(values), slopes(covered.triangle, values));
        let extent = |axis: usize| {
            let ends = covered.triangle.map(|p| f64::from(p[axis]) / 256.0);
            crate::probe::range(ends)
        };
        let over_the_box = gx.abs() * extent(0) + gy.abs() * extent(1);
        for span in &covered.spans {
            let start = plane.at(span.start - ax, span.y - ay);
            for x in sampled(span, &mut random) {
                let ours = start.plus(plane.dx.times(x - span.start)).value();
                let exact = linear(covered.triangle, values, x.into(), span.y.into());
                let steps = covered.steps(x, span.y);
                let bound = interpolation(V::BITS, steps, range);
                assert!(bound <= interpolation_by_design(V::BITS, steps, range, over_the_box));
                errors.add(ours - exact, bound, || {
                    let triangle = covered.triangle;
                    format!("{kind:?} {triangle:?} {values:?}: {ours} for {exact} at {x}, {}", span.y)
                });
            }
        }
    }
    errors
}

/// What single triangles of a kind carry: values of any size, colours, depths and 1/w.
pub(crate) fn of_kind(kind: Kind) -> Vec<Row> {
    let count = if matches!(kind, Kind::Ordinary | Kind::FullScreen | Kind::Guard) { 1500 } else { 20_000 };
    [
        ("attribute", "1", errors(kind, count, Attribute::from_random)),
        ("colour", "code of 255", errors(kind, count, colour)),
        ("depth", "code", errors(kind, count, DepthCode::from_random)),
        ("1/w", "1", errors(kind, count, Inverse::from_random)),
    ]
    .map(|(method, unit, errors)| {
        Row::new("interpolation", kind.name(), method, ["value", unit], &errors).reaching(REACHED)
    })
    .into()
}

/// Turned red by: truncated gradients, a start that is not moved to the centre of its pixel, a reciprocal of the area
/// without its second Newton step, gradients that saturate.
#[test]
fn interpolation_is_within_its_bound_on_every_kind_of_triangle() {
    Kind::ALL.into_iter().for_each(|kind| hold(&of_kind(kind)));
}

/// Two triangles that hide each other in part, through list, strips, depth runs and shader.
///
pub(crate) fn whole_path() -> Row {
    let mut random = Random::new(3);
    let mut errors = Errors::default();
    let (mut pixels, mut behind) = (0_u64, 0_u64);
    for round in 0..120 {
        // Eight times as wide, most vertices and many anchors are outside of the target.
        let wider = if round % 2 == 0 { 1 } else { 8 };
        let positions: Vec<[i16; 3]> = (0..6).map(|_| [(); 3].map(|()| random.next() as i16)).collect();
        let mesh = Mesh::new(&positions, &[[0, 1, 2], [3, 4, 5]]).unwrap();
        // Scaled in x and y only, so that no vertex is clipped: the guard rectangle is 1024 px wider than 256.
        let places: Vec<[i32; 2]> = positions
            .iter()
            .map(|&p| snapped(p, 1.0).expect("no tie").map(|c| (c - 32_768) * wider + 32_768))
            .collect();
        let values: Vec<[Attribute; 3]> =
            (0..6).map(|_| [(); 3].map(|()| Attribute::from_random(random.next()))).collect();
        let mut storage = ([0; 64], [ListTriangle::EMPTY; 2]);
        let mut list = DrawList::<_, Depth16>::new(&mut storage.0, &mut storage.1);
        list.set_cull(Cull::None);
        list.draw(&widened(wider), &mesh, &Pose::new(), &Probe { values: &values, first_face: 0 }).unwrap();
        let rows = [256, 100, 16, 7][round % 4];
        let mut cells = vec![UNSEEN; SIZE as usize * rows];
        let mut depths = vec![0; cells.len()];
        let faces = [0, 3].map(|first| -> Triangle { [places[first], places[first + 1], places[first + 2]] });
        for top in (0..SIZE as i32).step_by(rows) {
            let mut strip = Strip::new(SIZE as u16, &mut cells).unwrap().with_depth(&mut depths).unwrap();
            strip.clear();
            list.render(top..(top + rows as i32).min(SIZE as i32), &mut strip);
            for (index, cell) in strip.colours().iter().enumerate() {
                let (x, y) =
                    ((index % SIZE as usize) as i64, i64::from(top) + (index / SIZE as usize) as i64);
                if y >= i64::from(SIZE) {
                    continue;
                }
                let covering = faces.map(|triangle| covers(triangle, x, y));
                let Some(face) = cell.face() else {
                    assert_eq!(covering, [false; 2], "{positions:?} at {x}, {y}");
                    continue;
                };
                assert!(covering[face], "{positions:?} at {x}, {y}");
                let mut corners = [0, 1, 2].map(|k| face * 3 + k);
                corners.sort_by_key(|&k| (places[k][1], places[k][0]));
                let triangle = corners.map(|k| places[k]);
                let steps = (x - i64::from(triangle[0][0] >> 8)).unsigned_abs()
                    + (y - i64::from(triangle[0][1] >> 8)).unsigned_abs();
                for (channel, &ours) in cell.values.iter().enumerate() {
                    let at_vertices = corners.map(|k| values[k][channel].value());
                    let error = f64::from(ours) / 65_536.0 - linear(triangle, at_vertices, x, y);
                    let bound = interpolation(16, steps, range(at_vertices));
                    errors.add(error, bound, || format!("{positions:?} at {x}, {y}"));
                }
                pixels += 1;
                behind += u64::from(covering[0] && covering[1]);
            }
        }
        assert!(faces.iter().all(|&face| area2(face) != 0));
    }
    assert!(behind * 10 > pixels, "{behind} of {pixels} px are covered twice");
    Row::new("interpolation", "two triangles through strips", "attribute", ["value", "1"], &errors)
        .reaching(REACHED)
}

/// Turned red by: a run that starts with the value of its span.
#[test]
fn the_whole_path_hands_a_shader_the_same_values() {
    hold(&[whole_path()]);
}

/// [`exact_camera`] with x and y times `by`.
fn widened(by: i32) -> MatrixCamera<false> {
    let (by, one, o) = (Length::from_num(by), Length::ONE, Length::ZERO);
    let wide = Matrix::new([[by, o, o, o], [o, by, o, o], [o, o, one, o], [o, o, o, one]]);
    MatrixCamera::new(Size::new(SIZE, SIZE), wide.times(exact_camera().matrix()))
}
