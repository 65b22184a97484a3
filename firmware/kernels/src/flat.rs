//! Flat rows.
#![expect(unsafe_code, reason = "assembly")]

use core::arch::naked_asm;

use topleft::stages::{ShortEdge, Trapezoids};

#[inline(always)]
pub(crate) fn draw(trapezoids: &Trapezoids<ShortEdge>, colours: *mut u16, stride: usize, colour: u16) {
    unsafe { flat(trapezoids, colours, stride, u32::from(colour) * 0x1_0001) };
}

#[unsafe(naked)]
unsafe extern "C" fn flat(trapezoids: &Trapezoids<ShortEdge>, row: *mut u16, stride: usize, colours: u32) {
    naked_asm!(
        "push {{r4-r7, lr}}",
        "mov r4, r8",
        "mov r5, r9",
        "mov r6, r10",
        "mov r7, r11",
        "push {{r4-r7}}",
        "mov r10, r2",
        "ldmia r0!, {{r4-r6}}", // top turn bottom
        "subs r6, r6, r5",
        "subs r5, r5, r4",
        "muls r5, r2, r5",
        "adds r5, r5, r1",
        "mov r11, r5",
        "muls r6, r2, r6",
        "adds r6, r6, r5",
        "mov lr, r6",
        "ldmia r0!, {{r4-r7}}",
        "mov r8, r5",
        "mov r9, r7",
        "mov r12, r0",
        "mov r0, r3",
        "mov r2, r4",
        "mov r3, r6",
        "adr r7, 70f",
        "b 8f",
        // row
        "1: asrs r4, r2, #20",
        "asrs r5, r3, #20",
        "cmp r4, r5",
        "bge 70f",
        "lsls r4, r4, #1",
        "adds r4, r4, r1",
        "lsls r5, r5, #1",
        "adds r5, r5, r1",
        // align
        "lsrs r6, r4, #2",
        "bcc 2f",
        "strh r0, [r4]",
        "adds r4, #2",
        "2: lsrs r6, r5, #2",
        "bcc 3f",
        "subs r5, #2",
        "strh r0, [r5]",
        "3: subs r5, r5, r4", // bytes, of whole words
        "lsrs r5, r5, #1",
        "subs r6, r7, r5",
        "mov pc, r6",
        ".p2align 2",
        "str r0, [r4, #60]",
        "str r0, [r4, #56]",
        "str r0, [r4, #52]",
        "str r0, [r4, #48]",
        "str r0, [r4, #44]",
        "str r0, [r4, #40]",
        "str r0, [r4, #36]",
        "str r0, [r4, #32]",
        "str r0, [r4, #28]",
        "str r0, [r4, #24]",
        "str r0, [r4, #20]",
        "str r0, [r4, #16]",
        "str r0, [r4, #12]",
        "str r0, [r4, #8]",
        "str r0, [r4, #4]",
        "str r0, [r4, #0]",
        "70:",
        "add r2, r8",
        "add r3, r9",
        "add r1, r10",
        "8: cmp r1, r11",
        "bne 1b",
        // lower
        "cmp r1, lr",
        "beq 6f",
        "mov r11, lr",
        "mov r6, r12",
        "ldmia r6!, {{r4, r5}}", // place slope
        "ldrb r6, [r6]",
        "cmp r6, #0",
        "beq 5f",
        "mov r3, r4",
        "mov r9, r5",
        "b 1b",
        "5: mov r2, r4",
        "mov r8, r5",
        "b 1b",
        "6: pop {{r4-r7}}",
        "mov r8, r4",
        "mov r9, r5",
        "mov r10, r6",
        "mov r11, r7",
        "pop {{r4-r7, pc}}",
    )
}
