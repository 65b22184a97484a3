//! The depth buffer after the whole path, against the exact plane at the same snapped vertices.

use embedded_graphics_core::geometry::Size;
use reference::depth::code;
use reference::raster::covers;
use reference::setup::{Triangle, area2};
use reference::varying::linear;
use scenes::{Method, SCENES, Shade, View};
use topleft::{
    Camera, Cull, Depth16, DepthFloat, DrawList, Flat, ListTriangle, Material, Mesh, Pose, Strip, Turn,
};

use crate::measured::{Errors, Row, hold};
use crate::probe::{SIZE, exact_camera, exact_far_away, exact_perspective, outside, range, snapped, w_of};
use crate::random::Random;
use crate::support::coded::Coded;
use crate::tolerance::half;

/// What a camera of the probe makes of a position: its place on the screen and `1 - z / w`.
type Projected = fn([i16; 3]) -> Option<([i32; 2], f64)>;

fn level(position: [i16; 3]) -> Option<([i32; 2], f64)> {
    Some((snapped(position, 1.0)?, 0.5 - f64::from(position[2]) / 65_536.0))
}

fn with_perspective(position: [i16; 3]) -> Option<([i32; 2], f64)> {
    let w = w_of(position);
    Some((snapped(position, w)?, 1.0 / 64.0 / w))
}

fn far_away(position: [i16; 3]) -> Option<([i32; 2], f64)> {
    let w = w_of(position);
    Some((snapped(position, w)?, half(16) / w))
}

/// How far the codes of single triangles lie outside of the exact plane's.
fn codes<D: Coded, C: Camera>(camera: &C, projected: Projected, seed: u64) -> Errors {
    let mut random = Random::new(seed);
    let (mut errors, mut other, mut expected) = (Errors::default(), 0_u64, 0.0);
    let (mut cells, mut depths) = (vec![0_u16; (SIZE * SIZE) as usize], vec![0_u16; (SIZE * SIZE) as usize]);
    let mut drawn = 0;
    while drawn < 300 {
        // Far ones are shown as large as near ones, so that the ratio of w is up to 64 on any triangle.
        let flat = drawn % 3 == 0;
        let first = random.next() as i16;
        let positions = [(); 3].map(|()| {
            let z = if flat { first } else { ((i64::from(random.next() as i16)) >> (drawn % 2 * 4)) as i16 };
            let w = if C::PERSPECTIVE { w_of([0, 0, z]) } else { 1.0 };
            let place = [(); 2].map(|()| (f64::from(random.next() as i16) * w) as i16);
            [place[0], place[1], z]
        });
        let [Some(a), Some(b), Some(c)] = positions.map(projected) else { continue };
        let mut corners = [a, b, c];
        corners.sort_by_key(|&([x, y], _)| (y, x));
        let (triangle, values): (Triangle, _) = (corners.map(|c| c.0), corners.map(|c| c.1));
        if area2(triangle) == 0 {
            continue;
        }
        drawn += 1;
        let mesh = Mesh::new(&positions, &[[0, 1, 2]]).unwrap();
        let mut storage = ([0; 16], [ListTriangle::EMPTY; 1]);
        let mut list = DrawList::<u16, D>::new(&mut storage.0, &mut storage.1);
        list.set_cull(Cull::None);
        list.draw(camera, &mesh, &Pose::new(), &Flat::new(Material::OfMesh)).unwrap();
        let mut strip = D::strip(SIZE as u16, &mut cells, &mut depths);
        strip.clear();
        list.render(0..SIZE as i32, &mut strip);
        drop(strip);
        for (index, &ours) in depths.iter().enumerate() {
            let (x, y) = ((index % SIZE as usize) as i64, (index / SIZE as usize) as i64);
            if !covers(triangle, x, y) {
                assert_eq!(ours, 0, "{positions:?} at {x}, {y}");
                continue;
            }
            let nearness = linear(triangle, values, x, y);
            let exact = D::code(nearness);
            let steps =
                x.abs_diff(i64::from(triangle[0][0] >> 8)) + y.abs_diff(i64::from(triangle[0][1] >> 8));
            let bound = D::bound(nearness, steps, range(values));
            errors.add(outside(ours.into(), exact), bound, || {
                format!("{positions:?} at {x}, {y}: {ours} for {exact}")
            });
            other += u64::from(ours != code(exact));
            expected += bound.min(1.0);
        }
    }
    // A plane that is off by b codes shows another code at no more than every 1/b-th pixel.
    let compared = errors.count();
    assert!(compared > 1_000_000 && (other as f64) < expected, "{other} of {compared}, {expected}");
    errors
}

/// The codes in a buffer, without perspective, with it, and far away.
pub(crate) fn in_buffer() -> Vec<Row> {
    [
        ("orthographic", codes::<Depth16, _>(&exact_camera(), level, 5)),
        ("perspective", codes::<Depth16, _>(&exact_perspective(), with_perspective, 6)),
        ("orthographic small float", codes::<DepthFloat, _>(&exact_camera(), level, 5)),
        ("perspective small float", codes::<DepthFloat, _>(&exact_perspective(), with_perspective, 6)),
        ("small float far away", codes::<DepthFloat, _>(&exact_far_away(), far_away, 7)),
    ]
    .map(|(method, errors)| {
        Row::new("depth", "triangles over 256 px", method, ["beyond its code", "code"], &errors)
    })
    .into()
}

/// Turned red by: another code for the far plane, z / w for 1 - z / w, a nearness of 16 bits, an octave of a small float that
/// begins elsewhere.
#[test]
fn codes_are_those_of_the_exact_plane() {
    hold(&in_buffer());
}

/// Depth is a function of geometry and camera alone.
///
/// Turned red by: a vertex whose depth and 1/w are taken for each other.
#[test]
fn all_ways_of_shading_leave_the_same_depths() {
    const WIDTH: u16 = 120;
    for scene in SCENES {
        for turn in [0, 77] {
            let mut before: Option<Vec<u16>> = None;
            for (shade, method) in
                Shade::ALL.into_iter().flat_map(|shade| Method::ALL.map(|method| (shade, method)))
            {
                let mut words = vec![0; 1 << 16];
                let mut triangles = vec![ListTriangle::EMPTY; 4000];
                let mut list = DrawList::<u16, Depth16>::new(&mut words, &mut triangles);
                let view = View { turn: Turn::from_degrees(turn), shade: Some(shade), ..View::default() };
                let view = View { method: Some(method), ..view };
                scene.draw(&mut list, Size::new(WIDTH.into(), 100), &view).unwrap();
                let (mut cells, mut depths) = (vec![0; WIDTH as usize * 100], vec![0; WIDTH as usize * 100]);
                let mut strip = Strip::new(WIDTH, &mut cells).unwrap().with_depth(&mut depths).unwrap();
                strip.clear();
                list.render(0..100, &mut strip);
                assert!(depths.iter().any(|&depth| depth != 0), "{} shows nothing", scene.name);
                let before = before.get_or_insert_with(|| depths.clone());
                assert!(*before == depths, "{} at {turn} degrees, {}", scene.name, shade.name());
            }
        }
    }
}
