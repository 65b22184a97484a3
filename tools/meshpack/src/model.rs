//! A mesh in floats, between reading and quantising.

use crate::normals;
use std::collections::HashMap;
use std::path::{Path, PathBuf};

/// A triangle mesh in floats, in the file's own unit.
///
/// Attributes are empty or have one entry for each vertex or face, as their names say;
/// [`quantise`](Self::quantise) checks that.
#[derive(Clone, Debug, Default)]
pub struct Model {
    /// Where the mesh comes from: the name that errors give.
    pub source: PathBuf,
    /// The vertices' positions.
    pub positions: Vec<[f64; 3]>,
    /// Three vertices a face, counter-clockwise from outside.
    pub faces: Vec<[u32; 3]>,
    /// The vertices' normals, of any length above 0.
    pub normals: Vec<[f64; 3]>,
    /// The faces' normals, or nothing.
    pub face_normals: Vec<[f64; 3]>,
    /// The vertices' texture coordinates, or nothing: (0, 0) is the image's top left corner, and v grows down.
    pub uvs: Vec<[f64; 2]>,
    /// The vertices' colours, or nothing.
    pub vertex_colours: Vec<[u8; 3]>,
    /// The faces' colours, or nothing.
    pub face_colours: Vec<[u8; 3]>,
    /// The images that the mesh's materials name, in the order of the file.
    pub textures: Vec<PathBuf>,
    /// Faces left out because two of their corners are one point.
    pub dropped: usize,
    /// What was passed over while reading, one line each.
    pub warnings: Vec<String>,
}

impl Model {
    /// The same mesh, `factor` times as large.
    #[must_use]
    pub fn scale(mut self, factor: f64) -> Self {
        for coordinate in self.positions.as_flattened_mut() {
            *coordinate *= factor;
        }
        self
    }

    /// The same mesh, centred on the origin, its longest side from `-half` to `half`.
    ///
    /// A mesh that is a single point is only centred.
    #[must_use]
    pub fn fit(mut self, half: f64) -> Self {
        let [low, high] = bounds(&self.positions);
        let centre = std::array::from_fn::<_, 3, _>(|axis| f64::midpoint(low[axis], high[axis]));
        let extent = (0..3).map(|axis| high[axis] / 2.0 - low[axis] / 2.0).fold(0.0, f64::max);
        let factor = if extent > 0.0 { half / extent } else { 1.0 };
        for position in &mut self.positions {
            *position = std::array::from_fn(|axis| position[axis] * factor - centre[axis] * factor);
        }
        self
    }

    /// The same mesh, with a normal for each face beside those of the vertices.
    #[must_use]
    pub fn with_face_normals(mut self) -> Self {
        self.face_normals = normals::of_faces(&self.positions, &self.faces);
        self
    }
}

/// The least and the greatest coordinate on each axis; zeros without positions.
pub(crate) fn bounds(positions: &[[f64; 3]]) -> [[f64; 3]; 2] {
    let first = positions.first().copied().unwrap_or_default();
    let mut bounds = [first; 2];
    for position in positions {
        for axis in 0..3 {
            bounds[0][axis] = bounds[0][axis].min(position[axis]);
            bounds[1][axis] = bounds[1][axis].max(position[axis]);
        }
    }
    bounds
}

/// What one corner of a face carries.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Corner {
    pub(crate) position: [f64; 3],
    pub(crate) normal: Option<[f64; 3]>,
    pub(crate) uv: Option<[f64; 2]>,
    pub(crate) colour: Option<[u8; 3]>,
}

/// A corner as bits: two corners with the same bits are one vertex.
type Key = ([u64; 3], Option<[u64; 3]>, Option<[u64; 2]>, Option<[u8; 3]>);

impl Corner {
    fn key(&self) -> Key {
        // Adding 0 makes -0 into 0.
        let bits = |value: f64| (value + 0.0).to_bits();
        (
            self.position.map(bits),
            self.normal.map(|n| n.map(bits)),
            self.uv.map(|uv| uv.map(bits)),
            self.colour,
        )
    }
}

/// Makes a mesh from loose triangles: equal corners become one vertex, and faces without area are left out.
#[derive(Debug, Default)]
pub(crate) struct Welder {
    vertices: Vec<Corner>,
    faces: Vec<[u32; 3]>,
    face_colours: Vec<Option<[u8; 3]>>,
    indices: HashMap<Key, u32>,
    dropped: usize,
}

impl Welder {
    /// Adds a face, unless two of its corners are at one point.
    pub(crate) fn face(&mut self, corners: [Corner; 3], colour: Option<[u8; 3]>) {
        let [a, b, c] = corners.map(|corner| corner.position);
        if a == b || b == c || c == a {
            self.dropped += 1;
            return;
        }
        let face = corners.map(|corner| {
            *self.indices.entry(corner.key()).or_insert_with(|| {
                self.vertices.push(corner);
                (self.vertices.len() - 1) as u32
            })
        });
        self.faces.push(face);
        self.face_colours.push(colour);
    }

    /// The mesh, with normals for the vertices that were given none.
    ///
    /// Texture coordinates that only some corners have are (0, 0) elsewhere; colours are white.
    pub(crate) fn finish(self, source: &Path) -> Model {
        const WHITE: [u8; 3] = [255; 3];
        let Self { vertices, faces, face_colours, dropped, .. } = self;
        let positions: Vec<_> = vertices.iter().map(|vertex| vertex.position).collect();
        let given: Vec<_> = vertices.iter().map(|vertex| vertex.normal).collect();
        Model {
            source: source.into(),
            normals: normals::of_vertices(&positions, &faces, &given),
            uvs: all_or_nothing(vertices.iter().map(|vertex| vertex.uv), [0.0; 2]),
            vertex_colours: all_or_nothing(vertices.iter().map(|vertex| vertex.colour), WHITE),
            face_colours: all_or_nothing(face_colours.into_iter(), WHITE),
            positions,
            faces,
            dropped,
            ..Model::default()
        }
    }
}

/// One value for each entry when at least one entry has a value, otherwise none.
fn all_or_nothing<T: Copy>(values: impl Iterator<Item = Option<T>> + Clone, missing: T) -> Vec<T> {
    if values.clone().all(|value| value.is_none()) {
        return Vec::new();
    }
    values.map(|value| value.unwrap_or(missing)).collect()
}
