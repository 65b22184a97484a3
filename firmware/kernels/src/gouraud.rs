//! Rows of three channels, with depth or without.
#![expect(unsafe_code, reason = "assembly")]

use core::arch::naked_asm;

use topleft::stages::{Plane, ShortEdge, Stepped, Trapezoids};
use topleft::{Attribute, DepthCode};

#[repr(C)]
pub(crate) struct Frame {
    start: i32,
    dy: i32,
    colour: u64,
    colour_dy: u64,
    to_depths: usize,
    dx: i32,
    colour_dx: u64,
}

pub(crate) type Channels = Plane<[Attribute; 3]>;

impl Frame {
    #[inline(always)]
    fn new(channels: &Channels) -> Self {
        let packed = Stepped::<u16>::new;
        Self {
            start: 0,
            dy: 0,
            colour: packed(channels.start),
            colour_dy: packed(channels.dy),
            to_depths: 0,
            dx: 0,
            colour_dx: packed(channels.dx),
        }
    }
}

#[inline(always)]
pub(crate) fn draw(
    trapezoids: &Trapezoids<ShortEdge>,
    colours: *mut u16,
    stride: usize,
    channels: &Channels,
) {
    unsafe { gouraud(trapezoids, colours, stride, &Frame::new(channels)) };
}

#[inline(always)]
pub(crate) fn draw_depth(
    trapezoids: &Trapezoids<ShortEdge>,
    colours: *mut u16,
    stride: usize,
    depths: *mut u16,
    depth: &Plane<DepthCode>,
    channels: &Channels,
) {
    let frame = Frame {
        start: depth.start.to_bits().cast_signed(),
        dx: depth.dx.to_bits().cast_signed(),
        dy: depth.dy.to_bits().cast_signed(),
        to_depths: (depths as usize).wrapping_sub(colours as usize),
        ..Frame::new(channels)
    };
    unsafe { gouraud_depth(trapezoids, colours, stride, &frame) };
}

macro_rules! rows {
    ($($test:literal)*) => {
        naked_asm!(
            "push {{r4-r7, lr}}",
            "mov r4, r8", "mov r5, r9", "mov r6, r10", "mov r7, r11",
            "push {{r4-r7}}",
            "ldmia r0!, {{r4-r6}}", // top turn bottom
            "subs r6, r6, r5", "subs r5, r5, r4",
            "muls r5, r2, r5", "adds r5, r5, r1",
            "muls r6, r2, r6", "adds r6, r6, r5",
            "sub sp, #64",
            "str r1, [sp, #8]", "str r2, [sp, #12]", "str r5, [sp, #16]", "str r6, [sp, #48]",
            "ldmia r0!, {{r4-r7}}", // places and slopes
            "mov r12, r4", "mov lr, r6",
            "str r5, [sp, #0]", "str r7, [sp, #4]",
            "str r0, [sp, #52]",
            "add r0, sp, #20",
            "ldmia r3!, {{r4-r7}}", "stmia r0!, {{r4-r7}}", // start dy colour
            "ldmia r3!, {{r4-r7}}", "stmia r0!, {{r4-r6}}", // colour_dy to_depths
            "mov r9, r7",
            "ldmia r3!, {{r4, r5}}",
            "movs r7, #0x7E", "lsls r7, r7, #4", "mov r10, r7",
            "ldr r2, [sp, #8]", "ldr r6, [sp, #16]",
            "cmp r2, r6",
            "beq 9f",
            // row
            "1: mov r0, r12", "asrs r0, r0, #20",
            "mov r1, lr", "asrs r1, r1, #20",
            "subs r1, r1, r0",
            "ble 7f",
            "ldr r3, [sp, #8]", "lsls r2, r0, #1", "adds r3, r3, r2", // from
            "lsls r1, r1, #1", "adds r1, r1, r3", "mov r11, r1", // to
            "add r7, sp, #20",
            "ldmia r7!, {{r1, r2}}", // depth at column 0
            "mov r6, r9", "muls r6, r0, r6", "adds r1, r1, r6", "mov r8, r1",
            "ldmia r7!, {{r2, r6}}", // colour there
            "mov r1, r5", "muls r1, r0, r1", "adds r6, r6, r1",
            "uxth r1, r4", "muls r1, r0, r1",
            "lsrs r7, r4, #16", "muls r7, r0, r7",
            "adds r2, r2, r1", "movs r1, #0", "adcs r6, r6, r1",
            "lsls r1, r7, #16", "lsrs r7, r7, #16",
            "adds r2, r2, r1", "adcs r6, r6, r7",
            "mov r0, r3", "mov r3, r6",
            "ldr r1, [sp, #44]",
            "2:",
            $($test,)*
            "mov r6, r10", "ands r6, r3",
            "lsrs r7, r3, #27", "lsls r7, r7, #11", "orrs r6, r7",
            "lsls r7, r2, #11", "lsrs r7, r7, #27", "orrs r6, r7",
            "strh r6, [r0]",
            "3: adds r2, r2, r4", "adcs r3, r5",
            "add r8, r9",
            "adds r0, #2",
            "cmp r0, r11",
            "bne 2b",
            // next row
            "7: mov r7, sp",
            "ldmia r7!, {{r0, r1, r2, r3, r6}}", // slopes row stride end
            "add r12, r0", "add lr, r1", "adds r2, r2, r3", "str r2, [sp, #8]",
            "ldmia r7!, {{r0, r1}}", "adds r0, r0, r1", "str r0, [sp, #20]",
            "ldmia r7, {{r0, r1, r3, r7}}",
            "adds r0, r0, r3", "adcs r1, r7", "str r0, [sp, #28]", "str r1, [sp, #32]",
            "cmp r2, r6",
            "bne 1b",
            // lower
            "9: ldr r6, [sp, #48]", "cmp r2, r6", "beq 6f",
            "str r6, [sp, #16]",
            "ldr r0, [sp, #52]",
            "ldmia r0!, {{r1, r2}}",
            "ldrb r0, [r0]",
            "cmp r0, #0", "beq 5f",
            "mov lr, r1", "str r2, [sp, #4]", "b 1b",
            "5: mov r12, r1", "str r2, [sp, #0]", "b 1b",
            "6: add sp, #64",
            "pop {{r4-r7}}",
            "mov r8, r4", "mov r9, r5", "mov r10, r6", "mov r11, r7",
            "pop {{r4-r7, pc}}",
        )
    };
}

#[unsafe(naked)]
unsafe extern "C" fn gouraud(
    trapezoids: &Trapezoids<ShortEdge>,
    row: *mut u16,
    stride: usize,
    frame: &Frame,
) {
    rows!()
}

#[unsafe(naked)]
unsafe extern "C" fn gouraud_depth(
    trapezoids: &Trapezoids<ShortEdge>,
    row: *mut u16,
    stride: usize,
    frame: &Frame,
) {
    rows!(
        "ldrh r6, [r0, r1]"
        "mov r7, r8"
        "lsrs r7, r7, #16"
        "cmp r6, r7"
        "bhs 3f"
        "strh r7, [r0, r1]"
    )
}
