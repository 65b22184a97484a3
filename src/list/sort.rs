//! Painter's order: a list's triangles from far to near.

use core::hint::black_box;

use super::{Contents, DrawList, ListTriangle};
use crate::attributes::Words;
use crate::depth::{Nearness, Painter};
use crate::retained::Records;

/// Triangles that 16 bits can tell apart.
const MOST_SORTED: usize = 1 << 16;

/// Why a list was not sorted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SortError {
    /// The scratch is shorter than the list, or the list longer than 65 536 triangles.
    Short {
        /// Triangles that there is no room for.
        triangles: usize,
    },
}

impl core::fmt::Display for SortError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let Self::Short { triangles } = self;
        write!(f, "{triangles} triangles of the list do not fit the scratch that it is sorted by")
    }
}

impl core::error::Error for SortError {}

impl<P, T> DrawList<'_, P, Painter, T> {
    /// Puts the triangles in painter's order: from far to near by the mean depth of their vertices, in 16 bits; those of
    /// the same depth stay as they were drawn.
    ///
    /// Sort once a frame, when all meshes are drawn. What is drawn afterwards lies over all that was sorted, which suits
    /// a display over the scene, until the list is sorted again.
    ///
    /// The scratch has 6 bytes for each triangle; what it holds does not matter, before or after. It takes 1 KB of stack,
    /// and time in proportion to the triangles.
    ///
    /// ```
    /// use embedded_graphics_core::geometry::Size;
    /// use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};
    /// use topleft::{DrawList, Flat, Length, ListTriangle, Mesh, Orthographic, Painter, Pose, SortError, Strip};
    ///
    /// let positions = [[-32767, -32767, 0], [32767, -32767, 0], [0, 32767, 0]];
    /// let mesh = Mesh::new(&positions, &[[0, 1, 2]]).unwrap();
    /// let camera = Orthographic::new(Size::new(8, 8), 2.0, -1.0..1.0);
    /// let nearer = Pose::new().at([Length::ZERO, Length::ZERO, Length::lit("0.5")]);
    ///
    /// let (mut vertices, mut triangles) = ([0; 24], [ListTriangle::EMPTY; 4]);
    /// let mut list = DrawList::new(&mut vertices, &mut triangles);
    /// list.draw(&camera, &mesh, &nearer, &Flat::new(Rgb565::GREEN)).unwrap();
    /// list.draw(&camera, &mesh, &Pose::new(), &Flat::new(Rgb565::RED)).unwrap();
    /// assert_eq!(list.sort(&mut [[0; 3]; 1]), Err(SortError::Short { triangles: 1 }));
    /// assert_eq!(list.sort(&mut [[0; 3]; 2]), Ok(()));
    ///
    /// let mut colours = [Rgb565::BLACK; 64];
    /// let mut frame = Strip::new(8, &mut colours).unwrap().for_painter();
    /// list.render(0..8, &mut frame);
    /// assert!(frame.colours().contains(&Rgb565::GREEN) && !frame.colours().contains(&Rgb565::RED));
    /// ```
    ///
    /// Only lists of [`Painter`] have it, as only theirs keep what they are sorted by.
    ///
    /// # Errors
    /// The scratch is shorter than the list, or the list longer than 65 536 triangles; it stays as it was.
    pub fn sort(&mut self, scratch: &mut [[u16; 3]]) -> Result<(), SortError> {
        let Self { contents: Contents { words, triangles, used_triangles, records, .. }, shaders, .. } = self;
        *records = Records::NONE;
        let triangles = triangles.get_mut(..*used_triangles).unwrap_or_default();
        let room = scratch.len().min(MOST_SORTED);
        let Some(scratch) = scratch.get_mut(..triangles.len()).filter(|scratch| scratch.len() <= room) else {
            return Err(SortError::Short { triangles: triangles.len() - room });
        };
        let (mut low, mut high) = ([0; DIGITS], [0; DIGITS]);
        for (triangle, [key, ..]) in triangles.iter().zip(scratch.iter_mut()) {
            let block = shaders.get(triangle.shader()).map(|kept| kept.block).unwrap_or_default();
            let depth = |vertex: u16| {
                // It follows x and y.
                let word = block.base() + usize::from(vertex) * block.stride() + 2;
                Nearness::load(&mut words.get(word).copied().into_iter()).unwrap_or_default()
            };
            let [a, b, c] = triangle.vertices;
            *key = Nearness::key([depth(a), depth(b), depth(c)]);
            next(&mut low, *key as u8);
            next(&mut high, (*key >> 8) as u8);
        }
        sum_up(&mut low);
        sum_up(&mut high);
        by_digits(scratch, &mut low, &mut high);
        reorder(triangles, scratch);
        Ok(())
    }
}

/// Values of a digit of 8 bits.
const DIGITS: usize = 1 << 8;

/// How many triangles have each digit, or the place where the next of them goes: the largest place is 65 535.
type Places = [u16; DIGITS];

/// The place of the next triangle with a digit.
#[inline(always)]
fn next(places: &mut Places, digit: u8) -> usize {
    let Some(place) = places.get_mut(usize::from(digit)) else { return 0 };
    let here = *place;
    // All of 65 536 triangles may have the same one: that count is not read again.
    *place = here.wrapping_add(1);
    usize::from(here)
}

/// From how many triangles have a digit to how many have a lower one.
fn sum_up(places: &mut Places) {
    let mut before = 0_u16;
    for place in places {
        black_box(());
        before = before.wrapping_add(core::mem::replace(place, before));
    }
}

/// From keys to the places that triangles come from, in order: by the low digit first, then by the high one, among whose
/// equals the order stays.
fn by_digits(scratch: &mut [[u16; 3]], low: &mut Places, high: &mut Places) {
    for from in 0..scratch.len() {
        // Here and below, it keeps the loop as it is: unrolled, it needs more registers than a small core has.
        black_box(());
        let Some(&[key, ..]) = scratch.get(from) else { return };
        if let Some([_, by_low, _]) = scratch.get_mut(next(low, key as u8)) {
            *by_low = from as u16;
        }
    }
    for at in 0..scratch.len() {
        black_box(());
        let Some(&[_, from, _]) = scratch.get(at) else { return };
        let Some(&[key, ..]) = scratch.get(usize::from(from)) else { return };
        if let Some([.., by_both]) = scratch.get_mut(next(high, (key >> 8) as u8)) {
            *by_both = from;
        }
    }
}

/// Moves each triangle to its place, ring by ring: what was in a place goes to another, until one ends in the first.
fn reorder(triangles: &mut [ListTriangle], scratch: &mut [[u16; 3]]) {
    for first in 0..scratch.len() {
        let Some(&held) = triangles.get(first) else { return };
        let mut to = first;
        // A ring has no more places than there are.
        for _ in 0..scratch.len() {
            let Some([.., source]) = scratch.get_mut(to) else { return };
            // In place from now on.
            let from = usize::from(core::mem::replace(source, to as u16));
            if from == to {
                break;
            }
            let triangle = if from == first { Some(&held) } else { triangles.get(from) };
            let Some(&triangle) = triangle else { return };
            if let Some(place) = triangles.get_mut(to) {
                *place = triangle;
            }
            if from == first {
                break;
            }
            to = from;
        }
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use std::vec::Vec;

    use proptest::prelude::*;
    use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestRng, TestRunner};

    use super::super::{Block, Kept};
    use super::*;
    use crate::raster::Spans;
    use crate::shade::Uniforms;

    /// A mesh's triangles: words between them and those before, words of a vertex, depths, and who has which.
    type Part = (usize, usize, Vec<u32>, Vec<[prop::sample::Index; 3]>);

    fn parts() -> impl Strategy<Value = Vec<Part>> {
        // Whole lists of few depths, so that many keys are the same.
        let depth = prop_oneof![any::<u32>(), (0..4_u32).prop_map(|depth| depth << 20), Just(u32::MAX)];
        let vertices = prop::collection::vec(depth, 1..40);
        let faces = prop::collection::vec(any::<[prop::sample::Index; 3]>(), 0..200);
        prop::collection::vec((0..5_usize, 3..9_usize, vertices, faces), 0..5)
    }

    fn sorts(parts: &[Part]) -> Result<(), TestCaseError> {
        let (mut words, mut triangles) = (Vec::new(), Vec::new());
        let mut shaders = heapless::Vec::new();
        let mut expected = Vec::new();
        for (shader, (padding, stride, depths, faces)) in parts.iter().enumerate() {
            words.resize(words.len() + padding, 0xDEAD);
            let block = Block::new(words.len(), *stride);
            prop_assert_eq!((block.base(), block.stride()), (words.len(), *stride));
            let kept = Kept { uniforms: Uniforms::NONE, draw: |_, _, _, _| {}, simple: None, block };
            prop_assert!(shaders.push(kept).is_ok());
            for depth in depths {
                let start = words.len();
                words.resize(start + stride, 0xDEAD);
                Nearness::new(*depth).store(&mut |word| words[start + 2] = word);
            }
            for face in faces {
                let vertices = face.map(|corner| corner.index(depths.len()));
                let colour = [(triangles.len() >> 8) as u8, triangles.len() as u8, 0];
                let kept = ListTriangle { shader: shader as u8, colour, ..ListTriangle::EMPTY };
                triangles.push(ListTriangle { vertices: vertices.map(|vertex| vertex as u16), ..kept });
                expected.push((Nearness::key(vertices.map(|vertex| Nearness::new(depths[vertex]))), colour));
            }
        }
        expected.sort_by_key(|(key, _)| *key);
        let count = triangles.len();
        triangles.resize(count + 3, ListTriangle::EMPTY);
        let mut list = DrawList::<u16, Painter, Spans>::with_traversal(&mut words, &mut triangles);
        (list.contents.used_triangles, list.shaders) = (count, shaders);
        let mut scratch = std::vec![[0xDEAD; 3]; count + 1];
        prop_assert_eq!(list.sort(&mut scratch), Ok(()));
        let sorted: Vec<[u8; 3]> =
            list.contents.triangles[..count].iter().map(|triangle| triangle.colour).collect();
        let expected: Vec<[u8; 3]> = expected.iter().map(|(_, colour)| *colour).collect();
        prop_assert_eq!(sorted, expected);
        Ok(())
    }

    // Red when the passes change places, a digit has 7 bits, those of one digit are turned round, or a shader's vertices are
    // sought where another's are.
    #[test]
    fn the_order_is_that_of_a_stable_sort() {
        let config = Config { cases: 500, failure_persistence: None, ..Config::default() };
        let rng = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
        TestRunner::new_with_rng(config, rng).run(&parts(), |parts| sorts(&parts)).unwrap();
    }
}
