//! The bytes of a mesh before a camera whose vertices are known to the bit, and of those vertices.

use std::cell::Cell;

use embedded_graphics::prelude::*;
use proptest::prelude::*;
use scenes::texture::TEST_CARD;
use topleft::stages::Shader;
use topleft::{
    Affine, Attribute, BoxWalk, Camera, ColourError, Coord, Cull, Depth16, DepthCode, DepthFloat, DrawList,
    Flat, Gouraud, Length, ListTriangle, Material, Matrix, MatrixCamera, Mesh, NoDepth, Painter, PerPixel,
    Point as Corner, Pose, ProjectedVertex, Spans, Subspans, Sun, Textured, Within,
};

use crate::support::check;
use crate::support::frame::{Strips, rendered};
use crate::support::strategies::{MeshData, mesh_data};

const SIZE: Size = Size::new(64, 64);
const BACKGROUND: u16 = 0x1234;

/// By powers of two alone, so that no stage rounds.
fn matrix(rows: [[&str; 4]; 4]) -> Matrix {
    Matrix::new(rows.map(|row| row.map(|element| element.parse::<Length>().expect("a number"))))
}

/// Where a position is: x and y in 1/256 px from the centre, w as a power of two, and how near it is.
type Placed = ([i32; 2], i32, u32);

/// A camera, and what is known of it.
trait Known {
    type Camera: Camera;
    fn camera() -> Self::Camera;
    /// A position that the camera places exactly.
    fn position(any: [i16; 3]) -> [i16; 3];
    fn place(position: [i16; 3]) -> Placed;
}

/// A step of a position is one of 1/256 px.
struct Level;

impl Known for Level {
    type Camera = MatrixCamera<false>;

    fn camera() -> Self::Camera {
        let level =
            [["4", "0", "0", "0"], ["0", "4", "0", "0"], ["0", "0", "-0.5", "0.5"], ["0", "0", "0", "1"]];
        MatrixCamera::new(SIZE, matrix(level))
    }

    fn position(any: [i16; 3]) -> [i16; 3] {
        any
    }

    fn place([x, y, z]: [i16; 3]) -> Placed {
        ([i32::from(x), -i32::from(y)], 0, (1_u32 << 31).wrapping_add_signed(i32::from(z) << 16))
    }
}

/// w is 1, 1/2 or 1/4, where the near plane is.
struct Deep;

impl Known for Deep {
    type Camera = MatrixCamera<true>;

    fn camera() -> Self::Camera {
        let w = ["0", "0", "-0.5", "0.5"];
        MatrixCamera::new(
            SIZE,
            matrix([["4", "0", "0", "0"], ["0", "4", "0", "0"], ["0", "0", "-0.5", "0.25"], w]),
        )
    }

    fn position([x, y, z]: [i16; 3]) -> [i16; 3] {
        [x, y, [-32_768, 0, 16_384][z as usize % 3]]
    }

    fn place([x, y, z]: [i16; 3]) -> Placed {
        let halvings = match z {
            -32_768 => 0,
            0 => 1,
            _ => 2,
        };
        let nearness = (1_u64 << (30 + halvings)).min(u64::from(u32::MAX)) as u32;
        ([i32::from(x) << halvings, -i32::from(y) << halvings], -halvings, nearness)
    }
}

/// Storage of a list.
type Store = (Vec<u32>, Vec<ListTriangle>);

/// A mesh, and how it is drawn.
struct Case<'c> {
    mesh: Mesh<'c>,
    cull: Cull,
    /// The unit of w: a power of two.
    unit: i32,
    pixels: &'c Cell<usize>,
}

impl Case<'_> {
    fn both<'a, K: Known, S: Shader<'a, u16>>(
        &self,
        stores: &'a mut [Store],
        shader: &S,
    ) -> Result<(), String> {
        let mut stores = stores.iter_mut();
        let mut two = || [(); 2].map(|()| stores.next().expect("two for each depth"));
        self.by::<Depth16, K, S>(two(), shader)?;
        self.by::<DepthFloat, K, S>(two(), shader)?;
        self.by::<Painter, K, S>(two(), shader)?;
        self.by::<NoDepth, K, S>(two(), shader)
    }

    fn by<'a, D: Strips, K: Known, S: Shader<'a, u16>>(
        &self,
        [(words, triangles), (more_words, more_triangles)]: [&'a mut Store; 2],
        shader: &S,
    ) -> Result<(), String> {
        let Self { mesh, cull, unit, pixels } = self;
        let mut expected = DrawList::<u16, D, Spans>::with_traversal(words, triangles);
        expected.set_cull(*cull);
        expected.draw(&K::camera(), mesh, &Pose::new(), shader).map_err(|error| error.to_string())?;
        D::sort(&mut expected);

        let mut list = DrawList::<u16, D, BoxWalk>::with_traversal(more_words, more_triangles);
        list.set_cull(*cull);
        let local = shader.local(mesh, &Pose::new());
        let vertices = mesh.positions().iter().enumerate().map(|(vertex, &position)| {
            let ([x, y], w, nearness) = K::place(position);
            let at = [x, y].map(|offset| Coord::from_bits((32 << 8) + offset));
            ProjectedVertex::new(Corner::new(at[0], at[1]), shader.vertex(&local, mesh, vertex))
                .with_depth(DepthCode::from_bits(nearness))
                .with_w(Length::from_bits(1 << (unit + w)))
        });
        let colours: Vec<[u8; 3]> =
            (0..mesh.faces().len()).map(|face| shader.face(&local, mesh, face)).collect();
        list.draw_projected(SIZE, vertices, mesh.faces(), &colours, &shader.pixel())
            .map_err(|error| error.to_string())?;
        D::sort(&mut list);

        let stats = expected.stats();
        if stats.clipped > 0 || (stats.drawn > 0 && stats != list.stats()) {
            return Err(format!("{:?} instead of {stats:?}", list.stats()));
        }
        let frame = rendered(&expected, 64, 0..64, 64, BACKGROUND);
        pixels.set(pixels.get() + frame.colours.iter().filter(|&&colour| colour != BACKGROUND).count());
        rendered(&list, 64, 0..64, 11, BACKGROUND).same(std::any::type_name::<(D, K, S)>(), &frame)
    }
}

/// A shader's pixel half takes what its vertex half gives: both kinds of camera, with light and without.
fn compare<K: Known>(data: &MeshData, way: usize, case: &Case<'_>) -> Result<(), String> {
    let positions: Vec<_> = data.positions.iter().map(|&position| K::position(position)).collect();
    let mut moved = data.clone();
    moved.positions = positions;
    let case = Case { mesh: moved.mesh(), ..*case };
    let sun = Sun::new([Length::lit("0.3"), Length::lit("0.8"), Length::lit("0.4")]);
    let stores = &mut vec![(vec![0; 100], vec![ListTriangle::EMPTY; 10]); 8];
    match way {
        0 => case.both::<K, _>(stores, &Flat::new(Material::OfMesh)),
        1 => case.both::<K, _>(stores, &Flat::new(Material::OfMesh).lit_by(&sun)),
        2 => case.both::<K, _>(stores, &Gouraud::unlit(&Material::OfMesh)),
        3 => case.both::<K, _>(stores, &Gouraud::new(&sun, &Material::OfMesh).within(ColourError::default())),
        4 => case.both::<K, _>(stores, &Textured::new(&TEST_CARD, Affine)),
        5 => case.both::<K, _>(stores, &Textured::new(&TEST_CARD, PerPixel)),
        6 => case.both::<K, _>(stores, &Textured::new(&TEST_CARD, PerPixel).lit_by(&sun)),
        7 => case.both::<K, _>(stores, &Textured::new(&TEST_CARD, Subspans::Of8)),
        _ => case.both::<K, _>(stores, &Textured::new(&TEST_CARD, Within::texels(Attribute::lit("0.25")))),
    }
}

// Red when a depth, w or the attributes are written in another order than they are read in, when colours are counted from
// another face, or the triangles are not culled, bounded or ordered as those of a mesh are.
#[test]
fn vertices_on_the_screen_are_drawn_as_those_of_a_mesh_are() {
    let pixels = Cell::new(0);
    let culls = prop::sample::select(vec![Cull::Back, Cull::Front, Cull::None]);
    check(6_000, &(mesh_data(), 0..9_usize, culls, 2..30), |(data, way, cull, unit)| {
        let case = Case { mesh: data.mesh(), cull, unit, pixels: &pixels };
        compare::<Level>(&data, way, &case)?;
        compare::<Deep>(&data, way, &case)
    });
    println!("{} pixels", pixels.get());
    assert!(pixels.get() > 1_000_000);
}

// Red when a list that has both starts the faces of one at the vertices of the other: `first` in `room`.
#[test]
fn meshes_and_vertices_on_the_screen_take_turns_in_a_list() {
    fn turns(data: &[MeshData; 3], order: [bool; 3]) -> crate::support::frame::Frame {
        let mut storage = (vec![0; 400], vec![ListTriangle::EMPTY; 40]);
        let mut list = DrawList::<u16, Depth16>::new(&mut storage.0, &mut storage.1);
        list.set_cull(Cull::None);
        let shader = Gouraud::unlit(&Material::OfMesh);
        for (data, by_mesh) in data.iter().zip(order) {
            let mesh = data.mesh();
            if by_mesh {
                list.draw(&Level::camera(), &mesh, &Pose::new(), &shader).expect("it fits");
                continue;
            }
            let vertices = mesh.positions().iter().zip(mesh.vertex_colours()).map(|(&position, &colour)| {
                let ([x, y], _, nearness) = Level::place(position);
                let at = [x, y].map(|offset| Coord::from_bits((32 << 8) + offset));
                let vertex = ProjectedVertex::new(Corner::new(at[0], at[1]), colour);
                vertex.with_depth(DepthCode::from_bits(nearness))
            });
            let pixel = Shader::<u16>::pixel(&shader);
            list.draw_projected(SIZE, vertices, mesh.faces(), &[], &pixel).expect("it fits");
        }
        rendered(&list, 64, 0..64, 64, BACKGROUND)
    }
    check(500, &[mesh_data(), mesh_data(), mesh_data()], |data| {
        let expected = turns(&data, [true; 3]);
        for order in [[false; 3], [true, false, true], [false, true, false]] {
            turns(&data, order).same(&format!("by mesh {order:?}"), &expected)?;
        }
        Ok(())
    });
}
