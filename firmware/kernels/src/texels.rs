//! Rows of texels, with depth or without.
#![expect(unsafe_code, reason = "assembly")]

use core::arch::naked_asm;

use topleft::stages::{Plane, ShortEdge, Trapezoids};
use topleft::{Attribute, DepthCode, Texture};

#[repr(C)]
pub(crate) struct Frame {
    // Each row: 20
    start: [i32; 2],
    dy: [i32; 2],
    // 36
    above: u32,
    mask: u32,
    texels: *const u16,
    // 48
    depth: i32,
    depth_dy: i32,
    depth_dx: i32,
    to_depths: usize,
    // 64
    dx: [i32; 2],
}

pub(crate) type Texels = Plane<[Attribute; 2]>;

impl Frame {
    #[inline(always)]
    fn new(texture: &Texture<'_>, texels: &Texels) -> Self {
        let bits = |[u, v]: [Attribute; 2]| [u.to_bits(), v.to_bits()];
        Self {
            start: bits(texels.start),
            dy: bits(texels.dy),
            above: 31 - texture.width().trailing_zeros(),
            mask: 2 * (texture.texels().len() as u32 - 1),
            texels: texture.texels().as_ptr(),
            depth: 0,
            depth_dy: 0,
            depth_dx: 0,
            to_depths: 0,
            dx: bits(texels.dx),
        }
    }
}

#[inline(always)]
pub(crate) fn draw(
    trapezoids: &Trapezoids<ShortEdge>,
    colours: *mut u16,
    stride: usize,
    texture: &Texture<'_>,
    texels: &Texels,
) {
    unsafe { affine(trapezoids, colours, stride, &Frame::new(texture, texels)) };
}

#[inline(always)]
pub(crate) fn draw_depth(
    trapezoids: &Trapezoids<ShortEdge>,
    colours: *mut u16,
    stride: usize,
    depths: *mut u16,
    depth: &Plane<DepthCode>,
    texture: &Texture<'_>,
    texels: &Texels,
) {
    let frame = Frame {
        depth: depth.start.to_bits().cast_signed(),
        depth_dy: depth.dy.to_bits().cast_signed(),
        depth_dx: depth.dx.to_bits().cast_signed(),
        to_depths: (depths as usize).wrapping_sub(colours as usize),
        ..Frame::new(texture, texels)
    };
    unsafe { affine_depth(trapezoids, colours, stride, &frame) };
}

/// Stack: 0 slopes, 8 stride, 12 end, 16 bottom, 20 texels, 28 dy, 36 above, 40 mask, 44 texels, 48 depth, 52 dy, 56 dx,
/// 60 to depths, 64 lower, 68 end of the row, 72 place in it, 76 index, 80 depth there.
///
/// r8, r9: steps; r10: row; r11: end; r12, lr: sides.
macro_rules! enter {
    () => {
        "
        push {{r4-r7, lr}}
        mov r4, r8
        mov r5, r9
        mov r6, r10
        mov r7, r11
        push {{r4-r7}}
        mov r10, r1
        ldmia r0!, {{r4-r6}}
        subs r6, r6, r5
        subs r5, r5, r4
        muls r5, r2, r5
        adds r5, r5, r1
        muls r6, r2, r6
        adds r6, r6, r5
        sub sp, #84
        str r2, [sp, #8]
        str r5, [sp, #12]
        str r6, [sp, #16]
        ldmia r0!, {{r4-r7}}
        mov r12, r4
        mov lr, r6
        str r5, [sp, #0]
        str r7, [sp, #4]
        str r0, [sp, #64]
        add r0, sp, #20
        ldmia r3!, {{r4-r7}}
        stmia r0!, {{r4-r7}}
        ldmia r3!, {{r5-r7}}
        stmia r0!, {{r5-r7}}
        ldmia r3!, {{r1, r2, r4}}
        stmia r0!, {{r1, r2, r4}}
        ldmia r3!, {{r1, r2, r4}}
        stmia r0!, {{r1}}
        mov r8, r2
        mov r9, r4
        ldr r3, [sp, #12]
        cmp r10, r3
        beq 9f
        "
    };
}

/// From r0 to r11, r3 is the column of the first.
macro_rules! texels {
    () => {
        "
        ldr r1, [sp, #20]
        mov r4, r8
        muls r4, r3, r4
        adds r1, r1, r4
        ldr r2, [sp, #24]
        mov r4, r9
        muls r4, r3, r4
        adds r2, r2, r4
        mov r3, r11
        subs r3, r3, r0
        lsls r3, r3, #30
        bpl 2f
        subs r0, #2
        b 3f
        2:
        lsrs r3, r2, #16
        lsrs r4, r1, #15
        lsls r4, r5
        orrs r3, r4
        rors r3, r5
        ands r3, r6
        ldrh r3, [r7, r3]
        strh r3, [r0]
        add r1, r8
        add r2, r9
        3:
        lsrs r3, r2, #16
        lsrs r4, r1, #15
        lsls r4, r5
        orrs r3, r4
        rors r3, r5
        ands r3, r6
        ldrh r3, [r7, r3]
        strh r3, [r0, #2]
        add r1, r8
        add r2, r9
        adds r0, #4
        cmp r0, r11
        bne 2b
        "
    };
}

macro_rules! next_row {
    () => {
        "
        mov r4, sp
        ldmia r4!, {{r0-r3}}
        add r12, r0
        add lr, r1
        add r10, r2
        adds r4, #4
        ldmia r4, {{r0, r1, r2, r4}}
        adds r0, r0, r2
        adds r1, r1, r4
        str r0, [sp, #20]
        str r1, [sp, #24]
        cmp r10, r3
        bne 1b
        9:
        ldr r3, [sp, #16]
        cmp r10, r3
        beq 8f
        str r3, [sp, #12]
        ldr r0, [sp, #64]
        ldmia r0!, {{r1, r2}}
        ldrb r0, [r0]
        cmp r0, #0
        beq 6f
        mov lr, r1
        str r2, [sp, #4]
        b 1b
        6:
        mov r12, r1
        str r2, [sp, #0]
        b 1b
        8:
        add sp, #84
        pop {{r4-r7}}
        mov r8, r4
        mov r9, r5
        mov r10, r6
        mov r11, r7
        pop {{r4-r7, pc}}
        "
    };
}

#[unsafe(naked)]
unsafe extern "C" fn affine(trapezoids: &Trapezoids<ShortEdge>, row: *mut u16, stride: usize, frame: &Frame) {
    naked_asm!(
        enter!(),
        "
        1:
        mov r3, r12
        asrs r3, r3, #20
        mov r1, lr
        asrs r1, r1, #20
        subs r1, r1, r3
        ble 7f
        lsls r0, r3, #1
        add r0, r10
        lsls r1, r1, #1
        adds r1, r1, r0
        mov r11, r1
        ",
        texels!(),
        "7:",
        next_row!(),
    )
}

#[unsafe(naked)]
unsafe extern "C" fn affine_depth(
    trapezoids: &Trapezoids<ShortEdge>,
    row: *mut u16,
    stride: usize,
    frame: &Frame,
) {
    naked_asm!(
        enter!(),
        "
        1:
        mov r0, r12
        asrs r0, r0, #20
        mov r1, lr
        asrs r1, r1, #20
        subs r1, r1, r0
        ble 7f
        lsls r3, r0, #1
        add r3, r10
        lsls r1, r1, #1
        adds r1, r1, r3
        ldr r4, [sp, #56]
        muls r0, r4, r0
        ldr r2, [sp, #48]
        adds r2, r2, r0
        ldr r0, [sp, #60]
        adds r0, r0, r1
        str r1, [sp, #68]
        4:
        str r3, [sp, #72]
        subs r1, r3, r1
        2:
        ldrh r3, [r0, r1]
        lsrs r5, r2, #16
        cmp r3, r5
        bhs 3f
        strh r5, [r0, r1]
        adds r2, r2, r4
        adds r1, #2
        bne 2b
        3:
        str r1, [sp, #76]
        str r2, [sp, #80]
        ldr r0, [sp, #72]
        ldr r2, [sp, #68]
        adds r2, r2, r1
        cmp r2, r0
        beq 5f
        mov r11, r2
        mov r2, r10
        subs r3, r0, r2
        lsrs r3, r3, #1
        add r7, sp, #36
        ldmia r7, {{r5-r7}}
        ",
        texels!(),
        "
        ldr r1, [sp, #76]
        cmp r1, #0
        beq 7f
        5:
        ldr r3, [sp, #68]
        ldr r0, [sp, #60]
        adds r0, r0, r3
        ldr r2, [sp, #80]
        ldr r4, [sp, #56]
        2:
        ldrh r3, [r0, r1]
        lsrs r5, r2, #16
        cmp r3, r5
        blo 3f
        adds r2, r2, r4
        adds r1, #2
        bne 2b
        b 7f
        3:
        mov r3, r1
        ldr r1, [sp, #68]
        adds r3, r3, r1
        b 4b
        7:
        ldr r0, [sp, #48]
        ldr r1, [sp, #52]
        adds r0, r0, r1
        str r0, [sp, #48]
        ",
        next_row!(),
    )
}
