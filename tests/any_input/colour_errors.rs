//! Errors of colours of nothing, and less.

use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use scenes::{Object, SCENES, View};
use topleft::{ColourError, Depth16, DrawList, Gouraud, Length, ListTriangle, Sun};

use crate::support::frame::rendered;

// Red when a triangle whose colours differ by a code is drawn in one of them.
#[test]
fn an_error_of_zero_or_less_gives_the_bytes_of_gouraud() {
    let size = Size::new(120, 90);
    let sun = Sun::new([Length::lit("0.3"), Length::lit("0.8"), Length::lit("0.4")]);
    for scene in SCENES {
        let frame = |error: Option<&str>| {
            let (mut words, mut triangles) = (vec![0; 40_000], vec![ListTriangle::EMPTY; 8_000]);
            let mut list = DrawList::<Rgb888, Depth16>::new(&mut words, &mut triangles);
            let gouraud = |object: &Object| Gouraud::new(&sun, &object.look.material);
            match error {
                None => scene.draw_with(&mut list, size, &View::default(), gouraud),
                Some(codes) => {
                    let error = ColourError::codes(codes.parse().expect("a number"));
                    scene.draw_with(&mut list, size, &View::default(), |object| gouraud(object).within(error))
                }
            }
            .expect("the list is long enough");
            rendered(&list, 120, 0..90, 90, Rgb888::BLACK)
        };
        let expected = frame(None);
        for codes in ["0", "-2", "-32768"] {
            frame(Some(codes)).same(&format!("{}, {codes}", scene.name), &expected).unwrap();
        }
    }
}
