//! Textures made with integers alone.

use crate::read_image::{PackedTexture, rgb565};
use topleft::Wrap;

/// Width and height.
const SIZE: u16 = 64;

fn make(colour: impl Fn(u16, u16) -> [u8; 3]) -> PackedTexture {
    let texels =
        (0..SIZE).flat_map(|y| (0..SIZE).map(move |x| (x, y))).map(|(x, y)| rgb565(colour(x, y))).collect();
    PackedTexture { width: SIZE, height: SIZE, texels, wrap: Wrap::Repeat }
}

/// 8 x 8 squares of 8 texels.
pub(super) fn checker() -> PackedTexture {
    make(|x, y| if (x / 8 + y / 8) % 2 == 0 { [232, 228, 212] } else { [52, 84, 120] })
}

/// Bricks of 16 x 8 texels with joints of one texel, every other course moved by half a brick.
pub(super) fn brick() -> PackedTexture {
    make(|x, y| {
        let course = y / 8;
        let along = (x + course % 2 * 8) % SIZE;
        if y % 8 == 7 || along % 16 == 15 {
            return [176, 168, 156];
        }
        // Each brick in a shade of its own, with a grain over it and a lit upper edge.
        let shade = noise(along / 16, course) % 48;
        let grain = noise(x, y + 64) % 16;
        let light = if y % 8 == 0 { 24 } else { 0 };
        [136 + shade + grain + light, 56 + shade / 2 + grain + light, 44 + shade / 3 + grain + light]
            .map(|c| c as u8)
    })
}

/// Crests of light in blue water, bent, and broken in places; all of it repeats after 64 texels.
pub(super) fn waves() -> PackedTexture {
    let hill = |at: u16, length: u16| (at % length).min(length - at % length);
    make(|x, y| {
        let bent = y + hill(x, 32) / 2 + hill(x + 8, 16) / 2 + SIZE;
        let crest = (bent + hill(x + 20, 64) / 4) % 16;
        let whole = !noise(x / 8, y / 16).is_multiple_of(3);
        let grain = noise(x, y) % 8;
        let depth = crest * 3 + hill(y, 64) / 2;
        match (crest, whole) {
            (0, true) => [196 + grain, 228 + grain, 240],
            (1, _) => [104 + grain, 176 + grain, 216],
            _ => [24 + grain, 84 + depth + grain, 150 + depth],
        }
        .map(|c| c as u8)
    })
}

/// Numbers without a pattern that the eye would find.
fn noise(x: u16, y: u16) -> u16 {
    let mixed = u32::from(x).wrapping_mul(0x9E37_79B1) ^ u32::from(y).wrapping_mul(0x85EB_CA77);
    let value = (mixed ^ mixed >> 15).wrapping_mul(0x2C1B_3C6D);
    (value >> 20) as u16
}

/// A grid of 8 texels, an F in the middle, red, green, blue and yellow corners from the top left with the clock, and a
/// background that gets redder to the right and greener downwards.
pub(super) fn test_card() -> PackedTexture {
    make(|x, y| {
        let (left, top) = (x < 12, y < 12);
        let (right, bottom) = (x >= SIZE - 12, y >= SIZE - 12);
        // The letter: a stem, a long bar and a short one.
        let stem = (22..28).contains(&x) && (16..48).contains(&y);
        let long = (22..44).contains(&x) && (16..22).contains(&y);
        let short = (22..38).contains(&x) && (29..35).contains(&y);
        match () {
            () if left && top => [224, 32, 32],
            () if right && top => [32, 192, 48],
            () if right && bottom => [40, 64, 224],
            () if left && bottom => [240, 216, 32],
            () if stem || long || short => [16, 16, 24],
            () if x % 8 == 0 || y % 8 == 0 => [248, 248, 248],
            () => [96 + x as u8 * 2, 96 + y as u8 * 2, 160],
        }
    })
}
