//! What `Hiding` does not promise: slivers on the far side that are seen less than a step or two high.

use topleft::{Depth, Depth16};
use topleft::{
    DrawList, Flat, Hiding, Length, ListTriangle, Material, Mesh, NoDepth, Perspective, Pose, Strip, Turn,
};

use embedded_graphics_core::geometry::Size;

const SIDE: i16 = 32_000;

/// A cube, whose back has a vertex in its middle, 1/200 of a side off the diagonal: a needle lies between.
const CORNERS: [[i16; 3]; 9] = [
    [-SIDE, -SIDE, SIDE],
    [SIDE, -SIDE, SIDE],
    [SIDE, SIDE, SIDE],
    [-SIDE, SIDE, SIDE],
    [-SIDE, -SIDE, -SIDE],
    [SIDE, -SIDE, -SIDE],
    [SIDE, SIDE, -SIDE],
    [-SIDE, SIDE, -SIDE],
    [100, 101, -SIDE],
];
const FACES: [[u16; 3]; 14] = [
    [0, 1, 2],
    [0, 2, 3],
    [4, 6, 5],
    [4, 8, 6],
    [4, 7, 8],
    [8, 7, 6],
    [1, 5, 6],
    [1, 6, 2],
    [4, 0, 3],
    [4, 3, 7],
    [3, 2, 6],
    [3, 6, 7],
    [4, 5, 1],
    [4, 1, 0],
];

fn drawn<D: Depth>(
    mut strip: Strip<'_, u16, D>,
    camera: &Perspective,
    mesh: &Mesh<'_>,
    pose: &Pose,
) -> Vec<u16> {
    let (mut words, mut triangles) = ([0; 60], [ListTriangle::EMPTY; 20]);
    let mut list = DrawList::<u16, D>::new(&mut words, &mut triangles);
    list.draw(camera, mesh, pose, &Flat::new(Material::OfMesh)).unwrap();
    strip.clear();
    list.render(0..64, &mut strip);
    strip.colours().to_vec()
}

/// Red when such a needle no longer shows, which would be good news for what is said of it, or shows more than a pixel.
#[test]
fn a_needle_on_the_back_shows_a_pixel_now_and_then() {
    let colours: [[u8; 3]; 14] = core::array::from_fn(|face| [0, 8 * face as u8, 255]);
    let mesh = Mesh::new(&CORNERS, &FACES).unwrap().with_face_colours(&colours).unwrap();
    assert!(mesh.is_convex());
    let camera = Perspective::new(Size::new(64, 64), Turn::from_degrees(50), 1.0..20.0);
    let (mut frames, mut pixels) = (0, 0);
    for k in 0..4000 {
        let [x, y, z] = [k * 13 % 1700, k * 7 % 1500, k * 11].map(|turn| Turn::new(turn as u16));
        let place = [k * 37 % 4001, k * 91 % 4001, -4 << 16].map(Length::from_bits);
        let pose = Pose::new().turned_y(y).turned_x(x).turned_z(z).at(place);
        assert_eq!(Hiding::cheapest(&camera, &[(&mesh, &pose)], Length::ONE), Hiding::Culling);
        let (mut culled, mut deep, mut depths) = ([0; 64 * 64], [0; 64 * 64], [0; 64 * 64]);
        let culled = drawn::<NoDepth>(Strip::new(64, &mut culled).unwrap(), &camera, &mesh, &pose);
        let strip = Strip::new(64, &mut deep).unwrap().with_depth(&mut depths).unwrap();
        let deep = drawn::<Depth16>(strip, &camera, &mesh, &pose);
        let differ = culled.iter().zip(&deep).filter(|(culled, deep)| culled != deep).count();
        assert!(differ <= 1, "{differ} pixels in frame {k}");
        frames += 1;
        pixels += differ;
    }
    println!("{pixels} pixels of {frames} frames");
    assert!(pixels > 0);
}
