//! Texels that are linear on the screen, of a texture that repeats.
#![expect(unsafe_code, reason = "assembly: it relies on what `Rows` promises")]

use topleft::stages::{Plane, Rows, ShortEdge, Trapezoids};
use topleft::{Attribute, DepthCode, Texture};

use crate::single_pass::{Frame, single_pass};
use crate::walk::Walk;

type Texels = Plane<[Attribute; 2]>;

/// What r2 to r5 begin with.
#[repr(C)]
struct Low {
    /// 31 less the power of two that the width is, and twice one less than there are texels.
    above: u32,
    mask: u32,
    texels: *const u16,
    /// The texel's row, or depth where there is one.
    fourth: u32,
}

impl Low {
    #[inline(always)]
    fn new(texture: &Texture<'_>) -> Self {
        Self {
            above: 31 - texture.width().trailing_zeros(),
            mask: 2 * (texture.texels().len() as u32 - 1),
            texels: texture.texels().as_ptr(),
            fourth: 0,
        }
    }

    /// A texel's column and row. Columns stand at the top of 32 bits, which keep those of the texture and lose what repeats it.
    #[inline(always)]
    fn bits(&self, [u, v]: &[Attribute; 2]) -> [u32; 2] {
        [u.to_bits().cast_unsigned() << (self.above - 15), v.to_bits().cast_unsigned()]
    }
}

#[inline(always)]
pub(crate) fn draw(rows: Rows<'_>, texture: &Texture<'_>, texels: &Texels) {
    let Walk { trapezoids, row, stride, .. } = Walk::new(rows);
    let low = Low::new(texture);
    let [u, v] = low.bits(&texels.start);
    let [u_dx, v_dx] = low.bits(&texels.dx);
    let [u_dy, v_dy] = low.bits(&texels.dy);
    let frame = Frame::new([u_dy, v_dy, 0, 0], [u, 0, u_dx, v_dx], Low { fourth: v, ..low });
    // SAFETY: the cells are borrowed for all rows, and no row reaches beyond its cells or over more than 32 of them, as the
    // jump into the code has it; the mask keeps texels in the texture, which has a power of two of them, 2^10 a side at most.
    unsafe { affine(trapezoids, row, stride, 0, frame) };
}

#[inline(always)]
pub(crate) fn draw_tested(rows: Rows<'_>, depth: Plane<DepthCode>, texture: &Texture<'_>, texels: &Texels) {
    let Walk { trapezoids, row, stride, to_depth } = Walk::new(rows);
    let low = Low::new(texture);
    let [u, v] = low.bits(&texels.start);
    let [u_dx, v_dx] = low.bits(&texels.dx);
    let [u_dy, v_dy] = low.bits(&texels.dy);
    let [z, z_dx, z_dy] = [depth.start, depth.dx, depth.dy].map(DepthCode::to_bits);
    let frame = Frame::new([u_dy, v_dy, z_dy, to_depth as u32], [u, v, u_dx, v_dx], Low { fourth: z, ..low });
    // SAFETY: as above; each cell has its depth as far from it as the first has.
    unsafe { affine_tested(trapezoids, row, stride, z_dx, frame) };
}

/// A texel, 8 cycles: its row is in r6, turned to above the column, and the mask takes what repeats the texture. r2 to r4: `above`,
/// `mask` and `texels`; r8: the column; r10, r11: steps of column and row.
macro_rules! texel {
    () => {
        "
         mov r7, r8
         lsrs r7, r7, r2
         orrs r6, r6, r7
         ands r6, r6, r3
         ldrh r6, [r4, r6]
         strh r6, [r0, #\\column]
         "
    };
}

/// About 55 cycles a row, and 12 a pixel. r5: the texel's row.
#[unsafe(naked)]
unsafe extern "C" fn affine(
    _: &Trapezoids<ShortEdge>,
    row: *mut u16,
    stride: usize,
    _: u32,
    frame: Frame<Low>,
) {
    single_pass!(
        bytes: 20,
        pixel: concat!(
            "lsrs r6, r5, #16
             rors r6, r6, r2",
            texel!(),
            "add r8, r10
             add r5, r11",
        ),
        down:
            "ldmia r7!, {{r1, r6}}
             add r8, r1
             adds r5, r5, r6
             adds r7, r7, #8",
        along:
            "mov r7, r10
             muls r7, r0, r7
             add r8, r7
             mov r7, r11
             muls r7, r0, r7
             adds r5, r5, r7",
        depths: "",
        fourth: "movs r7, #0",
    )
}

/// About 65 cycles a row, and 21 a pixel that is visible. r5: depth; r9: the texel's row; lr: depth's step.
#[unsafe(naked)]
unsafe extern "C" fn affine_tested(
    _: &Trapezoids<ShortEdge>,
    row: *mut u16,
    stride: usize,
    z_dx: u32,
    frame: Frame<Low>,
) {
    single_pass!(
        bytes: 34,
        pixel: concat!(
            "ldrh r6, [r1, #\\column]
             lsrs r7, r5, #16
             cmp r6, r7
             bhs 3f
             strh r7, [r1, #\\column]
             mov r6, r9
             lsrs r6, r6, #16
             rors r6, r6, r2",
            texel!(),
            "3:
             add r8, r10
             add r9, r11
             add r5, lr",
        ),
        down:
            "ldmia r7!, {{r1, r6}}
             add r8, r1
             add r9, r6
             ldmia r7!, {{r1, r6}}
             adds r5, r5, r1",
        along:
            "mov r7, r10
             muls r7, r0, r7
             add r8, r7
             mov r7, r11
             muls r7, r0, r7
             add r9, r7
             mov r7, lr
             muls r7, r0, r7
             adds r5, r5, r7",
        depths:
            "ldr r1, [sp, #60]
             adds r1, r1, r0",
        fourth: "ldr r7, [sp, #72]",
    )
}
