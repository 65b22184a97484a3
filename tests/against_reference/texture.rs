//! Texels and texture coordinates: exact.

use reference::shade::{texel, uv};
use topleft::stages::Shader;
use topleft::{MAX_UV_EXPONENT, Mesh, PerPixel, Pose, Texture, Textured, Wrap};

use crate::random::Random;

/// Turned red by: `%` for the repeat, a clamp at the size instead of the last texel.
#[test]
fn texels_repeat_and_clamp_as_the_reference_says() {
    let mut random = Random::new(31);
    let texels: Vec<u16> = (0..1 << 20).map(|_| random.next() as u16).collect();
    for (width, height) in [(1, 1), (1, 1024), (1024, 1), (2, 8), (64, 32), (1024, 1024)] {
        let texels = &texels[..usize::from(width) * usize::from(height)];
        for wrap in [Wrap::Repeat, Wrap::Clamp] {
            let texture = Texture::new(width, height, texels).unwrap().with_wrap(wrap);
            let ends = [i32::MIN, -1025, -1024, -2, -1, 0, 1, 1023, 1024, i32::MAX];
            let any = (0..2000).map(|i| (random.next() >> (i % 32)) as i32).collect::<Vec<_>>();
            let near = (0..200).map(|i| i - 100);
            let columns: Vec<i32> = ends.into_iter().chain(any).chain(near).collect();
            for &u in &columns {
                let v = columns[random.within(0, columns.len() as i64 - 1) as usize];
                for (u, v) in [(u, v), (v, u)] {
                    let exact = texel(&texture, [f64::from(u), f64::from(v)]);
                    assert_eq!(texture.texel(u, v), exact, "{width}x{height} {wrap:?} at {u}, {v}");
                }
            }
        }
    }
}

/// Turned red by: an exponent that is left out.
#[test]
fn coordinates_are_those_of_the_mesh() {
    let mut random = Random::new(32);
    let texels = vec![0; 1 << 20];
    for round in 0..2000 {
        let [width, height] = [(); 2].map(|()| 1 << random.within(0, 10));
        let texture =
            Texture::new(width, height, &texels[..usize::from(width) * usize::from(height)]).unwrap();
        let exponent = (round % (usize::from(MAX_UV_EXPONENT) + 1)) as u8;
        let raw = [[random.next() as i16, random.next() as i16], [i16::MIN, i16::MAX]];
        let mesh = Mesh::new(&[[0; 3]; 2], &[]).unwrap().with_uvs(&raw, exponent).unwrap();
        let shader = Textured::new(&texture, PerPixel);
        Shader::<u16>::local(&shader, &mesh, &Pose::new());
        for (vertex, &raw) in raw.iter().enumerate() {
            let ours = Shader::<u16>::vertex(&shader, &(), &mesh, vertex);
            let exact = uv(raw, exponent, &texture);
            assert_eq!(ours.map(|c| f64::from(c.to_bits()) / 65_536.0), exact, "{raw:?} of {width}x{height}");
        }
    }
}
