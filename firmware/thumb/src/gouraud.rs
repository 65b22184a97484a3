//! Three channels, as RGB565 packs them: 16 fraction bits each in 64.
#![expect(unsafe_code, reason = "assembly: it relies on what `Rows` promises")]

use core::arch::naked_asm;

use topleft::stages::{Plane, Rows, ShortEdge, Stepped, Trapezoids};
use topleft::{Attribute, DepthCode};

use crate::walk::{Walk, ends, enter, keep, restore, turn};

type Channels = Plane<[Attribute; 3]>;

#[repr(C)]
struct Frame {
    depth: u32,
    depth_dy: u32,
    colour: u64,
    colour_dy: u64,
    to_depth: usize,
    depth_dx: u32,
    colour_dx: u64,
}

impl Frame {
    #[inline(always)]
    fn new(channels: &Channels, to_depth: usize, depth: u32, depth_dx: u32, depth_dy: u32) -> Self {
        let packed = Stepped::<u16>::new;
        let (colour, colour_dx, colour_dy) =
            (packed(channels.start), packed(channels.dx), packed(channels.dy));
        Self { depth, depth_dy, colour, colour_dy, to_depth, depth_dx, colour_dx }
    }
}

/// Whether planes fit their 64 bits at column 0, as they do at the pixels that are covered.
///
/// Red may wrap there, being on top. Blue and green are known modulo 2^32: they are what they are if from there to any pixel,
/// 32 rows and 2047 columns at most, they change by less than 2^30 + 2^23, as at pixels they are from 0 to 2^22.
#[inline(always)]
pub(crate) fn suits(channels: &Channels, width: usize) -> bool {
    let columns = if width < 2047 { width as u32 } else { 2047 };
    let changes = |dx: Attribute, dy: Attribute| {
        let [dx, dy] = [dx, dy].map(|step| step.to_bits().unsigned_abs() >> 12);
        dx * columns + dy * 32
    };
    let ([_, g_dx, b_dx], [_, g_dy, b_dy]) = (channels.dx, channels.dy);
    changes(g_dx, g_dy) < 1 << 18 && changes(b_dx, b_dy) < 1 << 18
}

#[inline(always)]
pub(crate) fn draw(rows: Rows<'_>, channels: &Channels) {
    let Walk { trapezoids, row, stride, .. } = Walk::new(rows);
    let frame = Frame::new(channels, 0, 0, 0, 0);
    // SAFETY: the cells are borrowed for all rows, and no row reaches beyond its cells.
    unsafe { gouraud(trapezoids, row, stride, &frame) };
}

#[inline(always)]
pub(crate) fn draw_tested(rows: Rows<'_>, depth: Plane<DepthCode>, channels: &Channels) {
    let Walk { trapezoids, row, stride, to_depth } = Walk::new(rows);
    let [depth, depth_dx, depth_dy] = [depth.start, depth.dx, depth.dy].map(DepthCode::to_bits);
    let frame = Frame::new(channels, to_depth, depth, depth_dx, depth_dy);
    // SAFETY: as above; each cell has its depth as far from it as the first has.
    unsafe { gouraud_tested(trapezoids, row, stride, &frame) };
}

/// About 75 cycles a row, and 19 a pixel and the test.
///
/// r0: the pixel; r1: bytes to depths; r2, r3: the colour, low and high; r4, r5: its step.
/// r8, r9: depth and step; r10: green where a pixel has it; r11: the row's end; r12, lr: sides. Stack, from 16 on: the row;
/// depth at its column 0, and from row to row; the colour in the same way; bytes to depths.
macro_rules! rows {
    ($test:literal) => {
        naked_asm!(
            enter!(56),
            "mov r12, r4
             mov lr, r6
             str r1, [sp, #16]
             add r0, sp, #20
             ldmia r3!, {{r4, r6, r7}}
             stmia r0!, {{r4, r6, r7}}
             ldmia r3!, {{r2, r4, r6, r7}}
             stmia r0!, {{r2, r4, r6, r7}}
             ldmia r3!, {{r0, r4, r6}}
             mov r9, r0
             movs r0, #0x7E
             lsls r0, r0, #4
             mov r10, r0
             mov r2, r1
             cmp r2, r5
             mov r5, r6
             beq 9f",
            "1:
             mov r0, r12
             asrs r0, r0, #20
             mov r1, lr
             asrs r1, r1, #20
             subs r1, r1, r0
             ble 4f
             add r7, sp, #16
             ldmia r7!, {{r3, r6}}
             lsls r2, r0, #1
             adds r3, r3, r2
             lsls r1, r1, #1
             adds r1, r1, r3
             mov r11, r1
             mov r1, r9
             muls r1, r0, r1
             adds r6, r6, r1
             mov r8, r6
             adds r7, r7, #4
             ldmia r7!, {{r2, r6}}",
            // A column's part of the colour: 64 bits by 16.
            "mov r1, r5
             muls r1, r0, r1
             adds r6, r6, r1
             uxth r1, r4
             muls r1, r0, r1
             lsrs r7, r4, #16
             muls r7, r0, r7
             movs r0, #0
             adds r2, r2, r1
             adcs r6, r6, r0
             lsls r1, r7, #16
             lsrs r7, r7, #16
             adds r2, r2, r1
             adcs r6, r6, r7
             mov r0, r3
             mov r3, r6
             ldr r1, [sp, #44]
             2:",
            $test,
            "mov r6, r10
             ands r6, r6, r3
             lsrs r7, r3, #27
             lsls r7, r7, #11
             orrs r6, r6, r7
             lsls r7, r2, #11
             lsrs r7, r7, #27
             orrs r6, r6, r7
             strh r6, [r0]
             3:
             adds r2, r2, r4
             adcs r3, r3, r5
             add r8, r9
             adds r0, r0, #2
             cmp r0, r11
             bne 2b
             4:
             mov r7, sp
             ldmia r7!, {{r0, r1, r2, r3, r6}}
             add r12, r0
             add lr, r1
             adds r2, r2, r6
             str r2, [sp, #16]
             ldmia r7!, {{r0, r1}}
             adds r0, r0, r1
             str r0, [sp, #20]
             ldmia r7, {{r0, r1, r6, r7}}
             adds r0, r0, r6
             adcs r1, r1, r7
             str r0, [sp, #28]
             str r1, [sp, #32]
             cmp r2, r3
             bne 1b",
            turn!(56, row: "r2", left: "r12", right: "lr"),
        )
    };
}

#[unsafe(naked)]
unsafe extern "C" fn gouraud(_: &Trapezoids<ShortEdge>, row: *mut u16, stride: usize, frame: &Frame) {
    rows!("")
}

#[unsafe(naked)]
unsafe extern "C" fn gouraud_tested(_: &Trapezoids<ShortEdge>, row: *mut u16, stride: usize, frame: &Frame) {
    rows!(
        "ldrh r6, [r0, r1]
         mov r7, r8
         lsrs r7, r7, #16
         cmp r6, r7
         bhs 3f
         strh r7, [r0, r1]"
    )
}
