//! Blobs: what is written is what is read, and nothing that is read can do harm.

use meshpack::{Model, Packed, made_meshes, made_textures};
use proptest::prelude::*;
use topleft::{Aligned, BlobError, Mesh, MeshError, Texture, TextureError, Wrap};

/// The bytes at a multiple of 4, as a firmware's static has them.
struct Placed(Vec<u32>, usize);

impl Placed {
    fn new(bytes: &[u8]) -> Self {
        let mut words = vec![0_u32; bytes.len().div_ceil(4) + 1];
        bytemuck::cast_slice_mut::<u32, u8>(&mut words)[..bytes.len()].copy_from_slice(bytes);
        Self(words, bytes.len())
    }

    fn bytes(&self) -> &[u8] {
        &bytemuck::cast_slice(&self.0)[..self.1]
    }
}

fn assert_equal(a: &Mesh<'_>, b: &Mesh<'_>) {
    assert_eq!(format!("{a:?}"), format!("{b:?}"));
}

/// A mesh with every attribute, of sizes that need padding everywhere.
fn small() -> Packed {
    let model = Model {
        positions: vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.25], [0.0, 2.0, -0.5]],
        faces: vec![[0, 1, 2]],
        normals: vec![[0.0, 0.0, 1.0], [1.0, 2.0, 3.0], [-1.0, 0.0, 0.5]],
        uvs: vec![[0.0, 0.0], [3.0, -1.0], [0.1, 0.9]],
        vertex_colours: vec![[1, 2, 3], [4, 5, 6], [7, 8, 9]],
        face_colours: vec![[10, 11, 12]],
        ..Model::default()
    };
    model.with_face_normals().quantise().unwrap()
}

#[test]
fn what_is_written_is_what_is_read() {
    for packed in made_meshes().into_iter().map(|made| made.packed).chain([small()]) {
        let placed = Placed::new(&packed.to_blob());
        assert_equal(&Mesh::from_bytes(placed.bytes()).unwrap(), &packed.mesh());
    }
    for made in made_textures() {
        for wrap in [Wrap::Repeat, Wrap::Clamp] {
            let packed = made.packed.clone().with_wrap(wrap);
            let placed = Placed::new(&packed.to_blob());
            assert_eq!(Texture::from_bytes(placed.bytes()).unwrap(), packed.texture());
        }
    }
}

#[test]
fn sections_start_at_multiples_of_four() {
    let packed = small();
    let placed = Placed::new(&packed.to_blob());
    let mesh = Mesh::from_bytes(placed.bytes()).unwrap();
    let starts = [
        mesh.positions().as_ptr() as usize,
        mesh.faces().as_ptr() as usize,
        mesh.normals().as_ptr() as usize,
        mesh.face_normals().as_ptr() as usize,
        mesh.uvs().as_ptr() as usize,
        mesh.vertex_colours().as_ptr() as usize,
        mesh.face_colours().as_ptr() as usize,
    ];
    assert!(starts.iter().all(|start| start % 4 == 0));
    assert_eq!(starts[0] - placed.bytes().as_ptr() as usize, 36);
}

#[test]
fn every_shorter_blob_is_refused() {
    let packed = small();
    let blob = packed.to_blob();
    // The last section is 3 bytes and one of padding, which nobody needs.
    let needed = blob.len() - 1;
    for length in 0..needed {
        let placed = Placed::new(&blob[..length]);
        match Mesh::from_bytes(placed.bytes()) {
            Err(BlobError::Truncated { needed: short, given }) => {
                assert_eq!(given, length);
                assert!((length + 1..=needed).contains(&short), "{short} at {length}");
            }
            other => panic!("{other:?} at {length} bytes"),
        }
    }
    assert_equal(&Mesh::from_bytes(Placed::new(&blob[..needed]).bytes()).unwrap(), &packed.mesh());
    let mut longer = blob;
    longer.extend([1, 2, 3]);
    assert_equal(&Mesh::from_bytes(Placed::new(&longer).bytes()).unwrap(), &packed.mesh());

    let texture = made_textures().remove(0).packed.to_blob();
    for length in 0..texture.len() {
        let error = Texture::from_bytes(Placed::new(&texture[..length]).bytes()).unwrap_err();
        assert!(matches!(error, BlobError::Truncated { .. }), "{error:?} at {length} bytes");
    }
}

#[test]
fn no_flipped_bit_panics_and_none_in_an_index_goes_unseen() {
    let blob = small().to_blob();
    for bit in 0..blob.len() * 8 {
        let mut changed = blob.clone();
        changed[bit / 8] ^= 1 << (bit % 8);
        let placed = Placed::new(&changed);
        if let Ok(mesh) = Mesh::from_bytes(placed.bytes()) {
            assert!(mesh.faces().iter().flatten().all(|&index| usize::from(index) < mesh.positions().len()));
        }
    }
    let texture = made_textures().remove(0).packed.to_blob();
    for bit in 0..12 * 8 {
        let mut changed = texture.clone();
        changed[bit / 8] ^= 1 << (bit % 8);
        let _ = Texture::from_bytes(Placed::new(&changed).bytes());
    }
}

/// The blob of `small` with some bytes changed, and what is said of it.
fn refused(offset: usize, bytes: &[u8]) -> BlobError {
    let mut blob = small().to_blob();
    blob[offset..offset + bytes.len()].copy_from_slice(bytes);
    Mesh::from_bytes(Placed::new(&blob).bytes()).unwrap_err()
}

#[test]
fn each_error_carries_the_bad_value() {
    assert_eq!(refused(0, b"OBJ "), BlobError::BadMagic(*b"OBJ "));
    assert_eq!(refused(4, &[2, 1]), BlobError::Version(0x0102));
    assert_eq!(refused(6, &[0x3F, 0]), BlobError::Attributes(0x3F));
    let huge = usize::try_from(u64::from(u32::MAX) * 6 + 36).unwrap();
    assert!(matches!(refused(8, &[0xFF; 4]), BlobError::Truncated { needed, .. } if needed == huge));
    assert_eq!(refused(16, &[6, 0, 0, 0]), BlobError::Mesh(MeshError::UvExponent(6)));
    assert_eq!(refused(16, &[1, 1, 0, 0]), BlobError::Mesh(MeshError::UvExponent(255)));
    // Positions are 18 bytes and 2 of padding, so that the faces start at 56.
    assert_eq!(refused(56, &[3, 0]), BlobError::Mesh(MeshError::IndexOutOfRange { face: 0, index: 3 }));

    let texture = |bytes: &[u8]| Texture::from_bytes(Placed::new(bytes).bytes()).unwrap_err();
    assert_eq!(texture(b"TLMH\x01\0\0\0"), BlobError::BadMagic(*b"TLMH"));
    assert_eq!(texture(b"TLTX\x01\0\x02\0\x01\0\x01\0\0\0"), BlobError::Wrap(2));
    assert_eq!(texture(b"TLTX\x01\0\0\0\x03\0\x01\0\0\0\0\0\0\0"), BlobError::Texture(TextureError::Size(3)));
}

#[test]
fn an_odd_address_is_refused() {
    let mut bytes = vec![0];
    bytes.extend(small().to_blob());
    assert_eq!(Mesh::from_bytes(&Placed::new(&bytes).bytes()[1..]).unwrap_err(), BlobError::Misaligned);
    static BYTES: &Aligned<[u8]> = &Aligned(*b"12345");
    assert_eq!(BYTES.0.as_ptr() as usize % 4, 0);
}

#[test]
fn a_mesh_without_faces_is_a_mesh() {
    let mut blob = b"TLMH\x01\0\0\0".to_vec();
    blob.resize(36, 0);
    let placed = Placed::new(&blob);
    assert!(Mesh::from_bytes(placed.bytes()).unwrap().faces().is_empty());
}

proptest! {
    #[test]
    fn arbitrary_bytes_never_panic(bytes in prop::collection::vec(any::<u8>(), 0..256)) {
        let placed = Placed::new(&bytes);
        let _ = Mesh::from_bytes(placed.bytes());
        let _ = Texture::from_bytes(placed.bytes());
    }

    /// Arbitrary bytes behind a header that is right, so that the sections are reached.
    #[test]
    fn arbitrary_sections_never_panic(
        flags in 0_u16..32,
        counts in prop::array::uniform2(prop_oneof![0_u32..20, any::<u32>()]),
        exponent in 0_u32..8,
        bytes in prop::collection::vec(any::<u8>(), 0..512),
        skip in 0_usize..4,
    ) {
        let mut blob = vec![0; skip];
        blob.extend(b"TLMH\x01\0");
        blob.extend(flags.to_le_bytes());
        blob.extend([counts[0], counts[1], exponent].into_iter().flat_map(u32::to_le_bytes));
        blob.extend(bytes);
        let placed = Placed::new(&blob);
        if let Ok(mesh) = Mesh::from_bytes(&placed.bytes()[skip..]) {
            prop_assert!(mesh.faces().iter().flatten().all(|&index| usize::from(index) < mesh.positions().len()));
        }
    }
}
