//! Whether a mesh is convex: with its back faces culled, such a mesh hides itself.

use crate::mesh::Mesh;

impl Mesh<'_> {
    /// Whether every vertex lies on or behind the plane of every face; or, of a room that is seen from inside, on or before
    /// the plane of every face. Exact, and usable in a `const`.
    ///
    /// Each ray of sight then meets at most one face from its front and at most one from its back: where either kind is
    /// culled, nothing of the mesh hides anything else of it. The surface need not be closed. Faces of one plane have no
    /// order among themselves, whatever hides what: a mesh in which some cover each other is convex all the same.
    ///
    /// A face without area has no plane. One with two corners in one place is never drawn, and says nothing. One with
    /// three corners in a row can be seen once they are snapped to the screen, and may lie anywhere inside: a mesh with
    /// such a face does not count as convex. A face that is seen less than a step or two of 1/256 px high can be turned over
    /// by snapping as well: that depends on how far away it is, and is not looked at.
    ///
    /// It takes a product of each face with each vertex, up to the first that contradicts another.
    ///
    /// ```
    /// use topleft::Mesh;
    ///
    /// const CORNERS: [[i16; 3]; 5] = [[9, 9, 9], [9, -9, -9], [-9, 9, -9], [-9, -9, 9], [0, 0, 0]];
    /// let tetrahedron = Mesh::new(&CORNERS, &[[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]]).unwrap();
    /// let dented = Mesh::new(&CORNERS, &[[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 4], [3, 2, 4], [2, 1, 4]]).unwrap();
    /// assert!(tetrahedron.is_convex() && !dented.is_convex());
    /// ```
    pub const fn is_convex(&self) -> bool {
        let positions = self.positions();
        let mut faces = self.faces();
        let mut sides = Sides { before: false, behind: false };
        while let [[a, b, c], rest @ ..] = faces {
            let (a, b, c) = (position(positions, *a), position(positions, *b), position(positions, *c));
            let (along, across) = (minus(b, a), minus(c, a));
            let normal = cross(along, across);
            if is_nothing(normal) {
                if !is_nothing(along) && !is_nothing(across) && !is_nothing(minus(c, b)) {
                    return false;
                }
            } else {
                sides = sides.with(positions, a, normal);
            }
            if sides.before && sides.behind {
                return false;
            }
            faces = rest;
        }
        true
    }
}

/// Whether any vertex lies before the plane of a face, and whether any lies behind one.
#[derive(Clone, Copy)]
struct Sides {
    before: bool,
    behind: bool,
}

impl Sides {
    /// With those of a plane: as far as it takes to find both.
    const fn with(mut self, mut positions: &[[i16; 3]], point: Steps, [x, y, z]: Steps) -> Self {
        while let [position, rest @ ..] = positions {
            let [dx, dy, dz] = minus(steps(*position), point);
            let height = x * dx + y * dy + z * dz;
            self.before |= height > 0;
            self.behind |= height < 0;
            if self.before && self.behind {
                break;
            }
            positions = rest;
        }
        self
    }
}

/// A position in whole steps. Those of two lie up to 2^16 apart, so a normal has 34 bits, and its product with a third
/// 52.
type Steps = [i64; 3];

/// Where a vertex is that a face names: a mesh has it.
const fn position(positions: &[[i16; 3]], vertex: u16) -> Steps {
    match positions.split_at_checked(vertex as usize) {
        Some((_, [position, ..])) => steps(*position),
        _ => [0; 3],
    }
}

const fn steps([x, y, z]: [i16; 3]) -> Steps {
    [x as i64, y as i64, z as i64]
}

const fn minus([a, b, c]: Steps, [x, y, z]: Steps) -> Steps {
    [a - x, b - y, c - z]
}

const fn cross([a, b, c]: Steps, [x, y, z]: Steps) -> Steps {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

const fn is_nothing(steps: Steps) -> bool {
    matches!(steps, [0, 0, 0])
}
