//! Vertices to the screen: two meshes, seen whole.

use criterion::{Criterion, Throughput};
use scenes::mesh::{GLOBE, TEAPOT};
use topleft::{Cull, DrawList, Flat, Material, Mesh, NoDepth, Perspective, Pose, Turn};

use crate::{Buffers, FITS, PANEL};

pub(crate) fn bench(criterion: &mut Criterion) {
    let camera = Perspective::new(PANEL, Turn::from_degrees(45), 1.0..8.0).look_at([0.0, 0.0, 4.0], [0.0; 3]);
    let mut group = criterion.benchmark_group("transform");
    let meshes: [(&str, &Mesh<'_>); 2] = [("globe", &GLOBE), ("teapot", &TEAPOT)];
    for (name, mesh) in meshes {
        let mut buffers = Buffers::new();
        let pose = Pose::new();
        group.throughput(Throughput::Elements(mesh.positions().len() as u64)).bench_function(
            name,
            |bencher| {
                bencher.iter(|| {
                    let mut list = DrawList::<u16, NoDepth>::new(&mut buffers.words, &mut buffers.triangles);
                    list.set_cull(Cull::None);
                    list.draw(&camera, mesh, &pose, &Flat::new(Material::OfMesh)).expect(FITS);
                    list.stats().drawn
                });
            },
        );
    }
    group.finish();
}
