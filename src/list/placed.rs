//! One draw's vertices in the list, and what its faces have: what it takes to find triangles, whatever wrote the vertices.

/// The first word of a vertex that the list does not show: the second names the planes that it is outside of.
pub(super) const UNSEEN: u32 = 1 << 31;

/// Where the vertices of a draw are, and the colours of its faces.
pub(super) struct Placed<'m> {
    pub(super) colours: &'m dyn FaceColours,
    /// Words of a vertex.
    pub(super) stride: u8,
    /// Where the pixel shader is kept.
    pub(super) kept: u8,
    /// The first word of that shader's vertices.
    pub(super) base: usize,
}

impl Placed<'_> {
    /// Words of a vertex.
    #[inline]
    pub(super) fn stride(&self) -> usize {
        usize::from(self.stride)
    }

    /// Where a vertex of the shader starts.
    #[inline]
    pub(super) fn word(&self, vertex: usize) -> usize {
        self.base + vertex * self.stride()
    }
}

/// The colours of faces.
pub(super) trait FaceColours {
    /// That of a face: red, green, blue.
    fn face(&self, face: usize) -> [u8; 3];
}
