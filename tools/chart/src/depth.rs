//! Depth: what each format tells apart, and which pixels show the wrong face.

use embedded_graphics_core::geometry::Size;
use reference::raster::{covers, row_span};
use reference::setup::{Cull, facing};
use scenes::{Camera, Scene, View, by_name};
use topleft::{Depth, Depth16, DepthFloat, DrawList, ListTriangle, NoDepth, Painter, Strip};

use crate::patches::{Frame, Patch};
use crate::probe::{Probe, Seen, UNSEEN};
use crate::table::{Table, figure};

const PANEL: Size = Size::new(240, 240);

/// Scenes of one mesh that hides itself, of things that stand on others, and of pairs that are ever closer together.
const SCENES: [&str; 3] = ["knot", "teapot", "ladder"];

/// A way to keep 16 bits of depth: the library's, linear on the screen and as a small float with 4 bits of exponent; and 1/w
/// as a small float with so many.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Format {
    Linear,
    Float,
    Model(i32),
}

impl Format {
    /// The library's, and a model of another.
    pub(crate) const ALL: [(&'static str, Self); 3] =
        [("Depth16", Self::Linear), ("DepthFloat", Self::Float), ("1/w as e3m13 (model)", Self::Model(3))];

    /// The code for a depth in codes of `Depth16` with fractions, where far is `far` near planes off.
    fn code(self, depth: f64, far: f64) -> u32 {
        let share = ((depth - 4.0) / 65_528.0).clamp(0.0, 1.0);
        match self {
            Self::Linear => code_of::<Depth16>(share),
            Self::Float => code_of::<DepthFloat>(share),
            Self::Model(exponent) => {
                // Of the near plane's: 1 there and 1 / far at the other.
                let q = (share * (far - 1.0) + 1.0) / far;
                let (mantissa, last) = (16 - exponent, (1 << exponent) - 1);
                let down = (-q.log2()).floor().clamp(0.0, f64::from(last)) as i32;
                // The last power has no leading one, and goes down to 0.
                let shift = if down == last { last } else { down + 1 };
                let power = if down == last { 0 } else { last - down - 1 };
                (f64::from(power << mantissa) + q * 2.0_f64.powi(mantissa + shift)).min(65_535.0) as u32
            }
        }
    }

    /// The least distance, as a share of how far away it is, that is told apart `distance` near planes off.
    fn resolution(self, distance: f64, far: f64) -> f64 {
        let float = |exponent: i32| {
            let least = 2.0_f64.powi(1 - (1 << exponent));
            2.0_f64.powi(exponent - 16) * (least * distance).max(1.0)
        };
        match self {
            Self::Linear => distance * (far - 1.0) / far / 65_528.0,
            Self::Float => float(4),
            Self::Model(exponent) => float(exponent),
        }
    }
}

/// What the library keeps of a share of its range.
fn code_of<D: for<'c> Depth<Cell<'c> = &'c mut u16>>(share: f64) -> u32 {
    let mut cell = 0;
    // The cast saturates.
    D::cover(&mut cell, D::varying(D::vertex(|| (share * 2.0_f64.powi(32)) as u32)));
    cell.into()
}

/// How far the near and the far plane of a scene are apart.
fn far_of(scene: &Scene) -> f64 {
    match scene.camera {
        Camera::Orbit { depth: (near, far), .. } => f64::from(far) / f64::from(near),
        Camera::Front { .. } => 1.0,
    }
}

/// A face at a pixel: its exact depth there.
#[derive(Clone, Copy, Debug)]
struct Layer {
    face: usize,
    depth: f64,
}

/// The faces at each pixel in the order in which they are drawn.
fn layers(scene: &Scene, frame: &Frame) -> Vec<Vec<Layer>> {
    let (width, height) = (i64::from(PANEL.width), i64::from(PANEL.height));
    let mut layers = vec![Vec::new(); (width * height) as usize];
    for (face, patches) in frame.faces.iter().enumerate() {
        for patch in patches.iter().filter(|patch| is_drawn(scene, patch)) {
            for y in 0..height {
                let Some((start, end)) = row_span(patch.triangle, y) else { continue };
                for x in start.max(0)..end.min(width) {
                    let depth = patch.depth(x, y).0;
                    layers[(y * width + x) as usize].push(Layer { face, depth });
                }
            }
        }
    }
    layers
}

fn is_drawn(scene: &Scene, patch: &Patch) -> bool {
    let cull = match scene.objects[patch.object].cull {
        topleft::Cull::Back => Cull::Back,
        topleft::Cull::Front => Cull::Front,
        topleft::Cull::None => Cull::None,
    };
    cull.keeps(facing(patch.triangle))
}

/// The face that is seen where the greatest key wins, and the earlier of two that are equal.
fn seen<K: PartialOrd>(layers: &[Layer], key: impl Fn(&Layer) -> K) -> Option<usize> {
    let mut best: Option<(usize, K)> = None;
    for layer in layers {
        let key = key(layer);
        if best.as_ref().is_none_or(|(_, most)| key > *most) {
            best = Some((layer.face, key));
        }
    }
    best.map(|(face, _)| face)
}

/// The faces that the library shows with a depth buffer, sorted, or as they are listed.
fn drawn<D: Kept>(scene: &Scene) -> Vec<Option<usize>> {
    let pixels = (PANEL.width * PANEL.height) as usize;
    let (mut words, mut triangles) = (vec![0; 1 << 16], vec![ListTriangle::EMPTY; 4000]);
    let (mut cells, mut depths) = (vec![UNSEEN; pixels], vec![0; pixels]);
    let mut list = DrawList::<Seen, D>::new(&mut words, &mut triangles);
    let mut first_face = 0;
    for object in scene.objects {
        list.set_cull(object.cull);
        let (pose, probe) = (object.pose(View::default().turn), Probe { values: &[], first_face });
        let camera = scene.camera.orbiting(PANEL, &View::default()).expect("the scenes have perspective");
        list.draw(&camera, object.mesh, &pose, &probe).expect("the list is long enough");
        first_face += object.mesh.faces().len();
    }
    D::sort(&mut list);
    let mut strip = D::strip(Strip::new(PANEL.width as u16, &mut cells).expect("whole rows"), &mut depths);
    strip.clear();
    list.render(0..PANEL.height as i32, &mut strip);
    drop(strip);
    cells.iter().map(Seen::face).collect()
}

/// A strip with depth, or as it is, and a list that is sorted, or as it is.
trait Kept: Depth + Sized {
    fn sort(_: &mut DrawList<'_, Seen, Self>) {}

    fn strip<'s>(strip: Strip<'s, Seen, NoDepth>, depths: &'s mut [u16]) -> Strip<'s, Seen, Self>;
}

impl Kept for NoDepth {
    fn strip<'s>(strip: Strip<'s, Seen, NoDepth>, _: &'s mut [u16]) -> Strip<'s, Seen, Self> {
        strip
    }
}

impl Kept for Painter {
    fn sort(list: &mut DrawList<'_, Seen, Self>) {
        list.sort(&mut vec![[0; 3]; list.stats().drawn]).expect("as many");
    }

    fn strip<'s>(strip: Strip<'s, Seen, NoDepth>, _: &'s mut [u16]) -> Strip<'s, Seen, Self> {
        strip.for_painter()
    }
}

impl Kept for Depth16 {
    fn strip<'s>(strip: Strip<'s, Seen, NoDepth>, depths: &'s mut [u16]) -> Strip<'s, Seen, Self> {
        strip.with_depth(depths).expect("as many")
    }
}

impl Kept for DepthFloat {
    fn strip<'s>(strip: Strip<'s, Seen, NoDepth>, depths: &'s mut [u16]) -> Strip<'s, Seen, Self> {
        strip.with_depth_float(depths).expect("as many")
    }
}

/// Pixels of each scene that show another face than the nearest, by what is kept of depth. Costs are of nothing, of a list
/// that is sorted, sorting included, of a buffer, and of one of small floats.
pub(crate) fn inversions(costs: [Option<f64>; 4], mut done: impl FnMut()) -> Table {
    let mut header = vec!["method", "m0_cycles_per_px"];
    header.extend(SCENES);
    let mut table = Table::new(&header);
    let scenes: Vec<&Scene> = SCENES.into_iter().filter_map(by_name).collect();
    let counted: Vec<Vec<usize>> = scenes
        .iter()
        .map(|scene| {
            let frame = Frame::new(scene, PANEL, &View::default());
            let layers = layers(scene, &frame);
            let nearest: Vec<_> = layers.iter().map(|layers| seen(layers, |layer| layer.depth)).collect();
            let wrong = |shown: &dyn Fn(usize) -> Option<usize>| {
                (0..layers.len())
                    .filter(|&pixel| shown(pixel).is_some_and(|face| nearest[pixel] != Some(face)))
                    .count()
            };
            // At an edge a vertex may have been snapped to the next step: only what covers the pixel counts.
            let library = |faces: Vec<Option<usize>>| {
                wrong(&|pixel| {
                    let (x, y) = ((pixel % 240) as i64, (pixel / 240) as i64);
                    let covered =
                        |face: &usize| frame.faces[*face].iter().any(|patch| covers(patch.triangle, x, y));
                    faces[pixel].filter(covered)
                })
            };
            let far = far_of(scene);
            let mut counts = vec![
                library(drawn::<NoDepth>(scene)),
                library(drawn::<Painter>(scene)),
                library(drawn::<Depth16>(scene)),
                library(drawn::<DepthFloat>(scene)),
            ];
            for (_, format) in Format::ALL.into_iter().skip(2) {
                counts.push(wrong(&|pixel| seen(&layers[pixel], |layer| format.code(layer.depth, far))));
            }
            done();
            counts
        })
        .collect();
    let names = ["NoDepth, as listed", "Painter"].into_iter();
    let names = names.chain(Format::ALL.map(|(name, _)| name));
    for (row, name) in names.enumerate() {
        // A model has no cost of its own: it is drawn where the library's small floats are.
        let cost = costs[row.min(costs.len() - 1)].map_or(String::new(), figure);
        let counts: Vec<usize> = counted.iter().map(|counts| counts[row]).collect();
        let mut cells = vec![name.to_owned(), cost];
        cells.extend(counts.iter().map(usize::to_string));
        table.rows.push(cells);
    }
    table
}

/// The distances of the ladder's rungs in near planes, and how far apart the faces of its pairs are.
const NEAR: f64 = 0.1;
const CLOSER: [f64; 6] = [0.05, 0.02, 0.01, 0.005, 0.002, 0.001];

/// What each format tells apart at each distance of the ladder: the bound, and the closest pair there without a wrong
/// pixel, with all pairs that are further apart.
pub(crate) fn resolution(mut done: impl FnMut()) -> Table {
    let mut table = Table::new(&["format", "distance", "bound", "closest_pair_right"]);
    let ladder = by_name("ladder").expect("it is there");
    let far = far_of(ladder);
    let frame = Frame::new(ladder, PANEL, &View::default());
    let layers = layers(ladder, &frame);
    let (linear, float) = (drawn::<Depth16>(ladder), drawn::<DepthFloat>(ladder));
    for (name, format) in Format::ALL {
        for (place, object) in ladder.objects.iter().enumerate() {
            let distance = object.scale.to_num::<f64>() / NEAR;
            // Faces of a pair: two of the red quad, then two of the green one.
            let first = place * 4 * CLOSER.len();
            let is_right = |pair: usize| {
                let red = first + 4 * pair..first + 4 * pair + 2;
                !layers.iter().zip(linear.iter().zip(&float)).any(|(layers, (&linear, &float))| {
                    let shown = match format {
                        Format::Linear => linear,
                        Format::Float => float,
                        Format::Model(_) => seen(layers, |layer| format.code(layer.depth, far)),
                    };
                    shown.is_some_and(|face| {
                        red.contains(&face)
                            && layers.iter().any(|layer| (red.end..red.end + 2).contains(&layer.face))
                    })
                })
            };
            let right = (0..CLOSER.len()).take_while(|&pair| is_right(pair)).last();
            table.rows.push(vec![
                name.into(),
                figure(distance),
                figure(format.resolution(distance, far)),
                right.map_or(String::new(), |pair| figure(CLOSER[pair])),
            ]);
        }
        done();
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;

    // Red when a float's last power has a leading one, or grows the wrong way.
    #[test]
    fn codes_fall_with_distance() {
        let far = 1000.0;
        for (name, format) in Format::ALL {
            let code =
                |w: f64| format.code(4.0 + 65_528.0 * (1.0 - far / (far - 1.0) * (1.0 - 1.0 / w)), far);
            let codes: Vec<u32> = (0..3000).map(|k| code(far.powf(f64::from(k) / 2999.0))).collect();
            assert!(codes.windows(2).all(|pair| pair[0] >= pair[1]), "{name}");
            assert!(codes[0] > 60_000, "{name} {}", codes[0]);
        }
    }

    // Red when the bound of a format is another's, or less than what it tells apart.
    #[test]
    fn pairs_beyond_the_resolution_have_two_codes() {
        let far = 1000.0;
        for (name, format) in Format::ALL {
            let code =
                |w: f64| format.code(4.0 + 65_528.0 * (1.0 - far / (far - 1.0) * (1.0 - 1.0 / w)), far);
            for w in (0..600).map(|k| far.powf(f64::from(k) / 600.0)) {
                let apart = format.resolution(w, far) * 1.0001;
                let nearer = w * (1.0 - apart);
                assert!(nearer < 1.0 || code(nearer) > code(w), "{name} at {w}");
            }
        }
    }
}
