//! Painter's order: a list's triangles from far to near.

use core::hint::black_box;

use super::{DrawList, ListTriangle};
use crate::attributes::Words;
use crate::depth::{Nearness, Painter};

/// Digits of a key: two of 8 bits.
const DIGITS: [u32; 2] = [0, 8];

/// Why a list was not sorted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SortError {
    /// The scratch is shorter than the list.
    Short {
        /// Triangles that it has no room for.
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
    /// It takes time in proportion to the triangles, and 1 KB of stack. What the scratch holds does not matter, before or
    /// after.
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
    /// assert_eq!(list.sort(&mut [ListTriangle::EMPTY; 1]), Err(SortError::Short { triangles: 1 }));
    /// assert_eq!(list.sort(&mut [ListTriangle::EMPTY; 2]), Ok(()));
    ///
    /// let mut colours = [Rgb565::BLACK; 64];
    /// let mut frame = Strip::new(8, &mut colours).unwrap().for_painter();
    /// list.render(0..8, &mut frame);
    /// assert!(frame.colours().contains(&Rgb565::GREEN) && !frame.colours().contains(&Rgb565::RED));
    /// ```
    ///
    /// # Errors
    /// The scratch is shorter than the list, which stays as it was.
    pub fn sort(&mut self, scratch: &mut [ListTriangle]) -> Result<(), SortError> {
        let Self { words, triangles, used_triangles, shaders, .. } = self;
        let triangles = triangles.get_mut(..*used_triangles).unwrap_or_default();
        let length = triangles.len();
        let Some(scratch) = scratch.get_mut(..length) else {
            return Err(SortError::Short { triangles: length - scratch.len() });
        };
        let key = |triangle: &ListTriangle| {
            let block = shaders.get(usize::from(triangle.shader)).map(|kept| kept.block).unwrap_or_default();
            let (base, stride) = (block.base(), block.stride());
            let depth = |vertex: u16| {
                // It follows x and y.
                let mut words =
                    words.get(base + usize::from(vertex) * stride + 2..).unwrap_or_default().iter();
                Nearness::load(&mut words.by_ref().copied()).unwrap_or_default()
            };
            let [a, b, c] = triangle.vertices;
            Nearness::key([depth(a), depth(b), depth(c)])
        };
        let [low, high] = DIGITS;
        by_digit(triangles, scratch, low, &key);
        by_digit(scratch, triangles, high, &key);
        Ok(())
    }
}

/// Copies triangles in the order of a digit of their keys; those with the same one stay in order.
#[inline(never)]
fn by_digit(from: &[ListTriangle], to: &mut [ListTriangle], shift: u32, key: &impl Fn(&ListTriangle) -> u16) {
    let digit = |triangle: &ListTriangle| usize::from((key(triangle) >> shift) as u8);
    // Where the next triangle with each digit goes.
    let mut places = [0_usize; 256];
    for triangle in from {
        if let Some(count) = places.get_mut(digit(triangle)) {
            *count += 1;
        }
    }
    let mut before = 0;
    for place in &mut places {
        black_box(());
        before += core::mem::replace(place, before);
    }
    for triangle in from {
        if let Some(place) = places.get_mut(digit(triangle)) {
            if let Some(to) = to.get_mut(*place) {
                *to = *triangle;
            }
            *place += 1;
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
            let kept = Kept { uniforms: Uniforms::NONE, draw: |_, _, _, _| {}, block };
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
        (list.used_triangles, list.shaders) = (count, shaders);
        let mut scratch = std::vec![ListTriangle { shader: 200, ..ListTriangle::EMPTY }; count + 1];
        prop_assert_eq!(list.sort(&mut scratch), Ok(()));
        let sorted: Vec<[u8; 3]> = list.triangles[..count].iter().map(|triangle| triangle.colour).collect();
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
