//! Light and colours, vertex by vertex and face by face.

use embedded_graphics_core::pixelcolor::{Bgr565, Rgb555, Rgb565, Rgb666, Rgb888};
use reference::matrix::{Vec3, cross, dot, normalise, sub};
use reference::shade::{Light, from_rgb565, lit, to_rgb565, to_rgb888};
use reference::transform::{length, normal};
use topleft::stages::Shader;
use topleft::{Flat, Gouraud, Length, Material, Mesh, PerPixel, Pixel, Pose, Sun, Texture, Textured, Turn};

use crate::measured::{Errors, Row, hold};
use crate::random::Random;
use crate::tolerance::{LIGHT_STEPS, LIT, PLANE_NORMAL};

/// A sun, a pose and a colour, and the reference's light in the mesh's own space.
struct Case {
    sun: Sun,
    pose: Pose,
    colour: [u8; 3],
    light: Light,
}

impl Case {
    fn new(random: &mut Random) -> Self {
        let direction = [(); 3].map(|()| Length::from_bits(random.next() as i32));
        let [ambient, diffuse] = [(); 2].map(|()| random.next() as u8);
        let [x, y, z] = [(); 3].map(|()| Turn::new(random.next() as u16));
        // A scale and a place change nothing.
        let turned = Pose::new().turned_x(x).turned_y(y).turned_z(z);
        let pose = turned.scaled(Length::from_num(3)).at([Length::ONE; 3]);
        let towards: Vec3 = [0, 1, 2].map(|axis| {
            let mut unit = [Length::ZERO; 3];
            unit[axis] = Length::from_num(32_767);
            let seen = turned.apply(unit).map(|c| length(c) / 32_767.0);
            dot(seen, normalise(direction.map(length)))
        });
        Self {
            sun: Sun::new(direction).with_ambient(ambient).with_diffuse(diffuse),
            pose,
            colour: [(); 3].map(|()| random.next() as u8),
            light: Light {
                towards,
                ambient: f64::from(ambient) / 255.0,
                diffuse: f64::from(diffuse) / 255.0,
            },
        }
    }

    fn error(&self, ours: [u8; 3], normal: Vec3) -> f64 {
        let exact = lit(self.colour.map(f64::from), self.light.at(normal));
        (0..3).map(|k| (f64::from(ours[k]) - exact[k]).abs()).fold(0.0, f64::max)
    }
}

/// Normals of length 1 as a mesh stores them, and a few that are not.
fn normals(random: &mut Random) -> Vec<[i8; 3]> {
    let unit = |random: &mut Random| {
        let raw = [(); 3].map(|()| random.unit() - 0.5);
        normalise(raw).map(|c| (c * 127.0).round() as i8)
    };
    let mut normals: Vec<_> = (0..64).map(|_| unit(random)).collect();
    normals.extend([[127, 0, 0], [0, -127, 0], [0, 0, 127], [127, 127, 127], [-128; 3], [0; 3]]);
    normals
}

/// The colours of Gouraud's vertices, and the light of textured ones.
pub(crate) fn on_vertices() -> Vec<Row> {
    let mut random = Random::new(21);
    let [mut colours, mut lights] = [(); 2].map(|()| Errors::default());
    for _ in 0..3000 {
        let case = Case::new(&mut random);
        let normals = normals(&mut random);
        let positions = vec![[0; 3]; normals.len()];
        let mesh = Mesh::new(&positions, &[]).unwrap().with_normals(&normals).unwrap();
        let gouraud = Gouraud::new(&case.sun, &Material::Colour(case.colour));
        let local = Shader::<u16>::local(&gouraud, &mesh, &case.pose);
        let textured = Textured::new(&Texture::WHITE, PerPixel).lit_by(&case.sun);
        let textured_local = Shader::<u16>::local(&textured, &mesh, &case.pose);
        for (vertex, &raw) in normals.iter().enumerate() {
            let error = case.error(Shader::<u16>::vertex(&gouraud, &local, &mesh, vertex), normal(raw));
            colours.add(error, LIT, || format!("{raw:?} under {:?}", case.light));
            let (_, steps) = Shader::<u16>::vertex(&textured, &textured_local, &mesh, vertex);
            // A half is in it, for rounding.
            let steps = f64::from(steps.to_bits()) / 65_536.0 - 0.5;
            let error = steps - 64.0 * case.light.at(normal(raw));
            lights.add(error, LIGHT_STEPS, || format!("{raw:?} under {:?}", case.light));
        }
    }
    [
        // Rounding alone is half a code.
        Row::new("light", "random suns", "vertex", ["lit colour", "code of 255"], &colours)
            .reaching(0.5 / LIT),
        Row::new("light", "random suns", "vertex", ["light", "1/64"], &lights).reaching(0.125),
    ]
    .into()
}

/// Turned red by: a sun that turns with the mesh, light that is not limited, colours that are truncated, a cosine of 8
/// bits.
#[test]
fn vertices_are_lit_as_the_reference_says() {
    hold(&on_vertices());
}

/// The colours of faces, by their own normal and by that of their plane.
pub(crate) fn on_faces() -> Vec<Row> {
    let mut random = Random::new(22);
    let [mut own, mut of_plane] = [(); 2].map(|()| Errors::default());
    for round in 0..20_000 {
        let case = Case::new(&mut random);
        let size = random.within(0, 14);
        let positions = [(); 3].map(|()| [(); 3].map(|()| (random.next() as i16) >> size));
        let mesh = Mesh::new(&positions, &[[0, 1, 2]]).unwrap();
        let flat = Flat::new(Material::Colour(case.colour)).lit_by(&case.sun);
        let local = Shader::<u16>::local(&flat, &mesh, &case.pose);
        let raw = normals(&mut random)[round % 70];
        let with_normal = mesh.with_face_normals(core::slice::from_ref(&raw)).unwrap();
        let error = case.error(Shader::<u16>::face(&flat, &local, &with_normal, 0), normal(raw));
        own.add(error, LIT, || format!("{raw:?}"));
        let [a, b, c] = positions.map(|p| p.map(f64::from));
        let across = cross(sub(b, a), sub(c, a));
        if dot(across, across) > 0.0 {
            let error = case.error(Shader::<u16>::face(&flat, &local, &mesh, 0), normalise(across));
            of_plane.add(error, LIT + PLANE_NORMAL, || format!("{positions:?}"));
        }
    }
    let row = |method, errors: &Errors| {
        Row::new("light", "random suns", method, ["lit colour", "code of 255"], errors)
    };
    [
        row("face", &own).reaching(0.49 / LIT),
        row("plane of the face", &of_plane).reaching(0.25 * PLANE_NORMAL / (LIT + PLANE_NORMAL)),
    ]
    .into()
}

/// Turned red by: a vertex's normal for the face's, a plane normal that points inwards.
#[test]
fn faces_are_lit_by_their_normal_or_that_of_their_plane() {
    hold(&on_faces());
}

/// Turned red by: 8 bits that are truncated to 5.
#[test]
fn colours_are_rounded_to_the_nearest() {
    for code in 0..=255_u8 {
        for rgb in [[code; 3], [code, 0, 255], [255, code, 7]] {
            let exact = rgb.map(f64::from);
            assert_eq!(u16::from_rgb(rgb), to_rgb565(exact));
            assert_eq!(Rgb888::from_rgb(rgb).channels(), to_rgb888(exact));
            let nearest = |most: f64| exact.map(|c| (c * most / 255.0).round() as u8);
            assert_eq!(Rgb555::from_rgb(rgb).channels(), nearest(31.0));
            assert_eq!(Rgb666::from_rgb(rgb).channels(), nearest(63.0));
            let [r, g, b] = Bgr565::from_rgb(rgb).channels();
            assert_eq!([r, g, b], Rgb565::from_rgb(rgb).channels());
        }
    }
    // A texel at any of the 65 lights, and the nearest texel to what the reference makes of it.
    for texel in (0..=u16::MAX).step_by(7) {
        assert_eq!(to_rgb888(from_rgb565(texel)), Rgb888::from_texel(texel).channels(), "{texel:#x}");
        for light in 0..=64 {
            let exact = lit(from_rgb565(texel), f64::from(light) / 64.0);
            let step = [31.0, 63.0, 31.0].map(|most| 255.0 / most);
            let ours = from_rgb565(u16::lit_texel(texel, light));
            for k in 0..3 {
                let error = (ours[k] - exact[k]).abs();
                assert!(error <= step[k] / 2.0 + 1e-9, "{texel:#x} at {light}: {ours:?} for {exact:?}");
            }
        }
    }
}
