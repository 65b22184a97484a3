//! What is not drawn, and what the list says of it.

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use topleft::stages::{FlatPixel, GouraudPixel};
use topleft::{
    Affine, Depth16, DrawError, DrawList, Length, ListTriangle, MAX_VERTICES, MeshError, NoDepth, PerPixel,
    ProjectedVertex, Stats, Texture, Textured, point,
};

const SIZE: Size = Size::new(16, 16);
const FACE: [[u16; 3]; 1] = [[0, 1, 2]];

/// A triangle that shows its front.
fn corners<A: Copy>(attributes: A) -> [ProjectedVertex<A>; 3] {
    [[0.0, 0.0], [0.0, 16.0], [16.0, 0.0]].map(|[x, y]| ProjectedVertex::new(point(x, y), attributes))
}

/// Turned red by: a list that keeps something of what is refused, or tells another reason.
#[test]
fn what_is_refused_leaves_the_list_as_it_was() {
    let mut storage = (vec![0; 100], vec![ListTriangle::EMPTY; 20]);
    let mut list = DrawList::<Rgb565, Depth16>::new(&mut storage.0, &mut storage.1);
    list.draw_projected(SIZE, corners([9; 3]), &FACE, &[], &GouraudPixel).unwrap();
    let (stats, words) = (list.stats(), list.words());
    assert_eq!((stats.drawn, words), (1, 12));
    let mut refused = |size, faces: &[[u16; 3]], vertices: &[ProjectedVertex]| {
        let result = list.draw_projected(size, vertices.iter().copied(), faces, &[], &FlatPixel);
        assert_eq!((list.stats(), list.words()), (stats, words));
        result
    };
    let index = MeshError::IndexOutOfRange { face: 1, index: 3 };
    assert_eq!(refused(SIZE, &[[0, 1, 2], [1, 3, 0]], &corners(())), Err(DrawError::Faces(index)));
    let index = MeshError::IndexOutOfRange { face: 0, index: 2 };
    assert_eq!(refused(SIZE, &FACE, &[]), Err(DrawError::Faces(index)));
    let many = vec![ProjectedVertex::new(point(1.0, 1.0), ()); MAX_VERTICES + 1];
    let too_many = MeshError::TooManyVertices(MAX_VERTICES + 1);
    assert_eq!(refused(SIZE, &FACE, &many), Err(DrawError::Faces(too_many)));
    let large = Size::new(4000, 4000);
    assert_eq!(refused(large, &FACE, &corners(())), Err(DrawError::TooLarge(large)));
    // Without faces there is nothing to keep.
    assert_eq!(refused(SIZE, &[], &corners(())), Ok(()));
}

/// Turned red by: words or triangles that are missing and not counted, faces that are counted only where they fit.
#[test]
fn a_full_list_hands_back_what_did_not_fit() {
    let colours = [[1, 2, 3], [4, 5, 6]];
    for (words, triangles) in [(5, 2), (6, 2), (6, 1), (6, 0), (0, 2)] {
        let mut storage = (vec![0; words], vec![ListTriangle::EMPTY; triangles]);
        let mut list = DrawList::<Rgb565, NoDepth>::new(&mut storage.0, &mut storage.1);
        let result = list.draw_projected(SIZE, corners(()), &[FACE[0]; 2], &colours, &FlatPixel);
        let drawn = if words < 6 { 0 } else { triangles };
        let full = DrawError::Full { triangles: 2 - drawn, words: 6_usize.saturating_sub(words) };
        assert_eq!(result, if drawn == 2 { Ok(()) } else { Err(full) });
        assert_eq!(list.stats(), Stats { faces: 2, drawn, ..Stats::default() });
        assert_eq!(list.words(), if words < 6 { 0 } else { 6 });
    }
}

/// Turned red by: a w that is looked at where nothing is divided by it, or not where something is.
#[test]
fn only_shaders_with_perspective_ask_for_a_positive_w() {
    let texture = Texture::WHITE;
    for (w, outside) in [(Length::DELTA, 0), (Length::ZERO, 1), (Length::MIN, 1)] {
        let mut storage = (vec![0; 100], vec![ListTriangle::EMPTY; 20]);
        let mut list = DrawList::<Rgb565, NoDepth>::new(&mut storage.0, &mut storage.1);
        let [a, b, c] = corners([topleft::Attribute::ZERO; 2]);
        let vertices = [a, b.with_w(w), c];
        list.draw_projected(SIZE, vertices, &FACE, &[], &Textured::new(&texture, Affine)).unwrap();
        assert_eq!((list.stats().outside, list.stats().drawn), (0, 1));
        list.draw_projected(SIZE, vertices, &FACE, &[], &Textured::new(&texture, PerPixel)).unwrap();
        assert_eq!(list.stats().outside, outside);
    }
}

/// Turned red by: a vertex that is nowhere and written as one at (0, 0): `UNSEEN` in src/list/projected.rs.
#[test]
fn a_vertex_at_no_finite_point_leaves_its_triangles_out() {
    let mut storage = (vec![0; 100], vec![ListTriangle::EMPTY; 20]);
    let mut list = DrawList::<Rgb565, NoDepth>::new(&mut storage.0, &mut storage.1);
    for nowhere in [point(f32::NAN, 9.0), point(9.0, f32::INFINITY), point(9.0, f32::NEG_INFINITY)] {
        let [a, b, c] = corners(());
        let vertices = [a, b, c, ProjectedVertex::new(nowhere, ())];
        list.clear();
        list.draw_projected(SIZE, vertices, &[[0, 1, 2], [3, 1, 2], [0, 3, 3]], &[], &FlatPixel).unwrap();
        assert_eq!(list.stats(), Stats { faces: 3, drawn: 1, outside: 2, ..Stats::default() });
    }
}
