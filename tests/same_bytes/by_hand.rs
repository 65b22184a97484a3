//! A kernel as plain as can be: each pixel by its planes. What it draws, and what it leaves, has to be what the stages draw.

use std::cell::Cell;
use std::convert::Infallible;

use embedded_graphics::geometry::Size;
use proptest::prelude::*;
use scenes::texture::TEST_CARD;
use topleft::stages::{
    Correction, DrawSpan, FlatPixel, FoundSides, Kernel, Plane, Rows, Setup, Shade, SmallTriangle, Snapped,
    Span, Tested, TexelsOverW, Traversal, Window,
};
use topleft::{
    Attribute, Coord, Cull, Depth16, DepthCode, Length, ListStorage, NoDepth, PerPixel, Point,
    ProjectedVertex, Spans, SpansBy, Strip, Texture, Textured, Within, Wrap, point,
};

use crate::support::{check, same};

thread_local! {
    static DRAWN: Cell<u64> = const { Cell::new(0) };
    /// Those of them that took a reciprocal, and of these the ones in a lower octave.
    static DIVIDED: Cell<u64> = const { Cell::new(0) };
    static TWICE: Cell<u64> = const { Cell::new(0) };
    static SIDES: Cell<u64> = const { Cell::new(0) };
}

/// Draws all that kernels are handed, but for textures that end.
pub(crate) enum ByHand {}

impl Kernel for ByHand {
    fn draw(rows: Rows<'_>) -> bool {
        let (shade, tested, width) = (rows.shade(), rows.tested(), rows.width());
        if let Shade::Affine(texture, _) | Shade::Perspective(texture, _) = shade
            && texture.wrap() == Wrap::Clamp
        {
            return false;
        }
        let mut spans = Vec::new();
        rows.spans(|span| spans.push(span));
        let (colours, depths) = rows.into_cells();
        for Span { y, start, end } in spans {
            // What is promised to code that cannot be checked.
            assert!(start >= 0 && end <= width as i32 && end - start <= 32, "{start}..{end} of {width}");
            for x in start..end {
                let at = y as usize * width + x as usize;
                if let Tested::Depth16(plane) = tested {
                    let code = (plane.at(x, y).to_bits() >> 16) as u16;
                    if code <= depths[at] {
                        continue;
                    }
                    depths[at] = code;
                }
                colours[at] = match shade {
                    Shade::Flat(colour) => colour,
                    Shade::Gouraud(plane) => {
                        let [r, g, b] = plane.at(x, y).map(|channel| (channel.to_bits() >> 16) as u16);
                        r << 11 | g << 5 | b
                    }
                    Shade::Affine(texture, plane) => {
                        let [u, v] = plane.at(x, y).map(|texel| texel.to_bits() >> 16);
                        texture.texel(u, v)
                    }
                    Shade::Perspective(texture, texels) => {
                        DIVIDED.set(DIVIDED.get() + 1);
                        let [u, v] = divided(&texels, x, y);
                        texture.texel(u, v)
                    }
                };
                DRAWN.set(DRAWN.get() + 1);
            }
        }
        true
    }

    fn sides(triangle: SmallTriangle<'_>) -> FoundSides<'_> {
        let (setup, rows) = (triangle.setup(), triangle.rows());
        SIDES.set(SIDES.get() + 1);
        // Promised as well.
        let [a, b, c] = setup.points();
        let crossed = setup.rows();
        assert!(!rows.is_empty() && rows.start >= crossed.start && rows.end <= crossed.end, "{rows:?}");
        for (upper, lower) in [(a, b), (b, c), (a, c)] {
            let [x, y] = [upper.x, upper.y].map(Coord::to_bits);
            let [width, height] = [lower.x.to_bits() - x, lower.y.to_bits() - y];
            assert!(width.abs() < 32 << 8 && (0..32 << 8).contains(&height), "{setup:?}");
            assert!([x, x + width].iter().all(|x| x.abs() <= 2047 << 8), "{setup:?}");
            let crosses = (y + 127) >> 8 < (y + height + 127) >> 8;
            assert!(!crosses || height >= 4, "{setup:?}");
        }
        triangle.sides()
    }
}

/// The column and row of a pixel's texel, as `TexelsOverW` says.
fn divided(texels: &TexelsOverW, x: i32, y: i32) -> [i32; 2] {
    let Plane { start, dx, dy } = texels.over_w;
    let at = |i: usize| start[i].wrapping_add(dx[i].wrapping_mul(x)).wrapping_add(dy[i].wrapping_mul(y));
    let [mut q, mut u, mut v] = [0, 1, 2].map(at);
    // What is promised to code that shifts without a sign.
    if texels.one_octave {
        assert!(q >= 1 << 30 && u >= 0 && v >= 0, "{q:#x} {u:#x} {v:#x}");
    } else {
        assert!(q >= 1 << 29 && u > -(1 << 13) && v > -(1 << 13), "{q:#x} {u:#x} {v:#x}");
        (u, v) = (u.max(0), v.max(0));
    }
    if q < 1 << 30 {
        (q, u, v) = (q << 1, u << 1, v << 1);
        TWICE.set(TWICE.get() + 1);
    }
    let below = q.cast_unsigned() << 2;
    let line = TexelsOverW::reciprocals()[(below >> 26) as usize];
    let reciprocal = (line - (line & 0xFFFF) * (below >> 10)) >> 16;
    let part = |c: i32| ((c.cast_unsigned() >> 15) * reciprocal) >> (31 - texels.span_log2);
    let [least_u, least_v] = texels.least;
    [least_u + part(u).cast_signed(), least_v + part(v).cast_signed()]
}

/// Spans of a window that no strip here has.
enum Between<const START: i32, const END: i32> {}

impl<const START: i32, const END: i32> Traversal for Between<START, END> {
    fn spans<E>(setup: &Setup, window: &Window, target: &mut impl DrawSpan<E>) -> Result<(), E> {
        let window = Window { columns: START..END, rows: window.rows.clone() };
        SpansBy::<ByHand>::spans(setup, &window, target)
    }
}

/// Triangles of 16 px in a row, from 8 px left of a frame of 40 columns to 8 px right of it.
fn row<T: Traversal>() -> (u64, Vec<u16>) {
    let (mut storage, mut colours) = (ListStorage::<30, 5>::new(), [0; 40 * 16]);
    let mut list = storage.list_with_traversal::<u16, NoDepth, T>();
    list.set_cull(Cull::None);
    let corner = |i: u16| {
        let (x, y) = [(0.0, 0.5), (15.0, 2.0), (6.0, 15.0)][usize::from(i % 3)];
        ProjectedVertex::new(point(x - 8.0 + 10.0 * f32::from(i / 3), y), ())
    };
    let faces: [[u16; 3]; 5] = std::array::from_fn(|i| [0, 1, 2].map(|corner| 3 * i as u16 + corner));
    let size = Size::new(40, 16);
    let (white, shader) = ([[255; 3]; 5], FlatPixel);
    list.draw_projected(size, (0..15).map(corner), &faces, &white, &shader).expect("it is long enough");
    DRAWN.set(0);
    SIDES.set(0);
    list.render(0..16, &mut Strip::new(40, &mut colours).expect("rows"));
    (DRAWN.get(), colours.to_vec())
}

// Red when kernels are not asked for sides, or triangles whose columns are not all in the strip reach a kernel: `columns.start >= 0` or `columns.end <= width` in
// `Rows::new`.
#[test]
fn kernels_get_whole_triangles_inside_of_the_strip_and_nothing_else() {
    let (none, expected) = row::<Spans>();
    assert_eq!(SIDES.get(), 0);
    let (drawn, colours) = row::<SpansBy<ByHand>>();
    // Those that reach over an end of the strip have other edges.
    assert_eq!(SIDES.get(), 3);
    // Three of the five are inside.
    let seen = expected.iter().filter(|&&colour| colour != 0).count() as u64;
    assert!(none == 0 && drawn > 200 && drawn < seen, "{drawn} of {seen}");
    assert_eq!(colours, expected);
    let drawn =
        [row::<Between<0, 60>>(), row::<Between<-10, 40>>(), row::<Between<0, 40>>()].map(|row| row.0);
    assert!(drawn[..2] == [0, 0] && drawn[2] > 200, "{drawn:?}");
}

/// Spans of triangles that a kernel is asked for, and does not draw.
struct Asked(Vec<Span>);

impl DrawSpan<Infallible> for Asked {
    fn has_kernels(&self) -> bool {
        true
    }

    fn draw(&mut self, span: Span) -> Result<(), Infallible> {
        self.0.push(span);
        Ok(())
    }
}

// Red when `ShortEdge::suits` takes edges that are lower, triangles that are wider or higher, or vertices left of the window.
#[test]
fn kernels_find_the_sides_of_small_triangles_and_of_no_others() {
    let asked = |corners: [[i32; 2]; 3]| {
        let (setup, _) = Setup::new(corners.map(|[x, y]| Snapped::from_bits(x, y))).expect("an area");
        let window = Window { columns: 0..60, rows: 0..60 };
        let (mut spans, mut expected) = (Asked(Vec::new()), Vec::new());
        SIDES.set(0);
        let Ok(()) = SpansBy::<ByHand>::spans::<Infallible>(&setup, &window, &mut spans);
        let Asked(spans) = spans;
        let Ok(()) = Spans::walk::<Infallible>(&setup, &window, |span| {
            expected.push(span);
            Ok(())
        });
        assert!(spans == expected && !spans.is_empty(), "{spans:?}, {expected:?}");
        SIDES.get()
    };
    // From above the first row's centres to 4 steps further down, and to 3.
    assert_eq!([130, 129].map(|y| asked([[300, 126], [2000, y], [300, 2000]])), [1, 0]);
    assert_eq!([8191, 8192].map(|x| asked([[0, 0], [x, 300], [0, 2000]])), [1, 0]);
    assert_eq!([8191, 8192].map(|y| asked([[0, 0], [2000, 300], [0, y]])), [1, 0]);
    assert_eq!([0, -1].map(|x| asked([[x, 0], [2000, 300], [0, 2000]])), [1, 0]);
}

/// Draws a triangle that is up to 40 px wide and 32 px high, in strips of so many rows.
fn divided_by<T: Traversal>(
    corners: &[Vertex; 3],
    shader: &Textured<'_, impl Correction>,
    rows: i32,
) -> (Vec<u16>, Vec<u16>) {
    let (mut storage, size) = (ListStorage::<24, 1>::new(), Size::new(48, 36));
    let mut list = storage.list_with_traversal::<u16, Depth16, T>();
    list.set_cull(Cull::None);
    let vertices = corners.map(|((x, y), w, texel, depth)| {
        let at = Point::new(Coord::from_bits(x), Coord::from_bits(y));
        ProjectedVertex::new(at, texel.map(Attribute::from_bits))
            .with_w(Length::from_bits(w))
            .with_depth(DepthCode::from_bits(depth))
    });
    list.draw_projected(size, vertices, &[[0, 1, 2]], &[], shader).expect("it is long enough");
    let (mut colours, mut depths) = (vec![0; 48 * 36], vec![0; 48 * 36]);
    // Something is before the triangle in some places.
    depths.iter_mut().step_by(5).for_each(|depth| *depth = 0x8000);
    for top in (0..36).step_by(rows as usize) {
        let cells = 48 * top as usize..48 * (top + rows) as usize;
        let strip = Strip::new(48, &mut colours[cells.clone()]).expect("whole rows");
        list.render(top..top + rows, &mut strip.with_depth(&mut depths[cells]).expect("as many"));
    }
    (colours, depths)
}

/// By the library alone and by hand: the same.
fn both(
    corners: &[Vertex; 3],
    texture: &Texture<'_>,
    correction: impl Correction,
    rows: i32,
) -> Result<(), String> {
    let shader = Textured::new(texture, correction);
    let expected = divided_by::<Spans>(corners, &shader, rows);
    DIVIDED.set(0);
    TWICE.set(0);
    let got = divided_by::<SpansBy<ByHand>>(corners, &shader, rows);
    same("colours", 48, &got.0, &expected.0)?;
    same("depths", 48, &got.1, &expected.1)
}

/// A place in 1/256 px, w in steps of a `Length`, a texel in steps of an `Attribute`, and a depth.
type Vertex = ((i32, i32), i32, [i32; 2], u32);

// Red when a triangle of more than two octaves reaches a kernel, or one of two is said to be of one: `over_w` and `in_octaves`; and
// when some runs of small triangles are by subspans: `WORTH_SUBSPANS` of 32.
#[test]
fn small_triangles_in_perspective_are_divided_by_kernels() {
    let (w, texel) = (1 << 14..3 << 15_i32, -40 << 16..40 << 16_i32);
    let place = (2 << 8..42 << 8_i32, 2 << 8..34 << 8_i32);
    let vertex = (place, w, [texel.clone(), texel], 0..u32::MAX);
    let rows = prop_oneof![Just(36), Just(9), Just(1)];
    let counts = Cell::new([[0; 2]; 3]);
    check(20_000, &([vertex.clone(), vertex.clone(), vertex], rows, 0..3_usize), |(corners, rows, way)| {
        match way {
            0 => both(&corners, &TEST_CARD, PerPixel, rows),
            1 => both(&corners, &TEST_CARD, Within::default(), rows),
            _ => both(&corners, &TEST_CARD, Within::texels(Attribute::ONE), rows),
        }?;
        let mut seen = counts.get();
        let [divided, twice] = &mut seen[way];
        (*divided, *twice) = (*divided + DIVIDED.get(), *twice + TWICE.get());
        counts.set(seen);
        Ok(())
    });
    // Of 32 pixels in its first row: none of a small triangle has more.
    let widest = [
        ((639, 639), 3 << 14, [0, 0], u32::MAX),
        ((8830, 639), 1 << 16, [60 << 16, 0], u32::MAX),
        ((639, 8830), 1 << 16, [0, 60 << 16], u32::MAX),
    ];
    let texels: [u16; 64 * 64] = std::array::from_fn(|i| i as u16 + 1);
    let each = Texture::new(64, 64, &texels).expect("powers of two");
    both(&widest, &each, Within::texels(Attribute::ONE), 36).expect("the same");
    assert!(DIVIDED.get() > 500, "{}", DIVIDED.get());
    println!("{:?} pixels divided, of which twice as high", counts.get());
    assert!(counts.get().as_flattened().iter().all(|&count| count > 10_000), "{:?}", counts.get());
}
