//! Textures: texels beyond the edge.

use reference::naive::sample::{clamped_before_floor, remainder};
use reference::shade::{from_rgb565, texel, to_rgb888};
use scenes::texture::{BRICK, WAVES};
use topleft::Wrap;

use crate::canvas::{Canvas, Colour};
use crate::strip::{Picture, Strip};

const SIDE: i32 = 66;
/// Where an index is not in the texture: a panic, or what lies before it in memory.
const OUT_OF_BOUNDS: Colour = [255, 0, 255];

/// A texel for each pixel, the one at 0, 0 in the middle.
fn shown(texel: impl Fn(i32, i32) -> Option<u16>) -> Picture {
    shown_from(-SIDE / 2, texel)
}

/// The same with another texel at the left and at the top.
fn shown_from(first: i32, texel: impl Fn(i32, i32) -> Option<u16>) -> Picture {
    let places = (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x + first, y + first)));
    let colour = |word: u16| to_rgb888(from_rgb565(word));
    Picture::new(SIDE as usize, places.map(|(u, v)| texel(u, v).map_or(OUT_OF_BOUNDS, colour)).collect())
}

/// Row 19: coordinates below 0.
pub(crate) fn below_zero() -> Canvas {
    let texture = BRICK.with_wrap(Wrap::Repeat);
    let size = texture.width();
    let naive = |u: i32, v: i32| {
        let [u, v] = [u, v].map(|c| remainder(c, size));
        usize::try_from(v * i32::from(size) + u).ok().filter(|_| u >= 0).map(|index| texture.texels()[index])
    };
    Strip {
        title: "19  A texture that repeats to the left of its edge and above it",
        naive_method: "texel % size",
        naive: shown(naive),
        topleft: shown(|u, v| Some(texture.texel(u, v))),
        reference: shown(|u, v| Some(texel(&texture, [u, v].map(f64::from)))),
        zoom: 3,
        times: 1,
        unit: "code",
        notes: vec!["Texels from -33 to 32 both ways. Magenta: the index is negative, which stops a program or reads what is not texture.".into()],
    }
    .draw()
}

/// Row 20: the last texel, held.
pub(crate) fn beyond_the_last() -> Canvas {
    let texture = WAVES.with_wrap(Wrap::Clamp);
    let size = texture.width();
    let first = i32::from(size) - SIDE / 2;
    let naive = |u: i32, v: i32| {
        let [u, v] = [u, v].map(|c| clamped_before_floor(f64::from(c) / f64::from(size), size));
        texture.texels().get(v * usize::from(size) + u).copied()
    };
    Strip {
        title: "20  A texture held at its right and its lower edge",
        naive_method: "clamp, then floor",
        naive: shown_from(first, naive),
        topleft: shown_from(first, |u, v| Some(texture.texel(u, v))),
        reference: shown_from(first, |u, v| Some(texel(&texture, [u, v].map(f64::from)))),
        zoom: 3,
        times: 1,
        unit: "code",
        notes: vec![
            "At 1.0 the texel after the last is named: to the right the next row's first one, below (magenta) none at all.".into(),
        ],
    }
    .draw()
}
