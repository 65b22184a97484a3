//! The whole path, brute force: every triangle, every pixel, through the stages in order.

use crate::clip::{ClipVertex, Plane, clip, guard};
use crate::depth::{code, passes};
use crate::image::Image;
use crate::matrix::Matrix;
use crate::raster::{covers, pixel_box};
use crate::setup::{Triangle, facing, fan, snap};
use crate::shade::{Base, Look, Normals, Rgb, from_rgb565, lit, texel, uv};
use crate::transform::{Viewport, depth, model_position, normal};
use crate::varying::{carry, linear};
use std::fmt;
use topleft::Mesh;

/// Where a mesh is seen from.
#[derive(Clone, Copy, Debug)]
pub struct View {
    /// The mesh's scene units to clip space.
    pub model_to_clip: Matrix,
    /// Pixels of this margin round the target are never clipped; `None` never clips x and y. Where it cuts is seen
    /// only in affine varyings.
    pub guard: Option<u32>,
    /// The number of the mesh's face 0 in [`crate::image::Pixel::face`].
    pub first_face: u32,
}

/// What became of a mesh.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Drawn {
    /// Faces of the mesh.
    pub faces: u64,
    /// Faces with nothing between near and far, in the guard rectangle, or finite.
    pub outside: u64,
    /// Faces that were cut.
    pub clipped: u64,
    /// Triangles, after cutting, that were culled.
    pub culled: u64,
    /// Triangles, after cutting, that were drawn.
    pub triangles: u64,
    /// Pixels that they cover in the viewport, hidden ones included.
    pub covered: u64,
    /// Colours written.
    pub written: u64,
}

/// The mesh lacks what the look asks for: the attribute's name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Missing(pub &'static str);

impl fmt::Display for Missing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the look needs {} and the mesh has none", self.0)
    }
}

impl std::error::Error for Missing {}

/// What is carried: red, green, blue, light, u, v.
type Varyings = [f64; 6];

/// A corner on the screen.
#[derive(Clone, Copy)]
struct Corner {
    place: [i32; 2],
    depth: f64,
    /// 1/w.
    q: f64,
    varyings: Varyings,
}

/// Draws a mesh over what the image holds.
///
/// # Errors
/// The mesh lacks colours, normals or texture coordinates that the look asks for.
pub fn draw(image: &mut Image, mesh: &Mesh<'_>, view: &View, look: &Look<'_>) -> Result<Drawn, Missing> {
    check(mesh, look)?;
    let mut drawn = Drawn::default();
    let viewport = image.viewport();
    let guards: Vec<Plane> =
        view.guard.map_or(Vec::new(), |margin| guard(viewport, f64::from(margin)).to_vec());
    for (face, indices) in mesh.faces().iter().enumerate() {
        drawn.faces += 1;
        let vertices = indices.map(|index| vertex(mesh, face, usize::from(index), view, look));
        let polygon = clip(vertices, &guards);
        let corners: Option<Vec<Corner>> = polygon.iter().map(|vertex| corner(vertex, viewport)).collect();
        let Some(corners) = corners.filter(|corners| !corners.is_empty()) else {
            drawn.outside += 1;
            continue;
        };
        drawn.clipped += u64::from(polygon != vertices);
        let places: Vec<[i32; 2]> = corners.iter().map(|corner| corner.place).collect();
        for indices in fan(&places) {
            let triangle = indices.map(|i| corners[i]);
            if look.cull.keeps(facing(triangle.map(|corner| corner.place))) {
                drawn.triangles += 1;
                fill(image, triangle, look, view.first_face + face as u32, &mut drawn);
            } else {
                drawn.culled += 1;
            }
        }
    }
    Ok(drawn)
}

fn check(mesh: &Mesh<'_>, look: &Look<'_>) -> Result<(), Missing> {
    let vertices = mesh.positions().len();
    let faces = mesh.faces().len();
    let (name, needed, given) = match look.base {
        Base::Uniform(_) => ("nothing", 0, 0),
        Base::FaceColours => ("face colours", faces, mesh.face_colours().len()),
        Base::VertexColours => ("vertex colours", vertices, mesh.vertex_colours().len()),
        Base::Texture(_) => ("texture coordinates", vertices, mesh.uvs().len()),
    };
    if given != needed {
        return Err(Missing(name));
    }
    match look.light {
        Some((_, Normals::Face)) if mesh.face_normals().len() != faces => Err(Missing("face normals")),
        Some((_, Normals::Vertex)) if mesh.normals().len() != vertices => Err(Missing("vertex normals")),
        _ => Ok(()),
    }
}

fn vertex(mesh: &Mesh<'_>, face: usize, index: usize, view: &View, look: &Look<'_>) -> ClipVertex<6> {
    let light = match look.light {
        None => 1.0,
        Some((light, Normals::Face)) => light.at(normal(mesh.face_normals()[face])),
        Some((light, Normals::Vertex)) => light.at(normal(mesh.normals()[index])),
    };
    let (base, [u, v]) = match &look.base {
        Base::Uniform(colour) => (*colour, [0.0; 2]),
        Base::FaceColours => (mesh.face_colours()[face], [0.0; 2]),
        Base::VertexColours => (mesh.vertex_colours()[index], [0.0; 2]),
        Base::Texture(texture) => ([0; 3], uv(mesh.uvs()[index], mesh.uv_exponent(), texture)),
    };
    let [r, g, b] = lit(base.map(f64::from), light);
    ClipVertex {
        position: view.model_to_clip.apply_point(model_position(mesh, index)),
        varyings: [r, g, b, light, u, v],
    }
}

fn corner(vertex: &ClipVertex<6>, viewport: Viewport) -> Option<Corner> {
    let [x, y] = viewport.to_screen(vertex.position);
    let depth = depth(vertex.position);
    let q = 1.0 / vertex.position[3];
    Some(Corner { place: [snap(x)?, snap(y)?], depth, q, varyings: vertex.varyings })
}

fn fill(image: &mut Image, corners: [Corner; 3], look: &Look<'_>, face: u32, drawn: &mut Drawn) {
    let triangle = corners.map(|corner| corner.place);
    let (columns, rows) = pixel_box(triangle, image.viewport());
    for y in rows {
        for x in columns.clone() {
            if !covers(triangle, x, y) {
                continue;
            }
            drawn.covered += 1;
            let pixel = image.pixel_mut(x as u32, y as u32);
            if look.depth {
                let depth = linear(triangle, corners.map(|corner| corner.depth), x, y);
                if !passes(code(depth), code(pixel.depth)) {
                    continue;
                }
                pixel.depth = depth;
            }
            pixel.colour = colour(triangle, &corners, look, x, y);
            pixel.face = Some(face);
            pixel.writes += 1;
            drawn.written += 1;
        }
    }
}

fn colour(triangle: Triangle, corners: &[Corner; 3], look: &Look<'_>, x: i64, y: i64) -> Rgb {
    let q = corners.map(|corner| corner.q);
    let value = |method, k: usize| carry(method, triangle, corners.map(|corner| corner.varyings[k]), q, x, y);
    match &look.base {
        Base::Texture(texture) => {
            let uv = [value(look.texels, 4), value(look.texels, 5)];
            lit(from_rgb565(texel(texture, uv)), value(look.colours, 3))
        }
        _ => [0, 1, 2].map(|channel| value(look.colours, channel)),
    }
}
