//! Frames of 240x240 words as pictures, and how they differ.

use std::collections::HashMap;
use std::fs::File;
use std::io::{BufReader, BufWriter};
use std::path::Path;

use pico::PANEL;
use topleft::Pixel;

const WIDTH: usize = PANEL.width as usize;

/// Words with the low byte first.
pub(crate) fn words(bytes: &[u8]) -> Vec<u16> {
    bytes.chunks_exact(2).map(|word| u16::from_le_bytes([word[0], word[1]])).collect()
}

/// How two frames differ, if they do.
pub(crate) fn difference(shown: &[u16], drawn: &[u16]) -> Option<String> {
    if shown.len() != drawn.len() {
        return Some(format!("the panel shows {} pixels, and not {}", shown.len(), drawn.len()));
    }
    let mut places = (0..shown.len()).filter(|&place| shown[place] != drawn[place]);
    let first = places.next()?;
    let (x, y) = (first % WIDTH, first / WIDTH);
    let (is, should) = (shown[first], drawn[first]);
    let count = 1 + places.count();
    Some(format!(
        "{count} pixels are not what the host draws; the first, ({x}, {y}), is {is:04x} and not {should:04x}"
    ))
}

/// CRC-32 of words, the low byte first, as the bench computes it.
pub(crate) fn crc(words: &[u16]) -> u32 {
    let mut hash = u32::MAX;
    for byte in words.iter().flat_map(|word| word.to_le_bytes()) {
        hash ^= u32::from(byte);
        for _ in 0..8 {
            hash = (hash >> 1) ^ (0xEDB8_8320 * (hash & 1));
        }
    }
    !hash
}

/// Three bytes a pixel.
pub(crate) fn rgb(words: &[u16]) -> Vec<u8> {
    words.iter().flat_map(|&word| colour(word)).collect()
}

fn colour(word: u16) -> [u8; 3] {
    let [r, g, b] = word.channels();
    [r << 3 | r >> 2, g << 2 | g >> 4, b << 3 | b >> 2]
}

fn named<T, E: std::fmt::Display>(path: &Path, result: Result<T, E>) -> Result<T, String> {
    result.map_err(|error| format!("{}: {error}", path.display()))
}

pub(crate) fn write_png(path: &Path, words: &[u16]) -> Result<(), String> {
    let file = BufWriter::new(named(path, File::create(path))?);
    let mut encoder = png::Encoder::new(file, PANEL.width, PANEL.height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    let mut writer = named(path, encoder.write_header())?;
    named(path, writer.write_image_data(&rgb(words)))
}

/// The pixels of a picture that [`write_png`] wrote.
pub(crate) fn read_png(path: &Path) -> Result<Vec<u8>, String> {
    let decoder = png::Decoder::new(BufReader::new(named(path, File::open(path))?));
    let mut reader = named(path, decoder.read_info())?;
    let mut pixels = vec![0; reader.output_buffer_size().unwrap_or_default()];
    let info = named(path, reader.next_frame(&mut pixels))?;
    pixels.truncate(info.buffer_size());
    Ok(pixels)
}

/// Frames of an animation that are one picture of it, and how long it stays: 30 frames a second.
const EVERY: usize = 4;
const HUNDREDTHS: u16 = 13;

/// An animation without end, in the 256 colours that are seen most, or those next to them.
pub(crate) fn write_gif(path: &Path, frames: &[Vec<u16>]) -> Result<(), String> {
    let palette = palette(frames);
    let flat: Vec<u8> = palette.iter().flat_map(|&word| colour(word)).collect();
    let file = BufWriter::new(named(path, File::create(path))?);
    let mut encoder = named(path, gif::Encoder::new(file, WIDTH as u16, PANEL.height as u16, &flat))?;
    named(path, encoder.set_repeat(gif::Repeat::Infinite))?;
    let mut nearest = HashMap::new();
    for words in frames.iter().step_by(EVERY) {
        let indices: Vec<u8> =
            words.iter().map(|&word| *nearest.entry(word).or_insert_with(|| index(&palette, word))).collect();
        let mut frame = gif::Frame::from_indexed_pixels(WIDTH as u16, PANEL.height as u16, indices, None);
        frame.delay = HUNDREDTHS;
        named(path, encoder.write_frame(&frame))?;
    }
    Ok(())
}

/// The colours that are seen most, the most first; of equals, the least word.
fn palette(frames: &[Vec<u16>]) -> Vec<u16> {
    let mut counts = HashMap::<u16, usize>::new();
    for &word in frames.iter().flatten() {
        *counts.entry(word).or_default() += 1;
    }
    let mut words: Vec<_> = counts.into_iter().collect();
    words.sort_by_key(|&(word, count)| (usize::MAX - count, word));
    words.into_iter().take(256).map(|(word, _)| word).collect()
}

fn index(palette: &[u16], word: u16) -> u8 {
    let distance = |other: u16| -> u32 {
        colour(word).iter().zip(colour(other)).map(|(&a, b)| u32::from(a.abs_diff(b)).pow(2)).sum()
    };
    (0..palette.len()).min_by_key(|&at| distance(palette[at])).unwrap_or_default() as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Red when: a pixel that differs is not counted, or is named at another place.
    #[test]
    fn a_difference_is_named() {
        let frame = vec![7; WIDTH * 240];
        assert_eq!(difference(&frame, &frame), None);
        let mut other = frame.clone();
        (other[WIDTH * 2 + 3], other[WIDTH * 9]) = (8, 9);
        let text = difference(&frame, &other).unwrap();
        assert!(text.starts_with("2 pixels") && text.contains("(3, 2)"), "{text}");
        assert!(difference(&frame[1..], &frame).is_some());
    }

    /// Red when: polynomial or byte order are others than the bench's, whose check value this is.
    #[test]
    fn the_checksum_is_that_of_the_bench() {
        assert_eq!(crc(&[0x3231, 0x3433, 0x3635, 0x3837]), 0x9AE0_DAAF);
    }
}
