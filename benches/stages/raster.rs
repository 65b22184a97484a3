//! Which pixels a triangle covers, by every walk, at six sizes.

use std::convert::Infallible;
use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput};
use topleft::stages::{Setup, Snapped, Traversal, Window};
use topleft::{BoxWalk, BySize, Spans};

const WINDOW: Window = Window { columns: 0..240, rows: 0..240 };

/// Pixels of a triangle.
fn pixels<T: Traversal>(setup: &Setup) -> u32 {
    let mut count = 0;
    let Ok(()) = T::walk(setup, &WINDOW, |span| {
        count += span.end.abs_diff(span.start);
        Ok::<_, Infallible>(())
    });
    count
}

pub(crate) fn bench(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("raster");
    for side in [2, 4, 8, 16, 64, 200] {
        // Leaning, so that no edge is level or upright.
        let corners = [[0.13, 0.05], [0.98, 0.31], [0.33, 0.97]];
        let points = corners.map(|corner| corner.map(|c: f64| (c * f64::from(side) * 256.0) as i32));
        let (setup, _) = Setup::new(points.map(|[x, y]| Snapped::from_bits(x, y))).expect("it has an area");
        group.throughput(Throughput::Elements(pixels::<Spans>(&setup).into()));
        group.bench_function(BenchmarkId::new("Spans", side), |bencher| {
            bencher.iter(|| pixels::<Spans>(black_box(&setup)));
        });
        group.bench_function(BenchmarkId::new("BoxWalk", side), |bencher| {
            bencher.iter(|| pixels::<BoxWalk>(black_box(&setup)));
        });
        group.bench_function(BenchmarkId::new("BySize", side), |bencher| {
            bencher.iter(|| pixels::<BySize>(black_box(&setup)));
        });
    }
    group.finish();
}
