//! A list's storage in one piece, for a `static`.

use super::{DrawList, ListTriangle};
use crate::depth::Depth;

/// Storage of a fixed size for a [`DrawList`]: words for vertices, and triangles.
///
/// ```
/// use topleft::{Depth16, DrawList, ListStorage};
///
/// let mut storage: ListStorage<2400, 1000> = ListStorage::new();
/// let list: DrawList<u16, Depth16> = storage.list();
/// assert_eq!(list.words(), 0);
/// assert_eq!(size_of::<ListStorage<2400, 1000>>(), 2400 * 4 + 1000 * 14);
/// ```
#[derive(Clone, Debug)]
pub struct ListStorage<const WORDS: usize, const TRIANGLES: usize> {
    words: [u32; WORDS],
    triangles: [ListTriangle; TRIANGLES],
}

impl<const WORDS: usize, const TRIANGLES: usize> ListStorage<WORDS, TRIANGLES> {
    /// Storage that nothing is drawn in.
    pub const fn new() -> Self {
        Self { words: [0; WORDS], triangles: [ListTriangle::EMPTY; TRIANGLES] }
    }

    /// An empty list over all of it.
    pub const fn list<P, D: Depth>(&mut self) -> DrawList<'_, P, D> {
        DrawList::new(&mut self.words, &mut self.triangles)
    }

    /// The same, whose pixels are found by another traversal: [`BySize`](crate::BySize) or [`BoxWalk`](crate::BoxWalk).
    pub const fn list_with_traversal<P, D: Depth, T>(&mut self) -> DrawList<'_, P, D, T> {
        DrawList::with_traversal(&mut self.words, &mut self.triangles)
    }
}

impl<const WORDS: usize, const TRIANGLES: usize> Default for ListStorage<WORDS, TRIANGLES> {
    fn default() -> Self {
        Self::new()
    }
}
