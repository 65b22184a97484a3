//! The distance between what the library drew and what the reference says, stage by stage and for whole frames.

use crate::depth::code;
use crate::image::Image;
use crate::shade::{Rgb, to_rgb888};
use std::fmt;
use topleft::Wrap;

/// Pixels whose hit counts differ.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Coverage {
    /// Pixels compared.
    pub pixels: u64,
    /// Pixels hit less often than they should be: cracks.
    pub missing: u64,
    /// Pixels hit more often than they should be.
    pub extra: u64,
    /// The first pixel that differs, counted in rows from the top.
    pub first: Option<usize>,
}

/// Compares hit counts, one a pixel.
///
/// # Panics
/// The two are not equally long.
pub fn coverage(ours: &[u32], reference: &[u32]) -> Coverage {
    let mut result = Coverage::default();
    for (index, (ours, reference)) in pairs(ours, reference).enumerate() {
        result.pixels += 1;
        result.missing += u64::from(ours < reference);
        result.extra += u64::from(ours > reference);
        if ours != reference && result.first.is_none() {
            result.first = Some(index);
        }
    }
    result
}

/// How many pixels were hit 0, 1, 2, .. times; as long as the greatest count needs.
pub fn hit_histogram(counts: &[u32]) -> Vec<u64> {
    let longest = counts.iter().max().map_or(0, |&most| most as usize + 1);
    let mut histogram = vec![0; longest];
    for &count in counts {
        histogram[count as usize] += 1;
    }
    histogram
}

/// The sizes of errors, collected one by one.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Errors {
    /// Values compared.
    pub count: u64,
    /// The largest error.
    pub max: f64,
    /// The number of the value with the largest error, counted from 0.
    pub worst: u64,
    sum: f64,
}

impl Errors {
    /// Adds an error of either sign. One that is not a number counts as infinite.
    pub fn add(&mut self, error: f64) {
        let size = if error.is_nan() { f64::INFINITY } else { error.abs() };
        if size > self.max {
            (self.max, self.worst) = (size, self.count);
        }
        self.count += 1;
        self.sum += size;
    }

    /// The mean size, 0 for no values.
    pub fn mean(&self) -> f64 {
        if self.count == 0 { 0.0 } else { self.sum / self.count as f64 }
    }
}

impl FromIterator<f64> for Errors {
    fn from_iter<I: IntoIterator<Item = f64>>(errors: I) -> Self {
        let mut result = Self::default();
        errors.into_iter().for_each(|error| result.add(error));
        result
    }
}

/// The error of a pixel's colour is that of its worst channel, in code values.
///
/// # Panics
/// The two are not equally long.
pub fn colours(ours: &[Rgb], reference: &[Rgb]) -> Errors {
    // Not `f64::max`, which would drop a channel that is not a number.
    let worse = |worst: f64, error: f64| if error > worst || error.is_nan() { error } else { worst };
    pairs(ours, reference)
        .map(|(a, b)| [0, 1, 2].map(|channel| (a[channel] - b[channel]).abs()).into_iter().fold(0.0, worse))
        .collect()
}

/// How far our depth codes are from the codes that the reference would store.
///
/// # Panics
/// The two are not equally long.
pub fn depths(ours: &[u16], reference: &[f64]) -> Errors {
    pairs(ours, reference).map(|(&ours, &reference)| f64::from(ours) - f64::from(code(reference))).collect()
}

/// How far two texture coordinates, in texels, are apart along one axis of `size` texels: the shorter way round where
/// the texture repeats, and not at all beyond the same edge where it is clamped.
pub fn texel_error(ours: f64, reference: f64, size: u16, wrap: Wrap) -> f64 {
    let size = f64::from(size);
    match wrap {
        Wrap::Repeat => {
            let apart = (ours - reference).rem_euclid(size);
            apart.min(size - apart)
        }
        Wrap::Clamp => (ours.clamp(0.0, size) - reference.clamp(0.0, size)).abs(),
    }
}

/// The peak signal-to-noise ratio of two 8-bit images in dB, over all channels. Infinite for equal images.
///
/// # Panics
/// The two are not equally long.
pub fn psnr(ours: &[[u8; 3]], reference: &[[u8; 3]]) -> f64 {
    let mut squares = 0_u64;
    let mut count = 0_u64;
    for (a, b) in pairs(ours, reference) {
        squares += a.iter().zip(b).map(|(&a, &b)| u64::from(a.abs_diff(b)).pow(2)).sum::<u64>();
        count += 3;
    }
    if squares == 0 { f64::INFINITY } else { 10.0 * (255.0 * 255.0 * count as f64 / squares as f64).log10() }
}

/// What a comparison found. It prints as one line, of what was compared only.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Report {
    /// What was compared.
    pub name: String,
    /// Which pixels were hit.
    pub coverage: Option<Coverage>,
    /// In code values of 255.
    pub colour: Option<Errors>,
    /// In texels.
    pub texel: Option<Errors>,
    /// In depth codes.
    pub depth: Option<Errors>,
    /// In dB, on 8-bit colours.
    pub psnr: Option<f64>,
}

/// Compares a whole frame: colours in code values (of RGB565 words: [`crate::shade::from_rgb565`]), and the depth
/// buffer when there is one. PSNR is of both images rounded to 8 bits.
///
/// For the error of drawing alone, without that of the display's 16 bits, compare with [`Image::quantised`].
///
/// # Panics
/// The frames are not of one size.
pub fn frame(name: &str, ours: &[Rgb], depth: Option<&[u16]>, reference: &Image) -> Report {
    let rgb888: Vec<[u8; 3]> = ours.iter().map(|&colour| to_rgb888(colour)).collect();
    let reference_colours: Vec<Rgb> = reference.pixels().iter().map(|pixel| pixel.colour).collect();
    let reference_depths: Vec<f64> = reference.pixels().iter().map(|pixel| pixel.depth).collect();
    Report {
        name: name.to_owned(),
        colour: Some(colours(ours, &reference_colours)),
        depth: depth.map(|codes| depths(codes, &reference_depths)),
        psnr: Some(psnr(&rgb888, &reference.rgb888())),
        ..Report::default()
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:", self.name)?;
        let mut parts = Vec::new();
        if let Some(Coverage { pixels, missing, extra, .. }) = self.coverage {
            parts.push(format!("{pixels} px, {missing} missing, {extra} extra"));
        }
        for (what, errors, unit) in [
            ("colour", self.colour, "of 255"),
            ("texel", self.texel, "texels"),
            ("depth", self.depth, "codes"),
        ] {
            if let Some(errors) = errors {
                parts.push(format!("{what} max {:.4} mean {:.4} {unit}", errors.max, errors.mean()));
            }
        }
        if let Some(psnr) = self.psnr {
            parts.push(format!("PSNR {psnr:.2} dB"));
        }
        write!(f, " {}", parts.join("; "))
    }
}

fn pairs<'a, A, B>(ours: &'a [A], reference: &'a [B]) -> impl Iterator<Item = (&'a A, &'a B)> {
    assert_eq!(ours.len(), reference.len(), "only results of one size can be compared");
    ours.iter().zip(reference)
}
