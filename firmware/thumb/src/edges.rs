//! The sides of a triangle, from its vertices.
#![expect(unsafe_code, reason = "assembly: it relies on what `SmallTriangle` promises")]

use core::arch::naked_asm;

use topleft::stages::{FoundSides, Setup, ShortEdge, SmallTriangle};

#[inline(always)]
pub(crate) fn sides<'t>(triangle: &SmallTriangle<'t>) -> FoundSides<'t> {
    let rows = triangle.rows();
    // SAFETY: it reads the triangle and the table, and writes what it returns: the sides of this triangle. Its heights are from 4
    // to 2^13, so that the search for their highest bit ends.
    unsafe { found(triangle.setup(), rows.start, rows.end, ShortEdge::reciprocals()) }
}

/// About 120 cycles, and 70 an edge.
///
/// Stack: 0, where sides are written; 4, the triangle; 8, the centre of a row, in steps of 1/256 px; 12, where the upper side
/// is written; 16, reciprocals.
#[unsafe(naked)]
unsafe extern "C" fn found<'t>(_: &'t Setup, top: i32, bottom: i32, _: &[u16; 65]) -> FoundSides<'t> {
    naked_asm!(
        "push {{r4-r7, lr}}
         mov r4, r3
         ldr r3, [r1, #12]
         adds r3, r3, #127
         asrs r3, r3, #8
         cmp r3, r2
         bge 1f
         mov r3, r2
         1:
         cmp r3, r4
         ble 1f
         mov r3, r4
         1:
         stmia r0!, {{r2-r4}}
         ldr r7, [sp, #20]
         lsls r2, r2, #8
         adds r2, r2, #128
         push {{r0-r3, r7}}
         movs r4, #1
         lsls r4, r4, #15
         mov r12, r4
         ldmia r1!, {{r2, r3}}
         ldr r4, [r1, #8]
         ldr r5, [r1, #12]
         bl 5f",
        // The long side is the left one where the area is not less than 0.
        "ldr r0, [sp, #0]
         ldr r6, [sp, #4]
         ldr r4, [r6, #28]
         lsrs r4, r4, #31
         movs r5, #1
         eors r5, r5, r4
         strb r5, [r0, #24]
         lsls r4, r4, #3
         adds r4, r4, r0
         stmia r4!, {{r1, r2}}
         lsls r5, r5, #3
         adds r5, r5, r0
         subs r0, r0, #12
         ldmia r0!, {{r3, r4}}
         cmp r3, r4
         bge 1f
         str r5, [sp, #12]
         ldmia r6!, {{r2-r5}}
         bl 5f
         ldr r5, [sp, #12]
         ldr r0, [sp, #0]
         subs r0, r0, #4
         1:
         stmia r5!, {{r1, r2}}
         subs r0, r0, #4
         ldmia r0!, {{r5, r6}}
         cmp r5, r6
         bge 1f
         lsls r5, r5, #8
         adds r5, r5, #128
         str r5, [sp, #8]
         ldr r6, [sp, #4]
         adds r6, r6, #8
         ldmia r6!, {{r2-r5}}
         bl 5f
         ldr r0, [sp, #0]
         1:
         str r1, [r0, #16]
         str r2, [r0, #20]
         add sp, #20
         pop {{r4-r7, pc}}",
        // An edge, from column r2 and row r3 to column r4 and row r5: its place to r1, and its slope to r2. What it is, and why,
        // is in `ShortEdge`; here r0 is the reciprocal, r3 the way down, r4 and r5 the edge's width and height, r7 the shift.
        "5:
         subs r4, r4, r2
         subs r5, r5, r3
         ldr r6, [sp, #8]
         subs r3, r6, r3
         movs r7, #10
         lsls r6, r5, #19
         bmi 7f
         6:
         subs r7, r7, #1
         lsls r6, r6, #1
         bpl 6b
         7:
         lsls r1, r6, #1
         lsrs r1, r1, #26
         lsls r1, r1, #1
         ldr r0, [sp, #16]
         adds r1, r1, r0
         ldrh r0, [r1]
         ldrh r1, [r1, #2]
         subs r1, r0, r1
         lsls r6, r6, #7
         lsrs r6, r6, #26
         muls r6, r1, r6
         adds r6, r6, #32
         lsrs r6, r6, #6
         subs r0, r0, r6
         add r0, r12",
        "adds r2, r2, #128
         mov r1, r2
         muls r1, r5, r1
         mov r6, r3
         muls r6, r4, r6
         adds r1, r1, r6
         subs r1, r1, #1
         uxtb r1, r1
         movs r6, #127
         subs r1, r6, r1
         muls r1, r0, r1
         asrs r1, r1, #6
         asrs r1, r1, r7
         lsls r2, r2, #12
         adds r1, r1, r2",
        "mov r2, r4
         muls r2, r0, r2
         lsls r2, r2, #2
         asrs r2, r2, r7
         muls r5, r2, r5
         lsls r4, r4, #20
         subs r4, r4, r5
         asrs r4, r4, #6
         muls r4, r0, r4
         asrs r4, r4, #12
         asrs r4, r4, r7
         adds r2, r2, r4
         asrs r4, r2, #8
         muls r4, r3, r4
         adds r1, r1, r4
         uxtb r4, r2
         muls r4, r3, r4
         asrs r4, r4, #8
         adds r1, r1, r4
         bx lr",
    )
}
