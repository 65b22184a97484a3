//! A kernel as plain as can be: each pixel by its planes. What it draws, and what it leaves, has to be what the stages draw.

use std::cell::Cell;

use topleft::stages::{
    DrawSpan, FlatPixel, Kernel, Plane, Rows, Setup, Shade, Span, Tested, TexelsOverW, Traversal, Window,
};
use topleft::{Cull, ListStorage, NoDepth, ProjectedVertex, Spans, SpansBy, Strip, Wrap, point};

thread_local! {
    static DRAWN: Cell<u64> = const { Cell::new(0) };
    /// Those of them that took a reciprocal.
    static DIVIDED: Cell<u64> = const { Cell::new(0) };
}

/// How many pixels took a reciprocal since the last call.
pub(crate) fn take_divided() -> u64 {
    DIVIDED.take()
}

/// Draws all that kernels are handed, but for textures that end.
pub(crate) enum ByHand {}

impl Kernel for ByHand {
    fn draw(rows: Rows<'_>) -> bool {
        let (shade, tested, width) = (rows.shade(), rows.tested(), rows.width());
        if let Shade::Affine(texture, _) | Shade::Perspective(texture, _) = shade {
            if texture.wrap() == Wrap::Clamp {
                return false;
            }
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
}

/// The column and row of a pixel's texel, as `TexelsOverW` says.
fn divided(texels: &TexelsOverW, x: i32, y: i32) -> [i32; 2] {
    let Plane { start, dx, dy } = texels.over_w;
    let at = |i: usize| start[i].wrapping_add(dx[i].wrapping_mul(x)).wrapping_add(dy[i].wrapping_mul(y));
    let [q, u, v] = [0, 1, 2].map(at);
    // What is promised to code that shifts without a sign.
    assert!(q >= 1 << 30 && u >= 0 && v >= 0, "{q:#x} {u:#x} {v:#x}");
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
    let size = embedded_graphics::geometry::Size::new(40, 16);
    let (white, shader) = ([[255; 3]; 5], FlatPixel);
    list.draw_projected(size, (0..15).map(corner), &faces, &white, &shader).expect("it is long enough");
    DRAWN.set(0);
    list.render(0..16, &mut Strip::new(40, &mut colours).expect("rows"));
    (DRAWN.get(), colours.to_vec())
}

// Red when triangles whose columns are not all in the strip reach a kernel: `columns.start >= 0` or `columns.end <= width` in
// `Rows::new`.
#[test]
fn kernels_get_whole_triangles_inside_of_the_strip_and_nothing_else() {
    let (none, expected) = row::<Spans>();
    let (drawn, colours) = row::<SpansBy<ByHand>>();
    // Three of the five are inside.
    let seen = expected.iter().filter(|&&colour| colour != 0).count() as u64;
    assert!(none == 0 && drawn > 200 && drawn < seen, "{drawn} of {seen}");
    assert_eq!(colours, expected);
    let drawn =
        [row::<Between<0, 60>>(), row::<Between<-10, 40>>(), row::<Between<0, 40>>()].map(|row| row.0);
    assert!(drawn[..2] == [0, 0] && drawn[2] > 200, "{drawn:?}");
}
