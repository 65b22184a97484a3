//! Measures one case: the vertex stages once, and the pixel stages strip by strip.

use embedded_graphics_core::geometry::Size;
use topleft::stages::Traversal;
use topleft::{Depth, Depth16, DepthFloat, DrawError, DrawList, ListTriangle, NoDepth, Painter, Strip};

use crate::crc::Crc;
use crate::row::Row;
use crate::traversal::{Counting, Nothing};

/// What is drawn for.
pub const PANEL: Size = Size::new(240, 240);

/// What counts cycles, or instructions.
pub trait Clock {
    /// How many there were since some fixed moment.
    fn now(&mut self) -> u64;

    /// Tells a profiler what is measured next: `clear`, `vertex`, `render` or `setup`.
    fn next(&mut self, part: Part) {
        let _ = part;
    }
}

/// What is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Nothing: what measuring itself costs.
    Overhead,
    /// [`Row::vertex`].
    Vertex,
    /// [`Row::clear`].
    Clear,
    /// [`Row::setup`].
    Setup,
    /// [`Row::setup`] and [`Row::raster`].
    Render,
}

/// A scene that is drawn in one way.
pub(crate) trait Case {
    type Depth: Buffered;

    fn method(&self) -> &'static str;

    fn scene(&self) -> &'static str;

    fn draw<T: Traversal>(&self, list: &mut DrawList<'_, u16, Self::Depth, T>) -> Result<(), DrawError>;

    fn background(&self) -> [u8; 3] {
        [0; 3]
    }
}

/// A depth, or none, and its part of the buffers.
pub(crate) trait Buffered: Depth + Sized {
    /// Puts a list in order, where it has one.
    fn sort<T>(_: &mut DrawList<'_, u16, Self, T>, _: &mut [[u16; 3]]) {}

    fn strip<'s>(colours: &'s mut [u16], depths: &'s mut [u16]) -> Strip<'s, u16, Self>;
}

const FITS: &str = "a strip is whole rows of the panel";

impl Buffered for NoDepth {
    fn strip<'s>(colours: &'s mut [u16], _: &'s mut [u16]) -> Strip<'s, u16, Self> {
        Strip::new(PANEL.width as u16, colours).expect(FITS)
    }
}

impl Buffered for Painter {
    fn sort<T>(list: &mut DrawList<'_, u16, Self, T>, scratch: &mut [[u16; 3]]) {
        list.sort(scratch).expect("as many triangles as the list");
    }

    fn strip<'s>(colours: &'s mut [u16], _: &'s mut [u16]) -> Strip<'s, u16, Self> {
        NoDepth::strip(colours, &mut []).for_painter()
    }
}

impl Buffered for Depth16 {
    fn strip<'s>(colours: &'s mut [u16], depths: &'s mut [u16]) -> Strip<'s, u16, Self> {
        NoDepth::strip(colours, &mut []).with_depth(depths).expect(FITS)
    }
}

impl Buffered for DepthFloat {
    fn strip<'s>(colours: &'s mut [u16], depths: &'s mut [u16]) -> Strip<'s, u16, Self> {
        NoDepth::strip(colours, &mut []).with_depth_float(depths).expect(FITS)
    }
}

/// What all cases draw with.
pub(crate) struct Buffers<'b> {
    pub(crate) colours: &'b mut [u16],
    pub(crate) depths: &'b mut [u16],
    pub(crate) words: &'b mut [u32],
    pub(crate) triangles: &'b mut [ListTriangle],
    /// For lists that are sorted.
    pub(crate) scratch: &'b mut [[u16; 3]],
}

/// The clock, and where rows go.
pub(crate) struct Bench<'c> {
    clock: &'c mut dyn Clock,
    report: &'c mut dyn FnMut(&Row),
    overhead: u64,
}

impl<'c> Bench<'c> {
    pub(crate) fn new(clock: &'c mut dyn Clock, report: &'c mut dyn FnMut(&Row)) -> Self {
        let mut bench = Self { clock, report, overhead: 0 };
        bench.overhead = bench.time(Part::Overhead, &mut || ());
        bench
    }

    #[inline(never)]
    fn time(&mut self, part: Part, what: &mut dyn FnMut()) -> u64 {
        self.clock.next(part);
        let start = self.clock.now();
        what();
        let end = self.clock.now();
        (end - start).saturating_sub(self.overhead)
    }

    /// Measures a case by spans, and reports its row.
    pub(crate) fn case<C: Case>(&mut self, case: &C, buffers: &mut Buffers<'_>) {
        self.by::<topleft_thumb::Spans, _>(case.method(), case, buffers);
    }

    /// Measures a case by a traversal, and reports its row. Not inlined: the lists of all cases at once would not leave
    /// room for a frame.
    #[inline(never)]
    pub(crate) fn by<T: Traversal, C: Case>(
        &mut self,
        method: &'static str,
        case: &C,
        buffers: &mut Buffers<'_>,
    ) {
        let Buffers { colours, depths, words, triangles, scratch } = buffers;
        let background = <u16 as topleft::Pixel>::from_rgb(case.background());
        let mut strip = C::Depth::strip(colours, depths).with_background(background);
        let rows = i32::from(strip.height());
        let tops = || (0..PANEL.height as i32).step_by(rows as usize);
        let part = |top: i32| top..top + rows;
        let fits = "the list is large enough for all cases";

        let pixels = {
            let mut list = DrawList::with_traversal(words, triangles);
            case.draw::<Counting>(&mut list).expect(fits);
            tops().for_each(|top| list.render_next(part(top), &mut strip));
            Counting::take()
        };
        let setup: u64 = {
            let mut list = DrawList::with_traversal(words, triangles);
            case.draw::<Nothing>(&mut list).expect(fits);
            tops().map(|top| self.time(Part::Setup, &mut || list.render_next(part(top), &mut strip))).sum()
        };
        let mut list = DrawList::<_, _, T>::with_traversal(words, triangles);
        let vertex = self.time(Part::Vertex, &mut || {
            case.draw(&mut list).expect(fits);
            C::Depth::sort(&mut list, scratch);
        });
        let (mut clear, mut render, mut crc) = (0, 0, Crc::new());
        for top in tops() {
            clear += self.time(Part::Clear, &mut || strip.clear());
            render += self.time(Part::Render, &mut || list.render_next(part(top), &mut strip));
            crc.add(strip.colours());
        }
        (self.report)(&Row {
            scene: case.scene(),
            method,
            strip_rows: rows as usize,
            triangles: list.stats().drawn,
            pixels,
            vertex,
            setup,
            raster: render.saturating_sub(setup),
            clear,
            crc: crc.value(),
        });
    }
}
