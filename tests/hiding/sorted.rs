//! Lists in painter's order: as they were where the scratch is too short, and the same bytes however they are rendered.

use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use embedded_graphics::prelude::*;
use scenes::{SCENES, Scene, View};
use topleft::stages::Traversal;
use topleft::{
    BoxWalk, Cull, DrawError, DrawList, Flat, Gouraud, ListTriangle, Material, Painter, Perspective, Pose,
    SortError, Spans, Turn,
};

use crate::support::check;
use crate::support::frame::{Frame, rendered};
use crate::support::strategies::mesh_data;

const SIZE: Size = Size::new(96, 96);

fn frame<T: Traversal>(list: &DrawList<'_, u16, Painter, T>, rows: usize) -> Frame {
    rendered(list, SIZE.width as usize, 0..SIZE.height.cast_signed(), rows, 0x1234)
}

/// A scene's list, sorted by a scratch of as many triangles more or less than it has, and what that returned.
fn listed<T: Traversal, R>(
    scene: &Scene,
    more: isize,
    with: impl FnOnce(&DrawList<'_, u16, Painter, T>, Result<(), SortError>) -> R,
) -> R {
    let (mut words, mut triangles) = (vec![0; 1 << 14], vec![ListTriangle::EMPTY; 4000]);
    let mut list = DrawList::<u16, Painter, T>::with_traversal(&mut words, &mut triangles);
    scene.draw(&mut list, SIZE, &View::default()).expect("it is long enough");
    let mut scratch = vec![[0; 3]; list.stats().drawn.saturating_add_signed(more)];
    let result = list.sort(&mut scratch);
    with(&list, result)
}

// Red when a strip shows other rows than its own, or when a traversal leaves out what is covered already.
#[test]
fn a_sorted_list_gives_the_same_bytes_in_strips_and_by_boxes() {
    for scene in SCENES {
        let whole = listed(scene, 0, |list: &DrawList<'_, _, _, Spans>, result| {
            assert_eq!(result, Ok(()));
            let whole = frame(list, SIZE.height as usize);
            for rows in [1, 7, 16] {
                frame(list, rows).same("strips", &whole).unwrap();
            }
            whole
        });
        listed(scene, 5, |list: &DrawList<'_, _, _, BoxWalk>, _| frame(list, 16).same("by boxes", &whole))
            .unwrap();
    }
}

// Red when a list is sorted in part where the scratch is too short, or when what does not fit is counted by one too many.
#[test]
fn a_scratch_too_short_says_by_how_much_and_leaves_the_list() {
    let scene = scenes::by_name("teapot").expect("it is there");
    let as_drawn = listed(scene, -10_000, |list: &DrawList<'_, _, _, Spans>, result| {
        assert_eq!(result, Err(SortError::Short { triangles: list.stats().drawn }));
        frame(list, 96)
    });
    for missing in [1, 2, 300] {
        listed(scene, -missing, |list: &DrawList<'_, _, _, Spans>, result| {
            assert_eq!(result, Err(SortError::Short { triangles: missing.unsigned_abs() }));
            frame(list, 96).same("not sorted", &as_drawn).unwrap();
        });
    }
    let sorted = listed(scene, 0, |list: &DrawList<'_, _, _, Spans>, _| frame(list, 96));
    assert_ne!(sorted, as_drawn, "the teapot needs to be sorted");
}

// Red when what is drawn after sorting is sorted with the rest, or lost; or when sorting again leaves it where it is.
#[test]
fn what_is_drawn_after_sorting_lies_over_the_rest_until_it_is_sorted_again() {
    let square = [[-20_000, -20_000, 0], [20_000, -20_000, 0], [20_000, 20_000, 0], [-20_000, 20_000, 0]];
    let mesh = topleft::Mesh::new(&square, &[[0, 1, 2], [0, 2, 3]]).unwrap();
    let camera = Perspective::new(SIZE, Turn::from_degrees(40), 1.0..10.0);
    let at = |z: &str| Pose::new().at(["0", "0", z].map(topleft::Length::lit));
    let (mut words, mut triangles) = ([0; 100], [ListTriangle::EMPTY; 8]);
    let mut list = DrawList::<u16, Painter>::new(&mut words, &mut triangles);
    let middle = |list: &DrawList<'_, u16, Painter>| frame(list, 96).colours[48 * 96 + 48];
    let [red, green, blue] = [Rgb565::RED, Rgb565::GREEN, Rgb565::BLUE].map(|c| c.into_storage());
    list.draw(&camera, &mesh, &at("-3"), &Flat::new(Rgb565::RED)).unwrap();
    list.draw(&camera, &mesh, &at("-4"), &Gouraud::unlit(&Material::from(Rgb888::GREEN))).unwrap();
    assert_eq!(middle(&list), green);
    list.sort(&mut [[0; 3]; 8]).unwrap();
    assert_eq!(middle(&list), red);
    list.draw(&camera, &mesh, &at("-5"), &Flat::new(Rgb565::BLUE)).unwrap();
    assert_eq!(middle(&list), blue);
    list.sort(&mut [[0; 3]; 8]).unwrap();
    assert_eq!(middle(&list), red);
}

// Red when a key is read beyond a list's words, or a sum of three depths overflows: the test profile checks.
#[test]
fn any_mesh_can_be_sorted_and_once_more_changes_nothing() {
    let input = (mesh_data(), mesh_data(), 0.01_f32..3.0, 1..90_i32, 0..400_usize, 0..40_usize);
    check(2000, &input, |(first, second, distance, degrees, words, count)| {
        let camera = Perspective::new(SIZE, Turn::from_degrees(degrees), 0.001..1.5)
            .look_at([distance, 0.3, distance], [0.0; 3]);
        let (mut words, mut triangles) = (vec![0; words], vec![ListTriangle::EMPTY; count]);
        let mut list = DrawList::<u16, Painter>::new(&mut words, &mut triangles);
        list.set_cull(Cull::None);
        for (data, flat) in [(&first, true), (&second, false), (&first, true)] {
            let (mesh, pose) = (data.mesh(), Pose::new());
            let result = if flat {
                list.draw(&camera, &mesh, &pose, &Flat::new(Material::OfMesh))
            } else {
                list.draw(&camera, &mesh, &pose, &Gouraud::unlit(&Material::OfMesh))
            };
            match result {
                Ok(()) | Err(DrawError::Full { .. }) => {}
                Err(error) => return Err(error.to_string()),
            }
        }
        let mut scratch = vec![[0; 3]; list.stats().drawn];
        list.sort(&mut scratch).map_err(|error| error.to_string())?;
        let once = frame(&list, 32);
        list.sort(&mut scratch).map_err(|error| error.to_string())?;
        frame(&list, 32).same("sorted twice", &once)
    });
}
