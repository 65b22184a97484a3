//! Which texel a coordinate names, one axis at a time: the forms that leave the texture.

/// `texel % size`, as most tutorials repeat a texture: negative left of the texture, where an index is out of bounds.
pub fn remainder(texel: i32, size: u16) -> i32 {
    texel % i32::from(size)
}

/// A coordinate from 0 to 1 that is clamped first and made a texel then: at 1, and beyond, it names the texel after the
/// last.
pub fn clamped_before_floor(coordinate: f64, size: u16) -> usize {
    (coordinate.clamp(0.0, 1.0) * f64::from(size)) as usize
}

/// A coordinate with the texture's 2^`log2` texels aligned to the top of a word, shifted down by what is left: nothing
/// where that is all 32 bits, as of a single texel: C leaves it undefined, and a debug build stops there.
pub fn top_aligned(coordinate: u32, log2: u32) -> Option<u32> {
    coordinate.checked_shr(32 - log2)
}

/// The same on an x86, which takes a shift by 32 for one by 0. (A Cortex-M makes it 0.)
pub fn top_aligned_on_x86(coordinate: u32, log2: u32) -> u32 {
    coordinate.wrapping_shr(32 - log2)
}

/// `texel & (size - 1)`, for a size that is no power of two: some texels are never shown.
pub fn masked(texel: i32, size: u16) -> i32 {
    texel & (i32::from(size) - 1)
}
