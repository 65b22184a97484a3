//! Strips that are rendered in order, and what is kept from one to the next.

use std::cell::Cell;

use embedded_graphics::prelude::*;
use proptest::prelude::*;
use topleft::stages::{
    Gradients, PerVertexInverse, PixelShader, Plane, Run, Shader, Uniforms, Varying, Words,
};
use topleft::{
    Attribute, Depth, Depth16, DrawList, ListTriangle, Mesh, NoDepth, Orthographic, Painter, Pose, Strip,
};

use super::{BACKGROUND, Drawing, OfMesh, WAYS};
use crate::support::check;
use crate::support::frame::{Frame, Strips, rendered};
use crate::support::strategies::mesh_data;

/// What is done with a list between two strips, by chance.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Between {
    Nothing,
    /// Some rows are left out.
    Skip(i32),
    /// Another mesh is drawn, into the list as it is or into an empty one: once.
    Draw,
    Clear,
    Sort,
}

fn between() -> impl Strategy<Value = Between> {
    prop_oneof![
        12 => Just(Between::Nothing),
        1 => (-3..6_i32).prop_map(Between::Skip),
        1 => Just(Between::Draw),
        1 => Just(Between::Clear),
        1 => Just(Between::Sort),
    ]
}

/// Renders strips one after the other from a list with so many free words, each compared with what `render` makes of it.
fn in_order<D: Strips>(
    [first, second, late]: [&OfMesh<'_>; 3],
    free: usize,
    strips: &[(i32, Between)],
) -> Result<usize, String> {
    let (mut words, mut triangles) = (vec![0; 4_096], vec![ListTriangle::EMPTY; 192]);
    let used = {
        let mut list = DrawList::<u16, D>::new(&mut words, &mut triangles);
        for drawing in [first, second, late] {
            drawing.draw(&mut list);
        }
        list.words()
    };
    let mut list = DrawList::<u16, D>::new(&mut words[..used + free], &mut triangles);
    first.draw(&mut list);
    second.draw(&mut list);
    let (mut top, mut is_drawn, mut seen) = (0, false, 0);
    for (number, &(height, between)) in strips.iter().enumerate() {
        let cells = 36 * height.max(1) as usize;
        let rows = top..top + height;
        let mut part = |next: bool| {
            let mut frame = Frame { width: 36, colours: vec![BACKGROUND; cells], depths: vec![0; cells] };
            let mut render = |strip: &mut Strip<'_, u16, D>| {
                if next {
                    list.render_next(rows.clone(), strip);
                } else {
                    list.render(rows.clone(), strip);
                }
            };
            render(&mut D::strip(36, &mut frame.colours, &mut frame.depths));
            frame
        };
        let (got, expected) = (part(true), part(false));
        got.same(&format!("strip {number}, {rows:?}"), &expected)?;
        seen += expected.colours.iter().filter(|&&colour| colour != BACKGROUND).count();
        top += height;
        match between {
            Between::Skip(rows) => top += rows,
            Between::Draw | Between::Clear if !is_drawn => {
                if between == Between::Clear {
                    list.clear();
                }
                late.draw(&mut list);
                is_drawn = true;
            }
            Between::Sort => D::sort(&mut list),
            _ => {}
        }
    }
    Ok(seen)
}

// Red when records outlive what they are of: `Records::NONE` left out in `DrawList::draw` or `sort`, or in `render_next` where
// there is no row, or the comparison of rows left out; and when one is put that is not taken, or taken that was not put: `<` in
// place of `<=` or `>` of `>=` in src/retained.rs.
#[test]
fn strips_in_order_give_the_bytes_that_each_gives_by_itself() {
    let seen = Cell::new(0);
    let mesh = || (mesh_data(), 0..WAYS - 1);
    let free = prop_oneof![Just(0), 1..64_usize, Just(1_000)];
    // Rows above the frame and below it, and strips without a row.
    let strips = proptest::collection::vec((-1..9_i32, between()), 1..20);
    check(10_000, &(mesh(), mesh(), mesh(), free, strips), |(a, b, c, free, strips)| {
        let drawings = [&a, &b, &c].map(|(data, way)| OfMesh {
            mesh: data.mesh(),
            way: *way,
            near: 0.05,
            stats: Cell::default(),
        });
        let [first, second, late] = &drawings;
        let meshes = [first, second, late];
        let pixels = in_order::<Depth16>(meshes, free, &strips)?
            + in_order::<NoDepth>(meshes, free, &strips)?
            + in_order::<Painter>(meshes, free, &strips)?;
        seen.set(seen.get() + pixels);
        Ok(())
    });
    println!("{} pixels", seen.get());
    assert!(seen.get() > 1_000_000);
}

thread_local! {
    /// Planes that were found.
    static PLANES: Cell<usize> = const { Cell::new(0) };
}

/// A value whose planes are counted.
#[derive(Clone, Copy)]
struct Counted(Attribute);

impl Words for Counted {
    const WORDS: usize = 1;

    fn store(self, put: &mut impl FnMut(u32)) {
        self.0.store(put);
    }

    fn load(words: &mut impl Iterator<Item = u32>) -> Option<Self> {
        Attribute::load(words).map(Self)
    }
}

impl Varying for Counted {
    fn plane(gradients: &Gradients, [a, b, c]: [Self; 3]) -> Plane<Self> {
        PLANES.set(PLANES.get() + 1);
        let Plane { start, dx, dy } = Attribute::plane(gradients, [a.0, b.0, c.0]);
        Plane { start: Self(start), dx: Self(dx), dy: Self(dy) }
    }

    fn plus(self, other: Self) -> Self {
        Self(self.0.plus(other.0))
    }

    fn times(self, steps: i32) -> Self {
        Self(self.0.times(steps))
    }
}

/// Shades by the row of the frame.
#[derive(Clone, Copy)]
struct ByCounted;

impl Shader<'_, u16> for ByCounted {
    type Pixel = Self;
    type Local = ();

    fn pixel(&self) -> Self {
        *self
    }

    fn local(&self, _: &Mesh<'_>, _: &Pose) {}

    fn vertex(&self, (): &(), _: &Mesh<'_>, vertex: usize) -> Attribute {
        Attribute::from_num(vertex)
    }

    fn face(&self, (): &(), _: &Mesh<'_>, _: usize) -> [u8; 3] {
        [0; 3]
    }
}

impl<'a> PixelShader<'a, u16> for ByCounted {
    type Vertex = Attribute;
    type Varying = Counted;
    type Triangle = ();
    type Simple = Self;
    const PERSPECTIVE: bool = false;

    fn uniforms(&self) -> Uniforms<'a> {
        Uniforms::NONE
    }

    fn from_uniforms(_: &Uniforms<'a>) -> Self {
        Self
    }

    fn triangle(&self, _: [u8; 3], at: [Attribute; 3], _: [PerVertexInverse; 3]) -> ((), [Counted; 3]) {
        ((), at.map(Counted))
    }

    fn shade<D: Depth>(&self, (): &(), mut at: Counted, step: &Counted, run: Run<'_, u16, D>) {
        for place in run.pixels() {
            place.shade(|| at.0.to_bits() as u16);
            at = at.plus(*step);
        }
    }
}

// Red when nothing is taken, or records start over those that are taken: the places in `Records::start`.
#[test]
fn planes_are_found_once_where_there_is_room() {
    let positions = [[-32767, 32767, 0], [-32767, -32767, 0], [32767, -32767, 0], [32767, 32767, 0]];
    let mesh = Mesh::new(&positions, &[[0, 1, 2], [0, 2, 3]]).expect("two faces");
    let camera = Orthographic::new(Size::new(8, 8), 2.0, -1.0..1.0);
    let (mut words, mut triangles) = ([0; 64], [ListTriangle::EMPTY; 2]);
    // Three words a vertex, and three a plane.
    for (free, expected) in [(0, 8), (2, 8), (3, 8 - 2), (5, 8 - 2), (9, 8 - 5), (12, 2), (52, 2)] {
        let mut list = DrawList::<u16, NoDepth>::new(&mut words[..12 + free], &mut triangles);
        list.draw(&camera, &mesh, &Pose::new(), &ByCounted).expect("room for both");
        let planes = |list: &mut DrawList<'_, u16, NoDepth>| {
            PLANES.set(0);
            for top in [0, 2, 4, 6] {
                let mut cells = [0; 16];
                list.render_next(top..top + 2, &mut Strip::new(8, &mut cells).expect("whole rows"));
            }
            PLANES.get()
        };
        assert_eq!([planes(&mut list), planes(&mut list)], [expected; 2], "{free} words");
    }
}

// Red when a triangle's rows are left out of the list's: `min` and `max` change places in `DrawList::rows`, or it ends with a row
// that shows something. That they are not too many is in its documentation's example.
#[test]
fn nothing_is_drawn_above_or_below_the_rows_of_a_list() {
    let outside = Cell::new(0);
    check(2_000, &((mesh_data(), 0..WAYS - 1), (mesh_data(), 0..WAYS - 1)), |meshes| {
        let (mut words, mut triangles) = (vec![0; 4_096], vec![ListTriangle::EMPTY; 192]);
        let mut list = DrawList::<u16, NoDepth>::new(&mut words, &mut triangles);
        for (data, way) in [&meshes.0, &meshes.1] {
            OfMesh { mesh: data.mesh(), way: *way, near: 0.05, stats: Cell::default() }.draw(&mut list);
        }
        let frame = rendered(&list, 36, 0..26, 26, BACKGROUND);
        for (row, cells) in (0..).zip(frame.colours.chunks(36)) {
            if !list.rows().contains(&row) {
                outside.set(outside.get() + 1);
                if cells.iter().any(|&colour| colour != BACKGROUND) {
                    return Err(format!("row {row} is not in {:?}", list.rows()));
                }
            }
        }
        Ok(())
    });
    println!("{} rows", outside.get());
    assert!(outside.get() > 1_000);
}
