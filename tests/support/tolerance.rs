//! Every error that the tests allow, with where it comes from. Nothing here was read off a result.
//!
//! Steps are of the format named; a screen step is 1/256 px. `half(n)` is 2^-n.

/// 2^-n.
pub(crate) const fn half(n: u32) -> f64 {
    1.0 / (1_u64 << n) as f64
}

// Interpolation. A gradient is rounded to half a step, so n columns and m rows from the anchor are off by (n + m) / 2;
// the start adds half a step for its own rounding and at most half for the gradients' over half a pixel each way. The
// reciprocal of the area is right to 2^-30 and scales the plane about its first vertex: 2^-30 of the difference D.

/// Of a plane with `bits` fraction bits, `steps` = n + m pixels from its anchor, over vertices that differ by `range`.
pub(crate) fn interpolation(bits: u32, steps: u64, range: f64) -> f64 {
    (steps + 2) as f64 * half(bits + 1) + range * half(30)
}

/// A looser bound, for the record: what separate truncation of the numerators would add, the slope over the box.
pub(crate) fn interpolation_by_design(bits: u32, steps: u64, range: f64, over_the_box: f64) -> f64 {
    (steps + 2) as f64 * half(bits + 1) + (range + over_the_box) * half(30)
}

/// The least share of its bound that the worst of some thousand triangles must reach, or the test is not a hard one:
/// rounding errors are uniform, and one in eight pairs of them has both above a half with one sign.
pub(crate) const REACHED: f64 = 0.5;

// Colours, in codes of 255.

/// Of a channel that a display of `max` steps shows, where it is off by `steps` of them before it is rounded: half a step for
/// that, and a code in steps is rounded down to 2^-16 of one, 255 times.
pub(crate) fn shown(max: f64, steps: f64) -> f64 {
    (0.5 + 255.0 * half(16) + steps) * 255.0 / max
}

/// The same before it is shown, where it is interpolated `steps` pixels from the anchor over vertices that differ by `range` of
/// the display's steps: each difference of two vertices is rounded down to 2^-8, the reciprocal is right to 2^-15, and gradients
/// to a step of 2^-16, the start as well.
pub(crate) fn channel(steps: u64, range: f64) -> f64 {
    half(8) + range * half(15) + (steps + 1) as f64 * half(16)
}

/// The middle of two channels, rounded down: in steps of the display's.
pub(crate) const MIDDLE: f64 = half(17);

// Texels, per pixel. In units of the triangle's box of texels, U.

/// Of a reciprocal r of x, from 1 to 2: the chord lies up to 2^-14 above, and the table is rounded by half a step of 2^-16
/// of r, 2^-16 at most. Below, that half step and a whole one of interpolation, 3 x 2^-17; and u / w loses up to a step of
/// its 17 bits times r, 2^-15 / x: together no more than 2^-14.
pub(crate) const RECIPROCAL: f64 = half(14) + half(16);
/// The same by division: 2^-16 above, as x has 17 bits; below a step of 2^-16 of r, and what u / w loses as before.
pub(crate) const DIVIDED: f64 = 3.0 * half(16);
/// 1/w of a vertex: a mantissa of 26 bits, rounded down, of a reciprocal that is right to 2^-27.9.
pub(crate) const VERTEX_INVERSE: f64 = half(25) + half(27);
/// u/w at a vertex: its part of the box and the product are each rounded down to 2^-31; and 1/w once more.
pub(crate) const OVER_W: f64 = 3.0 * half(31);

/// A vertex whose 1/w would be a power of two less a step has 2^-18 less of it. A share l of it changes a texel by
/// l (1 - l) of that.
pub(crate) const GREATEST: f64 = half(20);

/// A texel of a box of one unit, where the triangle's 1/w is `q` of the power of two above its largest.
pub(crate) fn per_pixel(steps: u64, q: f64) -> f64 {
    // Both u/w and 1/w are interpolated, over at most 1; their errors are divided by 1/w.
    let carried = 2.0 * interpolation(31, steps, 1.0) + OVER_W;
    carried / (q - carried) + VERTEX_INVERSE + GREATEST + RECIPROCAL
}

/// Of a texel between two exact ones that are `texels` and a ratio of w apart, `ends` being what those are off by in a box
/// of `unit` texels: what affine is off by between them; a step that is rounded down, for 32 pixels; and one over their
/// number, right to 2^-16.
pub(crate) fn subspan(texels: f64, ratio: f64, unit: f64, ends: f64) -> f64 {
    affine(texels, ratio) + unit * (ends + half(16)) + 32.0 * half(16)
}

/// What a caller allows, where `ends` as above is at most 2^-13: `Within` counts that for the ends. What is more is no part
/// of what it promises; nor is what a plane of linear texels is off by, from 0 to `range`.
pub(crate) fn within(error: f64, unit: f64, ends: f64, steps: u64, range: f64) -> f64 {
    let more = unit * (ends - half(13)).max(0.0);
    (error + more).max(unit * ends) + interpolation(16, steps, range)
}

/// Of a texel where nothing is corrected, on a triangle that spans `texels` and a ratio of w.
///
/// Along a line with w from 1 to r, perspective shows `s / (s + r (1 - s))` where linear shows s. They differ most at
/// `s = sqrt(r) / (sqrt(r) + 1)`, by the value below; no inner point of a triangle is worse than its worst line.
pub(crate) fn affine(texels: f64, ratio: f64) -> f64 {
    texels * (ratio.sqrt() - 1.0) / (ratio.sqrt() + 1.0)
}

/// What is promised of a texture of 256 texels at a w ratio of 64.
pub(crate) const SIXTEENTH: f64 = 1.0 / 16.0;

// Depth, in codes. 65528 of them between the planes.

/// A vertex: 1/w is right to 2^-27.9 = 1.07 2^-28, and 1 - z/w, the margin and the end of its range are each rounded
/// down by a step of 2^-16.
pub(crate) const DEPTH_VERTEX: f64 = 65_528.0 * 1.08 * half(28) + 3.0 * half(16);

// Depth as a small float. The plane below it is given in 2^-16 of its range, as codes of the other are.

/// In codes, of `nearness` = 1 - z / w, `steps` pixels from the anchor of a plane over vertices that differ by `range`. A
/// code is rounded down from what `code` makes of it, whose slope is greater below than above.
pub(crate) fn float_depth(code: fn(f64) -> f64, nearness: f64, steps: u64, range: f64) -> f64 {
    let off = (interpolation(16, steps, 65_536.0 * range) + DEPTH_VERTEX * 65_536.0 / 65_528.0) * half(16);
    code(nearness) - code(nearness - off)
}

// The transform.

/// Of a clip coordinate: `factors` is the largest camera element times the largest of the pose, `largest` the largest
/// coordinate in the mesh's cube.
///
/// The pose is right to 1.5 * 2^-30 an element, and 4 x 4 of them are summed. In steps of 2^-29 of the largest, for four
/// columns: 2 of the product, 4 of x and y in units of the reach, 4 of the common power of two; 3 for the products with
/// a position, 3 for a clipped vertex.
pub(crate) fn clip(factors: f64, largest: f64) -> f64 {
    24.0 * half(30) * factors + 16.0 * half(29) * largest
}

/// Of a corner, or of what clipping makes of it, where the mesh's cube is the scene's from -1 to 1 and has no pose: then the
/// product of matrices is exact. In steps of 2^-29 of `largest`; no coordinate has more than 2 of those 2^29 steps.
///
/// Of the corner 11: 4 of x and y in units of the reach, 4 of the common power of two, 3 for the products with a position.
/// A cut is at 30 fraction bits of the edge, a quarter of a step off for operands of 33 bits and rounded down: the ends
/// differ by 2^31 or less, 2.5 steps, and half a step is the rounding of each coordinate. Each of six planes moves what is
/// left by those 3; and 3 beyond the plane.
pub(crate) const CUT: i64 = 11 + 6 * 3 + 3;

/// Of the place of a mesh whose box is not centred: its turned centre is rounded to a `Length` on three axes. To be
/// multiplied by the largest camera element.
pub(crate) const TURNED_CENTRE: f64 = 3.0 * half(17);

/// What 1/w (2^-27.9) does to a place in the guard rectangle, at most 1024 + 512 px from the centre: in screen steps.
pub(crate) const PERSPECTIVE_DIVIDE: f64 = 1536.0 * 256.0 * 1.08 * half(28);

/// The same for 1/256 px in integers: half a step of rounding, and `PERSPECTIVE_DIVIDE`, which is less than another half.
pub(crate) const ROUNDED: i64 = 1;

/// Of a vertex on the screen in steps: `clip` is the error of x, y (in units of the reach, pixels) and w.
pub(crate) fn vertex_on_screen(clip: f64, w: f64, reach: f64, from_centre: f64) -> f64 {
    256.0 * (reach + from_centre) * clip / w + PERSPECTIVE_DIVIDE
}

/// Of an edge of a flat drawing that is clipped at the guard rectangle, in steps: both ends are rounded to half a step
/// on each axis, twice where they are cut in x and in y, and an edge moves no further than its ends: sqrt 2 steps.
pub(crate) const FLAT_CLIPPED: f64 = 1.415;

// Light, in codes of 255 for full diffuse light.

/// Of a cosine: the direction is rounded down to 2^-15 on three axes (times at most 1.74 together for a unit normal,
/// 3.03 for the longest), the sum to 2^-15 and the quotient by 127 to 2^-15 and 2^-14 of a value up to 1.74.
pub(crate) const COSINE: f64 = 3.03 * half(15) + 2.0 * half(15) + 1.74 * half(14);
/// Of light: the cosine, and a step of 8 fraction bits.
pub(crate) const LIGHT: f64 = 255.0 * COSINE + half(8);
/// Of a lit colour of 8 bits: the light, and rounding to nearest.
pub(crate) const LIT: f64 = LIGHT + 0.5;
/// A normal that is rounded to 127 steps: half a step on three axes, times a direction whose parts add up to sqrt 3.
pub(crate) const PLANE_NORMAL: f64 = 255.0 * 1.733 * 0.5 / 127.0;
/// Light in 64 steps: the light itself; 257/4 for 256 * 64 / 255, 2^-16 short, and a step of 2^-16.
pub(crate) const LIGHT_STEPS: f64 = LIGHT * 64.0 / 255.0 + 64.0 * half(16) + half(16);

// Cameras and angles.

/// A sine: 15 bits rounded to nearest, 2^-16, and the chord `(pi / 512)^2 / 8` = 2^-17.7 below the arc.
pub(crate) const SINE: f64 = half(16) + 4.71e-6;
/// A float of the camera: the unit vector is right to 2^-22, and a product or sum of three adds some 2^-24.
pub(crate) const CAMERA: f64 = half(21);

/// Where the bounds of `docs/measured/accuracy.csv` come from, by its columns `stage` and `metric`. What the names in
/// them are is derived above.
pub(crate) const DERIVED: [(&str, &str, &str); 23] = [
    ("coverage", "mismatches", "exact: the reference counts in 128-bit integers"),
    ("interpolation", "value", "`interpolation`, with the fraction bits of the format"),
    ("vertices", "place", "half a step, and `PERSPECTIVE_DIVIDE`; in a scene `vertex_on_screen` of `clip`"),
    ("vertices", "depth", "`DEPTH_VERTEX`; in a scene three times `clip` over w, of 65528 codes, more"),
    (
        "vertices",
        "1/w",
        "`VERTEX_INVERSE`; in a scene twice that and `clip` over w, as the unit is a vertex's own",
    ),
    (
        "depth",
        "beyond its code",
        "`interpolation` with 16 bits, and `DEPTH_VERTEX`; as a small float both in its codes, `float_depth`",
    ),
    ("texels", "of 256", "256 times `per_pixel`"),
    ("texels", "of 32768", "32768 times `per_pixel`; divided, with `DIVIDED` for `RECIPROCAL`"),
    ("texels", "of 256 on the plane", "`interpolation` with 16 bits"),
    ("texels", "of 255 by subspans", "`subspan` between its two exact ends, which are off by `per_pixel`"),
    ("texels", "as allowed", "`within`: what is allowed, and what interpolating linear texels adds"),
    ("texels", "of 254", "`affine` of 254 texels, and `interpolation` with 16 bits"),
    ("light", "lit colour", "`LIT`; of a plane's normal `PLANE_NORMAL` more"),
    ("light", "light", "`LIGHT_STEPS`"),
    (
        "colour",
        "shown",
        "`shown` of `channel`; what is allowed and `shown` of `MIDDLE`, where it is one colour",
    ),
    ("camera", "value", "`SINE`, and half a step of 2^-16 in 32767 for how it is read"),
    (
        "camera",
        "matrix element",
        "`CAMERA` for each float and `SINE` for the field of view, times what they are multiplied with",
    ),
    ("camera", "from a rotation", "four times `CAMERA`: two products of two elements"),
    (
        "frames",
        "mismatches",
        "another face is shown only nearer to an edge than `vertex_on_screen`, or to its depth than both of their bounds",
    ),
    (
        "frames",
        "depth beyond its code",
        "`interpolation`, the vertices' bound, and their planes' slope times `vertex_on_screen`",
    ),
    (
        "frames",
        "colour",
        "the furthest of the colours that the bounds of texel and light allow, or `LIT` and `channel`; rounded to RGB565",
    ),
    ("frames", "colour of one", "what is allowed more than for a colour that is interpolated"),
    (
        "frames",
        "PSNR (a least value)",
        "from the sum of the squares of what each channel of each pixel may be off",
    ),
];
