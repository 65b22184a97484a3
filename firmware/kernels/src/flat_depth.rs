//! Flat rows with depth.
#![expect(unsafe_code, reason = "assembly")]

use core::arch::naked_asm;

use topleft::DepthCode;
use topleft::stages::{Plane, ShortEdge, Trapezoids};

#[repr(C)]
struct Frame {
    start: i32,
    dx: i32,
    colour: u32,
    dy: i32,
    to_depths: usize,
}

#[inline(always)]
pub(crate) fn draw(
    trapezoids: &Trapezoids<ShortEdge>,
    colours: *mut u16,
    stride: usize,
    depths: *mut u16,
    depth: &Plane<DepthCode>,
    colour: u16,
) {
    let frame = Frame {
        start: depth.start.to_bits().cast_signed(),
        dx: depth.dx.to_bits().cast_signed(),
        colour: colour.into(),
        dy: depth.dy.to_bits().cast_signed(),
        to_depths: (depths as usize).wrapping_sub(colours as usize),
    };
    unsafe { flat_depth(trapezoids, colours, stride, &frame) };
}

#[unsafe(naked)]
unsafe extern "C" fn flat_depth(
    trapezoids: &Trapezoids<ShortEdge>,
    row: *mut u16,
    stride: usize,
    frame: &Frame,
) {
    naked_asm!(
        "push {{r4-r7, lr}}",
        "mov r4, r8",
        "mov r5, r9",
        "mov r6, r10",
        "mov r7, r11",
        "push {{r4-r7}}",
        "mov r10, r1",
        "ldmia r0!, {{r4-r6}}", // top turn bottom
        "subs r6, r6, r5",
        "subs r5, r5, r4",
        "muls r5, r2, r5",
        "adds r5, r5, r1",
        "muls r6, r2, r6",
        "adds r6, r6, r5",
        "mov lr, r6",
        "ldmia r0!, {{r1, r4, r6, r7}}",
        "mov r8, r1",
        "mov r9, r6",
        "mov r12, r0", // lower
        "mov r0, r4",
        "mov r1, r7",
        "ldmia r3!, {{r4, r7}}", // start dx
        "mov r11, r4",
        "ldmia r3!, {{r4, r6}}",  // colour dy
        "ldr r3, [r3]",           // to depths
        "push {{r0-r2, r5, r6}}", // slopes stride end dy
        "mov r0, r12",
        "push {{r0}}",
        "mov r12, r3",
        "mov r3, r7",
        "cmp r10, r5",
        "beq 9f",
        // row
        "1: mov r0, r8",
        "asrs r0, r0, #20",
        "mov r1, r9",
        "asrs r1, r1, #20",
        "subs r6, r0, r1",
        "bge 7f",
        "mov r2, r0",
        "muls r2, r3, r2",
        "add r2, r11",
        "lsls r1, r1, #1",
        "add r1, r10",
        "mov r0, r1",
        "add r0, r12",
        "lsls r6, r6, #1",
        "2: ldrh r5, [r0, r6]",
        "lsrs r7, r2, #16",
        "cmp r5, r7",
        "bhs 3f",
        "strh r7, [r0, r6]",
        "strh r4, [r1, r6]",
        "3: adds r2, r2, r3",
        "adds r6, #2",
        "bne 2b",
        "7: add r7, sp, #4",
        "ldmia r7!, {{r0, r1, r2, r5, r6}}", // slopes stride end depth_dy
        "add r8, r0",
        "add r9, r1",
        "add r10, r2",
        "add r11, r6",
        "cmp r10, r5",
        "bne 1b",
        // lower
        "9: cmp r10, lr",
        "beq 6f",
        "mov r0, lr",
        "str r0, [sp, #16]",
        "ldr r0, [sp]",
        "ldmia r0!, {{r1, r2}}",
        "ldrb r0, [r0]",
        "cmp r0, #0",
        "beq 5f",
        "mov r9, r1",
        "str r2, [sp, #8]",
        "b 1b",
        "5: mov r8, r1",
        "str r2, [sp, #4]",
        "b 1b",
        "6: add sp, #24",
        "pop {{r4-r7}}",
        "mov r8, r4",
        "mov r9, r5",
        "mov r10, r6",
        "mov r11, r7",
        "pop {{r4-r7, pc}}",
    )
}
