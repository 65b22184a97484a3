//! A reciprocal a pixel, of a texture that repeats.
#![expect(unsafe_code, reason = "assembly: it relies on what `Rows` promises")]

use core::arch::naked_asm;

use topleft::stages::{Plane, Rows, ShortEdge, TexelsOverW, Trapezoids};
use topleft::{DepthCode, Texture};

use crate::walk::{Walk, ends, enter, first_run, hidden, keep, restore, turn, visible};

#[repr(C)]
struct Frame {
    depth: u32,
    over_w: [u32; 3],
    depth_dy: u32,
    over_w_dy: [u32; 3],
    /// Twice one less than there are texels.
    mask: u32,
    texels: *const u16,
    reciprocals: &'static [u32; 64],
    depth_dx: u32,
    to_depth: usize,
    over_w_dx: [u32; 3],
    corner: u32,
    /// From the lowest byte up: what takes a product to texels; 32 less the power of two that the width is; 31 less it; and
    /// whether there are two octaves.
    shifts: u32,
}

impl Frame {
    #[inline(always)]
    fn new(texture: &Texture<'_>, texels: &TexelsOverW, to_depth: usize, depth: Plane<u32>) -> Self {
        // In one octave, what follows the leading one of 1/w.
        let up = if texels.one_octave { 2 } else { 0 };
        let words = |[q, u, v]: [i32; 3]| [q << up, u, v].map(i32::cast_unsigned);
        let (above, down) = (32 - texture.width().trailing_zeros(), 31 - texels.span_log2);
        let [column, row] = texels.least.map(i32::cast_unsigned);
        Self {
            depth: depth.start,
            over_w: words(texels.over_w.start),
            depth_dy: depth.dy,
            over_w_dy: words(texels.over_w.dy),
            mask: 2 * (texture.texels().len() as u32 - 1),
            texels: texture.texels().as_ptr(),
            reciprocals: TexelsOverW::reciprocals(),
            depth_dx: depth.dx,
            to_depth,
            over_w_dx: words(texels.over_w.dx),
            // Of one column, nothing is left. Heights divide 2^16.
            corner: column.checked_shl(above).unwrap_or_default().wrapping_add(row & 0xFFFF),
            shifts: down | above << 8 | (above - 1) << 16 | u32::from(!texels.one_octave) << 24,
        }
    }
}

#[inline(always)]
pub(crate) fn draw(rows: Rows<'_>, texture: &Texture<'_>, texels: &TexelsOverW) {
    let Walk { trapezoids, row, stride, .. } = Walk::new(rows);
    let frame = Frame::new(texture, texels, 0, Plane { start: 0, dx: 0, dy: 0 });
    // SAFETY: the cells are borrowed for all rows, and no row reaches beyond its cells; the mask keeps texels in the texture,
    // which has a power of two of them, 2^10 a side at most; six bits choose one of 64 reciprocals.
    unsafe { perspective(trapezoids, row, stride, &frame) };
}

#[inline(always)]
pub(crate) fn draw_tested(
    rows: Rows<'_>,
    depth: Plane<DepthCode>,
    texture: &Texture<'_>,
    texels: &TexelsOverW,
) {
    let Walk { trapezoids, row, stride, to_depth } = Walk::new(rows);
    let [start, dx, dy] = [depth.start, depth.dx, depth.dy].map(DepthCode::to_bits);
    let frame = Frame::new(texture, texels, to_depth, Plane { start, dx, dy });
    // SAFETY: as above; each cell has its depth as far from it as the first has.
    unsafe { perspective_tested(trapezoids, row, stride, &frame) };
}

/// Enters. r8 to r10: 1/w, u/w and v/w from pixel to pixel; r11: the run's end; r12: `corner`; lr: `shifts`. At the start of a
/// row r5 is the row, r6 and r7 are its sides. Stack, from 16 on: these three; at column 0 of the row, and from row to row,
/// depth, 1/w, u/w and v/w; `mask`, `texels` and `reciprocals`; depth from pixel to pixel; bytes to depths.
macro_rules! start {
    () => {
        concat!(
            enter!(104),
            "\nstr r1, [sp, #16]
             str r4, [sp, #20]
             str r6, [sp, #24]
             add r0, sp, #28
             ldmia r3!, {{r1, r2, r4-r7}}
             stmia r0!, {{r1, r2, r4-r7}}
             ldmia r3!, {{r1, r2, r4-r7}}
             stmia r0!, {{r1, r2, r4-r7}}
             ldmia r3!, {{r1, r2, r4-r7}}
             str r1, [r0]
             mov r8, r2
             mov r9, r4
             mov r10, r5
             mov r12, r6
             mov lr, r7
             add r0, sp, #12
             ldmia r0!, {{r4-r7}}
             cmp r4, r5
             bne 1f
             b 9f
             1:
             add r0, sp, #16
             stmia r0!, {{r5-r7}}
             asrs r0, r6, #20
             asrs r1, r7, #20
             subs r1, r1, r0
             bgt 2f
             b 7f
             2:",
        )
    };
}

/// A texel, 34 cycles: its reciprocal, and two products of 16 bits by 16.
macro_rules! texel {
    ($offset:literal) => {
        concat!(
            "lsrs r4, r1, #26
             lsls r4, r4, #2
             ldr r4, [r7, r4]
             lsrs r5, r1, #10
             uxth r6, r4
             muls r5, r6, r5
             subs r4, r4, r5
             lsrs r4, r4, #16
             lsrs r5, r2, #15
             muls r5, r4, r5
             lsrs r6, r3, #15
             muls r4, r6, r4\n",
            show!($offset),
        )
    };
}

/// Shows a texel and steps on. r4, r5: row and column, as products: the column goes above the row, is moved with it by the corner,
/// and is turned below it.
macro_rules! show {
    ($offset:literal) => {
        concat!(
            "mov r6, lr
             lsrs r5, r5, r6
             lsrs r4, r4, r6
             lsrs r6, r6, #8
             lsls r5, r5, r6
             orrs r4, r4, r5
             add r4, r12
             lsrs r6, r6, #8
             rors r4, r4, r6
             ldr r5, [sp, #60]
             ands r4, r4, r5
             ldr r5, [sp, #64]
             ldrh r4, [r5, r4]
             strh r4, [r0, #",
            $offset,
            "]
             add r1, r8
             add r2, r9
             add r3, r10\n"
        )
    };
}

/// Texels from r0 to r11, at least one; two at a time, beginning with the second where they are odd.
macro_rules! texels {
    () => {
        concat!(
            "ldr r4, [sp, #16]
             subs r4, r0, r4
             lsrs r4, r4, #1
             add r7, sp, #32
             ldmia r7!, {{r1-r3}}
             mov r5, r8
             muls r5, r4, r5
             adds r1, r1, r5
             mov r5, r9
             muls r5, r4, r5
             adds r2, r2, r5
             mov r5, r10
             muls r5, r4, r5
             adds r3, r3, r5
             ldr r7, [sp, #68]
             mov r4, lr
             lsrs r4, r4, #24
             beq 2f
             b 22f
             2:
             mov r4, r11
             subs r4, r4, r0
             lsls r4, r4, #30
             bpl 2f
             subs r0, r0, #2
             b 3f
             2:\n",
            texel!(0),
            "3:\n",
            texel!(2),
            "adds r0, r0, #4
             cmp r0, r11
             bne 2b
             23:"
        )
    };
}

/// The same of a triangle of two octaves, one at a time: 52 cycles. What is below 0 is 0, and in the lower one all is doubled.
macro_rules! two_octaves {
    () => {
        concat!(
            "22:
             lsls r4, r1, #2
             bcs 2f
             lsls r4, r4, #1
             2:
             lsrs r5, r4, #10
             lsrs r4, r4, #26
             lsls r4, r4, #2
             ldr r4, [r7, r4]
             uxth r6, r4
             muls r5, r6, r5
             subs r4, r4, r5
             lsrs r4, r4, #16
             lsrs r7, r1, #30
             adds r7, r7, #14
             mov r5, r2
             asrs r5, r5, r7
             asrs r6, r5, #31
             bics r5, r5, r6
             muls r5, r4, r5
             mov r6, r3
             asrs r6, r6, r7
             asrs r7, r6, #31
             bics r6, r6, r7
             muls r4, r6, r4
             ldr r7, [sp, #68]\n",
            show!(0),
            "adds r0, r0, #2
             cmp r0, r11
             bne 22b
             b 23b"
        )
    };
}

/// The next row.
macro_rules! step {
    () => {
        concat!(
            "add r0, sp, #28
             ldmia r0!, {{r1-r7}}
             adds r1, r1, r5
             adds r2, r2, r6
             adds r3, r3, r7
             ldr r5, [r0]
             adds r4, r4, r5
             add r0, sp, #28
             stmia r0!, {{r1-r4}}
             mov r0, sp
             ldmia r0!, {{r1-r7}}
             adds r5, r5, r3
             adds r6, r6, r1
             adds r7, r7, r2
             cmp r5, r4
             beq 9f
             b 1b\n",
            turn!(104, row: "r5", left: "r6", right: "r7"),
        )
    };
}

/// About 80 cycles a row, and 36 a pixel.
#[unsafe(naked)]
unsafe extern "C" fn perspective(_: &Trapezoids<ShortEdge>, row: *mut u16, stride: usize, frame: &Frame) {
    naked_asm!(
        start!(),
        "lsls r0, r0, #1
         adds r0, r0, r5
         lsls r1, r1, #1
         adds r1, r1, r0
         mov r11, r1",
        texels!(),
        "7:",
        step!(),
        two_octaves!(),
    )
}

/// About 120 cycles a row, and 47 a pixel that is visible: a run of them is found first and then painted.
#[unsafe(naked)]
unsafe extern "C" fn perspective_tested(
    _: &Trapezoids<ShortEdge>,
    row: *mut u16,
    stride: usize,
    frame: &Frame,
) {
    naked_asm!(
        start!(),
        first_run!(row: "r5", depth: 28, at: 72),
        visible!(72),
        texels!(),
        hidden!(72),
        "7:",
        step!(),
        two_octaves!(),
    )
}
