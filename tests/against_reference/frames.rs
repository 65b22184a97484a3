//! Whole scenes against whole frames of the reference: what is covered, how deep it is, and its colour.
//!
//! A pixel within the error of a vertex of an edge may belong to either side; all else must agree.

use embedded_graphics_core::geometry::Size;
use reference::raster::covers;
use reference::setup::Triangle;
use reference::shade::{from_rgb565, to_rgb565};
use reference::varying::linear;
use scenes::{Object, SCENES, Scene, Shade, sun};
use topleft::{
    Attribute, ColourError, Depth16, DrawList, Gouraud, ListTriangle, Material, Pixel, Strip, Turn,
};

use crate::measured::{Errors, Row, hold};
use crate::patches::{Frame, Patch};
use crate::probe::{Probe, Seen, UNSEEN, outside};
use crate::tolerance::{LIGHT_STEPS, LIT, channel, half};

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

/// A colour that is held against what a pixel may show.
struct Shown {
    right: bool,
    /// How far the furthest of what it may show is from the exact colour, channel by channel.
    off: [f64; 3],
}

/// Half a step of each channel of RGB565, in codes of 255.
const HALF_STEP: [f64; 3] = [255.0 / 62.0, 255.0 / 126.0, 255.0 / 62.0];

fn apart(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|k| (a[k] - b[k]).abs())
}

/// Holds a colour against all that a texture may show at a pixel; nothing where too much may be.
fn texture_shows(
    look: &scenes::Look,
    patch: &Patch,
    [x, y]: [i64; 2],
    ours: u16,
    exact: [f64; 3],
) -> Option<Shown> {
    let [(u, du), (v, dv)] = [patch.texel(0, x, y)?, patch.texel(1, x, y)?];
    let light = 64.0 * linear(patch.triangle, patch.varyings[0], x, y);
    let off = LIGHT_STEPS + 64.0 * patch.slope_error(patch.varyings[0]) + half(10);
    let lights = if look.shade == Shade::Lit {
        (light - off + 0.5).floor() as u32..=((light + off + 0.5).floor() as u32).min(64)
    } else {
        64..=64
    };
    let mut shown = Shown { right: false, off: [0.0; 3] };
    for u in (u - du).floor() as i32..=(u + du).floor() as i32 {
        for v in (v - dv).floor() as i32..=(v + dv).floor() as i32 {
            let texel = look.texture.texel(u, v);
            for colour in lights.clone().map(|light| u16::lit_texel(texel, light)) {
                shown.right |= colour == ours;
                let apart = apart(from_rgb565(colour), exact);
                shown.off = [0, 1, 2].map(|k| shown.off[k].max(apart[k]));
            }
        }
    }
    Some(shown)
}

/// Holds a colour against what a pixel that shows a patch may show; nothing where the bound says nothing.
fn shown(
    scene: &Scene,
    patch: &Patch,
    at: [i64; 2],
    ours: u16,
    exact: [f64; 3],
    allowed: f64,
) -> Option<Shown> {
    let look = &scene.objects[patch.object].look;
    match look.shade {
        Shade::Plain => Some(Shown { right: ours == to_rgb565(exact), off: HALF_STEP }),
        Shade::Flat => {
            let (off, apart) = (HALF_STEP.map(|step| step + LIT), apart(from_rgb565(ours), exact));
            Some(Shown { right: (0..3).all(|k| apart[k] <= off[k]), off })
        }
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
            // In codes: of red or blue, whose steps are the greater.
            let carried = channel(patch.steps(at[0], at[1]), 31.0) * 255.0 / 31.0;
            let off = allowed + colour + LIT + carried + half(7);
            let (off, apart) = (HALF_STEP.map(|step| step + off), apart(from_rgb565(ours), exact));
            Some(Shown { right: (0..3).all(|k| apart[k] <= off[k]), off })
        }
        _ => texture_shows(look, patch, at, ours, exact),
    }
}

/// What the library draws: faces, colours and depths. The colours are listed by `list_colours`.
fn drawn(
    scene: &Scene,
    size: Size,
    view: &scenes::View,
    list_colours: impl FnOnce(&mut DrawList<'_, u16, Depth16>),
) -> (Vec<Seen>, Vec<u16>, Vec<u16>) {
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
    list_colours(&mut list);
    let strip = Strip::new(width, &mut colours).unwrap().with_depth(&mut depths).unwrap();
    let mut strip = strip.with_background(to_rgb565(scene.background.map(f64::from)));
    strip.clear();
    list.render(rows, &mut strip);
    (faces, colours, depths)
}

/// A scene from two sides, on two sizes of screen.
pub(crate) fn of_scene(scene: &Scene) -> Vec<Row> {
    let mut rows = Vec::new();
    for (turn, size) in [(20, Size::new(240, 240)), (77, Size::new(160, 100))] {
        // The bounds of texels are for this method, whichever the scene asks for.
        let method = Some(scenes::Method::PerPixel);
        let view = scenes::View { turn: Turn::from_degrees(turn), method, ..scenes::View::default() };
        let frame_of = Frame::new(scene, size, &view);
        let (faces, colours, depths) =
            drawn(scene, size, &view, |list| scene.draw(list, size, &view).unwrap());
        let name = format!("{} at {turn} degrees {}x{}", scene.name, size.width, size.height);
        let result = compare(scene, &frame_of, &faces, &colours, &depths, 0.0, &name);
        assert!(result.colours.count() > 1500, "{name}: too little is compared");
        assert!(result.any_texel * 20 < result.colours.count(), "{name}: the bounds say too little");
        rows.extend(result.rows(&name, faces.len() as u64));
    }
    rows
}

/// The scenes of which all is smoothly shaded.
pub(crate) const SMOOTH: [&str; 2] = ["sphere", "knot"];

/// One of them with triangles of nearly one colour in one: what is allowed is added to what colours may be off by.
pub(crate) fn within_colour(name: &str) -> Vec<Row> {
    let scene = scenes::by_name(name).expect("a scene of that name");
    let (size, view) =
        (Size::new(240, 240), scenes::View { turn: Turn::from_degrees(20), ..scenes::View::default() });
    let frame_of = Frame::new(scene, size, &view);
    [1_u8, 4, 8, 16]
        .map(|codes| {
            let error = ColourError::codes(Attribute::from_num(codes));
            let (faces, colours, depths) = drawn(scene, size, &view, |list| {
                let shader = |object: &Object| Gouraud::new(&sun(), &object.look.material).within(error);
                scene.draw_with(list, size, &view, shader).unwrap();
            });
            let result = compare(scene, &frame_of, &faces, &colours, &depths, codes.into(), name);
            assert!(result.colours.count() > 1500 && result.any_texel == 0, "{name}: too little is compared");
            let method = format!("gouraud within {codes}");
            Row::new("frames", name, method, ["colour of one", "code of 255"], &result.colours)
        })
        .into()
}

/// Turned red by: one colour where vertices differ by four times the error, or where a channel of them does.
#[test]
fn smooth_scenes_are_off_by_what_is_allowed() {
    SMOOTH.iter().for_each(|name| hold(&within_colour(name)));
}

/// Turned red by: y up, a sun that turns with the mesh, colours that are truncated, another far code, u for v.
#[test]
fn scenes_are_what_the_reference_draws() {
    SCENES.iter().for_each(|scene| hold(&of_scene(scene)));
}

/// What was compared, and how far it is off.
#[derive(Debug, Default)]
struct Result {
    /// Pixels that show another face, all of them as near to an edge, or to the other's depth, as the bounds say.
    other_face: u64,
    /// Codes, beyond the exact one.
    depth: Errors,
    /// Channels of colours that are compared, and pixels where too many texels may be right.
    colours: Errors,
    any_texel: u64,
    /// Squares of the channels' errors, and of what they may be.
    squares: [f64; 2],
}

impl Result {
    fn rows(&self, name: &str, pixels: u64) -> [Row; 4] {
        let channels = self.colours.count() as f64;
        let [found, allowed] = self.squares.map(|sum| 10.0 * (255.0 * 255.0 * channels / sum).log10());
        let colours =
            Row::new("frames", name, "as the scene draws it", ["colour", "code of 255"], &self.colours);
        let noise = Row {
            metric: "PSNR (a least value)",
            unit: "dB".into(),
            measured_max: found,
            measured_p999: found,
            bound: allowed,
            ratio: (self.squares[0] / self.squares[1]).sqrt(),
            ..colours.clone()
        };
        let edges = format!("px; {} near an edge or as deep", self.other_face);
        [
            Row::none_of(pixels, &edges, "frames", name, "as the scene draws it"),
            Row::new("frames", name, "as the scene draws it", ["depth beyond its code", "code"], &self.depth),
            colours,
            noise,
        ]
    }
}

fn compare(
    scene: &Scene,
    wanted: &Frame,
    faces: &[Seen],
    colours: &[u16],
    depths: &[u16],
    allowed: f64,
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
            continue;
        }
        // On the edge of a fan inside a face, any of its triangles may be the one.
        let Some(patch) = patches(exact).iter().find(|patch| covers(patch.triangle, x, y)) else { continue };
        let (depth, off) = patch.depth(x, y);
        result.depth.add(outside(depths[index].into(), depth), off, || format!("{name} at {x}, {y}"));
        match shown(scene, patch, [x, y], colours[index], pixel.colour, allowed) {
            None => result.any_texel += 1,
            Some(shown) => {
                let (colour, exact) = (from_rgb565(colours[index]), pixel.colour);
                assert!(shown.right, "{name}: {colour:?} for {exact:?} at {x}, {y}");
                for (apart, off) in apart(colour, exact).into_iter().zip(shown.off) {
                    result
                        .colours
                        .add(apart, off, || format!("{name}: {colour:?} for {exact:?} at {x}, {y}"));
                    result.squares[0] += apart * apart;
                    result.squares[1] += off * off;
                }
            }
        }
    }
    result
}
