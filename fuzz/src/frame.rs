//! The whole pipeline: a frame of any meshes.

use std::ops::RangeInclusive;

use arbitrary::Arbitrary;
use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use embedded_graphics::prelude::RgbColor;
use topleft::{Cull, Depth16, DepthFloat, Material, NoDepth, Painter, Sun};

use crate::lens::{Lens, Target};
use crate::numbers::{Mostly, Number, Place};
use crate::picture::{Item, Look, Picture};
use crate::soup::{Image, Soup};
use crate::support::frame::Strips;

/// Any meshes in any places, seen by any camera, drawn into a list of any size and rendered in strips of any height.
#[derive(Arbitrary, Clone, Debug)]
pub struct Frame {
    target: Target,
    lens: Lens,
    /// What hides what: odd with a depth, as 16-bit colours, of small floats where the next bit is set; even without, as 24-bit
    /// ones, and sorted where the fourth is. By that bit all seeds draw something, also those whose lists have no word to spare.
    hiding: u8,
    /// Words and triangles of the list: usually enough.
    storage: Mostly<(), [u16; 2]>,
    window: [u8; 2],
    /// The first row that is looked at: usually the target's.
    top: Mostly<(), Mostly<i8, i32>>,
    strip_height: u8,
    display: [u8; 2],
    image: Image,
    sun: ([Number; 3], u8),
    first: Draw,
    second: Option<Draw>,
    /// The first once more: its shader's vertices are then on both sides of another's.
    again: bool,
}

#[derive(Arbitrary, Clone, Debug)]
struct Draw {
    place: Place,
    cull: u8,
    look: Look,
    colour: Option<[u8; 3]>,
    soup: Soup,
}

/// Most columns and rows that are looked at.
const MOST: u8 = 40;

impl Frame {
    /// Draws the frame in all ways, and gives back how many of its pixels something is seen in.
    ///
    /// # Panics
    /// Two of them differ, or what is drawn cannot be.
    pub fn check(&self) -> usize {
        let draws: Vec<&Draw> = [Some(&self.first), self.second.as_ref(), self.again.then_some(&self.first)]
            .into_iter()
            .flatten()
            .collect();
        let slices: Vec<_> = draws.iter().map(|draw| draw.soup.slices()).collect();
        let texels = self.image.texels();
        let (direction, ambient) = self.sun;
        let sun = Sun::new(direction.map(Number::length)).with_ambient(ambient);
        let item = |(draw, slices)| {
            let draw: &&Draw = draw;
            Item {
                mesh: draw.soup.mesh(slices),
                pose: draw.place.pose(),
                cull: [Cull::None, Cull::Back, Cull::Front, Cull::None][usize::from(draw.cull % 4)],
                look: draw.look,
                material: draw
                    .colour
                    .map_or(Material::OfMesh, |[r, g, b]| Material::from(Rgb888::new(r, g, b))),
                sun,
                texture: self.image.texture(&texels),
            }
        };
        let [columns, rows] = self.window.map(|length| length % MOST + 1);
        let top = match self.top {
            Mostly::Usual(()) => 0,
            Mostly::Any(Mostly::Usual(row)) => row.into(),
            Mostly::Any(Mostly::Any(row)) => row.min(i32::MAX - i32::from(MOST)),
        };
        let size = self.target.size();
        let picture = Picture {
            size,
            camera: self.lens.camera(size),
            items: draws.iter().zip(&slices).map(item).collect(),
            storage: match self.storage {
                Mostly::Usual(()) => [12_000, 1_000],
                // Up to what most frames need: the list ends everywhere in one.
                Mostly::Any([words, triangles]) => [usize::from(words % 512), usize::from(triangles % 64)],
            },
            columns: columns.into(),
            rows: top..top + i32::from(rows),
            height: usize::from(self.strip_height % MOST) + 1,
            display: self.display.map(|length| (length % MOST).into()),
        };
        let seen = match (self.hiding & 1, self.hiding & 2, self.hiding & 8) {
            (0, _, 0) => check_flat::<NoDepth>(&picture),
            (0, ..) => check_flat::<Painter>(&picture),
            // From 4 at the far plane to 65532 at the near one, and less than a code of error.
            (_, 0, _) => check_deep::<Depth16>(&picture, 3..=65_532),
            // From 256 at the far plane to the last of all, and at most 145 codes of error there: the margin's bound.
            _ => check_deep::<DepthFloat>(&picture, 111..=u16::MAX),
        };
        seen.unwrap_or_else(|error| panic!("{error}\n{self:#?}"))
    }
}

/// 16-bit colours with depth, whose codes are in a range.
fn check_deep<D: Strips>(picture: &Picture<'_>, codes: RangeInclusive<u16>) -> Result<usize, String> {
    let frame = picture.check::<Rgb565, D>()?;
    if let Some(depth) = frame.depths.iter().find(|&&depth| depth != 0 && !codes.contains(&depth)) {
        return Err(format!("a depth of {depth} is beyond a plane"));
    }
    if frame.colours.iter().zip(&frame.depths).any(|(&colour, &depth)| depth == 0 && colour != Rgb565::BLACK)
    {
        return Err("a colour without a depth".into());
    }
    Ok(frame.seen())
}

/// 24-bit colours without depth.
fn check_flat<D: Strips>(picture: &Picture<'_>) -> Result<usize, String> {
    let frame = picture.check::<Rgb888, D>()?;
    Ok(frame.colours.iter().filter(|&&colour| colour != Rgb888::BLACK).count())
}
