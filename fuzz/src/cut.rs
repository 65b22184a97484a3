//! Where a camera's planes cut a face: what is drawn of it against the face that is not cut at all.
//!
//! What clipping, rounding and the fan make of a face is a polygon. Each of its corners is the projection, rounded to
//! 1/256 px, of a point that is [`CUT`] or less from one of the face between the planes. A sum of such points in positive
//! parts is as near to another point between the planes, so a centre that the polygon covers is, within the rounding of
//! its corners, the projection of a point of the face moved by no more than `CUT`. And a centre where no such move leads
//! out of the face or through a plane is covered: a line that had all of the polygon on one side of it, and the centre on
//! the other, would cut off a point which some move takes there.

use embedded_graphics_core::geometry::Size;
use reference::homogeneous::{Face, Sure};
use reference::setup::Facing;
use reference::transform::Viewport;
use topleft::Matrix;

use crate::support::tolerance::{CUT, ROUNDED};

/// The face in clip space, or nothing where the camera shows nothing.
///
/// Coordinates are exact in 48 bits: 30 of the matrix, 15 of the cube, and 2 for the sum. 31 bits are kept of the largest
/// that the cube has, so a step of 2^-29 of it is 4 or less, and one more is what is dropped.
pub(crate) fn face(matrix: &Matrix, positions: [[i16; 3]; 3]) -> Option<Face> {
    let rows = [0, 1, 2, 3].map(|row| matrix.row(row).map(i64::from));
    let largest = rows.iter().map(|row| row.iter().map(|e| e.abs()).sum::<i64>()).max().unwrap_or(0) << 15;
    let dropped = 33_u32.checked_sub(largest.leading_zeros())?;
    let corners = positions.map(|position| {
        let [x, y, z] = position.map(i64::from);
        rows.map(|[a, b, c, t]| (a * x + b * y + c * z + (t << 15)) >> dropped)
    });
    Face::new(corners, 4 * CUT + 1)
}

/// Hits and winding numbers of the pixels of a target against the face, where it is sure what they must be.
///
/// The fan of a polygon whose corners were rounded may be folded near its corners, so a pixel inside may be hit three
/// times; one of them is the other side.
pub(crate) fn compare(face: &Face, size: Size, hits: &[i32], winding: &[i32]) -> Result<(), String> {
    let view = Viewport { width: size.width, height: size.height };
    let pixels = (0..size.height).flat_map(|y| (0..size.width).map(move |x| [x, y]));
    for (at, (&hits, &winding)) in pixels.zip(hits.iter().zip(winding)) {
        let right = match face.at(view, at, ROUNDED) {
            Some(Sure::Inside(Facing::Front)) => winding == 1,
            Some(Sure::Inside(_)) => winding == -1,
            Some(Sure::Outside) => hits == 0,
            None => true,
        };
        if !right {
            let sure = face.at(view, at, ROUNDED);
            return Err(format!("{hits} hits, winding {winding}, at {at:?}, which is {sure:?}; {face:?}"));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::support::exact::compare_mesh;
    use crate::support::winding::winding_of;
    use topleft::{Length, MatrixCamera, Mesh, Pose};

    /// Red when the band swallows it (`ROUNDED` of 4 px), or `Face::at` leaves a plane out, or its sign is the other way.
    #[test]
    fn planes_that_are_moved_by_a_64th_are_noticed() {
        let size = Size::new(64, 48);
        let one = 1 << 16;
        // w is z, and z in clip space is slope z + near: 0 at a quarter, and w at three quarters.
        let rows = |near: i32, slope: i32| {
            let rows = [[one, 0, 0, 0], [0, one, 0, 0], [0, 0, slope, near], [0, 0, one, 0]];
            Matrix::new(rows.map(|row| row.map(Length::from_bits)))
        };
        let (near, slope) = (-one * 3 / 8, one * 3 / 2);
        let positions = [[-32_000, -30_000, 30_000], [31_000, -20_000, 30_000], [500, 4_000, -10_000]];
        let mesh = Mesh::new(&positions, &[[0, 1, 2]]).expect("three vertices");
        let camera = MatrixCamera::<true>::new(size, rows(near, slope));
        let (polygons, hits) = compare_mesh(&camera, &mesh, &Pose::new()).expect("exact");
        let winding = winding_of(&polygons.edges(), 64, 48);
        let against = |near, slope| {
            compare(&face(&rows(near, slope), positions).expect("a face"), size, &hits, &winding)
        };
        assert_eq!(against(near, slope), Ok(()));
        for moved in [-one / 64, one / 64] {
            assert!(against(near + moved, slope).is_err(), "near by {moved}");
            assert!(against(near, slope + moved).is_err(), "far by {moved}");
        }
        let other = hits.iter().map(|hits| 1 - hits).collect::<Vec<_>>();
        assert!(
            compare(&face(&rows(near, slope), positions).expect("a face"), size, &other, &winding).is_err()
        );
    }
}
