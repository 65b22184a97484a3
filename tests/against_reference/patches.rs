//! A scene as the reference sees it: a frame, and the triangles in it with how far the library's may be off.
//!
//! The reference starts from the library's own matrices, read out exactly, so that this is the error of everything
//! after them; `numbers.rs` has the matrices. A vertex may be snapped to the neighbouring step, and planes are off by
//! their slope times that.

use embedded_graphics_core::geometry::Size;
use reference::clip::{ClipVertex, Plane, clip, guard};
use reference::image::Image;
use reference::matrix::{Matrix, Vec4, normalise};
use reference::render::{self, View};
use reference::setup::{Triangle, fan, snap};
use reference::shade::{Base, Light, Look, Normals, uv};
use reference::transform::{Pose, Viewport, depth, length, model_position, normal};
use reference::varying::{Method, linear, perspective};
use scenes::{Object, Scene, Shade};
use topleft::{Camera, Cull, Length, Material, Mesh, Turn};

use crate::probe::{exact, range, slopes};
use crate::tolerance::{self, DEPTH_VERTEX, TURNED_CENTRE, half, interpolation, per_pixel, vertex_on_screen};

/// A triangle of the reference, after clipping.
pub(crate) struct Patch {
    pub(crate) triangle: Triangle,
    pub(crate) clipped: bool,
    w: [f64; 3],
    depth: [f64; 3],
    /// Light, u and v.
    pub(crate) varyings: [[f64; 3]; 3],
    /// How far vertices may be off: clip coordinates, and the snapped ones in steps.
    clip_error: f64,
    pub(crate) moved: f64,
    /// The place of its look in the scene.
    pub(crate) object: usize,
}

/// A scene's objects as the reference sees them.
pub(crate) struct Frame {
    pub(crate) viewport: Viewport,
    pub(crate) image: Image,
    /// By face, counted over all objects.
    pub(crate) faces: Vec<Vec<Patch>>,
}

fn largest(matrix: &Matrix) -> f64 {
    matrix.0.iter().flatten().fold(0.0, |most, element| most.max(element.abs()))
}

/// The camera of a scene, exactly.
pub(crate) fn camera_of(scene: &Scene, size: Size, view: &scenes::View) -> Matrix {
    let orbiting = scene.camera.orbiting(size, view).map(|camera| exact(camera.matrix()));
    orbiting.unwrap_or_else(|| exact(scene.camera.front(size).unwrap().matrix()))
}

/// A pose as it is, from where it takes the axes: to 2^-32.
pub(crate) fn pose_of(object: &Object, turn: Turn) -> Pose {
    let turned = Object { at: [Length::ZERO; 3], scale: Length::ONE, ..*object }.pose(turn);
    let axis = |k: usize| {
        let mut unit = [Length::ZERO; 3];
        unit[k] = Length::from_num(32_767);
        turned.apply(unit).map(|c| length(c) / 32_767.0)
    };
    let columns = [axis(0), axis(1), axis(2)];
    Pose {
        rotation: [0, 1, 2].map(|row| columns.map(|column| column[row])),
        scale: length(object.scale),
        translation: object.at.map(length),
    }
}

/// The look of the reference for an object's; the sun is the one of the scenes.
fn look_of(object: &Object, pose: &Pose) -> Look<'static> {
    let sun = normalise(["-0.5", "0.9", "0.7"].map(|c| length(Length::from_str(c).unwrap())));
    let light = Light { towards: pose.direction_to_model(sun), ambient: 0.2, diffuse: 0.8 };
    let (lit, face_lit) = (Some((light, Normals::Vertex)), Some((light, Normals::Face)));
    let plain = |colours: Base<'static>| match object.look.material {
        Material::Colour(colour) => Base::Uniform(colour),
        Material::OfMesh => colours,
    };
    let (base, light) = match object.look.shade {
        Shade::Plain => (plain(Base::FaceColours), None),
        Shade::Gouraud => (plain(Base::VertexColours), lit),
        Shade::Textured => (Base::Texture(object.look.texture), None),
        Shade::Lit => (Base::Texture(object.look.texture), lit),
        Shade::Flat => (plain(Base::FaceColours), face_lit),
    };
    let cull = match object.cull {
        Cull::Back => reference::setup::Cull::Back,
        Cull::Front => reference::setup::Cull::Front,
        Cull::None => reference::setup::Cull::None,
    };
    Look { base, light, colours: Method::Affine, texels: Method::Perspective, cull, depth: true }
}

/// A mesh in front of a camera, and how far its vertices may be off.
pub(crate) struct Placement {
    /// The mesh's scene units to clip space.
    pub(crate) whole: Matrix,
    /// Of a clip coordinate.
    pub(crate) clip_error: f64,
    viewport: Viewport,
}

impl Placement {
    pub(crate) fn new(mesh: &Mesh<'_>, camera: &Matrix, pose: &Pose, viewport: Viewport) -> Self {
        let whole = pose.matrix().then(camera);
        let half_box = length(mesh.half()) * pose.scale;
        let of_pose = pose.translation.iter().fold(half_box.max(1.0), |most, c| most.max(c.abs()));
        // The coordinates of the cube's corners, at the most.
        let corner = [0, 1, 2].map(|axis| length(mesh.half()) + length(mesh.centre()[axis]).abs());
        let reaches =
            |row: &[f64; 4]| (0..3).fold(row[3].abs(), |sum, axis| sum + row[axis].abs() * corner[axis]);
        let most = whole.0.iter().map(reaches).fold(0.0, f64::max);
        let centred = mesh.centre() == [Length::ZERO; 3];
        let moved = if centred { 0.0 } else { TURNED_CENTRE * largest(camera) };
        let clip_error = tolerance::clip(largest(camera) * of_pose, most) + moved;
        Self { whole, clip_error, viewport }
    }

    /// How far a vertex that is seen at `place` may be off on the screen before it is snapped, in steps.
    pub(crate) fn error(&self, clip: Vec4, place: [f64; 2]) -> f64 {
        let Viewport { width, height } = self.viewport;
        let reach = f64::from(width.max(height).next_power_of_two()) / 2.0;
        let from_centre = (place[0] - f64::from(width) / 2.0).hypot(place[1] - f64::from(height) / 2.0);
        vertex_on_screen(self.clip_error, clip[3], reach, from_centre)
    }
}

/// The triangles of a mesh, by face.
fn patches(
    mesh: &Mesh<'_>,
    placement: &Placement,
    look: &Look<'_>,
    guards: &[Plane],
    object: usize,
) -> Vec<Vec<Patch>> {
    let Placement { whole, clip_error, viewport } = *placement;
    let vertex = |index: u16| {
        let index = usize::from(index);
        let light = look.light.map_or(1.0, |(light, _)| light.at(normal(mesh.normals()[index])));
        let [u, v] = match &look.base {
            Base::Texture(texture) => uv(mesh.uvs()[index], mesh.uv_exponent(), texture),
            _ => [0.0; 2],
        };
        ClipVertex { position: whole.apply_point(model_position(mesh, index)), varyings: [light, u, v] }
    };
    let face = |corners: &[u16; 3]| {
        let corners = corners.map(vertex);
        let polygon = clip(corners, guards);
        let places: Vec<[f64; 2]> = polygon.iter().map(|v| viewport.to_screen(v.position)).collect();
        let snapped: Vec<[i32; 2]> = places.iter().map(|p| p.map(|c| snap(c).expect("finite"))).collect();
        let patch = |corner: [usize; 3]| {
            let moved = corner.map(|i| 1.0 + placement.error(polygon[i].position, places[i]));
            Patch {
                triangle: corner.map(|i| snapped[i]),
                clipped: polygon != corners,
                w: corner.map(|i| polygon[i].position[3]),
                depth: corner.map(|i| depth(polygon[i].position)),
                varyings: [0, 1, 2].map(|k| corner.map(|i| polygon[i].varyings[k])),
                clip_error,
                moved: moved.into_iter().fold(0.0, f64::max),
                object,
            }
        };
        fan(&snapped).into_iter().map(patch).collect()
    };
    mesh.faces().iter().map(face).collect()
}

impl Frame {
    pub(crate) fn new(scene: &Scene, size: Size, view: &scenes::View) -> Self {
        let viewport = Viewport { width: size.width, height: size.height };
        let camera = camera_of(scene, size, view);
        let margin = u32::from(topleft::Viewport::new(size).unwrap().margin());
        let guards = guard(viewport, f64::from(margin));
        let mut image = Image::new(viewport, scene.background.map(f64::from));
        let mut faces = Vec::new();
        for (place, object) in scene.objects.iter().enumerate() {
            let pose = pose_of(object, view.turn);
            let look = look_of(object, &pose);
            let placement = Placement::new(object.mesh, &camera, &pose, viewport);
            let seen =
                View { model_to_clip: placement.whole, guard: Some(margin), first_face: faces.len() as u32 };
            render::draw(&mut image, object.mesh, &seen, &look).unwrap();
            faces.extend(patches(object.mesh, &placement, &look, &guards, place));
        }
        Self { viewport, image, faces }
    }
}

impl Patch {
    /// How far a plane over this triangle may be off at a pixel because vertices moved.
    pub(crate) fn slope_error(&self, values: [f64; 3]) -> f64 {
        let [gx, gy] = slopes(self.triangle, values);
        (gx.abs() + gy.abs()) * self.moved / 256.0
    }

    pub(crate) fn steps(&self, x: i64, y: i64) -> u64 {
        let to = |p: [i32; 2]| x.abs_diff(i64::from(p[0] >> 8)) + y.abs_diff(i64::from(p[1] >> 8)) + 2;
        self.triangle.map(to).into_iter().max().unwrap_or_default()
    }

    fn least_w(&self) -> f64 {
        self.w.into_iter().fold(f64::MAX, f64::min)
    }

    /// The depth at a pixel, and how far it may be off.
    pub(crate) fn depth(&self, x: i64, y: i64) -> (f64, f64) {
        // (w - z) / w: both of the quotient are off, and w - z is at most w.
        let vertex = 65_528.0 * 3.0 * self.clip_error / self.least_w() + DEPTH_VERTEX;
        let carried = interpolation(16, self.steps(x, y), range(self.depth));
        (linear(self.triangle, self.depth, x, y), self.slope_error(self.depth) + vertex + carried)
    }

    /// A texture coordinate at a pixel, and how far it may be off; nothing where that is more than a texel.
    pub(crate) fn texel(&self, axis: usize, x: i64, y: i64) -> Option<(f64, f64)> {
        let values = self.varyings[1 + axis];
        let q = self.w.map(|w| 1.0 / w);
        let at = |x, y| perspective(self.triangle, values, q, x, y);
        let (here, q_here) = (at(x, y), linear(self.triangle, q, x, y));
        // Vertices that move change u / q by ((gradient of u/w) - u (gradient of 1/w)) / q.
        let over_w = [0, 1, 2].map(|k| (values[k] - here) * q[k]);
        let left = q_here - self.slope_error(q);
        if left <= 0.0 {
            return None;
        }
        let largest = q.into_iter().fold(0.0, f64::max);
        let share = q_here / 2.0_f64.powi(largest.log2().ceil() as i32);
        let span = self.varyings[1..].iter().map(|&values| range(values)).fold(0.0, f64::max);
        let texel_box = (span + 1.0).ceil().max(1.0) as u64;
        let bound = self.slope_error(over_w) / left
            + texel_box.next_power_of_two() as f64 * per_pixel(self.steps(x, y), share)
            + 2.0 * span * self.clip_error / self.least_w()
            + half(16);
        (bound < 1.0).then_some((here, bound))
    }
}
