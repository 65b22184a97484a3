//! One colour.
#![expect(unsafe_code, reason = "assembly: it relies on what `Rows` promises")]

use core::arch::naked_asm;

use topleft::DepthCode;
use topleft::stages::{Plane, Rows, ShortEdge, Trapezoids};

use crate::walk::{Walk, ends, enter, keep, restore, turn};

#[inline(always)]
pub(crate) fn draw(rows: Rows<'_>, colour: u16) {
    let Walk { trapezoids, row, stride, .. } = Walk::new(rows);
    // SAFETY: the cells are borrowed for all rows, and no row reaches beyond its cells or over more than 32 of them.
    unsafe { flat(trapezoids, row, stride, u32::from(colour) * 0x1_0001) };
}

/// About 32 cycles a row, and one a pixel: two are stored at once.
///
/// r0: the colour, twice; r1: the row; r2, r3: its sides; r7: where stores end.
/// r8, r9: slopes; r10: bytes a row; r11: the row that the sides end before; r12: the lower side; lr: the row after all.
#[unsafe(naked)]
unsafe extern "C" fn flat(_: &Trapezoids<ShortEdge>, row: *mut u16, stride: usize, colours: u32) {
    naked_asm!(
        keep!(),
        "mov r10, r2",
        ends!(),
        "mov r11, r5
         mov lr, r6
         ldmia r0!, {{r4-r7}}
         mov r8, r5
         mov r9, r7
         mov r12, r0
         mov r0, r3
         mov r2, r4
         mov r3, r6
         adr r7, 5f
         b 6f",
        // A row: its first and last pixel by themselves where they share a word with others.
        "1:
         asrs r4, r2, #20
         asrs r5, r3, #20
         cmp r4, r5
         bge 5f
         lsls r4, r4, #1
         adds r4, r4, r1
         lsls r5, r5, #1
         adds r5, r5, r1
         lsrs r6, r4, #2
         bcc 2f
         strh r0, [r4]
         adds r4, r4, #2
         2:
         lsrs r6, r5, #2
         bcc 3f
         subs r5, r5, #2
         strh r0, [r5]
         3:
         subs r5, r5, r4",
        // So many words before the last store: an instruction has two bytes, a word four.
        "lsrs r5, r5, #1
         subs r6, r7, r5
         mov pc, r6
         .p2align 2
         str r0, [r4, #60]
         str r0, [r4, #56]
         str r0, [r4, #52]
         str r0, [r4, #48]
         str r0, [r4, #44]
         str r0, [r4, #40]
         str r0, [r4, #36]
         str r0, [r4, #32]
         str r0, [r4, #28]
         str r0, [r4, #24]
         str r0, [r4, #20]
         str r0, [r4, #16]
         str r0, [r4, #12]
         str r0, [r4, #8]
         str r0, [r4, #4]
         str r0, [r4, #0]
         5:
         add r2, r8
         add r3, r9
         add r1, r10
         6:
         cmp r1, r11
         bne 1b",
        // The lower sides.
        "cmp r1, lr
         beq 8f
         mov r11, lr
         mov r6, r12
         ldmia r6!, {{r4, r5}}
         ldrb r6, [r6]
         cmp r6, #0
         beq 7f
         mov r3, r4
         mov r9, r5
         b 1b
         7:
         mov r2, r4
         mov r8, r5
         b 1b
         8:",
        restore!(),
    )
}

#[repr(C)]
struct Tested {
    depth_dy: u32,
    depth: u32,
    depth_dx: u32,
    colour: u32,
    to_depth: usize,
}

#[inline(always)]
pub(crate) fn draw_tested(rows: Rows<'_>, depth: Plane<DepthCode>, colour: u16) {
    let Walk { trapezoids, row, stride, to_depth } = Walk::new(rows);
    let [depth, depth_dx, depth_dy] = [depth.start, depth.dx, depth.dy].map(DepthCode::to_bits);
    let frame = Tested { depth_dy, depth, depth_dx, colour: colour.into(), to_depth };
    // SAFETY: as above; each cell has its depth as far from it as the first has, and no row reaches over more than 32 of them.
    unsafe { flat_tested(trapezoids, row, stride, &frame) };
}

/// About 33 cycles a row, and 10 a pixel that is visible, without a loop: from the right, pixels stand in the code as they do in
/// the row, and the first is jumped to.
///
/// r0, r1: 64 bytes before the end of the row's depths and of its colours; r2, r3: depth and step; r4: the colour. r8, r9: sides;
/// r10: the row; r11: depth at its column 0; r12: bytes to depths; lr: where the last pixel's code ends. Stack, from 16 on: depth
/// from row to row.
#[unsafe(naked)]
unsafe extern "C" fn flat_tested(_: &Trapezoids<ShortEdge>, row: *mut u16, stride: usize, frame: &Tested) {
    naked_asm!(
        enter!(28),
        "mov r8, r4
         mov r9, r6
         mov r10, r1
         ldmia r3!, {{r0, r1, r2, r4, r6}}
         str r0, [sp, #16]
         mov r11, r1
         mov r3, r2
         mov r12, r6
         adr r7, 4f
         mov lr, r7
         b 5f
         .p2align 2
         .irp column, 0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30, 32, 34, 36, 38, 40, 42, 44, 46, 48, 50, 52, 54, \
         56, 58, 60, 62
         ldrh r5, [r0, #\\column]
         lsrs r7, r2, #16
         cmp r5, r7
         bhs 3f
         strh r7, [r0, #\\column]
         strh r4, [r1, #\\column]
         3:
         adds r2, r2, r3
         .endr
         4:
         mov r7, sp
         ldmia r7!, {{r0, r1, r2, r5, r6}}
         add r8, r0
         add r9, r1
         add r10, r2
         add r11, r6
         5:
         cmp r10, r5
         beq 9f",
        "1:
         mov r0, r8
         asrs r0, r0, #20
         mov r1, r9
         asrs r1, r1, #20
         subs r6, r0, r1
         bge 4b
         muls r0, r3, r0
         mov r2, r11
         adds r2, r2, r0
         lsls r1, r1, #1
         add r1, r10
         subs r1, r1, #64
         mov r0, r1
         add r0, r12
         movs r7, #14
         muls r6, r7, r6
         add r6, lr
         mov pc, r6",
        turn!(28, row: "r10", left: "r8", right: "r9"),
    )
}
