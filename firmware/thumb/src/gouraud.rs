//! Three channels, each in a register, as depth is.
#![expect(unsafe_code, reason = "assembly: it relies on what `Rows` promises")]

use core::arch::naked_asm;
use core::mem::MaybeUninit;

use topleft::stages::{Plane, Rows, ShortEdge, Trapezoids};
use topleft::{Attribute, DepthCode};

use crate::walk::{Walk, keep, restore};

type Channels = Plane<[Attribute; 3]>;

/// Red, green, blue and depth. It is passed on the stack, and belongs to the kernel there.
#[repr(C)]
struct Frame {
    dy: [u32; 4],
    room: [MaybeUninit<u32>; 2],
    dx: [u32; 4],
    start: [u32; 4],
}

impl Frame {
    #[inline(always)]
    fn new(channels: &Channels, depth: Plane<DepthCode>) -> Self {
        let four = |channels: [Attribute; 3], depth: DepthCode| {
            let [r, g, b] = channels.map(|channel| channel.to_bits().cast_unsigned());
            [r, g, b, depth.to_bits()]
        };
        Self {
            dy: four(channels.dy, depth.dy),
            room: [MaybeUninit::uninit(); 2],
            dx: four(channels.dx, depth.dx),
            start: four(channels.start, depth.start),
        }
    }
}

#[cfg(narrow)]
#[inline(always)]
pub(crate) fn draw(rows: Rows<'_>, channels: &Channels) {
    let Walk { trapezoids, row, stride, .. } = Walk::new(rows);
    let none = DepthCode::from_bits(0);
    let frame = Frame::new(channels, Plane { start: none, dx: none, dy: none });
    // SAFETY: the cells are borrowed for all rows, and no row reaches beyond its cells or over more than 32 of them.
    unsafe { gouraud(trapezoids, row, stride, 0, frame) };
}

#[inline(always)]
pub(crate) fn draw_tested(rows: Rows<'_>, depth: Plane<DepthCode>, channels: &Channels) {
    let Walk { trapezoids, row, stride, to_depth } = Walk::new(rows);
    // SAFETY: the cells are borrowed for all rows, each has its depth as far from it as the first has, and no row reaches beyond
    // its cells or over more than 32 of them.
    unsafe { gouraud_tested(trapezoids, row, stride, to_depth, Frame::new(channels, depth)) };
}

/// About 60 cycles a row, and no loop in it: from the right, pixels stand in the code as they do in the row, and the first is
/// jumped to. So many bytes has one.
///
/// r0, r1: 64 bytes before the end of the row's pixels and of their depths; r2 to r5: red, green, blue and depth, whose
/// registers are kept from row to row: from the pixel behind a row to the next row's first, they are stepped at once.
/// r8 to r11: their steps; r12: 64 bytes before the row; lr: bytes to depths.
///
/// Stack: 0, the row after all, and where the lower side is; 8, where the last pixel's code ends; what [`keep`] keeps; 48,
/// steps from row to row; 64, bytes a row and the row that the sides end before; 72, left and right side, and slopes.
macro_rules! rows {
    ($bytes:literal, $test:literal, $step:literal) => {
        naked_asm!(
            keep!(),
            "mov lr, r3
             subs r1, r1, #64
             mov r12, r1
             add r7, sp, #60
             ldmia r7!, {{r3-r6}}
             mov r8, r3
             mov r9, r4
             mov r10, r5
             mov r11, r6
             subs r7, r7, #24
             ldmia r0!, {{r3-r5}}
             subs r5, r5, r4
             subs r4, r4, r3
             muls r4, r2, r4
             adds r4, r4, r1
             muls r5, r2, r5
             adds r5, r5, r4
             adr r6, 5f
             movs r3, #{bytes}
             lsls r3, r3, #5
             adds r6, r6, r3
             stmia r7!, {{r2, r4}}
             mov r2, r5
             mov r1, r4
             ldmia r0!, {{r3-r5, r7}}
             push {{r0, r6}}
             push {{r2}}
             add r6, sp, #72
             stmia r6!, {{r3-r5, r7}}
             ldmia r6!, {{r2-r5}}
             mov r0, r12
             add r7, sp, #72
             mov r6, r1
             b 7f
             .p2align 2
             5:
             .irp column, 0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30, 32, 34, 36, 38, 40, 42, 44, 46, 48, 50, 52, \
             54, 56, 58, 60, 62",
            $test,
            "lsrs r6, r2, #16
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
             add r4, r10",
            $step,
            ".endr",
            "4:
             add r7, sp, #48
             ldmia r7!, {{r1, r6}}
             adds r2, r2, r1
             adds r3, r3, r6
             ldmia r7!, {{r1, r6}}
             adds r4, r4, r1
             adds r5, r5, r6
             ldmia r7!, {{r1, r6}}
             adds r0, r0, r1
             add r12, r1
             7:
             cmp r12, r6
             beq 9f
             2:
             ldmia r7!, {{r1, r6}}
             adds r6, r6, r1
             str r6, [sp, #72]
             asrs r1, r1, #20
             ldmia r7, {{r6, r7}}
             adds r7, r7, r6
             str r7, [sp, #80]
             asrs r6, r6, #20
             subs r6, r6, r1
             ble 4b
             lsls r1, r1, #1
             add r1, r12
             subs r0, r1, r0
             asrs r0, r0, #1
             mov r7, r8
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
             adds r5, r5, r7
             lsls r7, r6, #1
             adds r0, r1, r7
             movs r7, #{bytes}
             muls r6, r7, r6
             ldr r7, [sp, #8]
             subs r7, r7, r6
             mov r1, r0
             add r1, lr
             mov pc, r7",
            // Where sides end: to the first row of the lower ones, or back to the caller.
            "9:
             ldr r1, [sp]
             cmp r12, r1
             beq 8f
             str r1, [sp, #68]
             ldr r1, [sp, #4]
             ldrb r6, [r1, #8]
             lsls r6, r6, #3
             add r7, sp, #72
             adds r7, r7, r6
             ldmia r1, {{r1, r6}}
             stmia r7!, {{r1, r6}}
             add r7, sp, #72
             b 2b
             8:
             add sp, #12",
            restore!(),
            bytes = const $bytes,
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
    frame: Frame,
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
    frame: Frame,
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
