//! Fans: triangles that share a vertex and, two by two, an edge.

use std::cell::Cell;
use std::cmp::Ordering;

use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use proptest::collection::vec;
use proptest::prelude::*;
use reference::setup::Triangle;
use topleft::stages::Traversal;
use topleft::{BoxWalk, Coord, Point as Corner, ShadedTriangle, Spans};

use crate::support::counter::StrictDisplay;
use crate::support::measured::{Row, hold};
use crate::support::winding::{Edge, hits, winding_of};
use crate::support::{check, same};
use embedded_graphics::pixelcolor::Rgb565;

const WIDTH: usize = 40;
const HEIGHT: usize = 40;

/// A hub and the points round it, in 1/256 px.
#[derive(Clone, Debug)]
struct Fan {
    hub: [i32; 2],
    ring: Vec<[i32; 2]>,
}

impl Fan {
    fn edges(&self) -> Vec<Edge> {
        let next = self.ring.iter().cycle().skip(1);
        self.ring.iter().zip(next).map(|(&from, &to)| [from, to]).collect()
    }

    fn triangles(&self) -> Vec<Triangle> {
        self.edges().into_iter().map(|[from, to]| [self.hub, from, to]).collect()
    }

    /// The ring in the order of its angles, counter-clockwise as seen from the hub: no triangle is folded over another.
    fn sorted(mut self) -> Self {
        let [hx, hy] = self.hub.map(i64::from);
        let about = |[x, y]: [i32; 2]| [i64::from(x) - hx, i64::from(y) - hy];
        // From the right upwards, which is to smaller y.
        let lower_half = |[x, y]: [i64; 2]| y > 0 || (y == 0 && x < 0);
        self.ring.retain(|&point| about(point) != [0, 0]);
        self.ring.sort_by(|&a, &b| {
            let (a, b) = (about(a), about(b));
            lower_half(a).cmp(&lower_half(b)).then_with(|| match a[0] * b[1] - a[1] * b[0] {
                0 => Ordering::Equal,
                cross if cross < 0 => Ordering::Less,
                _ => Ordering::Greater,
            })
        });
        self
    }
}

/// A fan on a lattice of `step` / 256 px, with spokes to the right, up, left and down: no gap is wider than a quarter.
fn fans(step: i32, size: i32) -> impl Strategy<Value = Fan> {
    let most = size * 256 / step;
    let at = move || [0..=most, 0..=most];
    (at(), [1..most, 1..most, 1..most, 1..most], vec(at(), 0..24)).prop_map(
        move |([x, y], [right, up, left, down], mut ring)| {
            ring.extend([[x + right, y], [x, y - up], [x - left, y], [x, y + down]]);
            let scaled = |[x, y]: [i32; 2]| [x * step, y * step];
            Fan { hub: scaled([x, y]), ring: ring.into_iter().map(scaled).collect() }
        },
    )
}

/// Hits of a closed fan are the winding number of its ring; of one without folds, every hit is a front's.
fn wind<T: Traversal>(fan: &Fan, folded: bool) -> Result<usize, String> {
    let grids = hits::<T>(fan.triangles(), WIDTH, HEIGHT);
    let winding = winding_of(&fan.edges(), WIDTH, HEIGHT);
    same("front hits minus back hits", WIDTH, &grids.signed, &winding)?;
    if !folded {
        same("hits", WIDTH, &grids.all, &winding)?;
        if let Some(hits) = winding.iter().find(|&&hits| hits != 0 && hits != 1) {
            return Err(format!("a fan that hits a pixel {hits} times is not the closed fan it should be"));
        }
    }
    Ok(winding.iter().filter(|&&hits| hits != 0).count())
}

/// That fans whose corners stand on a lattice of `step` / 256 px hit each of their pixels once.
fn exactly_once(cases: u32, step: i32) -> Row {
    let pixels = Cell::new(0);
    check(cases, &fans(step, 32), |fan| {
        let fan = fan.sorted();
        pixels.set(pixels.get() + wind::<Spans>(&fan, false)?);
        wind::<BoxWalk>(&fan, false)?;
        Ok(())
    });
    let scene = format!("fans on a lattice of {step}/256 px");
    Row::none_of(pixels.get() as u64, &format!("px of {cases} fans"), "coverage", scene, "spans and box walk")
}

pub(crate) fn on_half_pixels() -> Row {
    exactly_once(20_000, 128)
}

pub(crate) fn on_the_finest_lattice() -> Row {
    exactly_once(20_000, 1)
}

// Red when an edge that runs through pixel centres belongs to both its sides, or to neither: `first_centre`, `top_left`.
#[test]
fn fans_on_the_half_pixel_lattice_hit_each_pixel_once() {
    hold(&[on_half_pixels()]);
}

// Red when an edge is rounded differently for its two sides: any change to `Edge::new` that looks at the side.
#[test]
fn fans_on_the_finest_lattice_hit_each_pixel_once() {
    hold(&[on_the_finest_lattice()]);
}

// Red when front and back triangles of one edge disagree: the swap of b and c in src/raster/box_walk.rs.
#[test]
fn folded_fans_hit_pixels_as_often_as_their_ring_winds() {
    for step in [128, 1] {
        check(10_000, &fans(step, 32), |fan| {
            wind::<Spans>(&fan, true)?;
            wind::<BoxWalk>(&fan, true)?;
            Ok(())
        });
    }
}

// Red when a clipped vertex is computed from the outer end of its edge in one of two neighbours: `cut` in src/clip.rs.
#[test]
fn fans_that_leave_the_guard_rectangle_hit_each_pixel_once() {
    let far = || 2_000 * 256..=i32::MAX / 2 - 32 * 256;
    let ring = vec(
        [any::<bool>().boxed(), any::<bool>().boxed()].prop_flat_map(move |signs| {
            [far(), far()]
                .prop_map(move |at| [0, 1].map(|axis| if signs[axis] { at[axis] } else { -at[axis] }))
        }),
        0..8,
    );
    let fans = ([0..32 * 256, 0..24 * 256], [far(), far(), far(), far()], ring);
    check(2_000, &fans, |([x, y], [right, up, left, down], mut ring)| {
        ring.extend([[x + right, y], [x, y - up], [x - left, y], [x, y + down]]);
        let fan = Fan { hub: [x, y], ring }.sorted();
        let mut display = StrictDisplay::new(Rectangle::new(Point::new(-7, 3), Size::new(32, 24)));
        for triangle in fan.triangles() {
            let corners = triangle.map(|[x, y]| Corner::new(Coord::from_bits(x), Coord::from_bits(y)));
            let drawn = ShadedTriangle::flat(corners, Rgb565::RED).draw(&mut display);
            drawn.map_err(|error| format!("{error:?}"))?;
        }
        same("hits", 32, &display.writes, &[1; 32 * 24])
    });
}
