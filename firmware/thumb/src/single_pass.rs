//! Kernels in a single pass without a loop over pixels, which keep what they step in registers.

use core::mem::MaybeUninit;

/// What such a kernel is called with on the stack, where it belongs to the kernel.
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

/// How many pixels stand in the code: all that a row may have, or half of them on the narrowest cores, whose chips have the least
/// flash. A wider row is two there, and takes about 65 cycles more.
pub(crate) const PIXELS: u32 = if cfg!(narrow) { 16 } else { 32 };

/// All of a kernel. From the right, pixels stand in the code as they do in the row, and the first is jumped to. `bytes` has one,
/// `pixel`, which is `\\column` bytes from its pointers, and ends at 3 where it tests. Values stay in registers from row to row:
/// behind a row's last pixel, `down` steps them a row, and `along` so many columns as the next row's first one is from there.
///
/// r0: `2 * PIXELS` bytes before the end of the row's pixels, and r1 of their depths, where `depths` sets it; r12: as many before
/// the row. r2 to r5, r8 to r11 and lr are the kernel's, as its frame and its fourth argument have them.
/// `pixel` may change r6 and r7; `down` r1, r6, and r7, which goes from the frame's first word to behind its fourth; `along` r7, with
/// the columns in r0; `depths` r1.
///
/// Stack: 0, the row after all, and where the lower side is; 8, where the last pixel's code ends; what [`keep`] keeps; 48, the
/// steps from row to row; 64, bytes a row and the row that the sides end before; 72, left and right side, and slopes. Of the
/// steps, the fourth may be something else, which `fourth` loads into r7; or else that is 0.
///
/// It is entered with no row wider than 32 pixels: else it jumped to before its code.
macro_rules! single_pass {
    (
        bytes: $bytes:literal,
        pixel: $pixel:expr,
        down: $down:expr,
        along: $along:expr,
        depths: $depths:expr,
        fourth: $fourth:expr $(,)?
    ) => {
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
            // Of a wider row, the first pixels, with a frame that has no steps, 0 bytes a row, and sides that end at this one: they
            // come to 9 as they are, and back for the rest, whose number is behind that frame.
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
            pixels = const $crate::single_pass::PIXELS,
            log2 = const $crate::single_pass::PIXELS.ilog2(),
        )
    };
}

pub(crate) use single_pass;
