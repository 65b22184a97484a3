//! What hides what in a scene: the cheapest way that is safe, asked before the scene is drawn.

use heapless::Vec;

use crate::camera::Camera;
use crate::depth::Nearness;
use crate::math::format::Length;
use crate::math::matrix::Matrix;
use crate::mesh::Mesh;
use crate::pose::Pose;
use crate::transform::Transform;

/// Meshes in view that may be found to be apart: more of them get a depth buffer.
const MOST_APART: usize = 32;

/// A way to hide what is hidden, from the cheapest to the dearest.
///
/// ```
/// use embedded_graphics_core::geometry::Size;
/// use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};
/// use topleft::{DrawError, Hiding, Length, ListStorage, Perspective, Pose, Strip, Turn};
/// use topleft::{Depth, DrawList, Flat, Material, Mesh};
/// # use scenes::mesh::CUBE;
///
/// let camera = Perspective::new(Size::new(64, 64), Turn::from_degrees(50), 1.0..20.0);
/// let [near, far] = ["-4", "-9"].map(|z| Pose::new().at([Length::ZERO, Length::ZERO, Length::lit(z)]));
/// let things = [(&CUBE, &near), (&CUBE, &far)];
/// // The same for lists of all kinds.
/// fn draw<D: Depth>(
///     list: &mut DrawList<'_, Rgb565, D>,
///     camera: &Perspective,
///     things: &[(&Mesh<'_>, &Pose)],
/// ) -> Result<(), DrawError> {
///     things.iter().try_for_each(|(mesh, pose)| list.draw(camera, mesh, pose, &Flat::new(Material::OfMesh)))
/// }
///
/// let mut storage: ListStorage<1000, 24> = ListStorage::new();
/// let (mut colours, mut depths) = ([Rgb565::BLACK; 64 * 64], [0; 64 * 64]);
/// let mut frame = Strip::new(64, &mut colours)?;
/// let one_percent = Length::lit("0.01");
/// match Hiding::cheapest(&camera, &things, one_percent) {
///     Hiding::Culling => {
///         let mut list = storage.list();
///         draw(&mut list, &camera, &things)?;
///         list.render(0..64, &mut frame);
///     }
///     Hiding::Painter => {
///         let mut list = storage.list();
///         draw(&mut list, &camera, &things)?;
///         list.sort(&mut [[0; 3]; 24])?;
///         list.render(0..64, &mut frame.for_painter());
///     }
///     Hiding::Depth16 => {
///         let mut list = storage.list();
///         draw(&mut list, &camera, &things)?;
///         list.render(0..64, &mut frame.with_depth(&mut depths)?);
///     }
///     Hiding::DepthFloat => {
///         let mut list = storage.list();
///         draw(&mut list, &camera, &things)?;
///         list.render(0..64, &mut frame.with_depth_float(&mut depths)?);
///     }
/// }
/// assert_eq!(Hiding::cheapest(&camera, &things, one_percent), Hiding::Painter);
/// assert_eq!(Hiding::cheapest(&camera, &things[..1], one_percent), Hiding::Culling);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Hiding {
    /// Nothing but culling: [`NoDepth`](crate::NoDepth). For at most one mesh in view, which is convex. With
    /// [`Cull::None`](crate::Cull::None) it is not enough.
    Culling,
    /// A list that is sorted: [`Painter`](crate::Painter). For convex meshes of which each is nearer than the next as a
    /// whole.
    Painter,
    /// A buffer that is linear on the screen: [`Depth16`](crate::Depth16).
    Depth16,
    /// A buffer of small floats, which tells far things apart as well as near ones: [`DepthFloat`](crate::DepthFloat).
    DepthFloat,
}

impl Hiding {
    /// The cheapest way that shows nothing of what is hidden, where one kind of faces is culled
    /// ([`Cull::Back`](crate::Cull::Back), as lists do unless told otherwise): but for slivers that are seen less than a step
    /// or two of 1/256 px high. Snapping can turn such a one on the far side over, and it then shows where it holds a
    /// pixel centre.
    ///
    /// `gap` is what a depth buffer has to tell apart: how far one surface lies behind another, as a share of their
    /// distance from the eye. Where it is 0 or negative, the buffer is the one that is finer at the farthest thing in view.
    /// 0.01 is one percent. It is not looked at where no buffer is needed.
    ///
    /// What is known to be safe, and why:
    ///
    /// * [`Culling`](Self::Culling), where at most one mesh is in view, and that is [convex](Mesh::is_convex): a ray of
    ///   sight enters it once.
    /// * [`Painter`](Self::Painter), where all meshes in view are convex, and their ranges of depth, between the nearest
    ///   and the farthest corner of their [bounds](Mesh::bounds), have no [key](crate::DrawList::sort) in common. Every
    ///   triangle's key lies in the range of its mesh, so a nearer mesh is drawn later as a whole; in what order its
    ///   own triangles are drawn does not matter, as none hides another. Of more than 32 meshes in view this is not asked.
    /// * [`Depth16`](Self::Depth16), where one step of its codes at the farthest depth in view is no more than the gap,
    ///   `w (1 / near - 1 / far) / 65528` of the distance w; or where it is no coarser there than the small float, which
    ///   is so in the nearest 15/16 of all codes. Without perspective it always is.
    /// * [`DepthFloat`](Self::DepthFloat) otherwise: it tells apart what is 2^-12 of its distance apart, wherever it is.
    ///   Where the gap is less than that, no buffer of 16 bits does, and this one comes nearer to it.
    ///
    /// What is in view is decided by bounds; what the view does not reach is not counted. A mesh that the near plane cuts
    /// reaches up to the eye. Where nothing can be drawn, as the camera is not valid or its target too large, culling is
    /// enough.
    ///
    /// Whether meshes are convex is looked at last, where all else allows to go without a buffer: it takes a product of
    /// each face with each vertex, which for meshes of hundreds of faces is more than to draw them. Ask once a scene then,
    /// not once a frame. Anything else takes some thousand cycles a mesh.
    pub fn cheapest<C: Camera>(camera: &C, things: &[(&Mesh<'_>, &Pose)], gap: Length) -> Self {
        let (Ok(viewport), false) = (camera.viewport(), *camera.matrix() == Matrix::NOWHERE) else {
            return Self::Culling;
        };
        let mut ranges: Vec<(&Mesh<'_>, [u16; 2]), MOST_APART> = Vec::new();
        let (mut farthest, mut too_many) = (u32::MAX, false);
        for &(mesh, pose) in things {
            let transform = Transform::new(viewport, camera.matrix(), mesh, pose);
            if mesh.faces().is_empty() || transform.misses(mesh.bounds()) {
                continue;
            }
            let [far, near] = transform.depths(mesh.bounds());
            farthest = farthest.min(far);
            let keys = [far, near].map(|depth| Nearness::key([Nearness::new(depth); 3]));
            too_many |= ranges.push((mesh, keys)).is_err();
        }
        if too_many || !are_apart(&ranges) || !ranges.iter().all(|(mesh, _)| mesh.is_convex()) {
            Self::buffer(camera.matrix(), farthest, gap)
        } else if ranges.len() > 1 {
            Self::Painter
        } else {
            Self::Culling
        }
    }

    /// The cheapest buffer for what is no farther than a depth of `1 - z / w`, in 32 fraction bits.
    fn buffer(matrix: &Matrix, farthest: u32, gap: Length) -> Self {
        /// A gap times the depth above which one code is as much, in 16 and 32 fraction bits.
        const CODE: u64 = (1_u64 << 48).div_ceil(65_528);
        // z = a w + b, so `1 - z / w + (a - 1)` is in proportion to 1 / w: a code is 1 / 65528 of it in the distance where
        // it is 1. Along the axis where w has most digits.
        let [[zx, zy, zz, _], [wx, wy, wz, _]] = [matrix.row(2), matrix.row(3)];
        let Some((z, w)) = [(zx, wx), (zy, wy), (zz, wz)].into_iter().max_by_key(|(_, w)| w.unsigned_abs())
        else {
            return Self::Depth16;
        };
        let beyond = ((i64::from(z) - i64::from(w)) << 31).checked_div(i64::from(w));
        let Some(beyond) = beyond else { return Self::Depth16 };
        let depth = u64::from(farthest) + 2 * beyond.max(0).unsigned_abs();
        let gap = u64::from(gap.to_bits().max(0).unsigned_abs());
        // The small float has 12 bits of each octave: from the fourth one down its steps are less than a code.
        if gap.saturating_mul(depth) >= CODE || farthest >= 1 << 28 {
            Self::Depth16
        } else {
            Self::DepthFloat
        }
    }
}

/// Whether no two ranges have a number in common.
fn are_apart(ranges: &[(&Mesh<'_>, [u16; 2])]) -> bool {
    let mut rest = ranges;
    while let [(_, [far, near]), others @ ..] = rest {
        if others.iter().any(|(_, [other_far, other_near])| far <= other_near && other_far <= near) {
            return false;
        }
        rest = others;
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    // Red when ranges may touch, when one may lie in another, or when only neighbours are compared.
    #[test]
    fn ranges_are_apart_where_they_have_no_number_in_common() {
        let mesh = Mesh::new(&[], &[]).unwrap();
        let apart = |ranges: &[[u16; 2]]| {
            let ranges: Vec<_, MOST_APART> = ranges.iter().map(|&range| (&mesh, range)).collect();
            are_apart(&ranges)
        };
        assert!(
            apart(&[]) && apart(&[[3, 5]]) && apart(&[[3, 5], [6, 9]]) && apart(&[[6, 9], [3, 5], [1, 2]])
        );
        assert!(!apart(&[[3, 5], [5, 9]]) && !apart(&[[5, 9], [3, 5]]) && !apart(&[[3, 9], [5, 6]]));
        assert!(!apart(&[[5, 6], [3, 9]]) && !apart(&[[3, 3], [7, 8], [3, 3]]));
    }
}
