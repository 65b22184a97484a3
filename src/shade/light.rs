//! Ambient and directional light on diffuse materials, in code values: no gamma.

use crate::math::format::Length;
use crate::math::product;
use crate::math::recip::normalise;
use crate::mesh::Mesh;
use crate::pose::Pose;

/// Light from all around, and light from one direction.
///
/// Light is `ambient + diffuse * max(0, n . direction)`, at most 1, and a surface shows its colour times the light, in
/// code values. Normals are taken as they are: as long as 127 is one.
///
/// ```
/// use topleft::{Length, Sun};
///
/// let overhead = Sun::new([Length::ZERO, Length::ONE, Length::ZERO]).with_ambient(51).with_diffuse(204);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sun {
    /// Towards the light, length 1 in 30 fraction bits.
    direction: [i32; 3],
    ambient: u8,
    diffuse: u8,
}

impl Sun {
    /// A sun that stands in `direction` of the scene, seen from anywhere; its length does not matter. A fifth of the
    /// light is ambient, the rest diffuse.
    pub fn new(direction: [Length; 3]) -> Self {
        Self { direction: normalise(direction.map(Length::to_bits)), ambient: 51, diffuse: 204 }
    }

    /// Sets the light from all around: 255 is full.
    #[must_use]
    pub const fn with_ambient(mut self, ambient: u8) -> Self {
        self.ambient = ambient;
        self
    }

    /// Sets the light on a surface that faces the sun: 255 is full.
    #[must_use]
    pub const fn with_diffuse(mut self, diffuse: u8) -> Self {
        self.diffuse = diffuse;
        self
    }
}

/// What falls on a surface: a [`Sun`], or nothing.
///
/// A type parameter of the shaders: without light, none of its code is linked.
pub trait Lighting: Copy {
    /// What is computed once a mesh.
    type Local;

    /// The light as a mesh in this pose sees it.
    #[doc(hidden)]
    fn local(&self, pose: &Pose) -> Self::Local;

    /// The colour of a face under the light.
    #[doc(hidden)]
    fn on_face(local: &Self::Local, mesh: &Mesh<'_>, face: usize, colour: [u8; 3]) -> [u8; 3];

    /// The colour of a vertex under the light.
    #[doc(hidden)]
    fn on_vertex(local: &Self::Local, mesh: &Mesh<'_>, vertex: usize, colour: [u8; 3]) -> [u8; 3];
}

/// No light: colours are shown as they are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Unlit;

impl Lighting for Unlit {
    type Local = ();

    #[inline]
    fn local(&self, _: &Pose) {}

    #[inline]
    fn on_face((): &(), _: &Mesh<'_>, _: usize, colour: [u8; 3]) -> [u8; 3] {
        colour
    }

    #[inline]
    fn on_vertex((): &(), _: &Mesh<'_>, _: usize, colour: [u8; 3]) -> [u8; 3] {
        colour
    }
}

impl Lighting for Sun {
    type Local = LocalSun;

    fn local(&self, pose: &Pose) -> LocalSun {
        LocalSun {
            direction: pose.to_model(self.direction).map(|c| c >> 15),
            ambient: i32::from(self.ambient),
            diffuse: i32::from(self.diffuse),
        }
    }

    fn on_face(sun: &LocalSun, mesh: &Mesh<'_>, face: usize, colour: [u8; 3]) -> [u8; 3] {
        lit(colour, sun.on_face(mesh, face))
    }

    fn on_vertex(sun: &LocalSun, mesh: &Mesh<'_>, vertex: usize, colour: [u8; 3]) -> [u8; 3] {
        lit(colour, sun.on_vertex(mesh, vertex))
    }
}

/// A sun in the turned frame of a mesh.
#[derive(Clone, Copy, Debug)]
pub struct LocalSun {
    /// 15 fraction bits.
    direction: [i32; 3],
    ambient: i32,
    diffuse: i32,
}

/// Light: 0 to 255 in 8 fraction bits.
type Light = u32;
/// Full light.
const FULL: i32 = 255 << 8;

impl LocalSun {
    /// The light on a surface with this normal, 127 being 1; 255 in 8 fraction bits is full.
    fn on(&self, normal: [i8; 3]) -> Light {
        let [x, y, z] = normal.map(i32::from);
        let [dx, dy, dz] = self.direction;
        // 15 fraction bits times 127: below 2^23.8. Divided by 127 in the next product: 2^16 / 127 = 516.03.
        let cosine = (((x * dx + y * dy + z * dz) >> 7).max(0) * 516) >> 9;
        // 15 fraction bits now, at most 1.74 for a normal that is too long.
        let light = (self.ambient << 8) + ((self.diffuse * cosine) >> 7);
        light.min(FULL).unsigned_abs()
    }

    /// The light on a vertex; one without a normal has ambient light only.
    pub(crate) fn on_vertex(&self, mesh: &Mesh<'_>, vertex: usize) -> Light {
        self.on(mesh.normals().get(vertex).copied().unwrap_or_default())
    }

    /// The light on a face: by its own normal, or that of its plane.
    pub(crate) fn on_face(&self, mesh: &Mesh<'_>, face: usize) -> Light {
        self.on(match mesh.face_normals().get(face) {
            Some(normal) => *normal,
            None => plane_normal(mesh, face).unwrap_or_default(),
        })
    }
}

/// The normal of a face's plane, towards the side it is counter-clockwise from. Apart, so that an image shows whether light
/// is linked.
#[inline(never)]
fn plane_normal(mesh: &Mesh<'_>, face: usize) -> Option<[i8; 3]> {
    let corner = |index: u16| mesh.positions().get(usize::from(index)).map(|p| p.map(i32::from));
    let [a, b, c] = mesh.faces().get(face).copied()?;
    let ([ax, ay, az], [bx, by, bz], [cx, cy, cz]) = (corner(a)?, corner(b)?, corner(c)?);
    let (ux, uy, uz) = (bx - ax, by - ay, bz - az);
    let (vx, vy, vz) = (cx - ax, cy - ay, cz - az);
    let minor = |a, d, b, c| product::signed(a, d) - product::signed(b, c);
    let cross = [minor(uy, vz, uz, vy), minor(uz, vx, ux, vz), minor(ux, vy, uy, vx)];
    // 34 bits at the most: as many as fit are kept.
    let bits = cross.iter().fold(0, |bits, c| bits | c.unsigned_abs());
    let spare = bits.leading_zeros().saturating_sub(34);
    let shifted = cross.map(|c| ((c << spare) >> 4) as i32);
    Some(normalise(shifted).map(|c| ((product::signed(c, 127) + (1 << 29)) >> 30) as i8))
}

/// The colour of a surface in full light.
///
/// ```
/// use embedded_graphics_core::pixelcolor::Rgb888;
/// use topleft::Material;
///
/// let brass = Material::from(Rgb888::new(0xD0, 0xA0, 0x40));
/// assert_eq!(brass, Material::Colour([0xD0, 0xA0, 0x40]));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Material {
    /// One colour: red, green, blue.
    Colour([u8; 3]),
    /// The mesh's own colours, by vertex or by face; white where it has none.
    #[default]
    OfMesh,
}

impl<C: embedded_graphics_core::pixelcolor::RgbColor> From<C> for Material
where
    embedded_graphics_core::pixelcolor::Rgb888: From<C>,
{
    fn from(colour: C) -> Self {
        use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};
        let colour = Rgb888::from(colour);
        Self::Colour([colour.r(), colour.g(), colour.b()])
    }
}

const WHITE: [u8; 3] = [255; 3];

impl Material {
    /// The colour of a vertex.
    pub(crate) fn of_vertex(&self, mesh: &Mesh<'_>, vertex: usize) -> [u8; 3] {
        match self {
            Self::Colour(colour) => *colour,
            Self::OfMesh => mesh.vertex_colours().get(vertex).copied().unwrap_or(WHITE),
        }
    }

    /// The colour of a face.
    pub(crate) fn of_face(&self, mesh: &Mesh<'_>, face: usize) -> [u8; 3] {
        match self {
            Self::Colour(colour) => *colour,
            Self::OfMesh => mesh.face_colours().get(face).copied().unwrap_or(WHITE),
        }
    }
}

/// A colour under light, rounded to nearest.
pub(crate) fn lit([r, g, b]: [u8; 3], light: Light) -> [u8; 3] {
    let channel = |c: u8| over_full(u32::from(c) * light + (FULL as u32 / 2)) as u8;
    [channel(r), channel(g), channel(b)]
}

/// `x / FULL`, for what a colour under light can be: the first 16 bits over 255, of which `1 / 2^8 + 1 / 2^16` is little less.
const fn over_full(x: u32) -> u32 {
    let x = x >> 8;
    (x + (x >> 8) + 1) >> 8
}

#[cfg(test)]
mod tests {
    use super::*;

    // Red without one of the four.
    #[test]
    fn all_light_on_all_colours_is_rounded_to_nearest() {
        let full = FULL.unsigned_abs();
        for x in 0..=255 * full + full / 2 {
            assert_eq!(over_full(x), x / full, "{x}");
        }
    }
}
