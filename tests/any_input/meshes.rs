//! Lists of any meshes, poses, cameras and matrices, on strips of any rows.

use core::ops::Range;

use embedded_graphics_core::geometry::Size;
use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};
use proptest::prelude::*;
use topleft::stages::{Shader, Traversal};
use topleft::{
    Affine, Attribute, BoxWalk, Camera, Cull, Depth16, DepthFloat, DrawError, DrawList, Flat, Gouraud,
    Length, ListTriangle, Material, Matrix, MatrixCamera, Mesh, NoDepth, Orthographic, PerPixel, Perspective,
    Pose, Spans, Stats, Subspans, Sun, Textured, Turn, Within, Wrap,
};

use crate::support::check;
use crate::support::frame::Strips;
use crate::support::guarded::guarded;
use crate::support::stats::adds_up;
use crate::texture;

/// Storage of a list.
type Store = (Vec<u32>, Vec<ListTriangle>);

/// A mesh of any numbers, and what is done with it.
#[derive(Clone, Debug)]
struct Case {
    positions: Vec<[i16; 3]>,
    faces: Vec<[u16; 3]>,
    centre: [i32; 3],
    half: i32,
    scale: i32,
    at: [i32; 3],
    turns: [u16; 3],
    uv_exponent: u8,
    size: [u32; 2],
    rows: Range<i32>,
    storage: [usize; 2],
    seed: u64,
}

fn length() -> impl Strategy<Value = i32> + Clone {
    prop_oneof![any::<i32>(), -400_000..400_000_i32, Just(0), Just(65_536), Just(i32::MIN), Just(i32::MAX)]
}

fn case() -> impl Strategy<Value = Case> {
    let position = prop::array::uniform3(prop_oneof![any::<i16>(), Just(i16::MIN), Just(i16::MAX), Just(0)]);
    let mesh = (prop::collection::vec(position, 1..14), prop::collection::vec(any::<[u16; 3]>(), 0..14));
    let place = (prop::array::uniform3(length()), length(), length(), prop::array::uniform3(length()));
    let sizes = prop::sample::select(vec![[0, 0], [1, 1], [1, 90], [70, 1], [33, 21], [64, 64], [8190, 4]]);
    let rows = prop_oneof![
        Just(0..100),
        Just(-5..7),
        Just(i32::MIN..i32::MAX),
        any::<(i32, i32)>().prop_map(|(a, b)| a..b)
    ];
    let storage = prop_oneof![Just([4000, 400]), [0..200_usize, 0..30_usize]];
    let rest = (any::<[u16; 3]>(), 0..=5_u8, sizes, rows, storage, any::<u64>());
    (mesh, place, rest).prop_map(|((positions, faces), place, rest)| {
        let count = positions.len() as u16;
        let faces = faces.into_iter().map(|face| face.map(|index| index % count)).collect();
        let (centre, half, scale, at) = place;
        let (turns, uv_exponent, size, rows, storage, seed) = rest;
        Case { positions, faces, centre, half, scale, at, turns, uv_exponent, size, rows, storage, seed }
    })
}

/// A few bytes from a seed.
fn bytes<const N: usize>(seed: &mut u64) -> [u8; N] {
    [(); N].map(|()| {
        *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*seed >> 56) as u8
    })
}

impl Case {
    fn size(&self) -> Size {
        Size::new(self.size[0], self.size[1])
    }

    fn pose(&self) -> Pose {
        let [x, y, z] = self.turns.map(Turn::new);
        let pose = Pose::new().turned_x(x).turned_y(y).turned_z(z);
        pose.scaled(Length::from_bits(self.scale)).at(self.at.map(Length::from_bits))
    }

    /// Draws with all shaders, depths and traversals; all traversals agree.
    fn draw<C: Camera>(&self, camera: &C) -> Result<(), String> {
        let mut seed = self.seed;
        let count = self.positions.len();
        let signed = |bytes: [u8; 3]| bytes.map(|b| b as i8);
        let normals: Vec<_> = (0..count).map(|_| signed(bytes(&mut seed))).collect();
        let colours: Vec<[u8; 3]> = (0..count).map(|_| bytes(&mut seed)).collect();
        let uvs: Vec<_> = (0..count)
            .map(|_| {
                let [a, b, c, d] = bytes(&mut seed);
                [i16::from_le_bytes([a, b]), i16::from_le_bytes([c, d])]
            })
            .collect();
        let mesh = Mesh::new(&self.positions, &self.faces).unwrap();
        let mesh = mesh.with_box(self.centre.map(Length::from_bits), Length::from_bits(self.half));
        let mesh = mesh.with_vertex_colours(&colours).unwrap().with_uvs(&uvs, self.uv_exponent).unwrap();
        let mesh = if seed.is_multiple_of(2) { mesh.with_normals(&normals).unwrap() } else { mesh };
        let sun = Sun::new(self.at.map(Length::from_bits));
        let [words, triangles] = self.storage;
        let mut stores = vec![(vec![0; words], vec![ListTriangle::EMPTY; triangles]); 24];
        let texture = texture();
        let stores = &mut stores.iter_mut();
        self.with(stores, camera, &mesh, &Flat::new(Material::OfMesh).lit_by(&sun))?;
        self.with(stores, camera, &mesh, &Gouraud::new(&sun, &Material::OfMesh))?;
        self.with(stores, camera, &mesh, &Textured::new(&texture, Affine))?;
        self.with(stores, camera, &mesh, &Textured::new(&texture, PerPixel))?;
        self.with(stores, camera, &mesh, &Textured::new(&texture, Subspans::Of8))?;
        self.with(stores, camera, &mesh, &Textured::new(&texture, Within::default()))?;
        self.with(
            stores,
            camera,
            &mesh,
            &Textured::new(&texture, Within::texels(Attribute::from_bits(300_000))),
        )?;
        self.with(
            stores,
            camera,
            &mesh,
            &Textured::new(&texture.with_wrap(Wrap::Clamp), PerPixel).lit_by(&sun),
        )
    }

    fn with<'a, C: Camera, S: Shader<'a, u16>>(
        &self,
        stores: &mut impl Iterator<Item = &'a mut Store>,
        camera: &C,
        mesh: &Mesh<'_>,
        shader: &S,
    ) -> Result<(), String> {
        let mut store = || stores.next().expect("three for each shader");
        let (spans, boxes) = if self.turns[1].is_multiple_of(2) {
            (
                self.deep::<Depth16, C, S, Spans>(store(), camera, mesh, shader)?,
                self.deep::<Depth16, C, S, BoxWalk>(store(), camera, mesh, shader)?,
            )
        } else {
            (
                self.deep::<DepthFloat, C, S, Spans>(store(), camera, mesh, shader)?,
                self.deep::<DepthFloat, C, S, BoxWalk>(store(), camera, mesh, shader)?,
            )
        };
        if boxes != spans {
            return Err("the traversals differ".into());
        }
        let (words, triangles) = store();
        let mut list = DrawList::<u16, NoDepth>::new(words, triangles);
        let _ = list.draw(camera, mesh, &self.pose(), shader);
        guarded(&list, self.rows.clone()).map(drop)
    }

    /// With depth; what is drawn of it.
    fn deep<'a, D: Strips, C: Camera, S: Shader<'a, u16>, T: Traversal>(
        &self,
        (words, triangles): &'a mut Store,
        camera: &C,
        mesh: &Mesh<'_>,
        shader: &S,
    ) -> Result<Vec<u16>, String> {
        let mut list = DrawList::<u16, D, T>::with_traversal(words, triangles);
        list.set_cull([Cull::None, Cull::Front, Cull::Back][self.turns[0] as usize % 3]);
        let result = list.draw(camera, mesh, &self.pose(), shader);
        adds_up(Stats::default(), list.stats(), result, mesh.faces().len())?;
        guarded(&list, self.rows.clone())
    }
}

/// Turned red by: a camera that divides 0 by 0, or shifts a zero matrix by -1.
#[test]
fn a_list_takes_any_mesh_in_any_place() {
    let cameras = (prop::array::uniform8(any::<u32>()), any::<u16>(), any::<bool>());
    check(4000, &(case(), cameras), |(case, (floats, field, tame))| {
        let [near, far, height, ex, ey, ez, tx, ty] = floats.map(f32::from_bits);
        // Half of the cameras can exist.
        let (near, far) = if tame { (0.1, 50.0) } else { (near, far) };
        let (eye, target) = if tame { ([1.0, 2.0, 6.0], [0.0; 3]) } else { ([ex, ey, ez], [tx, ty, near]) };
        let field = if tame { 5000 + field % 20_000 } else { field };
        let perspective = Perspective::new(case.size(), Turn::new(field), near..far);
        case.draw(&perspective)?;
        case.draw(&perspective.look_at(eye, target))?;
        let height = if tame { 7.0 } else { height };
        case.draw(&Orthographic::new(case.size(), height, near..far).look_at(eye, target))
    });
}

/// Turned red by: a place on the screen that is added to the centre in 32 bits without wrapping.
#[test]
fn a_list_takes_any_matrix() {
    let element = prop_oneof![length(), length(), Just(0)];
    let matrix = prop::array::uniform4(prop::array::uniform4(element));
    check(4000, &(case(), matrix), |(case, rows)| {
        let matrix = Matrix::new(rows.map(|row| row.map(Length::from_bits)));
        case.draw(&MatrixCamera::<true>::new(case.size(), matrix))?;
        let [r0, r1, r2, [.., w]] = rows;
        let level = Matrix::new([r0, r1, r2, [0, 0, 0, w]].map(|row| row.map(Length::from_bits)));
        case.draw(&MatrixCamera::<false>::new(case.size(), level))?;
        // Against what its documentation asks for: nonsense, but no harm.
        case.draw(&MatrixCamera::<false>::new(case.size(), matrix))
    });
}

/// w is 1 for the place on the screen and large for what is inside, against what the camera asks for: x / w is as large as
/// an `i32`, on top of which comes the centre.
///
/// Turned red by: a sum that does not wrap.
#[test]
fn a_level_camera_may_be_told_lies() {
    let positions = [[-32_768, 32_767, 0], [32_767, 32_767, 0], [-32_768, 30_000, 0]];
    for size in [[2_u32, 2], [8, 8], [64, 64], [1024, 1024]] {
        // 2^23 steps of clip space times a reach of 1, 4, 32, 512, and a few less.
        let large = 1 << (25 - size[0].ilog2());
        for less in 0..64 {
            let x = Length::from_bits(less - large);
            let (o, w) = (Length::ZERO, Length::from_num(32_767));
            let matrix = Matrix::new([[x, o, o, o], [o; 4], [o; 4], [o, w, o, Length::from_bits(1)]]);
            let mesh = Mesh::new(&positions, &[[0, 1, 2], [2, 1, 0]]).unwrap();
            let mut storage = ([0; 64], [ListTriangle::EMPTY; 8]);
            let mut list = DrawList::<u16, Depth16>::new(&mut storage.0, &mut storage.1);
            let camera = MatrixCamera::<false>::new(Size::new(size[0], size[1]), matrix);
            list.draw(&camera, &mesh, &Pose::new(), &Flat::new(Rgb565::RED)).unwrap();
        }
    }
}

/// Turned red by: a target that is drawn to although its edge values do not fit.
#[test]
fn a_target_that_is_too_large_is_refused() {
    let mesh = Mesh::new(&[[0; 3]; 3], &[[0, 1, 2]]).unwrap();
    for size in [Size::new(4000, 4000), Size::new(u32::MAX, 1), Size::new(1, u32::MAX), Size::new(8191, 1)] {
        let mut list = DrawList::<u16, NoDepth>::new(&mut [], &mut []);
        let camera = Perspective::new(size, Turn::from_degrees(50), 0.1..20.0);
        let result = list.draw(&camera, &mesh, &Pose::new(), &Flat::new(Rgb565::RED));
        assert_eq!(result, Err(DrawError::TooLarge(size)));
        assert_eq!(list.stats(), Stats::default());
    }
}
