//! The colours of a run of 64 pixels, by each shader.

use std::hint::black_box;

use criterion::{Criterion, Throughput};
use scenes::texture::TEST_CARD;
use topleft::stages::{PerVertexInverse, PixelShader, Run, Setup, Shader, Snapped, Varying};
use topleft::{Affine, Gouraud, Length, Material, Mesh, PerPixel, Pose, Sun, Textured};

const RUN: usize = 64;

const POSITIONS: [[i16; 3]; 3] = [[0, 0, 0], [900, 0, 100], [0, 900, 50]];
const UVS: [[i16; 2]; 3] = [[0, 0], [30_000, 900], [2000, 30_000]];
const COLOURS: [[u8; 3]; 3] = [[250, 10, 90], [20, 220, 10], [70, 90, 240]];
const NORMALS: [[i8; 3]; 3] = [[0, 0, 127], [90, 0, 90], [0, 90, 90]];

fn mesh() -> Mesh<'static> {
    Mesh::new(&POSITIONS, &[[0, 1, 2]])
        .and_then(|mesh| mesh.with_uvs(&UVS, 0))
        .and_then(|mesh| mesh.with_vertex_colours(&COLOURS))
        .and_then(|mesh| mesh.with_normals(&NORMALS))
        .expect("as many of each")
}

/// The first row of a triangle, with w from 1 to 2.
fn run<'a, S: Shader<'a, u16>>(criterion: &mut Criterion, name: &str, shader: &S) {
    let (mesh, local) = (mesh(), shader.local(&mesh(), &Pose::new()));
    let vertices = [0, 1, 2].map(|vertex| shader.vertex(&local, &mesh, vertex));
    // Mantissas of 26 bits in one power of two.
    let inverses = [1 << 31, 1 << 30, 3 << 29].map(|word: u32| {
        topleft::stages::Words::load(&mut [word].into_iter()).unwrap_or(PerVertexInverse::ONE)
    });
    let pixel = shader.pixel();
    let (triangle, varyings) = pixel.triangle([200, 80, 40], vertices, inverses);
    let points = [[0, 0], [70, 1], [5, 60]].map(|[x, y]| Snapped::from_bits(x * 256, y * 256));
    let (setup, _) = Setup::new(points).expect("it has an area");
    let plane = Varying::plane(&setup.gradients(), varyings);
    let mut pixels = [0_u16; RUN];
    let mut group = criterion.benchmark_group("shade");
    group.throughput(Throughput::Elements(RUN as u64)).bench_function(name, |bencher| {
        bencher.iter(|| {
            pixel.shade(&triangle, black_box(plane.start), &plane.dx, Run::new(black_box(&mut pixels)));
        });
    });
    group.finish();
}

pub(crate) fn bench(criterion: &mut Criterion) {
    let sun = Sun::new([Length::ZERO, Length::ONE, Length::ONE]);
    run(criterion, "Gouraud", &Gouraud::unlit(&Material::OfMesh));
    run(criterion, "Affine", &Textured::new(&TEST_CARD, Affine));
    run(criterion, "PerPixel", &Textured::new(&TEST_CARD, PerPixel));
    run(criterion, "PerPixel, lit", &Textured::new(&TEST_CARD, PerPixel).lit_by(&sun));
}
