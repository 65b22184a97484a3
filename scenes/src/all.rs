//! All scenes.

use topleft::{Cull, Length, Material, Mesh, Texture, Turn};

use crate::demo::DEMO;
use crate::mesh::{
    CORRIDOR, CUBE, DIAL, FLOOR, GLOBE, GRID240, GROUND, ICOSPHERE_FINE, LADDER, STAR, TEAPOT, TORUS_KNOT,
};
use crate::scene::{Camera, Object, Scene, Spin};
use crate::shade::{Look, Method, Shade};
use crate::texture::{BRICK, CHECKER, TEST_CARD};

/// All scenes, by name.
pub const SCENES: &[Scene] = &[
    DEMO,
    Scene {
        name: "teapot",
        about: "Newell's teapot over a checkered floor",
        camera: orbit(["0", "-0.05", "0"], "3", 22, (1.0, 7.0)),
        background: NIGHT,
        objects: &[
            Object { at: place("0", "-0.525", "0"), ..still(&FLOOR, look(CHECKER, Shade::Textured)) },
            Object { spin: Spin::Upright, ..still(&TEAPOT, coloured([0xE0, 0xA8, 0x50], Shade::Gouraud)) },
        ],
    },
    Scene {
        name: "cube",
        about: "a brick cube under light, tumbling",
        camera: orbit(["0", "0", "0"], "5", 15, (2.5, 8.0)),
        background: NIGHT,
        objects: &[Object { spin: Spin::Tumbling, ..still(&CUBE, look(BRICK, Shade::Lit)) }],
    },
    Scene {
        name: "near-cube",
        about: "a cube so near that the near plane cuts it",
        camera: orbit(["0", "0", "0"], "2.1", 10, (0.5, 4.0)),
        background: NIGHT,
        objects: &[Object { spin: Spin::Upright, ..still(&CUBE, look(TEST_CARD, Shade::Textured)) }],
    },
    Scene {
        name: "sphere",
        about: "1280 small triangles",
        camera: orbit(["0", "0", "0"], "3.2", 10, (1.5, 5.0)),
        background: NIGHT,
        objects: &[Object {
            spin: Spin::Upright,
            ..still(&ICOSPHERE_FINE, coloured([0x60, 0xC0, 0xF0], Shade::Gouraud))
        }],
    },
    Scene {
        name: "knot",
        about: "a torus knot in its own colours, hiding itself",
        camera: orbit(["0", "0", "0"], "3.6", 20, (1.5, 6.0)),
        background: NIGHT,
        objects: &[Object {
            spin: Spin::Tumbling,
            look: Look {
                material: Material::OfMesh,
                texture: CHECKER,
                shade: Shade::Gouraud,
                method: Method::PerPixel,
            },
            ..still(&TORUS_KNOT, look(CHECKER, Shade::Gouraud))
        }],
    },
    Scene {
        name: "floor",
        about: "a floor that runs to the horizon and behind the viewer",
        camera: orbit(["0", "0", "0"], "2.2", 12, (0.1, 30.0)),
        background: SKY,
        objects: &[Object {
            scale: Length::lit("12"),
            spin: Spin::Upright,
            ..still(&FLOOR, look(CHECKER, Shade::Textured))
        }],
    },
    Scene {
        name: "grid240",
        about: "512 flat triangles that cover 240x240 pixels exactly once",
        camera: Camera::Front { height: 240.0 },
        background: [255, 0, 255],
        objects: &[Object { cull: Cull::None, ..still(&GRID240, of_mesh(TEST_CARD)) }],
    },
    Scene {
        name: "leaning-cube",
        about: "a cube near the eye whose edges follow no row",
        camera: orbit(["0", "0", "0"], "2.6", 10, (0.5, 5.0)),
        background: NIGHT,
        objects: &[Object {
            spin: Spin::Upright,
            lean: [Turn::from_degrees(15), Turn::from_degrees(35), ROLL],
            ..still(&CUBE, look(TEST_CARD, Shade::Textured))
        }],
    },
    Scene {
        name: "globe",
        about: "1152 small triangles with a texture",
        camera: orbit(["0", "0", "0"], "3.2", 10, (1.5, 5.0)),
        background: NIGHT,
        objects: &[Object { spin: Spin::Upright, ..still(&GLOBE, look(BRICK, Shade::Textured)) }],
    },
    Scene {
        name: "horizon",
        about: "two triangles of ground that run to a horizon, seen from a viewer who leans",
        camera: orbit(["0", "-0.20791", "-0.97815"], "1", 12, (0.1, 30.0)),
        background: SKY,
        objects: &[Object {
            // A unit below the eye, as the eye sees it.
            at: place("0.29552", "-0.95534", "0"),
            scale: Length::lit("12"),
            spin: Spin::Upright,
            lean: [Turn::ZERO, Turn::ZERO, ROLL],
            ..still(&GROUND, look(CHECKER, Shade::Textured))
        }],
    },
    Scene {
        name: "corridor",
        about: "walls that begin beside a viewer who leans",
        camera: orbit(["0", "0", "-1"], "1", 0, (0.5, 20.0)),
        background: NIGHT,
        objects: &[Object {
            at: place("0.3", "0.2", "0"),
            lean: [Turn::ZERO, Turn::from_degrees(8), ROLL],
            ..still(&CORRIDOR, look(BRICK, Shade::Textured))
        }],
    },
    Scene {
        name: "star",
        about: "360 needles, each thinner than a pixel",
        camera: orbit(["0", "0", "0"], "2.6", 25, (1.0, 5.0)),
        background: NIGHT,
        objects: &[Object {
            lean: [Turn::ZERO, Turn::ZERO, ROLL],
            // A sheet has two sides.
            cull: Cull::None,
            ..still(&STAR, of_mesh(TEST_CARD))
        }],
    },
    Scene {
        name: "ladder",
        about: "pairs of faces from 5 % to 0.1 % apart, at distances of 1 to 750: a red one that shows is an error",
        camera: orbit(["0", "0", "-1"], "1", 0, (0.1, 100.0)),
        background: NIGHT,
        objects: &[
            rungs("0.12000", -7),
            rungs("0.30896", -5),
            rungs("0.79548", -3),
            rungs("2.04810", -1),
            rungs("5.27319", 1),
            rungs("13.57677", 3),
            rungs("34.95582", 5),
            rungs("90.00000", 7),
        ],
    },
    Scene {
        name: "gauge",
        about: "a drawing without depth or perspective",
        camera: Camera::Front { height: 240.0 },
        background: NIGHT,
        objects: &[still(&DIAL, of_mesh(TEST_CARD))],
    },
];

/// The scene of that name.
pub fn by_name(name: &str) -> Option<&'static Scene> {
    SCENES.iter().find(|scene| scene.name == name)
}

const NIGHT: [u8; 3] = [16, 20, 40];
const SKY: [u8; 3] = [120, 170, 230];
/// 0.3 rad: no row and no column follows an edge.
const ROLL: Turn = Turn::new(3129);

const fn place(x: &str, y: &str, z: &str) -> [Length; 3] {
    [Length::lit(x), Length::lit(y), Length::lit(z)]
}

const fn orbit([x, y, z]: [&str; 3], distance: &str, pitch: i32, depth: (f32, f32)) -> Camera {
    Camera::Orbit {
        target: place(x, y, z),
        distance: Length::lit(distance),
        pitch: Turn::from_degrees(pitch),
        field_of_view: 45,
        depth,
    }
}

const fn look(texture: Texture<'static>, shade: Shade) -> Look {
    Look { material: Material::Colour([200; 3]), texture, shade, method: Method::PerPixel }
}

/// In the mesh's own colours, without light.
const fn of_mesh(texture: Texture<'static>) -> Look {
    Look { material: Material::OfMesh, texture, shade: Shade::Plain, method: Method::PerPixel }
}

/// The rungs, `distance` times as far away, and some steps of about 2.75 degrees to the right.
const fn rungs(distance: &str, right: i32) -> Object {
    Object {
        scale: Length::lit(distance),
        cull: Cull::None,
        lean: [Turn::ZERO, Turn::new((-501 * right).rem_euclid(65_536) as u16), Turn::ZERO],
        ..still(&LADDER, of_mesh(TEST_CARD))
    }
}

const fn coloured(colour: [u8; 3], shade: Shade) -> Look {
    Look { material: Material::Colour(colour), texture: BRICK, shade, method: Method::PerPixel }
}

const fn still(mesh: &'static Mesh<'static>, look: Look) -> Object {
    Object {
        mesh,
        at: [Length::ZERO; 3],
        scale: Length::ONE,
        spin: Spin::Still,
        lean: [Turn::ZERO; 3],
        look,
        cull: Cull::Back,
    }
}
