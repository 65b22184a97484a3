//! The walk from row to row, which kernels have in common.
//!
//! They are called with the triangle's [`Trapezoids`], its first row, the bytes from a row to the next, and a frame of their
//! own. On the stack they have, in words: the slopes of the left and the right side, the bytes from a row to the next, the
//! row that these sides end before; what a kernel has itself; and at last the row after all, and where the lower side is.

use core::mem::MaybeUninit;

use topleft::stages::{Rows, ShortEdge, Trapezoids};

/// What kernels are called with, but for their own frame.
pub(crate) struct Walk<'r> {
    pub(crate) trapezoids: &'r Trapezoids<ShortEdge>,
    pub(crate) row: *mut u16,
    pub(crate) stride: usize,
    /// Bytes from a pixel's colour to its depth.
    pub(crate) to_depth: usize,
}

impl<'r> Walk<'r> {
    #[inline(always)]
    pub(crate) fn new(rows: Rows<'r>) -> Self {
        let (trapezoids, stride) = (rows.trapezoids(), 2 * rows.width());
        let (colours, depths) = rows.into_cells();
        let (row, depths) = (colours.as_mut_ptr(), depths.as_mut_ptr());
        Self { trapezoids, row, stride, to_depth: (depths as usize).wrapping_sub(row as usize) }
    }
}

/// Keeps the registers that a caller has something in.
macro_rules! keep {
    () => {
        "push {{r4-r7, lr}}
         mov r4, r8
         mov r5, r9
         mov r6, r10
         mov r7, r11
         push {{r4-r7}}"
    };
}

/// Brings them back, and returns.
macro_rules! restore {
    () => {
        "pop {{r4-r7}}
         mov r8, r4
         mov r9, r5
         mov r10, r6
         mov r11, r7
         pop {{r4-r7, pc}}"
    };
}

/// From r0 to r2, as called: in r5 the row that the upper sides end before, in r6 the row after all, and in r0 the left side.
macro_rules! ends {
    () => {
        "ldmia r0!, {{r4-r6}}
         subs r6, r6, r5
         subs r5, r5, r4
         muls r5, r2, r5
         adds r5, r5, r1
         muls r6, r2, r6
         adds r6, r6, r5"
    };
}

/// Makes room on the stack for so many bytes, and puts all there but what a kernel has itself: r4 and r6 are the sides in the
/// first row, r5 is the row that they end before.
macro_rules! enter {
    ($bytes:literal) => {
        concat!(
            keep!(),
            "\nsub sp, #",
            $bytes,
            "\n",
            ends!(),
            "\nstr r2, [sp, #8]
             str r5, [sp, #12]
             str r6, [sp, #",
            $bytes,
            " - 8]
             mov r2, r5
             ldmia r0!, {{r4-r7}}
             str r5, [sp, #0]
             str r7, [sp, #4]
             str r0, [sp, #",
            $bytes,
            " - 4]
             mov r5, r2"
        )
    };
}

/// Where sides end: to the first row of the lower ones, at 1, or back to the caller.
macro_rules! turn {
    ($bytes:literal, row: $row:literal, left: $left:literal, right: $right:literal) => {
        concat!(
            "9:
             ldr r0, [sp, #",
            $bytes,
            " - 8]
             cmp ",
            $row,
            ", r0
             beq 8f
             str r0, [sp, #12]
             ldr r0, [sp, #",
            $bytes,
            " - 4]
             ldmia r0!, {{r1, r2}}
             ldrb r0, [r0]
             cmp r0, #0
             beq 6f
             mov ",
            $right,
            ", r1
             str r2, [sp, #4]
             b 1b
             6:
             mov ",
            $left,
            ", r1
             str r2, [sp, #0]
             b 1b
             8:
             add sp, #",
            $bytes,
            "\n",
            restore!(),
        )
    };
}

/// What a kernel in a single pass is called with, on the stack: it belongs to the kernel there.
#[repr(C)]
pub(crate) struct Frame<Low> {
    down: [u32; 4],
    room: [MaybeUninit<u32>; 2],
    high: [u32; 4],
    low: Low,
}

impl<Low> Frame<Low> {
    /// What rows are stepped by, what r8 to r11 begin with, and, of four words, what r2 to r5 do.
    #[inline(always)]
    pub(crate) fn new(down: [u32; 4], high: [u32; 4], low: Low) -> Self {
        const { assert!(size_of::<Low>() == 16) };
        Self { down, room: [MaybeUninit::uninit(); 2], high, low }
    }
}

/// How many pixels stand in the code of a kernel in a single pass: all that a row may have, or half of them where flash is small,
/// as on chips with the narrowest cores. There a wider row is two.
pub(crate) const PIXELS: u32 = if cfg!(narrow) { 16 } else { 32 };

/// A kernel without a loop over pixels: from the right, they stand in the code as they do in the row, and the first is jumped to.
/// `bytes` has one, `pixel`, which has its column from `\\column`. Its values stay in registers from row to row: behind a row's
/// last pixel, `down` steps them a row, and `along` so many columns as the next row's first one is from there.
///
/// r0: 64 bytes before the end of the row's pixels, and r1 of their depths, where `depths` sets it; r12: 64 bytes before the row.
/// r2 to r5, r8 to r11 and lr are the kernel's, as its frame and its fourth argument have them; r6 and r7 are free in `pixel`.
/// `down` has r1 and r6, and the frame's first word at r7, which it leaves behind the fourth; `along` has the columns in r0, and
/// r7; `depths` has r1.
///
/// Stack: 0, the row after all, and where the lower side is; 8, where the last pixel's code ends; what [`keep`] keeps; 48, the
/// steps from row to row; 64, bytes a row and the row that the sides end before; 72, left and right side, and slopes.
macro_rules! single_pass {
    (bytes: $bytes:literal, pixel: $pixel:expr, down: $down:expr, along: $along:expr, depths: $depths:expr, fourth: $fourth:expr $(,)?) => {
        core::arch::naked_asm!(
            $crate::walk::keep!(),
            "mov lr, r3
             subs r1, r1, #2 * {pixels}
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
             lsls r3, r3, #{log2}
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
             54, 56, 58, 60, 62
             .if \\column < 2 * {pixels}",
            $pixel,
            ".endif
             .endr
             4:
             add r7, sp, #48",
            $down,
            "ldmia r7!, {{r1, r6}}
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
             .if {pixels} < 32
             cmp r6, #{pixels}
             bhi 6f
             .endif
             3:
             lsls r1, r1, #1
             add r1, r12
             subs r0, r1, r0
             asrs r0, r0, #1",
            $along,
            "1:
             lsls r7, r6, #1
             adds r0, r1, r7
             movs r7, #{bytes}
             muls r6, r7, r6
             ldr r7, [sp, #8]
             subs r7, r7, r6",
            $depths,
            "mov pc, r7",
            // Of a wider row, its first pixels, with a frame that steps by nothing and ends with this row: so it comes to 9 as it
            // is, for the rest, whose number is behind that frame.
            ".if {pixels} < 32
             6:
             subs r6, r6, #{pixels}
             push {{r6}}
             movs r6, #0
             mov r7, r12
             push {{r6, r7}}",
            $fourth,
            "push {{r6, r7}}
             movs r7, #0
             push {{r6, r7}}
             ldr r7, [sp, #36]
             sub sp, #48
             str r7, [sp, #8]
             movs r6, #{pixels}
             b 3b
             6:
             add sp, #72
             pop {{r6}}
             mov r1, r0
             b 1b
             .endif",
            // Where sides end: to the first row of the lower ones, or back to the caller.
            "9:
             .if {pixels} < 32
             cmp r1, #0
             beq 6b
             .endif
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
            $crate::walk::restore!(),
            bytes = const $bytes,
            pixels = const $crate::walk::PIXELS,
            log2 = const $crate::walk::PIXELS.ilog2(),
        )
    };
}

/// The first run of a row that is tested: from column r0 on, r1 columns. `depth` is where on the stack depth at column 0 is, and
/// from `at` on it has depth from pixel to pixel and the bytes to depths; then the row's end, a run's start, what is left of the
/// row behind it, and depth there.
macro_rules! first_run {
    (row: $row:literal, depth: $depth:literal, at: $at:literal) => {
        concat!(
            "lsls r3, r0, #1
             add r3, ",
            $row,
            "
             lsls r1, r1, #1
             adds r1, r1, r3
             ldr r4, [sp, #",
            $at,
            "]
             muls r0, r4, r0
             ldr r2, [sp, #",
            $depth,
            "]
             adds r2, r2, r0
             ldr r0, [sp, #",
            $at,
            " + 4]
             adds r0, r0, r1
             str r1, [sp, #",
            $at,
            " + 8]"
        )
    };
}

/// Finds a run that is visible, from r3 on, and sets its depths: r0 is where the row's depths end, r1 where its cells do, r2 and
/// r4 are depth and its step. Then the run is from r0 to r11, at least one pixel, or the next that are hidden follow.
macro_rules! visible {
    ($at:literal) => {
        concat!(
            "4:
             str r3, [sp, #",
            $at,
            " + 12]
             subs r1, r3, r1
             2:
             ldrh r3, [r0, r1]
             lsrs r5, r2, #16
             cmp r3, r5
             bhs 3f
             strh r5, [r0, r1]
             adds r2, r2, r4
             adds r1, r1, #2
             bne 2b
             3:
             str r1, [sp, #",
            $at,
            " + 16]
             ldr r3, [sp, #",
            $at,
            " + 8]
             adds r3, r3, r1
             mov r11, r3
             ldr r0, [sp, #",
            $at,
            " + 12]
             cmp r3, r0
             beq 5f
             str r2, [sp, #",
            $at,
            " + 20]"
        )
    };
}

/// Passes over what is hidden behind a run: to the row's end, at 7, or to where a run starts again.
macro_rules! hidden {
    ($at:literal) => {
        concat!(
            "ldr r1, [sp, #",
            $at,
            " + 16]
             cmp r1, #0
             beq 7f
             ldr r2, [sp, #",
            $at,
            " + 20]
             ldr r4, [sp, #",
            $at,
            "]
             5:
             ldr r0, [sp, #",
            $at,
            " + 8]
             ldr r3, [sp, #",
            $at,
            " + 4]
             adds r0, r0, r3
             2:
             ldrh r3, [r0, r1]
             lsrs r5, r2, #16
             cmp r3, r5
             blo 3f
             adds r2, r2, r4
             adds r1, r1, #2
             bne 2b
             b 7f
             3:
             mov r3, r1
             ldr r1, [sp, #",
            $at,
            " + 8]
             adds r3, r3, r1
             b 4b"
        )
    };
}

pub(crate) use {ends, enter, first_run, hidden, keep, restore, single_pass, turn, visible};
