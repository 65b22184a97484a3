//! Single triangles, clipped, set up and covered, against 128-bit integers.

use arbitrary::Arbitrary;
use embedded_graphics_core::geometry::Size;
use reference::raster::edges;
use reference::setup::{Triangle, area2};
use topleft::stages::{Gradients, Setup, Span, Varying, Window};
use topleft::{Attribute, BoxWalk, DepthCode, Inverse, Mesh, Pose, Spans};

use crate::counting::Counting;
use crate::cut;
use crate::flat::compare as compare_flat;
use crate::lens::{Lens, Seen};
use crate::numbers::Number;
use crate::soup::Image;
use crate::support::exact::{compare, compare_mesh, expected};
use crate::support::same;
use crate::support::winding::{setup, winding_of};

/// Any triangle.
#[derive(Arbitrary, Clone, Debug)]
pub struct Case(Kind);

#[derive(Arbitrary, Clone, Debug)]
enum Kind {
    /// A flat drawing on a target.
    Flat {
        /// Its corners in 1/256 px.
        corners: [Corner; 3],
        /// Texels in 1/65536.
        texels: [[i32; 2]; 3],
        /// Its texture.
        image: Image,
        /// Where the target starts, and its size.
        target: ([i32; 2], [u8; 2]),
    },
    /// As set-up takes it, seen through a window.
    Window {
        /// Its corners in 1/256 px.
        corners: [Corner; 3],
        /// Where the window starts in pixels, from a corner's pixel or not, and its size.
        window: (u8, [i8; 2], [u8; 2]),
        /// Values at the corners.
        values: [u32; 3],
    },
    /// Through a camera, cut by its planes.
    Seen {
        /// The face in the cube from -1 to 1.
        positions: [[i16; 3]; 3],
        /// By whom.
        lens: Lens,
        /// Columns and rows.
        size: [u8; 2],
    },
}

/// A point in 1/256 px.
#[derive(Arbitrary, Clone, Copy, Debug)]
enum Corner {
    /// In a pixel near by, somewhere on a lattice of 2^n steps round its centre.
    Lattice([u8; 2], [i8; 2], u8),
    /// So far away that set-up takes most triangles of such corners.
    Wide([i32; 2]),
    /// Anywhere.
    Anywhere([Number; 2]),
}

impl Corner {
    fn at(self) -> [i32; 2] {
        match self {
            Self::Lattice(pixel, within, step) => [0, 1].map(|axis| {
                (i32::from(pixel[axis] % 80) - 8) * 256
                    + 128
                    + (i32::from(within[axis]) >> (step % 8) << (step % 8))
            }),
            Self::Wide([x, y]) => [x >> 11, y >> 12],
            Self::Anywhere(at) => at.map(Number::bits),
        }
    }
}

impl Case {
    /// Compares the triangle's coverage, and values on it, with what is exact, and gives back how many pixels it has.
    ///
    /// # Panics
    /// They differ by more than they may.
    pub fn check(&self) -> usize {
        let pixels = match &self.0 {
            Kind::Flat { corners, texels, image, target: ([left, top], size) } => {
                let [width, height] = size.map(|length| u32::from(length % 64));
                let (left, top) = ((*left).min(i32::MAX - 64), (*top).min(i32::MAX - 64));
                let texture = image.texels();
                let mut target = Counting::new(left, top, width, height);
                let corners = corners.map(Corner::at);
                compare_flat(corners, *texels, &image.texture(&texture), &mut target)
                    .map(|()| target.hits.iter().filter(|&&hits| hits != 0).count())
            }
            Kind::Window { corners, window, values } => windowed(corners.map(Corner::at), *window, *values),
            Kind::Seen { positions, lens, size } => seen(*positions, lens, *size),
        };
        pixels.unwrap_or_else(|error| panic!("{error}\n{self:#?}"))
    }
}

/// Coverage of a mesh of one face: that of its polygon, and that of the face where the camera's planes leave it; the same
/// from whichever corner and whichever way round, or neighbours would have different ends of the edge that they share.
fn seen([a, b, c]: [[i16; 3]; 3], lens: &Lens, size: [u8; 2]) -> Result<usize, String> {
    let [width, height] = size.map(|length| u32::from(length % 64 + 1));
    let size = Size::new(width, height);
    let camera = lens.camera(size);
    let drawn = |positions: [[i16; 3]; 3]| {
        let mesh = Mesh::new(&positions, &[[0, 1, 2]]).map_err(|error| error.to_string())?;
        let (polygons, hits) = match &camera {
            Seen::Perspective(camera) => compare_mesh(camera, &mesh, &Pose::new()),
            Seen::Level(camera) => compare_mesh(camera, &mesh, &Pose::new()),
        }?;
        let mut edges = polygons.edges();
        let winding = winding_of(&edges, width as usize, height as usize);
        for edge in &mut edges {
            edge.sort_unstable();
        }
        edges.sort_unstable();
        Ok::<_, String>((edges, hits, winding))
    };
    let (edges, hits, winding) = drawn([a, b, c])?;
    if let Some(face) = camera.matrix().and_then(|matrix| cut::face(matrix, [a, b, c])) {
        cut::compare(&face, size, &hits, &winding)?;
    }
    let (others, other, _) = drawn([c, b, a])?;
    if edges != others {
        return Err(format!("{edges:?} one way round, {others:?} the other"));
    }
    same("hits the other way round", width as usize, &other, &hits)?;
    Ok(hits.iter().filter(|&&hits| hits != 0).count())
}

/// Coverage and planes of a triangle that set-up takes; of what it does not take, that it has no area or is too large.
fn windowed(
    triangle: Triangle,
    (near, [left, top], size): (u8, [i8; 2], [u8; 2]),
    values: [u32; 3],
) -> Result<usize, String> {
    let setup = setup(triangle);
    if setup.is_some() != (area2(triangle) != 0 && fits(triangle)) {
        return Err(format!("set up: {setup:?}"));
    }
    let Some(setup) = setup else { return Ok(0) };
    // From 0 up, as windows are.
    let [x, y] = triangle.get(usize::from(near % 4)).map_or([0; 2], |corner| corner.map(|c| c >> 8));
    let [width, height] = size.map(|length| i32::from(length % 64) + 1);
    let (left, top) = ((x + i32::from(left / 2)).max(0), (y + i32::from(top / 2)).max(0));
    let window = Window { columns: left..left + width, rows: top..top + height };
    let spans = expected(triangle, &window);
    compare::<Spans>(triangle, &window, &spans)?;
    compare::<BoxWalk>(triangle, &window, &spans)?;
    // 8 units from the ends of the range: the errors of interpolation are allowed to use them.
    const ROOM: u32 = 8 << 16;
    let [a, b, c] = values.map(|value| value.clamp(ROOM, u32::MAX - ROOM));
    let [i, j, k] = values.map(|value| (value >> 1).clamp(ROOM, (u32::MAX >> 1) - ROOM));
    let signed = [a, b, c].map(|value| value.wrapping_add(1 << 31).cast_signed());
    planes(
        &setup,
        &spans,
        signed.map(i64::from),
        |v| Attribute::from_bits(v as i32),
        |v| v.to_bits().into(),
    )?;
    planes(
        &setup,
        &spans,
        [a, b, c].map(i64::from),
        |v| DepthCode::from_bits(v as u32),
        |v| v.to_bits().into(),
    )?;
    planes(
        &setup,
        &spans,
        [i, j, k].map(i64::from),
        |v| Inverse::from_bits(v as i32),
        |v| v.to_bits().into(),
    )?;
    Ok(spans.iter().map(|span| (span.end - span.start).unsigned_abs() as usize).sum())
}

/// What set-up says that it takes.
fn fits(triangle: Triangle) -> bool {
    let extent = |axis: usize| {
        let [a, b, c] = triangle.map(|corner| i64::from(corner[axis]));
        a.max(b).max(c) - a.min(b).min(c)
    };
    let (width, height) = (extent(0), extent(1));
    let near = triangle.iter().flatten().all(|c| c.unsigned_abs() <= 1 << 30);
    near && width <= 8191 << 8 && height <= 4095 << 8 && width * height <= 1 << 39
}

/// A plane's values at both ends of each span, in steps of its format: `(n + m + 2) / 2` for its gradients and start,
/// and 2^-30 of the largest difference for the reciprocal of the area. All of it in integers.
fn planes<V: Varying>(
    setup: &Setup,
    spans: &[Span],
    values: [i64; 3],
    make: fn(i64) -> V,
    steps: fn(V) -> i64,
) -> Result<(), String> {
    let gradients: Gradients = setup.gradients();
    let plane = V::plane(&gradients, values.map(make));
    let [ax, ay] = gradients.anchor();
    // In the order of set-up, which is that of the values.
    let triangle = setup.points().map(|point| [point.x.to_bits(), point.y.to_bits()]);
    let area = area2(triangle);
    let difference = i128::from(values.iter().max().unwrap_or(&0) - values.iter().min().unwrap_or(&0));
    for span in spans {
        for x in [span.start, span.end - 1] {
            let (columns, rows) = (x - ax, span.y - ay);
            let ours = i128::from(steps(plane.at(columns, rows)));
            let weights = edges(triangle, x.into(), span.y.into());
            let exact: i128 =
                weights.iter().zip(values).map(|(weight, value)| weight * i128::from(value)).sum();
            let error = ((ours * area - exact).abs()) << 30;
            let away = i128::from(columns.unsigned_abs()) + i128::from(rows.unsigned_abs());
            let bound = area.abs() * (((away + 2) << 29) + difference);
            if error > bound {
                let error = error as f64 / bound as f64;
                return Err(format!("{ours} at {x}, {} is off by {error} of the bound", span.y));
            }
        }
    }
    Ok(())
}
