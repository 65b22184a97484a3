//! PNG files: the fewest bits a pixel that its colours need, and the same bytes on every run.

use crate::canvas::{Canvas, Colour};

/// The bytes of a PNG: with a palette where 256 colours are enough.
pub(crate) fn png(canvas: &Canvas) -> Vec<u8> {
    let mut palette: Vec<Colour> = canvas.pixels().to_vec();
    palette.sort_unstable();
    palette.dedup();
    let [width, height] = canvas.size();
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width.unsigned_abs(), height.unsigned_abs());
    encoder.set_compression(png::Compression::High);
    let data = if palette.len() <= 256 {
        let depth = [1_u8, 2, 4, 8].into_iter().find(|&bits| palette.len() <= 1 << bits).unwrap_or(8);
        encoder.set_color(png::ColorType::Indexed);
        encoder.set_depth(match depth {
            1 => png::BitDepth::One,
            2 => png::BitDepth::Two,
            4 => png::BitDepth::Four,
            _ => png::BitDepth::Eight,
        });
        encoder.set_palette(palette.concat());
        // Neighbours in a palette are not alike.
        encoder.set_filter(png::Filter::NoFilter);
        packed(canvas, &palette, depth)
    } else {
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_filter(png::Filter::Adaptive);
        canvas.pixels().concat()
    };
    let mut writer = encoder.write_header().expect("a size that is not 0");
    writer.write_image_data(&data).expect("as many bytes as pixels need");
    writer.finish().expect("memory takes all that is written");
    bytes
}

/// Rows of the palette's numbers, `bits` each, from the left; each row starts with a new byte.
fn packed(canvas: &Canvas, palette: &[Colour], bits: u8) -> Vec<u8> {
    let width = canvas.size()[0].unsigned_abs() as usize;
    let per_byte = usize::from(8 / bits);
    let number =
        |colour: &Colour| palette.binary_search(colour).expect("every colour is in the palette") as u8;
    let byte = |pixels: &[Colour]| {
        let numbers = pixels.iter().map(number).chain(std::iter::repeat(0)).take(per_byte);
        numbers.fold(0_u16, |byte, number| byte << bits | u16::from(number)) as u8
    };
    canvas.pixels().chunks(width).flat_map(|row| row.chunks(per_byte).map(byte)).collect()
}
