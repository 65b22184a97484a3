//! Whole scenes against whole frames of the reference: what is covered, how deep it is, and its colour.
//!
//! A pixel within the error of a vertex of an edge may belong to either side; all else must agree.

use embedded_graphics_core::geometry::Size;
use reference::compare::{coverage, frame};
use reference::raster::covers;
use reference::setup::Triangle;
use reference::shade::{from_rgb565, to_rgb565};
use reference::varying::linear;
use scenes::{SCENES, Scene, Shade};
use topleft::{Depth16, DrawList, ListTriangle, Material, Pixel, Strip, Turn};

use crate::patches::{Frame, Patch};
use crate::probe::{Probe, Seen, UNSEEN};
use crate::tolerance::{LIGHT_STEPS, LIT, half, interpolation};

/// Steps from a pixel's centre to the nearest edge of a triangle.
fn to_edge(triangle: Triangle, x: i64, y: i64) -> f64 {
    let centre = [x, y].map(|c| (c * 256 + 128) as f64);
    let [a, b, c] = triangle.map(|p| p.map(f64::from));
    let distance = |from: [f64; 2], to: [f64; 2]| {
        let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
        let (px, py) = (centre[0] - from[0], centre[1] - from[1]);
        let along = ((px * dx + py * dy) / (dx * dx + dy * dy).max(1.0)).clamp(0.0, 1.0);
        (px - along * dx).hypot(py - along * dy)
    };
    distance(a, b).min(distance(b, c)).min(distance(c, a))
}

/// Whether `ours` is a colour that the texture may show at a pixel; nothing where too many may.
fn texture_shows(look: &scenes::Look, patch: &Patch, [x, y]: [i64; 2], ours: u16) -> Option<bool> {
    let [(u, du), (v, dv)] = [patch.texel(0, x, y)?, patch.texel(1, x, y)?];
    let light = 64.0 * linear(patch.triangle, patch.varyings[0], x, y);
    let off = LIGHT_STEPS + 64.0 * patch.slope_error(patch.varyings[0]) + half(10);
    let lights = if look.shade == Shade::Lit {
        (light - off + 0.5).floor() as u32..=((light + off + 0.5).floor() as u32).min(64)
    } else {
        64..=64
    };
    let columns = (u - du).floor() as i32..=(u + du).floor() as i32;
    let shows = |(u, v): (i32, i32)| {
        let texel = look.texture.texel(u, v);
        lights.clone().any(|light| u16::lit_texel(texel, light) == ours)
    };
    Some(
        columns
            .flat_map(|u| ((v - dv).floor() as i32..=(v + dv).floor() as i32).map(move |v| (u, v)))
            .any(shows),
    )
}

/// Whether a colour is right at a pixel that shows a patch; nothing where the bound says nothing.
fn colour_is_right(scene: &Scene, patch: &Patch, at: [i64; 2], ours: u16, exact: [f64; 3]) -> Option<bool> {
    let look = &scene.objects[patch.object].look;
    match look.shade {
        Shade::Plain => Some(ours == to_rgb565(exact)),
        Shade::Gouraud => {
            // Mixed at the guard rectangle, colours are not on one plane any more.
            if patch.clipped {
                return None;
            }
            // A colour is at most 255 times the light; those of a mesh differ by no more than all codes.
            let colour = match look.material {
                Material::Colour(_) => 255.0 * patch.slope_error(patch.varyings[0]),
                Material::OfMesh => [[255.0, 0.0, 0.0], [0.0, 255.0, 0.0], [0.0, 0.0, 255.0]]
                    .map(|values| patch.slope_error(values))
                    .into_iter()
                    .sum(),
            };
            let off = colour + LIT + 255.0 * interpolation(16, patch.steps(at[0], at[1]), 1.0) + half(7);
            let step = [31.0, 63.0, 31.0].map(|most| 255.0 / most / 2.0);
            let error = |k: usize| (from_rgb565(ours)[k] - exact[k]).abs();
            Some((0..3).all(|k| error(k) <= off + step[k]))
        }
        _ => texture_shows(look, patch, at, ours),
    }
}

/// What the library draws: faces, colours and depths.
fn drawn(scene: &Scene, size: Size, view: &scenes::View) -> (Vec<Seen>, Vec<u16>, Vec<u16>) {
    let (width, pixels) = (size.width as u16, (size.width * size.height) as usize);
    let rows = 0..size.height as i32;
    let storage = || (vec![0; 1 << 16], vec![ListTriangle::EMPTY; 4000]);
    let (mut words, mut triangles) = storage();
    let mut depths = vec![0; pixels];
    let mut faces = vec![UNSEEN; pixels];
    let mut list = DrawList::<Seen, Depth16>::new(&mut words, &mut triangles);
    let mut first_face = 0;
    for object in scene.objects {
        list.set_cull(object.cull);
        let (pose, probe) = (object.pose(view.turn), Probe { values: &[], first_face });
        if let Some(camera) = scene.camera.orbiting(size, view) {
            list.draw(&camera, object.mesh, &pose, &probe).unwrap();
        }
        if let Some(camera) = scene.camera.front(size) {
            list.draw(&camera, object.mesh, &pose, &probe).unwrap();
        }
        first_face += object.mesh.faces().len();
    }
    let mut strip = Strip::new(width, &mut faces).unwrap().with_depth(&mut depths).unwrap();
    strip.clear();
    list.render(rows.clone(), &mut strip);

    let mut colours = vec![0; pixels];
    let (mut words, mut triangles) = storage();
    let mut list = DrawList::<u16, Depth16>::new(&mut words, &mut triangles);
    scene.draw(&mut list, size, view).unwrap();
    let strip = Strip::new(width, &mut colours).unwrap().with_depth(&mut depths).unwrap();
    let mut strip = strip.with_background(to_rgb565(scene.background.map(f64::from)));
    strip.clear();
    list.render(rows, &mut strip);
    (faces, colours, depths)
}

/// Turned red by: y up, a sun that turns with the mesh, colours that are truncated, another far code, u for v.
#[test]
fn scenes_are_what_the_reference_draws() {
    for scene in SCENES {
        for (turn, size) in [(20, Size::new(240, 240)), (77, Size::new(160, 100))] {
            let view = scenes::View { turn: Turn::from_degrees(turn), ..scenes::View::default() };
            let frame_of = Frame::new(scene, size, &view);
            let (faces, colours, depths) = drawn(scene, size, &view);
            let name = format!("{} at {turn} degrees, {}x{}", scene.name, size.width, size.height);
            let result = compare(scene, &frame_of, &faces, &colours, &depths, &name);
            let counts = |covered: &dyn Fn(usize) -> bool| -> Vec<u32> {
                (0..faces.len()).map(|index| u32::from(covered(index))).collect()
            };
            let ours: Vec<_> = colours.iter().map(|&colour| from_rgb565(colour)).collect();
            let mut report = frame(&name, &ours, Some(&depths), &frame_of.image.quantised());
            report.coverage = Some(coverage(
                &counts(&|index| faces[index].face().is_some()),
                &counts(&|index| frame_of.image.pixels()[index].face.is_some()),
            ));
            println!("{report}\n    {result:?}");
            assert!(result.colours > 500, "{name}: too little is compared");
        }
    }
}

/// What was compared, and the worst of it.
#[derive(Debug, Default)]
struct Result {
    /// Pixels that show another face, and the furthest of them from an edge in steps, as a share of the bound.
    other_face: u64,
    from_edge: f64,
    /// Codes that differ, and the worst as a share of the bound.
    depth: f64,
    /// Colours compared, and pixels where too many texels may be right.
    colours: u64,
    any_texel: u64,
}

fn compare(
    scene: &Scene,
    wanted: &Frame,
    faces: &[Seen],
    colours: &[u16],
    depths: &[u16],
    name: &str,
) -> Result {
    let mut result = Result::default();
    for (index, pixel) in wanted.image.pixels().iter().enumerate() {
        let width = wanted.viewport.width as usize;
        let [x, y] = [index % width, index / width].map(|c| c as i64);
        let (ours, exact) = (faces[index].face(), pixel.face.map(|face| face as usize));
        let patches = |face: Option<usize>| face.map_or(&[][..], |face| &wanted.faces[face]);
        if ours != exact {
            result.other_face += 1;
            let share = patches(ours)
                .iter()
                .chain(patches(exact))
                .map(|patch| to_edge(patch.triangle, x, y) / (patch.moved * 2.0_f64.sqrt()))
                .fold(f64::INFINITY, f64::min);
            // Or both are as deep.
            let shown = |face| patches(face).iter().find(|patch| covers(patch.triangle, x, y));
            let tie = match (shown(ours), shown(exact)) {
                (Some(a), Some(b)) => {
                    let ((a, da), (b, db)) = (a.depth(x, y), b.depth(x, y));
                    (a - b).abs() <= da + db + 1.0
                }
                _ => false,
            };
            assert!(
                share <= 1.0 || tie,
                "{name}: face {ours:?} for {exact:?} at {x}, {y}, {share} of the bound"
            );
            if !tie {
                result.from_edge = result.from_edge.max(share);
            }
            continue;
        }
        // On the edge of a fan inside a face, any of its triangles may be the one.
        let Some(patch) = patches(exact).iter().find(|patch| covers(patch.triangle, x, y)) else { continue };
        let (depth, off) = patch.depth(x, y);
        let error = (f64::from(depths[index]) - depth).max(depth - f64::from(depths[index]) - 1.0);
        assert!(
            error <= off,
            "{name}: depth {} for {depth} at {x}, {y}, off by more than {off}",
            depths[index]
        );
        result.depth = result.depth.max(error / off);
        match colour_is_right(scene, patch, [x, y], colours[index], pixel.colour) {
            None => result.any_texel += 1,
            Some(right) => {
                result.colours += 1;
                let colour = from_rgb565(colours[index]);
                assert!(right, "{name}: {colour:?} for {:?} at {x}, {y}", pixel.colour);
            }
        }
    }
    result
}
