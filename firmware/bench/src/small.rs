//! The smallest triangles by every traversal: where a box is cheaper to walk than spans.

use topleft::stages::Traversal;
use topleft::{BoxWalk, BySize, Depth16, DrawError, DrawList, Flat, Mesh, NoDepth, Pose, Spans};

use core::marker::PhantomData;

use crate::measure::{Bench, Buffered, Buffers, Case};
use crate::sizes::{LEVEL, PAINT, VERTICES, mesh, positions, uvs};

macro_rules! sizes {
    ($($side:literal)*) => {
        /// By the triangles' side in pixels.
        static SIZES: [(&str, Mesh<'static>); 6] = [$((concat!("small-", $side), {
            static POSITIONS: [[i16; 3]; VERTICES] = positions($side);
            static UVS: [[i16; 2]; VERTICES] = uvs(&POSITIONS);
            mesh(&POSITIONS, &UVS)
        })),*];
    };
}

sizes! { 2 4 5 6 8 16 }

/// Measures all traversals at all sizes, without depth and with it.
pub(crate) fn all(bench: &mut Bench<'_>, buffers: &mut Buffers<'_>) {
    for size in 0..SIZES.len() {
        let flat = Small::<NoDepth> { size, depth: PhantomData };
        bench.by::<Spans, _>("flat", &flat, buffers);
        bench.by::<BoxWalk, _>("flat-box", &flat, buffers);
        bench.by::<BySize, _>("flat-by-size", &flat, buffers);
        let deep = Small::<Depth16> { size, depth: PhantomData };
        bench.by::<Spans, _>("flat+depth", &deep, buffers);
        bench.by::<BoxWalk, _>("flat-box+depth", &deep, buffers);
        bench.by::<BySize, _>("flat-by-size+depth", &deep, buffers);
    }
}

/// Triangles of one colour, of the size at that place.
struct Small<D> {
    size: usize,
    depth: PhantomData<D>,
}

impl<D: Buffered> Case for Small<D> {
    type Depth = D;

    fn method(&self) -> &'static str {
        "flat"
    }

    fn scene(&self) -> &'static str {
        SIZES[self.size].0
    }

    fn draw<T: Traversal>(&self, list: &mut DrawList<'_, u16, D, T>) -> Result<(), DrawError> {
        list.draw(&LEVEL, &SIZES[self.size].1, &Pose::new(), &Flat::new(PAINT))
    }
}
