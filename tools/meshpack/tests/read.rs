//! What is read from files: every way of writing a face, attributes that are missing, materials, both kinds of STL.

mod support;

use meshpack::{Error, Model, Problem, read_mesh, read_obj, read_stl, read_texture};
use proptest::prelude::*;
use support::Folder;

fn obj(name: &str, text: &str) -> Model {
    let folder = Folder::new(name);
    read_obj(folder.write("mesh.obj", text)).unwrap()
}

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

#[test]
fn polygons_negative_indices_and_groups_become_triangles() {
    for face in ["f 1 2 3 4", "f -4 -3 -2 -1", "g a\nf 1 2 3\no b\nf 1 3 4", "f 1 2 \\\n 3 4 # a comment"] {
        let model = obj("polygons", &format!("{SQUARE}{face}\n"));
        assert_eq!(model.positions.len(), 4, "{face}");
        assert_eq!(model.faces, [[0, 1, 2], [0, 2, 3]], "{face}");
        assert_eq!(model.normals, [[0.0, 0.0, 1.0]; 4], "{face}");
        assert!(model.uvs.is_empty() && model.face_colours.is_empty(), "{face}");
    }
}

#[test]
fn a_face_may_name_what_follows_it_and_lines_are_no_faces() {
    let model = obj("order", &format!("f 1 2 3 4\nl 1 2 3\np 1\ns off\n{SQUARE}"));
    assert_eq!(model.faces.len(), 2);
}

#[test]
fn v_grows_down_and_missing_attributes_are_filled() {
    let text = format!("{SQUARE}vt 0.25 1\nvt 1 0\nvn 0 0 -2\nf 1/1 2/2 3/1\nf 1//1 3 4//1\n");
    let model = obj("attributes", &text);
    assert!(model.uvs.contains(&[0.25, 0.0]) && model.uvs.contains(&[1.0, 1.0]));
    assert_eq!(model.uvs.len(), model.positions.len());
    // Given normals are kept at length 1, and missing ones are those of the faces.
    assert!(model.normals.contains(&[0.0, 0.0, -1.0]) && model.normals.contains(&[0.0, 0.0, 1.0]));
    assert_eq!(model.normals.len(), model.positions.len());
}

#[test]
fn smooth_normals_do_not_see_seams() {
    // Two squares at a right angle, split by a seam of the texture along their common edge.
    let text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 -1\nv 1 1 -1\nvt 0 0\nvt 1 1\n\
                f 1/1 2/1 3/1 4/1\nf 2/2 5/2 6/2 3/2\n";
    let model = obj("seams", text);
    assert_eq!(model.positions.len(), 8);
    let half = 0.5_f64.sqrt();
    for (position, normal) in model.positions.iter().zip(&model.normals) {
        if position[0] == 1.0 && position[2] == 0.0 {
            assert!((normal[0] - half).abs() < 1e-12 && (normal[2] - half).abs() < 1e-12, "{normal:?}");
        }
    }
}

#[test]
fn faces_without_area_are_left_out_and_counted() {
    let model = obj("degenerate", &format!("{SQUARE}v 0 0 0\nf 1 2 3\nf 1 1 2\nf 1 5 3\n"));
    assert_eq!((model.faces.len(), model.dropped, model.positions.len()), (1, 2, 3));
}

#[test]
fn materials_give_colours_and_images() {
    let folder = Folder::new("materials");
    folder.write(
        "my colours.mtl",
        "# made up\nnewmtl red one\nKd 1 0 0.5\nmap_Kd -s 1 1 1 -clamp on wood\\grain.png\n\
         newmtl grey\nKd 0.2\nnewmtl odd\nKd spectral x.rfl\n",
    );
    let text = format!(
        "mtllib my colours.mtl\n{SQUARE}usemtl red one\nf 1 2 3\nusemtl grey\nf 1 3 4\nusemtl nobody\nf 2 3 4\n"
    );
    let model = read_obj(folder.write("mesh.obj", text)).unwrap();
    assert_eq!(model.face_colours, [[255, 0, 128], [51, 51, 51], [255, 255, 255]]);
    assert_eq!(model.textures, [folder.path("wood/grain.png")]);
    assert_eq!(model.positions.len(), 4);
    let expected = format!(
        "{}:8: 'Kd' is followed by 'spectral x.rfl', which is not a number",
        folder.path("my colours.mtl").display()
    );
    assert_eq!(model.warnings, [expected]);
}

#[test]
fn a_missing_material_file_is_a_warning() {
    let model = obj("no_material", &format!("mtllib nowhere.mtl\nusemtl a\n{SQUARE}f 1 2 3\n"));
    assert_eq!(model.faces.len(), 1);
    assert_eq!(model.warnings.len(), 1);
    assert!(model.warnings[0].contains("nowhere.mtl: cannot be read"), "{:?}", model.warnings);
}

#[test]
fn vertex_colours_are_read_from_0_to_1_and_from_0_to_255() {
    let ones = obj("colours", "v 0 0 0 1 0.5 0\nv 1 0 0 0 0 0\nv 1 1 0 1 1 1\nf 1 2 3\n");
    assert_eq!(ones.vertex_colours, [[255, 128, 0], [0, 0, 0], [255, 255, 255]]);
    let bytes = obj("colours", "v 0 0 0 255 128 0\nv 1 0 0 0 0 0\nv 1 1 0 7 7 7\nf 1 2 3\n");
    assert_eq!(bytes.vertex_colours, [[255, 128, 0], [0, 0, 0], [7, 7, 7]]);
    let fourth = obj("colours", "v 0 0 0 1\nv 2 0 0 2\nv 1 1 0\nf 1 2 3\n");
    assert_eq!(fourth.positions[1], [1.0, 0.0, 0.0]);
    assert!(fourth.vertex_colours.is_empty());
}

#[test]
fn lines_end_as_they_like() {
    let text = format!("\u{FEFF}{}f 1 2 3", SQUARE.replace('\n', "\r\n"));
    assert_eq!(obj("ends", &text).faces.len(), 1);
}

/// A tetrahedron as a text STL, as two solids, with a triangle whose normal is not a number.
const TETRAHEDRON: [[[f32; 3]; 3]; 4] = [
    [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]],
    [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]],
    [[0.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]],
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
];

fn text_stl() -> String {
    let mut text = String::from("solid\n");
    for (index, triangle) in TETRAHEDRON.iter().enumerate() {
        if index == 2 {
            text += "endsolid\n\nSOLID b\n";
        }
        text += "  FACET NORMAL nan 0 0\n outer loop\n";
        for [x, y, z] in triangle {
            text += &format!("vertex {x:e} {y:e} {z:e}\n");
        }
        text += "endloop\nendfacet\n";
    }
    text + "endsolid b\n"
}

fn binary_stl(header: &[u8; 80]) -> Vec<u8> {
    let mut bytes = header.to_vec();
    bytes.extend((TETRAHEDRON.len() as u32).to_le_bytes());
    for triangle in &TETRAHEDRON {
        bytes.extend([0; 12]);
        bytes.extend(triangle.iter().flatten().flat_map(|value| value.to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

#[test]
fn text_and_binary_stl_are_welded_to_the_same_mesh() {
    let folder = Folder::new("stl");
    let mut solid = [b' '; 80];
    solid[..5].copy_from_slice(b"solid");
    let mut longer = binary_stl(&[0; 80]);
    longer.push(7);
    let files = [
        folder.write("text.stl", text_stl()),
        folder.write("binary.stl", binary_stl(&[0; 80])),
        folder.write("solid.STL", binary_stl(&solid)),
        folder.write("longer.stl", longer),
    ];
    for file in files {
        let model = read_mesh(&file).unwrap();
        assert_eq!((model.positions.len(), model.faces.len()), (4, 4), "{}", file.display());
        assert_eq!(model.faces, [[0, 1, 2], [0, 2, 3], [0, 3, 1], [2, 1, 3]]);
        let long = file.ends_with("longer.stl");
        assert_eq!(model.warnings.len(), usize::from(long));
    }
}

#[test]
fn a_sphere_keeps_its_normals_through_stl_and_smoothing() {
    // An octahedron: the smooth normal of each corner points away from the middle.
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let mut text = String::from("solid o\n");
    for signs in 0..8 {
        let sign = |axis: usize| if signs >> axis & 1 == 1 { -1.0 } else { 1.0 };
        let mut corners = [0, 1, 2].map(|axis| axes[axis].map(|value: f64| value * sign(axis)));
        if sign(0) * sign(1) * sign(2) < 0.0 {
            corners.swap(1, 2);
        }
        text += "facet normal 0 0 0\nouter loop\n";
        for [x, y, z] in corners {
            text += &format!("vertex {x} {y} {z}\n");
        }
        text += "endloop\nendfacet\n";
    }
    let folder = Folder::new("octahedron");
    let model = read_stl(folder.write("o.stl", text + "endsolid\n")).unwrap();
    assert_eq!(model.positions.len(), 6);
    for (position, normal) in model.positions.iter().zip(&model.normals) {
        assert!((0..3).all(|axis| (position[axis] - normal[axis]).abs() < 1e-12), "{position:?} {normal:?}");
    }
}

#[test]
fn images_are_rounded_to_rgb565() {
    let folder = Folder::new("images");
    let pixels = [255, 255, 255, 0, 0, 0, 255, 0, 0, 4, 2, 5];
    for name in ["a.png", "a.bmp"] {
        let path = folder.path(name);
        image::save_buffer(&path, &pixels, 2, 2, image::ExtendedColorType::Rgb8).unwrap();
        let packed = read_texture(&path).unwrap();
        // 4/255 and 5/255 are less and more than half a step of 31.
        assert_eq!(packed.texture().texels(), [0xFFFF, 0x0000, 0xF800, 0x0001], "{name}");
    }
}

#[test]
fn fitting_and_scaling_place_the_box() {
    let model = obj("fit", "v 10 0 0\nv 14 1 0\nv 10 2 0\nf 1 2 3\n");
    let packed = model.clone().fit(1.5).quantise().unwrap();
    let mesh = packed.mesh();
    assert_eq!(mesh.centre().map(|length| length.to_num::<f64>()), [0.0; 3]);
    assert!((mesh.half().to_num::<f64>() - 1.5).abs() < 1e-4);
    assert_eq!(mesh.bounds()[1][0], 32_767);
    assert_eq!(mesh.bounds()[0][0], -32_767);
    let scaled = model.scale(2.0).quantise().unwrap();
    assert_eq!(scaled.mesh().centre().map(|length| length.to_num::<f64>()), [24.0, 2.0, 0.0]);
}

#[test]
fn texture_coordinates_take_the_smallest_exponent() {
    for (largest, exponent) in [(0.999, 0), (1.0, 1), (1.5, 1), (2.0, 2), (7.9, 3), (31.9, 5), (32.0, 5)] {
        let mut model = obj("exponent", &format!("{SQUARE}f 1 2 3\n"));
        model.uvs = vec![[0.0, 0.0], [largest, 0.0], [-0.5, 0.25]];
        let packed = model.quantise().unwrap();
        assert_eq!(packed.mesh().uv_exponent(), exponent, "{largest}");
        let step = f64::from(1 << exponent) / 32_768.0 * 256.0;
        assert!(packed.error().uv_texels <= step, "{largest}");
    }
}

#[test]
fn models_that_do_not_fit_are_refused() {
    let model = obj("refused", &format!("{SQUARE}f 1 2 3\n"));
    let problem = |change: &dyn Fn(&mut Model)| {
        let mut model = model.clone();
        change(&mut model);
        match model.quantise() {
            Err(Error::Input { problem, .. }) => problem,
            other => panic!("{other:?}"),
        }
    };
    assert_eq!(problem(&|model| model.faces.clear()), Problem::NotAMesh("face that has an area"));
    assert_eq!(problem(&|model| model.positions[1][0] = 40_000.0), Problem::TooFar(40_000.0));
    assert!(matches!(problem(&|model| model.positions[1][2] = f64::NAN), Problem::NotFinite { .. }));
    assert_eq!(problem(&|model| model.uvs = vec![[0.0, -32.5]; 3]), Problem::UvTooFar(-32.5));
    assert_eq!(
        problem(&|model| model.uvs = vec![[0.0; 2]; 2]),
        Problem::LengthMismatch { given: 2, needed: 3 }
    );
    let out = Problem::OutOfRange { what: "vertex", index: 3, count: 3 };
    assert_eq!(problem(&|model| model.faces[0][2] = 3), out);
    assert_eq!(problem(&|model| model.positions.resize(65_536, [0.0; 3])), Problem::TooManyVertices(65_536));
}

proptest! {
    #[test]
    fn positions_are_rounded_within_half_a_step(
        corners in prop::collection::vec(prop::array::uniform3(-32_767.0..=32_767.0_f64), 3..20),
        factor in prop_oneof![Just(1.0), 1e-9..1.0_f64],
    ) {
        let faces = (2..corners.len() as u32).map(|last| [0, last - 1, last]).collect();
        let model = Model { positions: corners, faces, ..Model::default() }.scale(factor);
        let packed = model.quantise().unwrap();
        let step = packed.mesh().half().to_num::<f64>() / 32_768.0;
        prop_assert!(packed.error().position_max <= step * 0.7501_f64.sqrt(), "{packed}");
    }

    /// No text makes the reader panic, and what it takes can be packed or is refused with one line.
    #[test]
    fn arbitrary_lines_never_panic(lines in prop::collection::vec(
        ("(v|vt|vn|f|g|usemtl|mtllib|l|vp)", "[-0-9./ eE]{0,12}|[0-4] [0-4] [0-4]|nan inf"), 0..40,
    )) {
        let text: String = lines.iter().map(|(keyword, rest)| format!("{keyword} {rest}\n")).collect();
        let folder = Folder::new("arbitrary");
        match read_obj(folder.write("mesh.obj", text)).and_then(|model| model.quantise()) {
            Ok(packed) => prop_assert!(!packed.mesh().faces().is_empty()),
            Err(error) => prop_assert_eq!(error.to_string().lines().count(), 1),
        }
    }

    #[test]
    fn arbitrary_bytes_are_no_stl_that_panics(start in "(solid |facet|)", bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        let folder = Folder::new("arbitrary_stl");
        let _ = read_stl(folder.write("mesh.stl", [start.as_bytes(), &bytes].concat()));
    }
}
