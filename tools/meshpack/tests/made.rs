//! The repository's meshes and textures: closed, right way out, right way round, and as they are committed.

use meshpack::{Packed, generated, made_meshes, made_textures};
use std::collections::{HashMap, HashSet};
use std::path::Path;

type Position = [i16; 3];

fn made(module: &str) -> Packed {
    made_meshes().into_iter().find(|made| made.module == module).unwrap().packed
}

fn corners(packed: &Packed) -> Vec<[Position; 3]> {
    let mesh = packed.mesh();
    mesh.faces().iter().map(|face| face.map(|index| mesh.positions()[usize::from(index)])).collect()
}

/// How often each directed edge runs, by positions.
fn edges(packed: &Packed) -> HashMap<[Position; 2], u32> {
    let mut edges = HashMap::new();
    for [a, b, c] in corners(packed) {
        for edge in [[a, b], [b, c], [c, a]] {
            *edges.entry(edge).or_insert(0) += 1;
        }
    }
    edges
}

/// Six times the volume inside, in steps of a position; below 0 when inside out.
fn volume(packed: &Packed) -> i64 {
    let determinant = |[a, b, c]: [Position; 3]| {
        let [a, b, c] = [a, b, c].map(|p| p.map(i64::from));
        a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
            + a[2] * (b[0] * c[1] - b[1] * c[0])
    };
    corners(packed).into_iter().map(determinant).sum()
}

#[test]
fn the_committed_files_are_what_is_made() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/src");
    for (path, text) in generated() {
        let committed = std::fs::read_to_string(folder.join(&path)).unwrap();
        assert!(committed == text, "{} differs: run `meshpack make`", path.display());
    }
}

#[test]
fn every_edge_of_a_closed_mesh_has_its_opposite_exactly_once() {
    for module in ["cube", "icosphere", "icosphere_fine", "teapot", "torus_knot"] {
        let edges = edges(&made(module));
        for ([a, b], count) in &edges {
            assert_eq!(
                (*count, edges.get(&[*b, *a])),
                (1, Some(&1)),
                "{module}: the edge from {a:?} to {b:?}"
            );
        }
    }
}

#[test]
fn closed_meshes_have_their_volume_inside() {
    // The volume of the cube of positions is 2^48, and the sum counts six times.
    let whole = 6.0 * 2_f64.powi(48);
    let share = |module| volume(&made(module)) as f64 / whole;
    assert!((share("cube") - 1.0).abs() < 1e-3);
    let sphere = std::f64::consts::PI / 6.0;
    assert!((0.92 * sphere..sphere).contains(&share("icosphere")));
    assert!((0.98 * sphere..sphere).contains(&share("icosphere_fine")));
    assert!((0.05..0.30).contains(&share("teapot")), "{}", share("teapot"));
    assert!((0.02..0.20).contains(&share("torus_knot")), "{}", share("torus_knot"));
}

#[test]
fn normals_point_out_of_the_faces() {
    for made in made_meshes() {
        let mesh = made.packed.mesh();
        assert_eq!(mesh.normals().len(), mesh.positions().len(), "{}", made.name);
        assert_eq!(mesh.face_normals().len(), mesh.faces().len(), "{}", made.name);
        for (face, flat) in mesh.faces().iter().zip(mesh.face_normals()) {
            let [a, b, c] = face.map(|index| mesh.positions()[usize::from(index)].map(i64::from));
            let [ab, ac] = [b, c].map(|p| [p[0] - a[0], p[1] - a[1], p[2] - a[2]]);
            let cross =
                [ab[1] * ac[2] - ab[2] * ac[1], ab[2] * ac[0] - ab[0] * ac[2], ab[0] * ac[1] - ab[1] * ac[0]];
            assert_ne!(cross, [0; 3], "{}: a face without area", made.name);
            let along =
                |normal: [i8; 3]| (0..3).map(|axis| cross[axis] * i64::from(normal[axis])).sum::<i64>();
            assert!(along(*flat) > 0, "{}", made.name);
            let smooth = face.map(|index| along(mesh.normals()[usize::from(index)]));
            assert!(smooth.iter().sum::<i64>() > 0, "{}: {face:?}", made.name);
        }
    }
}

#[test]
fn textures_are_not_mirrored() {
    for made in made_meshes() {
        let mesh = made.packed.mesh();
        if mesh.uvs().is_empty() {
            continue;
        }
        for face in mesh.faces() {
            // v grows down, so that counter-clockwise corners have a negative area.
            let [a, b, c] = face.map(|index| mesh.uvs()[usize::from(index)].map(i64::from));
            let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
            assert!(area < 0, "{}: {face:?}", made.name);
        }
    }
}

#[test]
fn no_vertex_is_unused_and_no_two_are_equal() {
    for made in made_meshes() {
        let mesh = made.packed.mesh();
        let used: HashSet<_> = mesh.faces().iter().flatten().copied().collect();
        assert_eq!(used.len(), mesh.positions().len(), "{}", made.name);
        let all: HashSet<_> = (0..mesh.positions().len())
            .map(|i| {
                (mesh.positions()[i], mesh.normals().get(i), mesh.uvs().get(i), mesh.vertex_colours().get(i))
            })
            .collect();
        assert_eq!(all.len(), mesh.positions().len(), "{}", made.name);
    }
}

#[test]
fn the_teapot_stands_upright_with_its_spout_to_the_right() {
    let packed = made("teapot");
    let mesh = packed.mesh();
    assert!((1000..=1500).contains(&mesh.faces().len()));
    let unit = mesh.half().to_num::<f64>() / 32_768.0;
    let centre = mesh.centre().map(|length| length.to_num::<f64>());
    let place = |p: &Position| [0, 1, 2].map(|axis| centre[axis] + f64::from(p[axis]) * unit);
    let places: Vec<[f64; 3]> = mesh.positions().iter().map(place).collect();
    let range = |axis: usize| {
        let values = places.iter().map(|p| p[axis]);
        (values.clone().fold(f64::MAX, f64::min), values.fold(f64::MIN, f64::max))
    };
    // Newell's handle ends at -3, his spout near 3.43, the lid at 3.15 and the pot is 4 wide: here it is a third.
    let near = |value: f64, expected: f64| (value - expected).abs() < 0.02;
    assert!(near(range(0).0, -1.0) && near(range(0).1, 3.43 / 3.0), "{:?}", range(0));
    assert!(near(range(1).0, -0.525) && near(range(1).1, 0.525), "{:?}", range(1));
    assert!(near(range(2).0, -2.0 / 3.0) && near(range(2).1, 2.0 / 3.0), "{:?}", range(2));
    // What reaches farthest to +x is high up: the spout's lip. The highest point is the knob, on the axis.
    let lip = places.iter().max_by(|a, b| a[0].total_cmp(&b[0])).unwrap();
    assert!(lip[1] > 0.25);
    let knob = places.iter().max_by(|a, b| a[1].total_cmp(&b[1])).unwrap();
    assert!(knob[0].abs() < 1e-3 && knob[2].abs() < 1e-3);
}

#[test]
fn the_grid_covers_the_screen_with_fronts_and_tells_its_faces_apart() {
    let packed = made("grid240");
    let mesh = packed.mesh();
    assert_eq!((mesh.positions().len(), mesh.faces().len()), (289, 512));
    assert_eq!(mesh.half().to_num::<f64>() / 32_768.0, 1.0 / 16.0);
    assert_eq!(mesh.bounds(), [[-1920, -1920, 0], [1920, 1920, 0]]);
    // All doubled areas are above 0, and together they are the screen's.
    let areas: Vec<i32> = corners(&packed)
        .into_iter()
        .map(|triangle| {
            let [a, b, c] = triangle.map(|p| p.map(i32::from));
            (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        })
        .collect();
    assert!(areas.iter().all(|&area| area > 0));
    assert_eq!(areas.iter().sum::<i32>(), 2 * 3840 * 3840);
    // The texture's top left corner is the screen's.
    let corner = mesh.positions().iter().position(|p| *p == [-1920, 1920, 0]).unwrap();
    assert_eq!(mesh.uvs()[corner], [0, 0]);
    let rgb565 = |[r, g, b]: [u8; 3]| (r >> 3, g >> 2, b >> 3);
    let colours: HashSet<_> = mesh.face_colours().iter().map(|&colour| rgb565(colour)).collect();
    assert_eq!(colours.len(), 512);
}

#[test]
fn the_tilted_grid_is_where_the_grid_is_on_the_screen() {
    let (flat, tilted) = (made("grid240"), made("grid240_tilted"));
    assert_eq!(flat.mesh().faces(), tilted.mesh().faces());
    let mut farthest = 0.0_f64;
    for (flat, tilted) in flat.mesh().positions().iter().zip(tilted.mesh().positions()) {
        let [x, y] = [flat[0], flat[1]].map(|c| f64::from(c) / 16.0);
        let [over_x, over_y, away] = tilted.map(|c| f64::from(c) / 64.0);
        let w = -away / 120.0;
        assert!((1.0 / w - (0.625 - 0.375 * y / 120.0)).abs() < 1e-4);
        farthest = farthest.max((over_x / w - x).abs()).max((over_y / w - y).abs());
    }
    // Half a step of 1/64 px in a coordinate, and as much in w times 120 at the screen's edge.
    assert!(farthest < 1.0 / 64.0, "{farthest}");
}

#[test]
fn made_textures_have_the_promised_size() {
    for made in made_textures() {
        let texture = made.packed.texture();
        assert_eq!((texture.width(), texture.height()), (64, 64), "{}", made.name);
        let colours: HashSet<_> = texture.texels().iter().collect();
        assert!(colours.len() >= 2, "{}", made.name);
    }
}

#[test]
fn quantising_keeps_within_half_a_step() {
    for made in made_meshes() {
        let error = made.packed.error();
        let step = made.packed.mesh().half().to_num::<f64>() / 32_768.0;
        // Half a step on each of three axes; half a step of 1/127 on each axis of a normal, and the most that
        // normalising the rounded vector leaves of it.
        assert!(error.position_max <= step * 0.75_f64.sqrt() + 1e-12, "{}", made.name);
        assert!(error.position_rms <= error.position_max);
        assert!(error.normal_degrees < 0.4, "{}: {}", made.name, error.normal_degrees);
        let uv_step = f64::from(1 << made.packed.mesh().uv_exponent()) / 32_768.0;
        assert!(error.uv_texels <= uv_step / 2.0 * 256.0 + 1e-9, "{}", made.name);
    }
}
