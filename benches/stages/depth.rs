//! The same triangles without depth, with one that they pass, and with one that hides them.

use criterion::{Criterion, Throughput};
use scenes::by_name;
use topleft::{Depth16, DrawList, Flat, Material, NoDepth, Strip};

use crate::{Buffers, FITS, PANEL};

pub(crate) fn bench(criterion: &mut Criterion) {
    let grid = by_name("grid240").expect("it is there");
    let rows = 0..PANEL.height as i32;
    let width = PANEL.width as u16;
    let flat = || Flat::new(Material::OfMesh);
    let view = scenes::View::default();
    let mut group = criterion.benchmark_group("depth");
    group.throughput(Throughput::Elements(u64::from(PANEL.width * PANEL.height)));

    let mut buffers = Buffers::new();
    let mut list = DrawList::<u16, NoDepth>::new(&mut buffers.words, &mut buffers.triangles);
    grid.draw_with(&mut list, PANEL, &view, |_| flat()).expect(FITS);
    let mut strip = Strip::new(width, &mut buffers.colours).expect("whole rows");
    group.bench_function("none", |bencher| bencher.iter(|| list.render(rows.clone(), &mut strip)));

    for (name, cleared) in [("all visible, and cleared before", true), ("all hidden", false)] {
        let mut buffers = Buffers::new();
        let mut list = DrawList::<u16, Depth16>::new(&mut buffers.words, &mut buffers.triangles);
        grid.draw_with(&mut list, PANEL, &view, |_| flat()).expect(FITS);
        let strip = Strip::new(width, &mut buffers.colours).expect("whole rows");
        let mut strip = strip.with_depth(&mut buffers.depths).expect("as many");
        // What is as deep is hidden: after the first time all is.
        list.render(rows.clone(), &mut strip);
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                if cleared {
                    strip.clear();
                }
                list.render(rows.clone(), &mut strip);
            });
        });
    }
    group.finish();
}
