//! Textures: texels beyond the edge.

use reference::naive::sample::remainder;
use reference::shade::{from_rgb565, texel, to_rgb888};
use scenes::texture::BRICK;
use topleft::Wrap;

use crate::canvas::{Canvas, Colour};
use crate::strip::{Picture, Strip};

const SIDE: i32 = 66;
/// Where an index is not in the texture: a panic, or what lies before it in memory.
const OUT_OF_BOUNDS: Colour = [255, 0, 255];

/// A texel for each pixel, the one at 0, 0 in the middle.
fn shown(texel: impl Fn(i32, i32) -> Option<u16>) -> Picture {
    let middle = SIDE / 2;
    let places = (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x - middle, y - middle)));
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
