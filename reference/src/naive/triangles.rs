//! The worst cases of coverage and of slivers, for tests and pictures. Places are in 1/256 px where nothing else is said.

use crate::setup::Triangle;

/// Two triangles of a rectangle whose corners are the centres of pixels, split from its top left, or from its bottom
/// left: as many centres lie on the common edge as the sides have a common divisor, and one.
pub fn rectangle_on_centres([left, top]: [i32; 2], [width, height]: [i32; 2], rising: bool) -> [Triangle; 2] {
    let at = |x: i32, y: i32| [x * 256 + 128, y * 256 + 128];
    let (right, bottom) = (left + width, top + height);
    let corners = [at(left, top), at(left, bottom), at(right, bottom), at(right, top)];
    let [a, b, c, d] = corners;
    if rising { [[b, c, d], [b, d, a]] } else { [[a, b, c], [a, c, d]] }
}

/// A closed fan: the triangles between a hub and the points round it.
pub fn fan(hub: [i32; 2], ring: &[[i32; 2]]) -> Vec<Triangle> {
    let next = ring.iter().cycle().skip(1);
    ring.iter().zip(next).map(|(&from, &to)| [hub, from, to]).collect()
}

/// `spokes` points on a circle of `radius` pixels round a hub, counter-clockwise as seen from `phase` radians on, on a
/// lattice of `lattice` steps.
pub fn ring(hub: [i32; 2], radius: f64, spokes: u32, phase: f64, lattice: i32) -> Vec<[i32; 2]> {
    let place = |spoke: u32| {
        let (sin, cos) = (phase + std::f64::consts::TAU * f64::from(spoke) / f64::from(spokes)).sin_cos();
        let on_lattice = |at: i32, away: f64| {
            let units = (f64::from(at) + away * radius * 256.0) / f64::from(lattice);
            units.round() as i32 * lattice
        };
        [on_lattice(hub[0], cos), on_lattice(hub[1], -sin)]
    };
    (0..spokes).map(place).collect()
}

/// A right-angled triangle of two legs in pixels, of either sign: at its right angle the third edge's function is as
/// large as that of any triangle with this box.
pub fn right_angle(corner: [i32; 2], [along, down]: [i32; 2]) -> Triangle {
    let [x, y] = corner;
    [corner, [x + along * 256, y], [x, y + down * 256]]
}

/// A needle that starts at the centre of the pixel `from` and goes `across` pixels, to a point and to another `beside`
/// it. One edge runs through the centres of pixels, as many as `across` has a common divisor, and one.
pub fn needle(from: [i32; 2], across: [i32; 2], beside: [i32; 2]) -> Triangle {
    let start = from.map(|pixel| pixel * 256 + 128);
    let end = [0, 1].map(|axis| start[axis] + across[axis] * 256);
    [start, end, [0, 1].map(|axis| end[axis] + beside[axis])]
}

/// Four triangles in pixels, not snapped, without a fold: over and under a line whose ends are rounded down and up, and
/// between them a sliver that snapping turns over. It then lies on the centres of `row`, from `part` of the `length`
/// pixels on.
pub fn turned_over([left, row]: [f64; 2], length: f64, part: f64) -> [[[f64; 2]; 3]; 4] {
    // In 3/32 of 1/256 px: 18/32, 12/32 and -15/32 of a step are rounded to 1, 0 and 0.
    let at = |x: f64, units: f64| [x, row + 0.5 + units * 3.0 / 32.0 / 256.0];
    let (a, m, b) = (at(left, 6.0), at(left + length * part, 4.0), at(left + length, -5.0));
    let (over, under) = ([left + length * 0.5, row - 9.5], [left + length * 0.5, row + 10.5]);
    [[a, b, over], [a, m, b], [a, under, m], [m, under, b]]
}

/// A triangle over an edge, two under it, whose common vertex stands on that edge before it is rounded to `bits`
/// sub-pixel bits; and the needle that then lies between them. All are counter-clockwise as seen before rounding, but
/// the needle may be either way round.
pub fn t_junction(ends: [[f64; 2]; 2], part: f64, bits: u32) -> ([Triangle; 3], Triangle) {
    let unit = f64::from(1_u32 << bits);
    let snap = |place: [f64; 2]| place.map(|c| (c * unit).round() as i32 * (256 >> bits));
    let [p, q] = ends;
    let along = |part: f64| [p[0] + (q[0] - p[0]) * part, p[1] + (q[1] - p[1]) * part];
    let [mx, my] = along(0.5);
    let (over, under) = (snap([mx, my - 60.0]), snap([mx, my + 60.0]));
    let (p, m, q) = (snap(p), snap(along(part)), snap(q));
    ([[p, q, over], [p, under, m], [m, under, q]], [q, p, m])
}
