//! Which texel a pixel shows, against exact perspective at the same snapped vertices.

use reference::setup::{Triangle, area2};
use reference::transform::inverse_word;
use reference::varying::{linear, perspective};
use topleft::stages::{Correction, PerVertexInverse, PixelShader, Run, Varying, Words};
use topleft::{
    Affine, Attribute, Cull, DrawList, ListTriangle, Mesh, NoDepth, PerPixel, Pose, Strip, Texture, Textured,
};

use crate::measured::{Errors, Row, hold};
use crate::probe::{Covered, SIZE, exact_perspective, outside, range, sampled, snapped, texels_of, w_of};
use crate::random::{Kind, Random};
use crate::tolerance::{SIXTEENTH, affine, interpolation, per_pixel};

/// A texture of 256 x 256 whose texels say where they are.
fn map() -> Vec<u16> {
    (0..=u16::MAX).collect()
}

/// The powers of two of the texture's sizes.
pub(crate) const SIZES: [u8; 2] = [8, 8];

/// 1/w as a vertex carries it.
pub(crate) fn inverse(w: u32) -> PerVertexInverse {
    PerVertexInverse::load(&mut [inverse_word(w)].into_iter()).unwrap()
}

/// Three values of w from `least` to `ratio` times as much.
pub(crate) fn distances(ratio: f64, random: &mut Random) -> [u32; 3] {
    let least = random.within(1 << 22, 1 << 23) as f64;
    let between = 1.0 + (ratio - 1.0) * random.unit();
    let mut w = [1.0, ratio, between].map(|share| (least * share) as u32);
    w.rotate_left(random.within(0, 2) as usize);
    w
}

/// The power of two of texels that holds a triangle's span.
pub(crate) fn texel_box(texels: [[f64; 2]; 3]) -> f64 {
    let span = |axis: usize| {
        let ends = texels.map(|texel| texel[axis]);
        let most = ends.into_iter().fold(f64::MIN, f64::max);
        most - ends.into_iter().fold(f64::MAX, f64::min).floor()
    };
    let span = span(0).max(span(1)).ceil() as u64;
    span.next_power_of_two() as f64
}

/// The errors of one kind and ratio, of texels up to `size`.
fn errors<C: Correction>(correction: C, kind: Kind, ratio: f64, size: f64, count: u32) -> Errors {
    let mut random = Random::new(kind as u64 * 1000 + ratio as u64 + size as u64);
    let mut errors = Errors::default();
    for _ in 0..count {
        let covered = Covered::new(kind.triangle(&mut random));
        let w = distances(ratio, &mut random);
        let texels = [(); 3].map(|()| {
            [(); 2].map(|()| Attribute::from_bits(((random.unit() - 0.5) * size * 65_536.0) as i32))
        });
        let exact = texels.map(|texel| texel.map(|c| f64::from(c.to_bits()) / 65_536.0));
        let q = w.map(|w| 1.0 / f64::from(w));
        // 1/w as a share of the power of two at or above the largest.
        let unit = f64::from(1_u32 << w.into_iter().min().unwrap().ilog2());
        let u = texel_box(exact);
        let shown = covered.texels(correction, texels, w.map(inverse), SIZES);
        for (span, shown) in covered.spans.iter().zip(shown) {
            for x in sampled(span, &mut random) {
                let (column, row) = (i64::from(x), i64::from(span.y));
                let steps = covered.steps(x, span.y);
                for axis in 0..2 {
                    let values = exact.map(|texel| texel[axis]);
                    let (wanted, bound) = if C::PERSPECTIVE {
                        let share = linear(covered.triangle, q, column, row) * unit;
                        (perspective(covered.triangle, values, q, column, row), u * per_pixel(steps, share))
                    } else {
                        let range = range(values);
                        (linear(covered.triangle, values, column, row), interpolation(16, steps, range))
                    };
                    let texel = shown[(x - span.start) as usize][axis];
                    errors.add(outside(texel, wanted), bound, || {
                        let triangle = covered.triangle;
                        format!("{kind:?} {triangle:?}, w {w:?}, texels {exact:?}: {texel} for {wanted} at {x}, {row}")
                    });
                }
            }
        }
    }
    errors
}

pub(crate) const RATIOS: [f64; 4] = [1.5, 4.0, 16.0, 64.0];
pub(crate) const KINDS: [Kind; 6] =
    [Kind::Ordinary, Kind::Small, Kind::FullScreen, Kind::Sliver, Kind::Needle, Kind::Guard];

/// Triangles of a kind: enough of the small ones, and not too many pixels.
fn count(kind: Kind) -> u32 {
    if matches!(kind, Kind::Ordinary | Kind::FullScreen | Kind::Guard) { 150 } else { 2000 }
}

/// A reciprocal a pixel, on triangles of a kind, by the ratio of w.
pub(crate) fn per_pixel_of(kind: Kind) -> Vec<Row> {
    let rows = |ratio: f64| {
        let row = |size: f64, metric: &'static str| {
            let errors = errors(PerPixel, kind, ratio, size - 1.0, count(kind));
            Row::new("texels", kind.name(), format!("per pixel w 1:{ratio}"), [metric, "texel"], &errors)
        };
        let narrow = row(256.0, "of 256");
        // On the screen, what is promised. From anchors in the guard margin the derived bound holds alone.
        assert!(kind == Kind::Guard || narrow.measured_max <= SIXTEENTH, "{narrow}");
        // In a box of 2^15 texels a texel is a small part of the bound. The chord alone is two thirds of it, and a
        // truncation takes up to a third back.
        [narrow, row(32_768.0, "of 32768").reaching(0.25)]
    };
    RATIOS.into_iter().flat_map(rows).collect()
}

/// No correction, against the plane through the vertices' texels.
pub(crate) fn affine_of(kind: Kind) -> Row {
    let errors = errors(Affine, kind, 4.0, 255.0, 2 * count(kind));
    Row::new("texels", kind.name(), "affine", ["of 256 on the plane", "texel"], &errors)
}

/// No correction, against exact perspective: what the shortcut itself costs, by the ratio of w.
pub(crate) fn affine_for_perspective(ratio: f64) -> Row {
    let mut random = Random::new(13 + ratio as u64);
    let mut errors = Errors::default();
    for _ in 0..60 {
        let covered = Covered::new(Kind::FullScreen.triangle(&mut random));
        // Two vertices alike are the worst case: texel and w change along one direction, over all of their range.
        let (alone, near) = (random.within(0, 2) as usize, random.within(0, 1) == 0);
        let is_near = |k: usize| (k == alone) == near;
        let values = [0, 1, 2].map(|k| if is_near(k) { 1.0 } else { 255.0 });
        let q = [0, 1, 2].map(|k| if is_near(k) { 1.0 } else { 1.0 / ratio });
        let texels = values.map(|value| [Attribute::from_num(value); 2]);
        let ((), varyings) = Affine.triangle(texels, [inverse(1 << 22); 3], SIZES);
        let gradients = covered.setup.gradients();
        let plane = Varying::plane(&gradients, varyings);
        let [ax, ay] = gradients.anchor();
        for span in &covered.spans {
            let start = plane.at(span.start - ax, span.y - ay);
            for (x, [texel, _]) in
                (span.start..).zip(texels_of(Affine, &(), start, &plane.dx, span.end - span.start))
            {
                let wanted = perspective(covered.triangle, values, q, x.into(), span.y.into());
                let bound = affine(254.0, ratio) + interpolation(16, covered.steps(x, span.y), 254.0);
                let name = || format!("{:?} at {x}, {}: {texel} for {wanted}", covered.triangle, span.y);
                errors.add(outside(texel, wanted), bound, name);
            }
        }
    }
    // One texel is hidden by rounding down, and the next pixel to the worst place is less than one further.
    let reached = 1.0 - 2.0 / affine(254.0, ratio);
    Row::new("texels", "full-screen triangles", format!("affine w 1:{ratio}"), ["of 254", "texel"], &errors)
        .reaching(reached)
}

/// Turned red by: a reciprocal that is interpolated in quarters or not at all, 1/w of 17 bits.
#[test]
fn per_pixel_perspective_is_within_its_bound() {
    KINDS.into_iter().for_each(|kind| hold(&per_pixel_of(kind)));
    // The derived bound itself keeps the promise on a screen of 320 x 240.
    assert!(256.0 * per_pixel(560, 1.0 / 128.0) <= SIXTEENTH);
}

/// Turned red by: texels that are rounded to nearest, truncated gradients.
#[test]
fn affine_texels_are_those_of_the_plane() {
    hold(&KINDS.map(affine_of));
}

/// Turned red by: texels that are divided by w after all, a bound that is not the closed form.
#[test]
fn without_correction_texels_are_as_wrong_as_the_closed_form_says() {
    hold(&RATIOS.map(affine_for_perspective));
}

/// From the mesh through vertex stage, list and strip to the texel, at w ratios up to 64.
pub(crate) fn whole_path() -> Row {
    let texels = map();
    let texture = Texture::new(256, 256, &texels).unwrap();
    let mut random = Random::new(11);
    let (mut errors, mut drawn) = (Errors::default(), 0);
    while drawn < 200 {
        let positions = [(); 3].map(|()| {
            let z = random.next() as i16;
            let w = w_of([0, 0, z]);
            let place = [(); 2].map(|()| (f64::from(random.next() as i16) * w) as i16);
            [place[0], place[1], z]
        });
        let w = positions.map(w_of);
        let [a, b, c] = [0, 1, 2].map(|k| snapped(positions[k], w[k]));
        let (Some(a), Some(b), Some(c)) = (a, b, c) else { continue };
        let triangle: Triangle = [a, b, c];
        if area2(triangle) == 0 {
            continue;
        }
        drawn += 1;
        // From 1 to 255 texels: no error reaches round the texture.
        let uvs = [(); 3].map(|()| [(); 2].map(|()| random.within(128, 32_640) as i16));
        let exact = uvs.map(|uv| reference::shade::uv(uv, 0, &texture));
        let mesh = Mesh::new(&positions, &[[0, 1, 2]]).unwrap().with_uvs(&uvs, 0).unwrap();
        let mut storage = ([0; 32], [ListTriangle::EMPTY; 1]);
        let mut list = DrawList::<u16, NoDepth>::new(&mut storage.0, &mut storage.1);
        list.set_cull(Cull::None);
        list.draw(&exact_perspective(), &mesh, &Pose::new(), &Textured::new(&texture, PerPixel)).unwrap();
        let mut cells = vec![0; (SIZE * SIZE) as usize];
        let mut strip = Strip::new(SIZE as u16, &mut cells).unwrap();
        list.render(0..SIZE as i32, &mut strip);
        let (q, u) = (w.map(|w| 1.0 / w), texel_box(exact));
        let largest = q.into_iter().fold(0.0, f64::max);
        let unit = 2.0_f64.powi(-largest.log2().ceil() as i32);
        let first = triangle.into_iter().min_by_key(|&[x, y]| (y, x)).unwrap();
        for (index, &texel) in cells.iter().enumerate() {
            let (x, y) = ((index % SIZE as usize) as i64, (index / SIZE as usize) as i64);
            if !reference::raster::covers(triangle, x, y) {
                continue;
            }
            let steps = x.abs_diff(i64::from(first[0] >> 8)) + y.abs_diff(i64::from(first[1] >> 8));
            let bound = u * per_pixel(steps, linear(triangle, q, x, y) * unit);
            for (axis, ours) in [texel & 255, texel >> 8].into_iter().enumerate() {
                let wanted = perspective(triangle, exact.map(|texel| texel[axis]), q, x, y);
                errors.add(outside(ours.into(), wanted), bound, || {
                    format!("{positions:?} {exact:?}: {ours} for {wanted} at {x}, {y}")
                });
            }
        }
    }
    let row =
        Row::new("texels", "triangles from vertices", "per pixel w to 1:64", ["of 256", "texel"], &errors);
    assert!(row.measured_max <= SIXTEENTH && row.measured_max > 0.0, "{row}");
    row
}

/// Turned red by: another vertex's 1/w, u for v, vertices that are snapped by truncation.
#[test]
fn the_whole_path_shows_the_same_texels() {
    hold(&[whole_path()]);
}

/// The shader shows the texel that its correction finds, with `shade` as it is called for a run.
///
/// Turned red by: u for v.
#[test]
fn a_texture_is_fetched_where_the_correction_says() {
    let texels = map();
    let texture = Texture::new(256, 256, &texels).unwrap();
    let mut random = Random::new(12);
    let covered = Covered::new(Kind::FullScreen.triangle(&mut random));
    let corners = [[10, 20], [700, -300], [40, 250]].map(|texel| texel.map(Attribute::from_num));
    let shader = Textured::new(&texture, PerPixel);
    let inverses = distances(3.0, &mut random).map(inverse);
    let (shared, varyings) = PixelShader::<u16>::triangle(&shader, [0; 3], corners, inverses);
    let gradients = covered.setup.gradients();
    let plane = Varying::plane(&gradients, varyings);
    let [ax, ay] = gradients.anchor();
    for span in &covered.spans {
        let start: <PerPixel as Correction>::Varying = plane.at(span.start - ax, span.y - ay);
        let mut run = vec![0_u16; (span.end - span.start) as usize];
        shader.shade(&shared, start, &plane.dx, Run::new(&mut run));
        let shown = texels_of(PerPixel, &shared, start, &plane.dx, run.len() as i32);
        let wanted: Vec<u16> = shown.into_iter().map(|[u, v]| texture.texel(u, v)).collect();
        assert_eq!(run, wanted);
    }
}
