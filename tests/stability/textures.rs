//! Rows 18 to 23: texels that are too small, outside of the texture, or of another level.

use std::collections::BTreeSet;

use reference::naive::{sample, texel};
use reference::setup::Triangle;
use topleft::stages::Window;
use topleft::{Attribute, Texture, TextureError, Wrap};

use crate::figure::grouped;
use crate::perspective::Receding;
use crate::planes;
use crate::random::Random;

/// Numbers of texels that a coordinate may have, the worst of them first.
fn coordinates(random: &mut Random, count: usize) -> Vec<i32> {
    let ends = [i32::MIN, i32::MIN + 1, -1025, -65, -64, -1, 0, 63, 64, 1024, i32::MAX - 1, i32::MAX];
    ends.into_iter().chain((0..count).map(|_| random.next() as i32 >> (random.next() % 32))).collect()
}

/// The place of each texel as its colour.
const NUMBERED: [u16; 64 * 16] = {
    let mut texels = [0; 64 * 16];
    let mut i = 0;
    while i < texels.len() {
        texels[i] = i as u16;
        i += 1;
    }
    texels
};

fn numbered() -> Texture<'static> {
    Texture::new(64, 16, &NUMBERED).expect("powers of two")
}

/// A checker of 1 texel at 7.5 texels a pixel, moved by an eighth of a pixel a frame: the largest change of a pixel from
/// frame to frame in parts of full contrast, by the library's nearest texel and by averages over pixels.
pub(crate) fn minified() -> [f64; 2] {
    const CHECKER: [u16; 4] = [0, 0xFFFF, 0xFFFF, 0];
    const STEP: f64 = 7.5;
    let checker = Texture::new(2, 2, &CHECKER).expect("a texture");
    let square: [Triangle; 2] =
        [[[0, 0], [0, 32 * 256], [32 * 256, 32 * 256]], [[0, 0], [32 * 256, 32 * 256], [32 * 256, 0]]];
    let frame = |number: u32| {
        let moved = f64::from(number) / 8.0 * STEP;
        let mut pixels = vec![[0.0; 2]; 32 * 32];
        for triangle in square {
            let texel =
                |[x, y]: [i32; 2]| [x, y].map(|c| Attribute::from_num(f64::from(c) / 256.0 * STEP + moved));
            planes::values(
                triangle,
                triangle.map(texel),
                &Window { columns: 0..32, rows: 0..32 },
                |x, y, [u, v]| {
                    let nearest = f64::from(checker.texel(u.to_bits() >> 16, v.to_bits() >> 16)) / 65_535.0;
                    // The mean over a pixel's box: of a checker, 1/2 and a product of what is left over on each axis.
                    let rest = |at: Attribute| {
                        let integral = |t: f64| (t.rem_euclid(2.0) - 1.0).abs();
                        let t: f64 = at.to_num();
                        (integral(t + STEP / 2.0) - integral(t - STEP / 2.0)) / STEP
                    };
                    let mean = 0.5 - rest(u) * rest(v) / 2.0;
                    pixels[(y * 32 + x) as usize] = [nearest, mean];
                },
            );
        }
        pixels
    };
    let frames: Vec<_> = (0..=16).map(frame).collect();
    let change = |which: usize| {
        let pairs = frames.iter().zip(&frames[1..]).flat_map(|(before, after)| before.iter().zip(after));
        pairs
            .map(|(before, after): (&[f64; 2], &[f64; 2])| (before[which] - after[which]).abs())
            .fold(0.0, f64::max)
    };
    [change(0), change(1)]
}

// Open: the library has no mip levels. Red when it gets some, so that this row is then written anew.
#[test]
fn row_18_minified_textures_shimmer_and_still_do() {
    let [nearest, mean] = minified();
    println!(
        "row 18, nearest texel, 7.5 texels a pixel: a pixel changes by {nearest:.2} of full contrast at once; averages by {mean:.3}; topleft as the nearest (open)"
    );
    assert_eq!(nearest, 1.0);
    // What is left of a mean over 7.5 texels is at most 1 / 7.5 on each axis, and half of their product, either way.
    assert!(mean <= 1.0 / (7.5 * 7.5));
}

/// Coordinates, those that `%` puts before the texture, and those for which the library does not repeat.
pub(crate) fn below_zero() -> [u64; 3] {
    let (mut counts, mut random) = ([0; 3], Random::new(19));
    for u in coordinates(&mut random, 200_000) {
        let v = random.next() as i32;
        counts[0] += 1;
        counts[1] += u64::from(sample::remainder(u, 64) < 0);
        let right = v.rem_euclid(16) * 64 + u.rem_euclid(64);
        counts[2] += u64::from(i32::from(numbered().texel(u, v)) != right);
    }
    counts
}

// Red when `repeat` uses `%`, or masks with one bit too many.
#[test]
fn row_19_a_remainder_is_negative_left_of_the_texture() {
    let [all, naive, ours] = below_zero();
    println!(
        "row 19, `%`: {} of {} coordinates before the first texel; topleft {ours}",
        grouped(naive),
        grouped(all)
    );
    // Half of them are negative, but for multiples of 64.
    assert!(naive * 5 > all * 2);
    assert_eq!(ours, 0);
}

/// Places at and beyond the end, those that name the texel after the last, and those where the library does not hold.
pub(crate) fn at_the_end() -> [u64; 3] {
    let (mut counts, mut random) = ([0; 3], Random::new(20));
    let held = numbered().with_wrap(Wrap::Clamp);
    for u in coordinates(&mut random, 200_000) {
        let v = random.next() as i32;
        let beyond = u >= 64;
        counts[0] += u64::from(beyond);
        counts[1] += u64::from(beyond && sample::clamped_before_floor(f64::from(u) / 64.0, 64) > 63);
        let right = v.clamp(0, 15) * 64 + u.clamp(0, 63);
        counts[2] += u64::from(i32::from(held.texel(u, v)) != right);
    }
    counts
}

// Red when `clamp` lets the size itself through.
#[test]
fn row_20_a_coordinate_clamped_before_it_is_a_texel_reads_one_after_the_last() {
    let [all, naive, ours] = at_the_end();
    println!(
        "row 20, clamped before floor: {} of {} beyond the texture; topleft {ours}",
        grouped(naive),
        grouped(all)
    );
    assert_eq!(naive, all);
    assert_eq!(ours, 0);
}

/// Of textures with one texel on an axis: coordinates whose shift does not exist, those where an x86 then reads outside,
/// and those where the library does not show the texel.
pub(crate) fn single_texels() -> [u64; 4] {
    let (mut counts, mut random) = ([0; 4], Random::new(21));
    let one = Texture::new(1, 1, &[0xBEEF]).expect("one texel");
    let column = Texture::new(1, 64, &NUMBERED[..64]).expect("one column");
    for u in coordinates(&mut random, 100_000) {
        let v = random.next() as i32;
        counts[0] += 1;
        counts[1] += u64::from(sample::top_aligned(u.cast_unsigned(), 0).is_none());
        counts[2] += u64::from(sample::top_aligned_on_x86(u.cast_unsigned(), 0) != 0);
        for wrap in [Wrap::Repeat, Wrap::Clamp] {
            let row = if wrap == Wrap::Repeat { v.rem_euclid(64) } else { v.clamp(0, 63) };
            counts[3] += u64::from(one.with_wrap(wrap).texel(u, v) != 0xBEEF);
            counts[3] += u64::from(i32::from(column.with_wrap(wrap).texel(u, v)) != row);
        }
    }
    counts
}

// Red when `repeat` shifts by 32 less the size's bits.
#[test]
fn row_21_a_single_texel_needs_a_shift_by_all_bits() {
    let [all, none, outside, ours] = single_texels();
    println!(
        "row 21, top-aligned: {} of {} shifts by 32, {} of them outside on an x86; topleft {ours}",
        grouped(none),
        grouped(all),
        grouped(outside)
    );
    assert_eq!(none, all);
    // All but a coordinate of 0.
    assert!(outside * 10 > all * 9);
    assert_eq!(ours, 0);
}

/// Texels that a mask never shows, by the size of the texture, for sizes up to 100.
pub(crate) fn masked() -> Vec<(u16, usize)> {
    (1..=100_u16)
        .map(|size| {
            let shown: BTreeSet<i32> = (-300..300).map(|texel| sample::masked(texel, size)).collect();
            (size, usize::from(size) - shown.len())
        })
        .collect()
}

// Red when `Texture::new` takes a size that a mask does not fit.
#[test]
fn row_22_a_mask_hides_texels_of_other_sizes_than_powers_of_two() {
    let sizes = masked();
    let hidden: usize = sizes.iter().map(|(_, hidden)| hidden).sum();
    println!("row 22, masked: {hidden} of 5 050 texels are never shown; topleft refuses the sizes");
    for (size, hidden) in sizes {
        assert_eq!(hidden == 0, size.is_power_of_two(), "{size}");
        let texels = vec![0; usize::from(size)];
        let (wide, tall) = (Texture::new(size, 1, &texels), Texture::new(1, size, &texels));
        let refused = Err(TextureError::Size(size));
        assert_eq!([wide, tall].map(|made| made == refused), [!size.is_power_of_two(); 2]);
    }
}

/// A plane to the horizon in two triangles: the levels that each has as a whole, and how many texels further than the
/// exact change the library's change by at most from pixel to pixel in a row.
pub(crate) fn levels() -> (u32, f64) {
    let mut random = Random::new(23);
    let (mut jump, mut ours) = (0, 0.0_f64);
    for _ in 0..20 {
        let far = random.within(100, 319) as i32 * 256;
        // Both receive w from 1 to 64 and 255 texels; one is some pixels wide, the other as wide as the screen.
        let large = Receding::new([[0, 0], [0, 239 * 256], [far, 120 * 256]], 64.0, 0, &mut random);
        let small = Receding::new([[0, 0], [far / 16, 4 * 256], [0, 12 * 256]], 64.0, 0, &mut random);
        let level = |case: &Receding| {
            texel::level_of_triangle(
                255.0 * 255.0,
                case.covered.setup.area2().unsigned_abs() as f64 / 65_536.0,
            )
        };
        jump = jump.max(level(&large).abs_diff(level(&small)));
        let mut before: Option<(i32, i32, i32)> = None;
        large.shown(|x, y, u| {
            if let Some((left, row, texel)) = before.filter(|&(left, row, _)| row == y && left + 1 == x) {
                let exact = large.exact(x, y) - large.exact(left, row);
                ours = ours.max((f64::from(u - texel) - exact).abs());
            }
            before = Some((x, y, u));
        });
    }
    (jump, ours)
}

// Open: the library has one level. Red when what it shows jumps by more than rounding down and its own error.
#[test]
fn row_23_a_level_for_each_triangle_jumps_between_them() {
    let (naive, ours) = levels();
    println!(
        "row 23, a level a triangle: {naive} levels apart; topleft has one level (open): {ours:.3} texels more or less than the exact change"
    );
    assert!(naive >= 3);
    // Each end is rounded down to a texel, and off by 1/16 at most.
    assert!(ours <= 1.0 + 2.0 * crate::support::tolerance::SIXTEENTH);
}
