//! Three channels, each in a register, as depth is.
#![expect(unsafe_code, reason = "assembly: it relies on what `Rows` promises")]

use topleft::stages::{Plane, Rows, ShortEdge, Trapezoids};
use topleft::{Attribute, DepthCode};

use crate::single_pass::{Frame, single_pass};
use crate::walk::Walk;

type Channels = Plane<[Attribute; 3]>;

#[inline(always)]
fn frame(channels: &Channels, depth: Plane<DepthCode>) -> Frame<[u32; 4]> {
    let four = |channels: [Attribute; 3], depth: DepthCode| {
        let [r, g, b] = channels.map(|channel| channel.to_bits().cast_unsigned());
        [r, g, b, depth.to_bits()]
    };
    Frame::new(four(channels.dy, depth.dy), four(channels.dx, depth.dx), four(channels.start, depth.start))
}

#[cfg(narrow)]
#[inline(always)]
pub(crate) fn draw(rows: Rows<'_>, channels: &Channels) {
    let Walk { trapezoids, row, stride, .. } = Walk::new(rows);
    let none = DepthCode::from_bits(0);
    let frame = frame(channels, Plane { start: none, dx: none, dy: none });
    // SAFETY: the cells are borrowed for all rows, and no row reaches beyond its cells or over more than 32 of them, as the
    // jump into the code has it.
    unsafe { gouraud(trapezoids, row, stride, 0, frame) };
}

#[inline(always)]
pub(crate) fn draw_tested(rows: Rows<'_>, depth: Plane<DepthCode>, channels: &Channels) {
    let Walk { trapezoids, row, stride, to_depth } = Walk::new(rows);
    // SAFETY: the cells are borrowed for all rows, each has its depth as far from it as the first has, and no row reaches beyond
    // its cells or over more than 32 of them, as the jump into the code has it.
    unsafe { gouraud_tested(trapezoids, row, stride, to_depth, frame(channels, depth)) };
}

/// About 60 cycles a row. r2 to r5: red, green, blue and depth; r8 to r11: their steps; lr: bytes to depths.
macro_rules! rows {
    ($bytes:literal, $test:literal, $step:literal) => {
        single_pass!(
            bytes: $bytes,
            pixel: concat!(
                $test,
                "
                 lsrs r6, r2, #16
                 lsls r6, r6, #6
                 lsrs r7, r3, #16
                 orrs r6, r6, r7
                 lsls r6, r6, #5
                 lsrs r7, r4, #16
                 orrs r6, r6, r7
                 strh r6, [r0, #\\column]
                 3:
                 add r2, r8
                 add r3, r9
                 add r4, r10
                 ",
                $step,
            ),
            down:
                "ldmia r7!, {{r1, r6}}
                 adds r2, r2, r1
                 adds r3, r3, r6
                 ldmia r7!, {{r1, r6}}
                 adds r4, r4, r1
                 adds r5, r5, r6",
            along:
                "mov r7, r8
                 muls r7, r0, r7
                 adds r2, r2, r7
                 mov r7, r9
                 muls r7, r0, r7
                 adds r3, r3, r7
                 mov r7, r10
                 muls r7, r0, r7
                 adds r4, r4, r7
                 mov r7, r11
                 muls r7, r0, r7
                 adds r5, r5, r7",
            depths:
                "mov r1, r0
                 add r1, lr",
            fourth: "movs r7, #0",
        )
    };
}

#[cfg(narrow)]
#[unsafe(naked)]
unsafe extern "C" fn gouraud(
    _: &Trapezoids<ShortEdge>,
    row: *mut u16,
    stride: usize,
    to_depth: usize,
    frame: Frame<[u32; 4]>,
) {
    rows!(22, "", "")
}

/// 20 cycles a pixel that is visible.
#[unsafe(naked)]
unsafe extern "C" fn gouraud_tested(
    _: &Trapezoids<ShortEdge>,
    row: *mut u16,
    stride: usize,
    to_depth: usize,
    frame: Frame<[u32; 4]>,
) {
    rows!(
        34,
        "ldrh r6, [r1, #\\column]
         lsrs r7, r5, #16
         cmp r6, r7
         bhs 3f
         strh r7, [r1, #\\column]",
        "add r5, r11"
    )
}
