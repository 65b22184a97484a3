//! Bad input: one line that names file, line and value, exit status 2, and no file left behind.

mod support;

use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use support::Folder;

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

fn run(arguments: &[&str], file: &Path, folder: &Folder) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_meshpack"));
    command.args(arguments).arg(file);
    command.arg("--rust").arg(folder.path("out.rs")).arg("--blob").arg(folder.path("out.blob"));
    command.output().unwrap()
}

/// Asserts that the command refuses the file with exactly this line after its name, and writes nothing.
fn refuses(arguments: &[&str], folder: &Folder, file: &Path, message: &str) {
    let before = names(folder);
    let output = run(arguments, file, folder);
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!(said, format!("{}{message}\n", file.display()));
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(output.stdout.is_empty(), "{said}");
    assert_eq!(names(folder), before, "{said}");
}

fn names(folder: &Folder) -> Vec<String> {
    let entries = fs::read_dir(folder.path("")).unwrap();
    let mut names: Vec<_> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

fn refuses_mesh(name: &str, bytes: impl AsRef<[u8]>, message: &str) {
    let folder = Folder::new("bad_mesh");
    let file = folder.write(name, bytes);
    refuses(&["mesh"], &folder, &file, message);
}

// The tests of one file run at the same time, so that each has a folder of its own name.
macro_rules! bad_meshes {
    ($($test:ident: $name:literal, $bytes:expr, $message:expr;)*) => {$(
        #[test]
        fn $test() {
            let folder = Folder::new(stringify!($test));
            let file = folder.write($name, $bytes);
            refuses(&["mesh"], &folder, &file, $message);
        }
    )*};
}

bad_meshes! {
    an_empty_obj: "a.obj", "", ": the file is empty";
    a_blank_obj: "a.obj", " \n\r\n", ": the file is empty";
    prose: "a.obj", "Dear reader,\nthis is a letter.\n", ": not a mesh: no vertex ('v' line)";
    a_picture_named_obj: "a.obj", b"\x89PNG\r\n\x1A\n\0\0\0", ":1: not UTF-8 text";
    latin_1: "a.obj", b"v 0 0 0\n# caf\xE9\n", ":2: not UTF-8 text";
    points_alone: "a.obj", TRIANGLE, ": not a mesh: no face ('f' line)";
    lines_alone: "a.obj", format!("{TRIANGLE}l 1 2 3\n"), ": not a mesh: no face ('f' line)";
    faces_without_area: "a.obj", format!("{TRIANGLE}f 1 1 2\n"), ": not a mesh: no face that has an area";
    a_vertex_cut_off: "a.obj", "v 0 0 0\nv 1 0", ":2: 'v' needs at least 3 entries, and 2 are given";
    a_face_cut_off: "a.obj", format!("{TRIANGLE}f 1 2"), ":4: 'f' needs at least 3 entries, and 2 are given";
    faces_cut_off_from_vertices: "a.obj", "v 0 0 0\nv 1 0 0\nf 1 2 3\n", ":3: a face names vertex 3, and there are 2";
    an_index_out_of_range: "a.obj", format!("{TRIANGLE}f 1 2 7\n"), ":4: a face names vertex 7, and there are 3";
    index_0: "a.obj", format!("{TRIANGLE}f 0 1 2\n"), ":4: a face names vertex 0, and there are 3";
    an_index_before_the_first: "a.obj", format!("{TRIANGLE}f -1 -2 -4\n"), ":4: a face names vertex -4, and there are 3";
    the_largest_index: "a.obj", format!("{TRIANGLE}f 1 2 9223372036854775807\n"),
        ":4: a face names vertex 9223372036854775807, and there are 3";
    the_least_index: "a.obj", format!("{TRIANGLE}f 1 2 -9223372036854775808\n"),
        ":4: a face names vertex -9223372036854775808, and there are 3";
    an_index_beyond_all: "a.obj", format!("{TRIANGLE}f 1 2 99999999999999999999\n"),
        ":4: 'f' is followed by '99999999999999999999', which is not a number";
    a_texture_index_out_of_range: "a.obj", format!("{TRIANGLE}vt 0 0\nf 1/1 2/1 3/2\n"),
        ":5: a face names texture coordinate 2, and there are 1";
    a_normal_index_out_of_range: "a.obj", format!("{TRIANGLE}f 1//1 2//1 3//1\n"),
        ":4: a face names normal 1, and there are 0";
    too_many_slashes: "a.obj", format!("{TRIANGLE}f 1/2/3/4 2 3\n"), ":4: 'f' is followed by '1/2/3/4', which is not a number";
    not_a_number: "a.obj", "v 0 zero 0\n", ":1: 'v' is followed by 'zero', which is not a number";
    nan: "a.obj", "v 0 0 0\nv NaN 0 0\n", ":2: 'v' is followed by 'NaN', which is not finite";
    infinity: "a.obj", "v 0 -inf 0\n", ":1: 'v' is followed by '-inf', which is not finite";
    a_number_beyond_floats: "a.obj", "v 0 1e999 0\n", ":1: 'v' is followed by '1e999', which is not finite";
    a_normal_that_is_nan: "a.obj", "vn nan 0 0\n", ":1: 'vn' is followed by 'nan', which is not finite";
    a_texture_coordinate_that_is_infinite: "a.obj", "vt inf 0\n", ":1: 'vt' is followed by 'inf', which is not finite";
    a_texture_coordinate_too_far: "a.obj", "vt 0 0\nvt 32.5 0\n", ":2: texture coordinate 32.5 is beyond ±32 repeats";
    coordinates_too_far: "a.obj", "v 0 0 0\nv 40000 0 0\nv 0 1 0\nf 1 2 3\n",
        ": coordinate 40000 is beyond ±32767 units: give --scale or --fit";
    another_type: "a.ply", "ply\n", ": not a mesh file: the name should end in .obj or .stl";
    no_type: "mesh", "v 0 0 0\n", ": not a mesh file: the name should end in .obj or .stl";
    a_long_word: "a.obj", format!("v {} 0 0\n", "x".repeat(10_000)),
        &format!(":1: 'v' is followed by '{}…', which is not a number", "x".repeat(120));

    an_empty_stl: "a.stl", "", ": the file is empty";
    a_short_stl: "a.stl", [0; 60], ": the file is cut off: neither text nor binary STL: 60 bytes, and the header alone is 84";
    an_stl_without_triangles: "a.stl", [0; 84], ": not a mesh: no triangle";
    a_text_stl_without_triangles: "a.stl", "solid a\nendsolid a\n", ": not a mesh: no face that has an area";
    a_binary_stl_cut_off: "a.stl", [&[0; 80][..], &[9, 0, 0, 0], &[0; 99]].concat(),
        ": the file is cut off: the header counts 9 triangles, 534 bytes, and 183 bytes are there";
    a_binary_stl_with_nan: "a.stl", [&[0; 80][..], &[1, 0, 0, 0], &[0; 12], &f32::NAN.to_le_bytes(), &[0; 34]].concat(),
        ": 'triangle 1' is followed by 'NaN', which is not finite";
    a_text_stl_cut_off: "a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n",
        ":4: the file is cut off: 'vertex' should follow";
    a_text_stl_without_end: "a.stl", "solid a\n", ":1: the file is cut off: 'endsolid' should follow";
    a_text_stl_out_of_order: "a.stl", "solid a\nfacet normal 0 0 1\nvertex 0 0 0\n",
        ":3: 'outer loop' should stand here, and not 'vertex 0 0 0'";
    a_text_stl_with_infinity: "a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 inf 0\n",
        ":4: 'vertex' is followed by 'inf', which is not finite";
    a_text_stl_with_a_short_vertex: "a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0\n",
        ":4: 'vertex' needs at least 3 entries, and 2 are given";
    a_text_stl_in_latin_1: "a.stl", b"solid a\nfacet \xE9\n", ":2: not UTF-8 text";
}

#[test]
fn more_vertices_than_indices_can_name() {
    let mut text: String =
        (0..65_536).map(|index| format!("v {} {} 0\n", index % 256, index / 256)).collect();
    for index in 1..65_535 {
        text += &format!("f {} {} {}\n", index, index + 1, index + 2);
    }
    refuses_mesh("a.obj", text, ": 65536 vertices, and a mesh holds at most 65535");
}

#[test]
fn a_missing_file_and_a_folder() {
    let folder = Folder::new("missing");
    for name in ["nowhere.obj", "nowhere.stl"] {
        let message = ": cannot be read: No such file or directory (os error 2)";
        refuses(&["mesh"], &folder, &folder.path(name), message);
    }
    refuses(
        &["texture"],
        &folder,
        &folder.path("a.png"),
        ": cannot be read: No such file or directory (os error 2)",
    );
    fs::create_dir(folder.path("folder.obj")).unwrap();
    let output = run(&["mesh"], &folder.path("folder.obj"), &folder);
    assert_eq!(output.status.code(), Some(2));
}

#[test]
fn images_that_are_no_textures() {
    let folder = Folder::new("bad_images");
    for (width, height) in [(48, 64), (64, 3), (2048, 1)] {
        let file = folder.path("a.png");
        let pixels = vec![0; (width * height * 3) as usize];
        image::save_buffer(&file, &pixels, width, height, image::ExtendedColorType::Rgb8).unwrap();
        let message = format!(
            ": {width}x{height} pixels: a texture's width and height are powers of two from 1 to 1024"
        );
        refuses(&["texture"], &folder, &file, &message);
    }
    refuses(&["texture"], &folder, &folder.write("b.png", ""), ": the file is empty");
    let whole = {
        let file = folder.path("c.png");
        image::save_buffer(&file, &[9; 64 * 64 * 3], 64, 64, image::ExtendedColorType::Rgb8).unwrap();
        fs::read(file).unwrap()
    };
    for (name, bytes) in [("d.png", &b"this is a text"[..]), ("e.png", &whole[..whole.len() / 2])] {
        let file = folder.write(name, bytes);
        let before = names(&folder);
        let output = run(&["texture"], &file, &folder);
        let said = String::from_utf8(output.stderr).unwrap();
        assert!(said.starts_with(&format!("{}: not an image: ", file.display())), "{said}");
        assert_eq!((said.lines().count(), output.status.code()), (1, Some(2)), "{said}");
        assert_eq!(names(&folder), before);
    }
}

#[test]
fn an_output_that_cannot_be_written_leaves_no_other() {
    let folder = Folder::new("unwritable");
    let file = folder.write("a.obj", format!("{TRIANGLE}f 1 2 3\n"));
    fs::create_dir(folder.path("taken")).unwrap();
    let before = names(&folder);
    for target in ["no/such/folder/out.blob", "taken"] {
        let output = Command::new(env!("CARGO_BIN_EXE_meshpack"))
            .arg("mesh")
            .arg(&file)
            .arg("--rust")
            .arg(folder.path("out.rs"))
            .arg("--blob")
            .arg(folder.path(target))
            .output()
            .unwrap();
        let said = String::from_utf8(output.stderr).unwrap();
        assert!(
            said.starts_with(&format!("{}: cannot be written: ", folder.path(target).display())),
            "{said}"
        );
        assert_eq!((said.lines().count(), output.status.code()), (1, Some(2)), "{said}");
        assert_eq!(names(&folder), before);
    }
}

#[test]
fn options_that_make_no_sense() {
    let folder = Folder::new("options");
    let file = folder.write("a.obj", format!("{TRIANGLE}f 1 2 3\n"));
    for options in
        [["--scale", "0"], ["--scale", "inf"], ["--fit", "nan"], ["--fit", "-1"], ["--name", "two words"]]
    {
        let output = run(&[&["mesh"], &options[..]].concat(), &file, &folder);
        assert_eq!(output.status.code(), Some(2), "{options:?}");
        assert_eq!(names(&folder), ["a.obj"], "{options:?}");
    }
}

#[test]
fn good_input_is_written_whole() {
    let folder = Folder::new("good");
    let file = folder.write("my mesh.obj", format!("{TRIANGLE}f 1 2 3\n"));
    let output = run(&["mesh", "--fit", "2", "--face-normals"], &file, &folder);
    assert!(output.status.success() && output.stderr.is_empty());
    let report = String::from_utf8(output.stdout).unwrap();
    assert!(
        report.contains("vertices        3\n") && report.contains("flash           36 bytes"),
        "{report}"
    );
    let rust = fs::read_to_string(folder.path("out.rs")).unwrap();
    assert!(rust.contains("pub const MY_MESH: Mesh<'static> = {"), "{rust}");
    assert_eq!(fs::read(folder.path("out.blob")).unwrap()[..4], *b"TLMH");
    assert_eq!(names(&folder), ["my mesh.obj", "out.blob", "out.rs"]);
}
