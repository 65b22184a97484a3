use reference::depth::{CLEAR, code, passes};
use reference::shade::{Light, from_rgb565, lit, texel, to_rgb565, to_rgb888, uv};
use reference::transform::{CODES, FAR_CODE};
use topleft::{Texture, Wrap};

#[test]
fn the_nearer_of_two_depths_wins_and_the_first_of_equals() {
    assert!(passes(8, 7) && !passes(7, 8) && !passes(7, 7));
    assert_eq!([-1.0, 0.0, 6.999, 7.0, 65_532.5, 1e9].map(code), [0, 0, 6, 7, 65_532, 65_535]);
    // The far plane itself is nearer than nothing, and the near plane fits.
    assert!(passes(code(FAR_CODE), CLEAR));
    assert_eq!(code(FAR_CODE + CODES), 65_532);
}

#[test]
fn light_is_ambient_and_what_faces_it_up_to_one() {
    let light = Light { towards: [0.0, 0.6, 0.8], ambient: 0.25, diffuse: 0.5 };
    assert_eq!(light.at([0.0, 0.0, 1.0]), 0.25 + 0.4);
    assert_eq!(light.at([0.0, -1.0, 0.0]), 0.25);
    assert_eq!(Light { diffuse: 2.0, ..light }.at([0.0, 0.6, 0.8]), 1.0);
    assert_eq!(lit([200.0, 100.0, 0.0], 0.5), [100.0, 50.0, 0.0]);
}

#[test]
fn rgb565_survives_its_round_trip() {
    for word in 0..=u16::MAX {
        assert_eq!(to_rgb565(from_rgb565(word)), word);
    }
    assert_eq!(from_rgb565(0xFFFF), [255.0; 3]);
    assert_eq!(from_rgb565(0x0801), [255.0 / 31.0, 0.0, 255.0 / 31.0]);
    assert_eq!(from_rgb565(0x0020), [0.0, 255.0 / 63.0, 0.0]);
}

#[test]
fn quantising_rounds_to_nearest_and_stays_in_range() {
    // Half a step of red is 255 / 62 = 4.11, of green 255 / 126 = 2.02.
    assert_eq!(to_rgb565([4.0, 2.0, 4.2]), 0x0001);
    assert_eq!(to_rgb565([4.2, 2.1, 4.0]), 0x0820);
    assert_eq!(to_rgb565([-9.0, 300.0, 255.0]), 0x07FF);
    assert_eq!(to_rgb888([-9.0, 99.5, 300.0]), [0, 100, 255]);
}

#[test]
fn texels_are_found_by_rounding_down() {
    static TEXELS: [u16; 8] = [10, 11, 12, 13, 20, 21, 22, 23];
    let repeated = Texture::new(4, 2, &TEXELS).unwrap();
    let clamped = repeated.with_wrap(Wrap::Clamp);
    for (place, in_repeated, in_clamped) in [
        ([0.0, 0.0], 10, 10),
        ([0.999, 0.999], 10, 10),
        ([3.0, 1.0], 23, 23),
        ([-0.001, 0.5], 13, 10),
        ([4.0, 2.0], 10, 23),
        ([-5.5, -3.5], 12, 10),
        ([9.5, 7.5], 21, 23),
    ] {
        assert_eq!(texel(&repeated, place), in_repeated, "{place:?} repeated");
        assert_eq!(texel(&clamped, place), in_clamped, "{place:?} clamped");
    }
    // Half the texture; with an exponent of 3, four textures.
    assert_eq!(uv([16_384, -16_384], 0, &repeated), [2.0, -1.0]);
    assert_eq!(uv([16_384, 16_384], 3, &repeated), [16.0, 8.0]);
}
