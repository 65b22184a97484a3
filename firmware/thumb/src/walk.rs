//! The walk from row to row, which kernels have in common.
//!
//! They are called with the triangle's [`Trapezoids`], its first row, the bytes from a row to the next, and a frame of their
//! own. On the stack they have, in words: the slopes of the left and the right side, the bytes from a row to the next, the
//! row that these sides end before; what a kernel has itself; and at last the row after all, and where the lower side is.

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

pub(crate) use {ends, enter, first_run, hidden, keep, restore, turn, visible};
