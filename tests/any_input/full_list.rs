//! Lists that are too small for what is drawn into them.

use embedded_graphics_core::geometry::Size;
use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};
use topleft::{
    Affine, Cull, Depth16, DrawError, DrawList, Flat, Gouraud, Length, ListTriangle, Material, Mesh, NoDepth,
    Orthographic, Perspective, Pose, Stats, Strip, Texture, Textured, Turn, Wrap,
};

/// A fan of `faces` round the origin, seen from so near that the near plane cuts it, or from afar.
fn fan_mesh(faces: usize) -> (Vec<[i16; 3]>, Vec<[u16; 3]>) {
    let mut positions = vec![[0, 0, 0]];
    for k in 0..faces {
        let (sin, cos) = (k as f64 * core::f64::consts::TAU / faces as f64).sin_cos();
        positions.push([(cos * 32_000.0) as i16, (sin * 12_000.0) as i16, (sin * 32_000.0) as i16]);
    }
    let ring = |k: usize| (k % faces + 1) as u16;
    (positions, (0..faces).map(|k| [0, ring(k), ring(k + 1)]).collect())
}

/// A list of this size, with a fan drawn into it.
fn into_list(faces: usize, near: bool, [words, triangles]: [usize; 2]) -> (Result<(), DrawError>, Stats) {
    let (positions, indices) = fan_mesh(faces);
    let mesh = Mesh::new(&positions, &indices).unwrap();
    let mut storage = (vec![0; words], vec![ListTriangle::EMPTY; triangles]);
    let mut list = DrawList::<u16, Depth16>::new(&mut storage.0, &mut storage.1);
    list.set_cull(Cull::None);
    let eye = if near { [0.0, 0.3, 0.2] } else { [0.0, 2.5, 4.0] };
    let camera =
        Perspective::new(Size::new(64, 64), Turn::from_degrees(70), 0.1..20.0).look_at(eye, [0.0; 3]);
    let result = list.draw(&camera, &mesh, &Pose::new(), &Flat::new(Rgb565::RED));
    (result, list.stats())
}

/// Turned red by: a full list that says nothing, words that are missing of the last triangle only.
#[test]
fn a_full_list_says_how_much_did_not_fit() {
    for (faces, near) in [(40, false), (40, true), (7, true)] {
        let (result, all) = into_list(faces, near, [4000, 400]);
        assert_eq!(result, Ok(()));
        assert_eq!(near, all.clipped > 0, "{all:?}");
        assert!(all.drawn > faces / 3, "{all:?}");
        for words in (0..600).step_by(13).chain([4000]) {
            for triangles in (0..all.drawn + 3).step_by(3) {
                let (result, stats) = into_list(faces, near, [words, triangles]);
                let Err(error) = result else {
                    assert_eq!(stats, all);
                    continue;
                };
                let DrawError::Full { triangles: more, words: more_words } = error else {
                    panic!("{error:?}")
                };
                assert!(more > 0 && stats.drawn <= triangles && stats.faces == faces, "{error:?} {stats:?}");
                // What did fit is drawn.
                let vertices = 3 * (faces + 1);
                if words < vertices {
                    assert_eq!((more, more_words, stats.drawn), (faces, vertices - words, 0));
                } else if words == 4000 {
                    assert_eq!(stats.drawn, triangles, "{error:?} {stats:?}");
                }
                // As much more is enough; for what is clipped, the words are known once the vertices fit.
                let larger = [words + more_words, triangles + more];
                let (again, after) = into_list(faces, near, larger);
                let enough = again.is_ok() && after == all;
                assert!(
                    enough || words < vertices,
                    "{words} words, {triangles} triangles: {error:?}, then {again:?}"
                );
            }
        }
    }
}

/// Turned red by: padding between the vertices of two shaders that is not counted as missing.
#[test]
fn what_is_missing_counts_the_padding_too() {
    let (positions, indices) = fan_mesh(3);
    let mesh = Mesh::new(&positions, &indices).unwrap();
    let camera = Perspective::new(Size::new(64, 64), Turn::from_degrees(70), 0.1..20.0)
        .look_at([0.0, 2.5, 4.0], [0.0; 3]);
    // Vertices of three words, then of four, then of three again: 12, 16, 2 to spare, 12.
    let thrice = |words: usize| {
        let mut storage = (vec![0; words], vec![ListTriangle::EMPTY; 20]);
        let mut list = DrawList::<u16, Depth16>::new(&mut storage.0, &mut storage.1);
        list.set_cull(Cull::None);
        let flat = Flat::new(Rgb565::RED);
        list.draw(&camera, &mesh, &Pose::new(), &flat).unwrap();
        list.draw(&camera, &mesh, &Pose::new(), &Gouraud::unlit(&Material::OfMesh)).unwrap();
        list.draw(&camera, &mesh, &Pose::new(), &flat)
    };
    assert_eq!(thrice(42), Ok(()));
    for words in 28..42 {
        assert_eq!(thrice(words), Err(DrawError::Full { triangles: 3, words: 42 - words }));
    }
}

/// Turned red by: a mesh without faces, and so without vertices, for which padding is taken where there is none left.
#[test]
fn a_mesh_without_faces_takes_nothing() {
    let (positions, indices) = fan_mesh(3);
    let mesh = Mesh::new(&positions, &indices).unwrap();
    let camera = Perspective::new(Size::new(64, 64), Turn::from_degrees(70), 0.1..20.0)
        .look_at([0.0, 2.5, 4.0], [0.0; 3]);
    let (flat, gouraud) = (Flat::new(Rgb565::RED), Gouraud::unlit(&Material::OfMesh));
    for (positions, faces) in [(&[][..], &[][..]), (&positions[..], &[])] {
        let nothing = Mesh::new(positions, faces).unwrap();
        // As many as two shaders' vertices take, of three and of four words: 2 more would be padding.
        let mut storage = ([0; 28], [ListTriangle::EMPTY; 20]);
        let mut list = DrawList::<u16, Depth16>::new(&mut storage.0, &mut storage.1);
        list.draw(&camera, &mesh, &Pose::new(), &flat).unwrap();
        list.draw(&camera, &mesh, &Pose::new(), &gouraud).unwrap();
        assert_eq!(list.draw(&camera, &nothing, &Pose::new(), &flat), Ok(()));
        assert_eq!(list.words(), 28);
    }
}

/// Turned red by: a shader that is kept for a mesh that did not fit.
#[test]
fn a_mesh_that_does_not_fit_leaves_no_shader() {
    let (positions, indices) = fan_mesh(100);
    let (large, small) =
        (Mesh::new(&positions, &indices).unwrap(), Mesh::new(&positions[..4], &indices[..2]).unwrap());
    let camera = Perspective::new(Size::new(64, 64), Turn::from_degrees(70), 0.1..20.0)
        .look_at([0.0, 2.5, 4.0], [0.0; 3]);
    let texels = [[0; 4]; 17].map(|texels: [u16; 4]| texels);
    let mut storage = ([0; 60], [ListTriangle::EMPTY; 20]);
    let mut list = DrawList::<u16, Depth16>::new(&mut storage.0, &mut storage.1);
    for texels in &texels {
        let texture = Texture::new(2, 2, texels).unwrap();
        let result = list.draw(&camera, &large, &Pose::new(), &Textured::new(&texture, Affine));
        assert!(matches!(result, Err(DrawError::Full { triangles: 100, .. })), "{result:?}");
    }
    assert_eq!(list.draw(&camera, &small, &Pose::new(), &Flat::new(Rgb565::RED)), Ok(()));
}

/// Turned red by: a texture that is known by its texels' place without their sizes, or without how it repeats; and by one
/// that is never found again.
#[test]
fn textures_of_the_same_texels_are_told_apart_and_kept_once() {
    let texels: [u16; 16] = core::array::from_fn(|k| k as u16 * 0x0F0F);
    let sizes = [(1, 16), (2, 8), (4, 4), (8, 2), (16, 1)];
    let textures: Vec<_> = [Wrap::Repeat, Wrap::Clamp]
        .into_iter()
        .flat_map(|wrap| sizes.map(|(w, h)| Texture::new(w, h, &texels).unwrap().with_wrap(wrap)))
        .collect();
    let positions = [[-32_767, -32_767, 0], [32_767, -32_767, 0], [0, 32_767, 0]];
    let uvs = [[-32_767, 32_767], [32_767, 32_767], [0, -32_767]];
    let mesh = Mesh::new(&positions, &[[0, 1, 2]]).unwrap().with_uvs(&uvs, 1).unwrap();
    let camera = Orthographic::new(Size::new(32, 32), 2.0, -1.0..1.0);
    let frame = |textures: &[Texture<'_>]| {
        let mut storage = (vec![0; 1000], vec![ListTriangle::EMPTY; 100]);
        let mut list = DrawList::<Rgb565, NoDepth>::new(&mut storage.0, &mut storage.1);
        for texture in textures {
            let drawn = list.draw(&camera, &mesh, &Pose::new(), &Textured::new(texture, Affine));
            assert_eq!(drawn, Ok(()));
        }
        let mut colours = vec![Rgb565::BLACK; 32 * 32];
        list.render(0..32, &mut Strip::new(32, &mut colours).unwrap());
        colours
    };
    for last in 0..textures.len() {
        // All of them, three times: more draws than a list has places for shaders.
        let mut drawn = [&textures[..], &textures, &textures].concat();
        drawn.push(textures[last]);
        assert!(frame(&drawn) == frame(&textures[last..=last]), "{:?}", textures[last]);
    }
}

/// Turned red by: a mesh that shares the names of another's vertices, which its cut faces then do not find.
#[test]
fn a_small_mesh_is_cut_after_one_that_names_almost_all() {
    let mut positions = vec![[0, 0, 0]; 65_500];
    (positions[1], positions[2]) = ([1000, 0, 0], [0, 1000, 0]);
    let large = Mesh::new(&positions, &[[0, 1, 2]]).unwrap();
    let corners = [[-20_000, -20_000, 32_000], [20_000, -20_000, -32_000], [0, 20_000, -32_000]];
    let small = Mesh::new(&corners, &[[0, 1, 2]; 10]).unwrap();
    let camera = Perspective::new(Size::new(64, 64), Turn::from_degrees(50), 1.0..20.0);
    let mut storage = (vec![0; 200_000], [ListTriangle::EMPTY; 100]);
    let mut list = DrawList::<u16, Depth16>::new(&mut storage.0, &mut storage.1);
    list.set_cull(Cull::None);
    let at = |z: &str| Pose::new().at([Length::ZERO, Length::ZERO, Length::lit(z)]);
    list.draw(&camera, &large, &at("-5"), &Flat::new(Rgb565::RED)).unwrap();
    assert_eq!(list.draw(&camera, &small, &at("-1.5"), &Flat::new(Rgb565::RED)), Ok(()));
    assert_eq!(list.stats().clipped, 10);
}
