//! How far off texels are, by scene and method: the worst pixel that is seen, and the bound.

use embedded_graphics_core::geometry::Size;
use reference::raster::row_span;
use reference::varying::{linear, perspective};
use scenes::{Scene, by_name};
use topleft::stages::Correction;

use crate::method::{self, Bound, EachMethod, Method};
use crate::spy::{self, Cell, Seen};
use crate::tolerance::{DIVIDED, RECIPROCAL, affine, interpolation, per_pixel, subspan, within};

/// The scenes whose textures decide: few large faces, and many small ones.
pub(crate) const SCENES: [&str; 4] = ["leaning-cube", "globe", "horizon", "corridor"];

/// The panel.
pub(crate) const PANEL: Size = Size::new(240, 240);

/// The errors of one method in one scene, in texels.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Texels {
    pub(crate) scene: &'static str,
    pub(crate) method: Method,
    /// Of the worst pixel.
    pub(crate) worst: f64,
    /// What 99.9 % of the pixels do not exceed.
    pub(crate) most: f64,
    /// What none may exceed.
    pub(crate) bound: f64,
    /// Pixels that its triangles cover, hidden ones included.
    pub(crate) pixels: u64,
}

/// All methods in all scenes; `done` is called after each.
pub(crate) fn all(done: impl FnMut()) -> Vec<Texels> {
    struct Sweep<F> {
        results: Vec<Texels>,
        done: F,
    }
    impl<F: FnMut()> EachMethod for Sweep<F> {
        fn method(&mut self, method: Method, correction: impl Correction + 'static) {
            for scene in SCENES.into_iter().filter_map(by_name) {
                self.results.push(measure(scene, method, correction));
                (self.done)();
            }
        }
    }
    let mut sweep = Sweep { results: Vec::new(), done };
    method::for_each(&mut sweep);
    sweep.results
}

fn measure(scene: &'static Scene, method: Method, correction: impl Correction + 'static) -> Texels {
    let (seen, cells) = spy::frame(scene, PANEL, correction);
    let width = PANEL.width as usize;
    let mut errors = Vec::new();
    let mut bound = 0.0_f64;
    for (index, &Cell { triangle, texel }) in cells.iter().enumerate() {
        let Some(triangle) = (triangle as usize).checked_sub(1).map(|number| &seen[number]) else { continue };
        let (x, y) = ((index % width) as i64, (index / width) as i64);
        for (axis, shown) in texel.into_iter().enumerate() {
            let values = triangle.texels.map(|texel| texel[axis]);
            let exact = perspective(triangle.points, values, triangle.q, x, y);
            errors.push(outside(shown, exact));
            bound = bound.max(bound_at(method.bound, triangle, values, [x, y]));
        }
    }
    if let Bound::Every(pixels) = method.bound {
        bound = seen.iter().map(|triangle| between_steps(triangle, pixels)).fold(0.0, f64::max);
    }
    errors.sort_by(f64::total_cmp);
    let at = |share: f64| errors[((errors.len() - 1) as f64 * share).ceil() as usize];
    let pixels = seen.iter().map(|triangle| triangle.pixels).sum();
    Texels { scene: scene.name, method, worst: at(1.0), most: at(0.999), bound, pixels }
}

/// How far a texel lies from the exact place, which its step holds where it is right.
fn outside(texel: i32, exact: f64) -> f64 {
    let texel = f64::from(texel);
    (texel - exact).max(exact - texel - 1.0).max(0.0)
}

/// The largest difference between three values.
fn range(values: [f64; 3]) -> f64 {
    let [a, b, c] = values;
    a.max(b).max(c) - a.min(b).min(c)
}

/// Pixels from a triangle's first vertex, n + m.
fn steps_to(triangle: &Seen, [x, y]: [i64; 2]) -> u64 {
    let [ax, ay] = triangle.points[0].map(|c| i64::from(c.div_euclid(256)));
    x.abs_diff(ax) + y.abs_diff(ay)
}

/// What a texel that is divided may be off by, in units of its box.
fn ends(triangle: &Seen, at: [i64; 2]) -> f64 {
    let largest = triangle.q.into_iter().fold(0.0, f64::max);
    let unit = 2.0_f64.powi(-largest.log2().ceil() as i32);
    per_pixel(steps_to(triangle, at), linear(triangle.points, triangle.q, at[0], at[1]) * unit)
}

/// What a pixel's texel may be off by.
fn bound_at(bound: Bound, triangle: &Seen, values: [f64; 3], at: [i64; 2]) -> f64 {
    let (steps, range) = (steps_to(triangle, at), range(values));
    match bound {
        Bound::Triangle => {
            let largest = triangle.q.into_iter().fold(0.0, f64::max);
            let least = triangle.q.into_iter().fold(f64::MAX, f64::min);
            affine(range, largest / least) + interpolation(16, steps, range)
        }
        Bound::Asked(error) => within(error, texel_box(triangle), ends(triangle, at), steps, range),
        // Each row has its own, for both ends.
        Bound::Every(_) => 0.0,
        Bound::Pixel => texel_box(triangle) * ends(triangle, at),
        Bound::Quotient => texel_box(triangle) * (ends(triangle, at) - RECIPROCAL + DIVIDED),
    }
}

/// The power of two of texels that holds a triangle's.
fn texel_box(triangle: &Seen) -> f64 {
    let span = |axis: usize| {
        let [a, b, c] = triangle.texels.map(|texel| texel[axis]);
        a.max(b).max(c) - a.min(b).min(c).floor()
    };
    (span(0).max(span(1)).ceil() as u64).next_power_of_two() as f64
}

/// What linear steps between pixels `length` apart, or less at a row's end, are off by at the most: for any place where
/// they begin.
fn between_steps(triangle: &Seen, length: i64) -> f64 {
    let [top, bottom] = [0, 2].map(|corner| i64::from(triangle.points[corner][1].div_euclid(256)));
    let mut worst = 0.0_f64;
    for y in top.max(0)..=bottom.min(i64::from(PANEL.height) - 1) {
        let Some((start, end)) = row_span(triangle.points, y) else { continue };
        let (start, end) = (start.max(0), end.min(i64::from(PANEL.width)));
        for axis in 0..2 {
            let values = triangle.texels.map(|texel| texel[axis]);
            for left in start..end {
                let right = (left + length).min(end - 1);
                let [from, to] =
                    [left, right].map(|x| perspective(triangle.points, values, triangle.q, x, y));
                let [q0, q1] = [left, right].map(|x| linear(triangle.points, triangle.q, x, y));
                let of_ends = [left, right].map(|x| ends(triangle, [x, y])).into_iter().fold(0.0, f64::max);
                worst = worst.max(subspan(
                    (to - from).abs(),
                    (q0 / q1).max(q1 / q0),
                    texel_box(triangle),
                    of_ends,
                ));
            }
        }
    }
    worst
}

#[cfg(test)]
mod tests {
    use super::*;
    use topleft::stages::{PerVertexInverse, Sampler};
    use topleft::{Affine, Attribute, PerPixel};

    /// Shows the next column's texel.
    #[derive(Clone, Copy)]
    struct OneBeside;

    impl Correction for OneBeside {
        type Varying = <PerPixel as Correction>::Varying;
        type Triangle = <PerPixel as Correction>::Triangle;
        const PERSPECTIVE: bool = true;

        fn words(self) -> [u32; 2] {
            [0; 2]
        }

        fn from_words(_: [u32; 2]) -> Self {
            Self
        }

        fn triangle(
            self,
            texels: [[Attribute; 2]; 3],
            inverses: [PerVertexInverse; 3],
            sizes_log2: [u8; 2],
        ) -> (Self::Triangle, [Self::Varying; 3]) {
            PerPixel.triangle(texels, inverses, sizes_log2)
        }

        fn walk<T>(
            self,
            triangle: &Self::Triangle,
            start: Self::Varying,
            step: &Self::Varying,
            run: &mut [T],
            sampler: &mut impl Sampler<T>,
        ) {
            PerPixel
                .walk(triangle, start, step, run, &mut |pixel: &mut T, u, v| sampler.show(pixel, u + 1, v));
        }
    }

    fn of(scene: &str, bound: Bound, correction: impl Correction + 'static) -> Texels {
        let method = Method { family: method::Family::PerPixel, setting: "", row: "", bound };
        measure(by_name(scene).unwrap(), method, correction)
    }

    // Red when errors are taken for less than they are: u for v, another vertex's 1/w, rounded texels.
    #[test]
    fn a_wrong_texel_is_seen() {
        let right = of("corridor", Bound::Pixel, PerPixel);
        assert!(right.worst <= right.bound && right.bound < 0.1, "{right:?}");
        let wrong = of("corridor", Bound::Pixel, OneBeside);
        assert!(wrong.most > 0.9 && wrong.worst > wrong.bound, "{wrong:?}");
    }

    // Red when the reference interpolates without w as well.
    #[test]
    fn affine_is_as_far_off_as_its_closed_form_says() {
        let affine = of("leaning-cube", Bound::Triangle, Affine);
        assert!(affine.worst > 0.9 * affine.bound && affine.worst <= affine.bound, "{affine:?}");
    }
}
