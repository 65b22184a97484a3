//! Texels that are linear on the screen, of a texture that repeats.
#![expect(unsafe_code, reason = "assembly: it relies on what `Rows` promises")]

use core::arch::naked_asm;

use topleft::stages::{Plane, Rows, ShortEdge, Trapezoids};
use topleft::{Attribute, DepthCode, Texture};

use crate::walk::{Walk, ends, enter, first_run, hidden, keep, restore, turn, visible};

type Texels = Plane<[Attribute; 2]>;

#[repr(C)]
struct Frame {
    texel: [i32; 2],
    texel_dy: [i32; 2],
    /// 31 less the power of two that the width is, and twice one less than there are texels.
    above: u32,
    mask: u32,
    texels: *const u16,
    depth: u32,
    depth_dy: u32,
    depth_dx: u32,
    to_depth: usize,
    texel_dx: [i32; 2],
}

impl Frame {
    #[inline(always)]
    fn new(
        texture: &Texture<'_>,
        texels: &Texels,
        to_depth: usize,
        [depth, depth_dx, depth_dy]: [u32; 3],
    ) -> Self {
        let bits = |[u, v]: [Attribute; 2]| [u.to_bits(), v.to_bits()];
        Self {
            texel: bits(texels.start),
            texel_dy: bits(texels.dy),
            above: 31 - texture.width().trailing_zeros(),
            mask: 2 * (texture.texels().len() as u32 - 1),
            texels: texture.texels().as_ptr(),
            depth,
            depth_dy,
            depth_dx,
            to_depth,
            texel_dx: bits(texels.dx),
        }
    }
}

#[inline(always)]
pub(crate) fn draw(rows: Rows<'_>, texture: &Texture<'_>, texels: &Texels) {
    let Walk { trapezoids, row, stride, .. } = Walk::new(rows);
    let frame = Frame::new(texture, texels, 0, [0; 3]);
    // SAFETY: the cells are borrowed for all rows, and no row reaches beyond its cells; the mask keeps texels in the texture,
    // which has a power of two of them, 2^10 a side at most.
    unsafe { affine(trapezoids, row, stride, &frame) };
}

#[inline(always)]
pub(crate) fn draw_tested(rows: Rows<'_>, depth: Plane<DepthCode>, texture: &Texture<'_>, texels: &Texels) {
    let Walk { trapezoids, row, stride, to_depth } = Walk::new(rows);
    let depth = [depth.start, depth.dx, depth.dy].map(DepthCode::to_bits);
    let frame = Frame::new(texture, texels, to_depth, depth);
    // SAFETY: as above; each cell has its depth as far from it as the first has.
    unsafe { affine_tested(trapezoids, row, stride, &frame) };
}

/// Enters. r8, r9: the texel from pixel to pixel; r10: the row; r11: the run's end; r12, lr: sides. Stack, from 16 on: the
/// texel at column 0 of the row, and from row to row; `above`, `mask` and `texels`; depth at column 0 of the row, from row to
/// row and from pixel to pixel; bytes to depths.
macro_rules! start {
    () => {
        concat!(
            enter!(84),
            "\nmov r12, r4
             mov lr, r6
             mov r10, r1
             add r0, sp, #16
             ldmia r3!, {{r1, r2, r4, r6, r7}}
             stmia r0!, {{r1, r2, r4, r6, r7}}
             ldmia r3!, {{r1, r2, r4, r6, r7}}
             stmia r0!, {{r1, r2, r4, r6, r7}}
             ldmia r3!, {{r1, r2, r4}}
             str r1, [r0]
             mov r8, r2
             mov r9, r4
             add r7, sp, #32
             mov r4, r5
             ldmia r7, {{r5-r7}}
             cmp r10, r4
             beq 9f"
        )
    };
}

/// A texel, 12 cycles: its column stands above its row, and is turned below it.
macro_rules! texel {
    ($offset:literal) => {
        concat!(
            "lsrs r3, r2, #16
             lsrs r4, r1, #15
             lsls r4, r4, r5
             orrs r3, r3, r4
             rors r3, r3, r5
             ands r3, r3, r6
             ldrh r3, [r7, r3]
             strh r3, [r0, #",
            $offset,
            "]
             add r1, r8
             add r2, r9\n"
        )
    };
}

/// Texels from r0 to r11, at least one, the first of them in column r3; two at a time, beginning with the second where they
/// are odd. r5 to r7: `above`, `mask` and `texels`.
macro_rules! texels {
    () => {
        concat!(
            "ldr r1, [sp, #16]
             mov r4, r8
             muls r4, r3, r4
             adds r1, r1, r4
             ldr r2, [sp, #20]
             mov r4, r9
             muls r4, r3, r4
             adds r2, r2, r4
             mov r3, r11
             subs r3, r3, r0
             lsls r3, r3, #30
             bpl 2f
             subs r0, r0, #2
             b 3f
             2:\n",
            texel!(0),
            "3:\n",
            texel!(2),
            "adds r0, r0, #4
             cmp r0, r11
             bne 2b"
        )
    };
}

/// The next row.
macro_rules! step {
    () => {
        concat!(
            "mov r4, sp
             ldmia r4!, {{r0-r3}}
             add r12, r0
             add lr, r1
             add r10, r2
             ldmia r4, {{r0, r1, r2, r4}}
             adds r0, r0, r2
             adds r1, r1, r4
             str r0, [sp, #16]
             str r1, [sp, #20]
             cmp r10, r3
             bne 1b\n",
            turn!(84, row: "r10", left: "r12", right: "lr"),
        )
    };
}

/// About 60 cycles a row, and 14 a pixel.
#[unsafe(naked)]
unsafe extern "C" fn affine(_: &Trapezoids<ShortEdge>, row: *mut u16, stride: usize, frame: &Frame) {
    naked_asm!(
        start!(),
        "1:
         mov r3, r12
         asrs r3, r3, #20
         mov r1, lr
         asrs r1, r1, #20
         subs r1, r1, r3
         ble 4f
         lsls r0, r3, #1
         add r0, r10
         lsls r1, r1, #1
         adds r1, r1, r0
         mov r11, r1",
        texels!(),
        "4:",
        step!(),
    )
}

/// About 100 cycles a row, and 25 a pixel that is visible: a run of them is found first and then painted.
#[unsafe(naked)]
unsafe extern "C" fn affine_tested(_: &Trapezoids<ShortEdge>, row: *mut u16, stride: usize, frame: &Frame) {
    naked_asm!(
        start!(),
        "1:
         mov r0, r12
         asrs r0, r0, #20
         mov r1, lr
         asrs r1, r1, #20
         subs r1, r1, r0
         ble 7f",
        first_run!(row: "r10", depth: 44, at: 52),
        visible!(52),
        "mov r2, r10
         subs r3, r0, r2
         lsrs r3, r3, #1
         add r7, sp, #32
         ldmia r7, {{r5-r7}}",
        texels!(),
        hidden!(52),
        "7:
         ldr r0, [sp, #44]
         ldr r1, [sp, #48]
         adds r0, r0, r1
         str r0, [sp, #44]",
        step!(),
    )
}
