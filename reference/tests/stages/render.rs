use reference::image::Image;
use reference::matrix::rotation;
use reference::render::{Drawn, Missing, View, draw};
use reference::setup::Cull;
use reference::shade::{Base, Light, Look, Normals, from_rgb565};
use reference::transform::{Pose, Viewport, look_at, orthographic, perspective};
use reference::varying::Method;
use std::collections::BTreeSet;
use topleft::{Length, Mesh, Texture, Wrap};

const VIEWPORT: Viewport = Viewport { width: 40, height: 30 };
const ASPECT: f64 = 40.0 / 30.0;
const BLACK: [f64; 3] = [0.0; 3];
/// The cube's faces as two triangles each, counter-clockwise from outside; corner bits are x, y, z.
const CUBE: [[u16; 3]; 12] = [
    [4, 5, 7],
    [4, 7, 6],
    [1, 0, 2],
    [1, 2, 3],
    [5, 1, 3],
    [5, 3, 7],
    [0, 4, 6],
    [0, 6, 2],
    [6, 7, 3],
    [6, 3, 2],
    [0, 1, 5],
    [0, 5, 4],
];

/// From (0, 0, 3) to the origin, 90 degrees from top to bottom.
fn from_the_front() -> View {
    let camera = look_at([0.0, 0.0, 3.0], [0.0; 3], [0.0, 1.0, 0.0]);
    let lens = perspective(std::f64::consts::FRAC_PI_2, ASPECT, 0.5, 10.0);
    View { model_to_clip: camera.then(&lens), guard: None, first_face: 0 }
}

fn drawn(mesh: &Mesh<'_>, view: &View, look: &Look<'_>) -> (Image, Drawn) {
    let mut image = Image::new(VIEWPORT, BLACK);
    let drawn = draw(&mut image, mesh, view, look).unwrap();
    (image, drawn)
}

/// A quad in the plane z = 0 from (-1, -1) to (1, 1), corners from bottom left, counter-clockwise from +Z.
const QUAD: [[i16; 3]; 4] =
    [[-16_384, -16_384, 0], [16_384, -16_384, 0], [16_384, 16_384, 0], [-16_384, 16_384, 0]];
const QUAD_FACES: [[u16; 3]; 2] = [[0, 1, 2], [0, 2, 3]];

fn quad() -> Mesh<'static> {
    Mesh::new(&QUAD, &QUAD_FACES).unwrap().with_box([Length::ZERO; 3], Length::lit("2"))
}

#[test]
fn a_triangle_stands_upright_and_faces_who_sees_it_counter_clockwise() {
    // Red bottom left, green bottom right, blue on top.
    let positions = [[-16_384, -16_384, 0], [16_384, -16_384, 0], [0, 16_384, 0]];
    let colours = [[255, 0, 0], [0, 255, 0], [0, 0, 255]];
    let mesh = Mesh::new(&positions, &[[0, 1, 2]])
        .unwrap()
        .with_box([Length::ZERO; 3], Length::lit("2"))
        .with_vertex_colours(&colours)
        .unwrap();
    let look = Look { base: Base::VertexColours, ..Look::flat([0; 3]) };
    let (image, counts) = drawn(&mesh, &from_the_front(), &look);
    // A unit in the middle is 5 pixels: x from 15 to 25, y from 10 to 20.
    let brightest = |channel: usize| {
        let value = |&(x, y): &(u32, u32)| image.pixel(x, y).colour[channel];
        let places = (0..30).flat_map(|y| (0..40).map(move |x| (x, y)));
        places.max_by(|a, b| value(a).total_cmp(&value(b))).unwrap()
    };
    assert_eq!([brightest(0), brightest(1), brightest(2)], [(15, 19), (24, 19), (20, 11)]);
    assert_eq!(counts, Drawn { faces: 1, triangles: 1, covered: 50, written: 50, ..Drawn::default() });
    // From behind it is culled, unless fronts are; then left and right are exchanged.
    let behind = View {
        model_to_clip: look_at([0.0, 0.0, -3.0], [0.0; 3], [0.0, 1.0, 0.0]).then(&perspective(
            std::f64::consts::FRAC_PI_2,
            ASPECT,
            0.5,
            10.0,
        )),
        ..from_the_front()
    };
    assert_eq!(drawn(&mesh, &behind, &look).1, Drawn { faces: 1, culled: 1, ..Drawn::default() });
    let (image, _) = drawn(&mesh, &behind, &Look { cull: Cull::Front, ..look });
    assert!(image.pixel(24, 19).colour[0] > 200.0 && image.pixel(15, 19).colour[1] > 200.0);
}

#[test]
fn the_nearer_surface_is_seen_whatever_the_order() {
    // Two quads that cross at the view's middle: the left half of one and the right half of the other are nearer.
    let h = 16_384;
    let one = [[-h, -h, h], [h, -h, -h], [h, h, -h], [-h, h, h]];
    let other = one.map(|[x, y, z]| [x, y, -z]);
    let positions = [one, other].concat();
    let mut faces = [[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]];
    let colours = [[200, 0, 0], [200, 0, 0], [0, 0, 200], [0, 0, 200]];
    let look = Look { base: Base::FaceColours, ..Look::flat([0; 3]) };
    let camera = look_at([0.0, 0.0, 3.0], [0.0; 3], [0.0, 1.0, 0.0]);
    let view = View { model_to_clip: camera.then(&orthographic(2.0, ASPECT, 1.0, 5.0)), ..from_the_front() };
    let mut frames = Vec::new();
    for swap in [false, true] {
        let mut colours = colours;
        if swap {
            faces.reverse();
            colours.reverse();
        }
        let mesh = Mesh::new(&positions, &faces).unwrap().with_face_colours(&colours).unwrap();
        let (image, counts) = drawn(&mesh, &view, &look);
        // A half of a unit is 7.5 pixels: y from 7.5 to 22.5 has 15 rows of centres, x as many.
        assert_eq!(counts.covered, 2 * 15 * 15);
        assert_eq!(
            [image.pixel(14, 15).colour, image.pixel(26, 15).colour],
            [[200.0, 0.0, 0.0], [0.0, 0.0, 200.0]]
        );
        frames.push((image.rgb565(), image.depth_codes()));
        // Without depth the last one is seen.
        let (image, _) = drawn(&mesh, &view, &Look { depth: false, ..look });
        assert_eq!(image.pixel(14, 15).colour, image.pixel(26, 15).colour);
        assert_eq!(image.pixel(14, 15).depth, 0.0);
    }
    assert_eq!(frames[0], frames[1]);
    // The same surface again in another colour: nothing of it is nearer.
    let (mut image, _) = drawn(&quad(), &view, &Look::flat([200, 0, 0]));
    let before = image.clone();
    let again = draw(&mut image, &quad(), &view, &Look::flat([0, 200, 0])).unwrap();
    assert!(again.covered > 0 && again.written == 0 && image == before);
}

#[test]
fn depth_is_what_the_distance_says() {
    // A wall at distance 3 of near 0.5 and far 10: z/w = 10/9.5 * (1 - 0.5/3).
    let (image, _) = drawn(&quad(), &from_the_front(), &Look::flat([9; 3]));
    let wanted = 4.0 + 65_528.0 * (1.0 - 10.0 / 9.5 * (1.0 - 0.5 / 3.0));
    assert!((image.pixel(20, 15).depth - wanted).abs() < 1e-6);
    assert_eq!(image.depth_codes()[15 * 40 + 20], wanted.floor() as u16);
    assert_eq!(image.pixel(2, 2).depth, 0.0);
}

#[test]
fn a_texture_stands_upright() {
    // Texels 1 2 over 3 4 on the quad: its top left corner is the texture's origin.
    static TEXELS: [u16; 4] = [1, 2, 3, 4];
    let texture = Texture::new(2, 2, &TEXELS).unwrap().with_wrap(Wrap::Clamp);
    let uvs = [[0, 16_384], [16_384, 16_384], [16_384, 0], [0, 0]];
    let mesh = quad().with_uvs(&uvs, 1).unwrap();
    let look = Look { base: Base::Texture(texture), ..Look::flat([0; 3]) };
    let (image, _) = drawn(&mesh, &from_the_front(), &look);
    let seen = [(17, 12), (22, 12), (17, 17), (22, 17)].map(|(x, y)| image.pixel(x, y).colour);
    assert_eq!(seen, [1, 2, 3, 4].map(from_rgb565));
}

/// A floor that runs past the eye: near clipping, perspective and texture against a ray through each pixel.
#[test]
fn a_floor_is_what_rays_meet() {
    const SIZE: u16 = 64;
    let texels: Vec<u16> = (0..u32::from(SIZE).pow(2)).map(|i| ((i * 40_503) >> 4) as u16 | 1).collect();
    let texture = Texture::new(SIZE, SIZE, &texels).unwrap();
    // From -8 to 8 in x and z at y = 0; u and v grow with x and z, once every 4 units.
    let positions = [[-32_767, 0, 32_767], [32_767, 0, 32_767], [32_767, 0, -32_767], [-32_767, 0, -32_767]];
    let uvs = positions.map(|[x, _, z]| [x / 2, z / 2]);
    let mesh = Mesh::new(&positions, &QUAD_FACES).unwrap().with_box([Length::ZERO; 3], Length::lit("8"));
    let mesh = mesh.with_uvs(&uvs, 2).unwrap();
    let (eye, target) = ([0.5, 1.0, 3.0], [0.2, 0.4, 0.0]);
    let camera = look_at(eye, target, [0.0, 1.0, 0.0]);
    let lens = perspective(1.1, ASPECT, 0.5, 40.0);
    let view = View { model_to_clip: camera.then(&lens), ..from_the_front() };
    let look = Look { base: Base::Texture(texture), ..Look::flat([0; 3]) };
    let (image, counts) = drawn(&mesh, &view, &look);
    assert_eq!((counts.faces, counts.clipped, counts.outside), (2, 2, 0));
    // Clipped at the guard rectangle as well, the same rays answer.
    let (guarded, _) = drawn(&mesh, &View { guard: Some(4), ..view }, &look);

    // Where a ray through a place on the screen, in pixels, meets the floor.
    let meets = |x: f64, y: f64| {
        let seen = [(x / 20.0 - 1.0) / lens.0[0][0], (1.0 - y / 15.0) / lens.0[1][1], -1.0];
        // The camera's rotation, transposed, turns the ray back into the world.
        let ray = [0, 1, 2].map(|j| (0..3).map(|i| camera.0[i][j] * seen[i]).sum::<f64>());
        let distance = -eye[1] / ray[1];
        let place = [0, 2].map(|axis| eye[axis] + ray[axis] * distance);
        let edge = 8.0 * 32_767.0 / 32_768.0;
        (ray[1] < 0.0 && place.iter().all(|value| value.abs() < edge)).then_some(place)
    };
    let texel = |p: f64| (p / 8.0 * 2.0 * f64::from(SIZE)).floor().rem_euclid(f64::from(SIZE)) as usize;
    let colour = |[x, z]: [f64; 2]| from_rgb565(texels[texel(z) * usize::from(SIZE) + texel(x)]);
    let mut compared = [0, 0];
    for (index, pixel) in image.pixels().iter().enumerate() {
        // Snapping moves what is seen at a centre by up to half a step each way. A place on the floor is a quotient of
        // linear functions of the screen, so the corners of that square say between which places it lies.
        let step = 0.5 / 256.0 + 1e-9;
        let (x, y) = ((index % 40) as f64 + 0.5, (index / 40) as f64 + 0.5);
        let wanted = [(-step, -step), (-step, step), (step, -step), (step, step)]
            .map(|(dx, dy)| meets(x + dx, y + dy).map_or(BLACK, colour));
        if wanted.iter().all(|colour| *colour == wanted[0]) {
            compared[usize::from(wanted[0] != BLACK)] += 1;
            assert_eq!(pixel.colour, wanted[0], "pixel {x}, {y}");
            assert_eq!(guarded.pixels()[index].colour, wanted[0], "pixel {x}, {y} in the guard rectangle");
        }
    }
    assert!(compared[0] > 400 && compared[1] > 650, "{compared:?} pixels of the background and the floor");
}

#[test]
fn a_cubes_visible_faces_are_each_lit_once() {
    let positions = [0, 1, 2, 3, 4, 5, 6, 7]
        .map(|corner: i16| [0, 1, 2].map(|axis| if corner >> axis & 1 == 1 { 16_384 } else { -16_384 }));
    let axes: [[i8; 3]; 6] =
        [[0, 0, 127], [0, 0, -127], [127, 0, 0], [-127, 0, 0], [0, 127, 0], [0, -127, 0]];
    let normals: Vec<[i8; 3]> = axes.iter().flat_map(|&normal| [normal; 2]).collect();
    let mesh = Mesh::new(&positions, &CUBE).unwrap().with_face_normals(&normals).unwrap();
    let mesh = mesh.with_box([Length::ZERO; 3], Length::lit("2"));
    // Turned so that +X comes forward to the right of +Z's face: with a look from above three faces are seen.
    let pose = Pose { rotation: rotation([0.0, 1.0, 0.0], -0.6), ..Pose::IDENTITY };
    let camera = look_at([0.0, 2.0, 3.0], [0.0; 3], [0.0, 1.0, 0.0]);
    let lens = perspective(1.0, ASPECT, 0.5, 10.0);
    let model_to_clip = pose.matrix().then(&camera).then(&lens);
    let view = View { model_to_clip, guard: None, first_face: 100 };
    let towards = pose.direction_to_model([0.0, 1.0, 0.0]);
    let light = Light { towards, ambient: 0.25, diffuse: 0.5 };
    let look = Look { light: Some((light, Normals::Face)), depth: false, ..Look::flat([200, 100, 40]) };
    let (image, counts) = drawn(&mesh, &view, &look);
    assert_eq!((counts.faces, counts.triangles, counts.culled), (12, 6, 6));
    // Convex: with culling no pixel is written twice, and without depth nothing hides it if one were.
    assert!(image.pixels().iter().all(|pixel| pixel.writes <= 1));
    assert_eq!(image.pixels().iter().map(|pixel| u64::from(pixel.writes)).sum::<u64>(), counts.written);
    // The top has all the light, the sides what is ambient.
    let colour_of = |sides: [u32; 2]| {
        let seen = |face: u32| sides.contains(&(face / 2));
        let pixels =
            image.pixels().iter().filter(move |pixel| pixel.face.is_some_and(|face| seen(face - 100)));
        pixels.map(|pixel| pixel.colour.map(f64::round)).collect::<Vec<_>>()
    };
    let (top, sides) = (colour_of([4, 4]), colour_of([0, 2]));
    assert!(top.len() > 20 && top.iter().all(|&colour| colour == [150.0, 75.0, 30.0]));
    assert!(sides.len() > 20 && sides.iter().all(|&colour| colour == [50.0, 25.0, 10.0]));
    assert_eq!(top.len() + sides.len(), counts.written as usize);
    // Drawn again with all faces, the depth buffer leaves the same ones in sight.
    let (deep, _) = drawn(&mesh, &view, &Look { depth: true, cull: Cull::None, ..look });
    let faces = |image: &Image| image.pixels().iter().filter_map(|pixel| pixel.face).collect::<BTreeSet<_>>();
    assert_eq!(faces(&deep), faces(&image));
}

#[test]
fn light_is_carried_from_vertex_to_vertex() {
    // A wall seen straight on without perspective: from full light at the left to none at the right.
    let normals = [[0, 0, 127], [0, 0, -127], [0, 0, -127], [0, 0, 127]];
    let mesh = quad().with_normals(&normals).unwrap();
    let camera = look_at([0.0, 0.0, 3.0], [0.0; 3], [0.0, 1.0, 0.0]);
    let view = View { model_to_clip: camera.then(&orthographic(3.0, ASPECT, 1.0, 5.0)), ..from_the_front() };
    let light = Light { towards: [0.0, 0.0, 1.0], ambient: 0.0, diffuse: 1.0 };
    let look = Look { light: Some((light, Normals::Vertex)), ..Look::flat([200, 0, 0]) };
    static WHITE: [u16; 1] = [0xFFFF];
    let uvs = [[0; 2]; 4];
    let textured = mesh.with_uvs(&uvs, 0).unwrap();
    let white = Look { base: Base::Texture(Texture::new(1, 1, &WHITE).unwrap()), ..look };
    // 10 pixels a unit: x from 10 to 30.
    for x in 10..30 {
        let share = 1.0 - (f64::from(x) + 0.5 - 10.0) / 20.0;
        let uniform = drawn(&mesh, &view, &look).0.pixel(x, 12).colour;
        assert!((uniform[0] - 200.0 * share).abs() < 1e-9, "{uniform:?} at {x}");
        let texel = drawn(&textured, &view, &white).0.pixel(x, 12).colour;
        assert!((texel[1] - 255.0 * share).abs() < 1e-9, "{texel:?} at {x}");
    }
}

#[test]
fn colours_and_texels_are_each_carried_as_told() {
    // The quad turned about y: w differs from left to right, and so do the two methods.
    let uvs = [[0, 0], [32_767, 0], [32_767, 0], [0, 0]];
    let colours = [[0; 3], [255; 3], [255; 3], [0; 3]];
    let ramp: Vec<u16> = (0..32).map(|i| i << 11).collect();
    let mesh = quad().with_uvs(&uvs, 0).unwrap().with_vertex_colours(&colours).unwrap();
    let pose = Pose { rotation: rotation([0.0, 1.0, 0.0], 1.0), ..Pose::IDENTITY }.matrix();
    let view = View { model_to_clip: pose.then(&from_the_front().model_to_clip), ..from_the_front() };
    let red = |base: Base<'_>, colours: Method, texels: Method| {
        let look = Look { base, colours, texels, ..Look::flat([0; 3]) };
        drawn(&mesh, &view, &look).0.pixel(20, 15).colour[0]
    };
    let texture = Base::Texture(Texture::new(32, 1, &ramp).unwrap());
    use Method::{Affine, Perspective};
    let (curved, straight) =
        (red(Base::VertexColours, Perspective, Affine), red(Base::VertexColours, Affine, Perspective));
    assert!((curved - straight).abs() > 20.0, "{curved} against {straight}");
    assert!((red(texture, Affine, Perspective) - curved).abs() < 9.0);
    assert!((red(texture, Perspective, Affine) - straight).abs() < 9.0);
}

#[test]
fn what_is_outside_or_not_finite_draws_nothing() {
    let view = from_the_front();
    let moved = |translation| Pose { translation, ..Pose::IDENTITY }.matrix().then(&view.model_to_clip);
    let behind = View { model_to_clip: moved([0.0, 0.0, 9.0]), ..view };
    let infinite = View { model_to_clip: moved([f64::INFINITY, 0.0, 0.0]), ..view };
    let unknown = View { model_to_clip: moved([0.0, f64::NAN, 0.0]), ..view };
    for view in [behind, infinite, unknown] {
        let (image, counts) = drawn(&quad(), &view, &Look::flat([255; 3]));
        assert_eq!(counts, Drawn { faces: 2, outside: 2, ..Drawn::default() });
        assert_eq!(image, Image::new(VIEWPORT, BLACK));
    }
}

#[test]
fn a_look_that_the_mesh_cannot_serve_is_refused() {
    let light = Light { towards: [0.0, 0.0, 1.0], ambient: 0.0, diffuse: 1.0 };
    let texture = Texture::new(1, 1, &[0]).unwrap();
    let flat = Look::flat([0; 3]);
    for (look, name) in [
        (Look { base: Base::FaceColours, ..flat }, "face colours"),
        (Look { base: Base::VertexColours, ..flat }, "vertex colours"),
        (Look { base: Base::Texture(texture), ..flat }, "texture coordinates"),
        (Look { light: Some((light, Normals::Face)), ..flat }, "face normals"),
        (Look { light: Some((light, Normals::Vertex)), ..flat }, "vertex normals"),
    ] {
        let mut image = Image::new(VIEWPORT, BLACK);
        assert_eq!(draw(&mut image, &quad(), &from_the_front(), &look), Err(Missing(name)));
    }
    assert_eq!(Missing("face normals").to_string(), "the look needs face normals and the mesh has none");
}

#[test]
fn a_quantised_frame_is_what_the_display_shows() {
    let image = Image::new(Viewport { width: 1, height: 1 }, [9.0, 101.0, 250.0]);
    let shown = image.quantised().pixels()[0].colour;
    // 9 * 31 / 255 = 1.09, 101 * 63 / 255 = 24.95, 250 * 31 / 255 = 30.4.
    assert_eq!(shown, [255.0 / 31.0, 25.0 * 255.0 / 63.0, 30.0 * 255.0 / 31.0]);
    assert_eq!(image.rgb565(), [1 << 11 | 25 << 5 | 30]);
    assert_eq!(image.rgb888(), [[9, 101, 250]]);
}
