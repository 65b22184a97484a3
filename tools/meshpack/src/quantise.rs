//! From floats to the library's formats, with the error that this makes.

use crate::error::{Error, Problem};
use crate::model::{Model, bounds};
use crate::normals::{dot, unit};
use std::fmt::{self, Display, Formatter};
use topleft::{Length, MAX_UV_EXPONENT, MAX_VERTICES, Mesh};

/// The largest coordinate of a model, in its own unit.
const MAX_COORDINATE: f64 = 32_767.0;

/// Texel rows and columns of the texture that the error of texture coordinates is stated for.
const TEXELS: f64 = 256.0;

/// A mesh in the library's formats, checked.
#[derive(Clone, Debug, PartialEq)]
pub struct Packed {
    pub(crate) positions: Vec<[i16; 3]>,
    pub(crate) faces: Vec<[u16; 3]>,
    pub(crate) normals: Vec<[i8; 3]>,
    pub(crate) face_normals: Vec<[i8; 3]>,
    pub(crate) uvs: Vec<[i16; 2]>,
    pub(crate) uv_exponent: u8,
    pub(crate) vertex_colours: Vec<[u8; 3]>,
    pub(crate) face_colours: Vec<[u8; 3]>,
    pub(crate) centre: [Length; 3],
    pub(crate) half: Length,
    pub(crate) error: QuantisationError,
}

/// How far a packed mesh is from the model it was made of.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct QuantisationError {
    /// The largest distance of a vertex from its place, in the mesh's own unit.
    pub position_max: f64,
    /// The root of the mean square of these distances.
    pub position_rms: f64,
    /// The largest angle between a normal and its true direction, in degrees.
    pub normal_degrees: f64,
    /// The largest error of a texture coordinate, in texels of a texture with 256 rows and columns.
    pub uv_texels: f64,
}

impl Model {
    /// Rounds the mesh to the library's formats: everything to nearest.
    ///
    /// The mesh's box is centred on the model's, and its half edge is the longest half side, with room for every
    /// position. Texture coordinates get the smallest exponent that holds them all.
    ///
    /// # Errors
    /// No faces, more than 65 535 vertices, an index out of range, an attribute of the wrong length, a value that is
    /// not finite, a coordinate beyond ±32 767 units, or a texture coordinate beyond ±32 repeats.
    pub fn quantise(&self) -> Result<Packed, Error> {
        self.check().map_err(|problem| Error::file(&self.source, problem))?;
        let [low, high] = bounds(&self.positions);
        let centre: [Length; 3] = std::array::from_fn(|axis| {
            Length::from_bits((f64::midpoint(low[axis], high[axis]) * 65_536.0).round() as i32)
        });
        let origin = centre.map(|length| f64::from(length.to_bits()) / 65_536.0);
        let extent =
            (0..3).map(|axis| (high[axis] - origin[axis]).max(origin[axis] - low[axis])).fold(0.0, f64::max);
        let half = half_of(extent);
        let step = f64::from(half.to_bits()) / 65_536.0 / 32_768.0;

        let quantised = |position: &[f64; 3]| {
            std::array::from_fn(|axis| ((position[axis] - origin[axis]) / step).round() as i16)
        };
        let positions: Vec<[i16; 3]> = self.positions.iter().map(quantised).collect();
        let normals: Vec<[i8; 3]> = self.normals.iter().copied().map(normal).collect();
        let face_normals: Vec<[i8; 3]> = self.face_normals.iter().copied().map(normal).collect();
        let uv_exponent = uv_exponent(&self.uvs);
        let uv_step = f64::from(1 << uv_exponent) / 32_768.0;
        // The cast saturates: 32 repeats exactly are one step less.
        let uvs: Vec<[i16; 2]> =
            self.uvs.iter().map(|uv| uv.map(|value| (value / uv_step).round() as i16)).collect();

        let place =
            |position: &[i16; 3]| std::array::from_fn(|axis| origin[axis] + f64::from(position[axis]) * step);
        let [position_max, position_rms] = distances(&self.positions, positions.iter().map(place));
        let all_normals =
            self.normals.iter().zip(&normals).chain(self.face_normals.iter().zip(&face_normals));
        let uv_values = self.uvs.as_flattened().iter().zip(uvs.as_flattened());
        let error = QuantisationError {
            position_max,
            position_rms,
            normal_degrees: all_normals.map(|(n, packed)| degrees(*n, *packed)).fold(0.0, f64::max),
            uv_texels: uv_values.map(|(uv, raw)| (f64::from(*raw) * uv_step - uv).abs()).fold(0.0, f64::max)
                * TEXELS,
        };
        Ok(Packed {
            positions,
            faces: self.faces.iter().map(|face| face.map(|index| index as u16)).collect(),
            normals,
            face_normals,
            uvs,
            uv_exponent,
            vertex_colours: self.vertex_colours.clone(),
            face_colours: self.face_colours.clone(),
            centre,
            half,
            error,
        })
    }

    fn check(&self) -> Result<(), Problem> {
        if self.faces.is_empty() {
            return Err(Problem::NotAMesh("face that has an area"));
        }
        let (vertices, faces) = (self.positions.len(), self.faces.len());
        if vertices > MAX_VERTICES {
            return Err(Problem::TooManyVertices(vertices));
        }
        let indices = self.faces.as_flattened();
        if let Some(&index) = indices.iter().find(|&&index| index as usize >= vertices) {
            return Err(Problem::OutOfRange { what: "vertex", index: index.into(), count: vertices });
        }
        let lengths = [
            (self.normals.len(), vertices),
            (self.face_normals.len(), faces),
            (self.uvs.len(), vertices),
            (self.vertex_colours.len(), vertices),
            (self.face_colours.len(), faces),
        ];
        if let Some(&(given, needed)) = lengths.iter().find(|(given, needed)| *given != 0 && given != needed)
        {
            return Err(Problem::LengthMismatch { given, needed });
        }
        let coordinates = self.positions.as_flattened();
        let normals = self.normals.as_flattened().iter().chain(self.face_normals.as_flattened());
        let mut all = coordinates.iter().chain(normals).chain(self.uvs.as_flattened());
        if let Some(value) = all.find(|value| !value.is_finite()) {
            return Err(Problem::NotFinite { keyword: "vertex".into(), value: value.to_string() });
        }
        if let Some(&value) = coordinates.iter().find(|value| value.abs() > MAX_COORDINATE) {
            return Err(Problem::TooFar(value));
        }
        let most = f64::from(1 << MAX_UV_EXPONENT);
        if let Some(&value) = self.uvs.as_flattened().iter().find(|value| value.abs() > most) {
            return Err(Problem::UvTooFar(value));
        }
        Ok(())
    }
}

/// The half edge nearest to the one at which `extent` is 32 767 steps, or the next if `extent` does not fit then.
fn half_of(extent: f64) -> Length {
    // The cast saturates at the greatest length, where the greatest extent still rounds to 32 767.
    let nearest = ((extent * 32_768.0 / 32_767.0 * 65_536.0).round() as i32).max(1);
    let steps = (extent * 65_536.0 / f64::from(nearest) * 32_768.0).round();
    Length::from_bits(if steps > 32_767.0 { nearest.saturating_add(1) } else { nearest })
}

/// A direction in steps of 1/127, each axis to nearest. A vector without length becomes (0, 0, 127).
fn normal(vector: [f64; 3]) -> [i8; 3] {
    unit(vector).unwrap_or([0.0, 0.0, 1.0]).map(|value| (value * 127.0).round() as i8)
}

/// The smallest exponent at which no coordinate saturates, or the largest exponent.
fn uv_exponent(uvs: &[[f64; 2]]) -> u8 {
    let fits = |exponent: &u8| {
        let step = f64::from(1 << exponent) / 32_768.0;
        uvs.as_flattened().iter().all(|value| (-32_768.0..=32_767.0).contains(&(value / step).round()))
    };
    (0..MAX_UV_EXPONENT).find(fits).unwrap_or(MAX_UV_EXPONENT)
}

/// The largest distance of paired points, and the root of their mean square.
fn distances(given: &[[f64; 3]], packed: impl Iterator<Item = [f64; 3]>) -> [f64; 2] {
    let (mut most, mut sum) = (0.0_f64, 0.0);
    for (a, b) in given.iter().zip(packed) {
        let square: f64 = (0..3).map(|axis| (a[axis] - b[axis]).powi(2)).sum();
        most = most.max(square);
        sum += square;
    }
    [most.sqrt(), (sum / given.len().max(1) as f64).sqrt()]
}

/// The angle between a direction and its packed form.
fn degrees(vector: [f64; 3], packed: [i8; 3]) -> f64 {
    match (unit(vector), unit(packed.map(f64::from))) {
        (Some(a), Some(b)) => dot(a, b).clamp(-1.0, 1.0).acos().to_degrees(),
        _ => 0.0,
    }
}

impl Packed {
    /// The mesh, borrowed, as the library draws it.
    ///
    /// # Panics
    /// Never: what [`Model::quantise`] made is a mesh.
    pub fn mesh(&self) -> Mesh<'_> {
        self.try_mesh().expect("the packer checks indices and lengths")
    }

    fn try_mesh(&self) -> Result<Mesh<'_>, topleft::MeshError> {
        let mut mesh = Mesh::new(&self.positions, &self.faces)?.with_box(self.centre, self.half);
        if !self.normals.is_empty() {
            mesh = mesh.with_normals(&self.normals)?;
        }
        if !self.face_normals.is_empty() {
            mesh = mesh.with_face_normals(&self.face_normals)?;
        }
        if !self.uvs.is_empty() {
            mesh = mesh.with_uvs(&self.uvs, self.uv_exponent)?;
        }
        if !self.vertex_colours.is_empty() {
            mesh = mesh.with_vertex_colours(&self.vertex_colours)?;
        }
        if !self.face_colours.is_empty() {
            mesh = mesh.with_face_colours(&self.face_colours)?;
        }
        Ok(mesh)
    }

    /// How far the packed mesh is from its model.
    pub fn error(&self) -> QuantisationError {
        self.error
    }

    /// Bytes that the mesh's arrays take in flash.
    pub fn bytes(&self) -> usize {
        size_of_val(&*self.positions)
            + size_of_val(&*self.faces)
            + size_of_val(&*self.normals)
            + size_of_val(&*self.face_normals)
            + size_of_val(&*self.uvs)
            + size_of_val(&*self.vertex_colours)
            + size_of_val(&*self.face_colours)
    }
}

/// The report of the command: sizes, and the error of each attribute.
impl Display for Packed {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let error = self.error;
        writeln!(f, "vertices        {}", self.positions.len())?;
        writeln!(f, "faces           {}", self.faces.len())?;
        writeln!(
            f,
            "position error  {:.3e} at most, {:.3e} rms, in the mesh's unit",
            error.position_max, error.position_rms
        )?;
        writeln!(f, "normal error    {:.2} degrees at most", error.normal_degrees)?;
        if !self.uvs.is_empty() {
            writeln!(
                f,
                "uv error        {:.4} texels of 256 at most, exponent {}",
                error.uv_texels, self.uv_exponent
            )?;
        }
        write!(f, "flash           {} bytes", self.bytes())
    }
}
