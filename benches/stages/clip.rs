//! Faces that planes cut: few large ones, and a globe round the eye.

use criterion::{Criterion, Throughput};
use scenes::mesh::{CORRIDOR, GLOBE};
use topleft::{Cull, DrawList, Flat, Material, Mesh, NoDepth, Perspective, Pose, Turn};

use crate::{Buffers, FITS, PANEL};

pub(crate) fn bench(criterion: &mut Criterion) {
    let camera = Perspective::new(PANEL, Turn::from_degrees(60), 0.5..20.0);
    let mut group = criterion.benchmark_group("clip");
    let meshes: [(&str, &Mesh<'_>); 2] = [("corridor", &CORRIDOR), ("inside a globe", &GLOBE)];
    for (name, mesh) in meshes {
        let mut buffers = Buffers::new();
        group.throughput(Throughput::Elements(mesh.faces().len() as u64)).bench_function(name, |bencher| {
            bencher.iter(|| {
                let mut list = DrawList::<u16, NoDepth>::new(&mut buffers.words, &mut buffers.triangles);
                list.set_cull(Cull::None);
                list.draw(&camera, mesh, &Pose::new(), &Flat::new(Material::OfMesh)).expect(FITS);
                list.stats().drawn
            });
        });
    }
    group.finish();
}
