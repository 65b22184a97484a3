//! Canonical order, area and planes of one triangle.

use std::hint::black_box;

use criterion::Criterion;
use topleft::Attribute;
use topleft::stages::{Plane, Setup, Snapped, Varying};

pub(crate) fn bench(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("setup");
    for (name, size) in [("8 px", 8 * 256), ("200 px", 200 * 256)] {
        let points = [[13, 77], [size, 200], [size / 3, size]].map(|[x, y]| Snapped::from_bits(x, y));
        group.bench_function(format!("order and area, {name}"), |bencher| {
            bencher.iter(|| Setup::new(black_box(points)));
        });
        let (setup, _) = Setup::new(points).expect("it has an area");
        let values = [3, 200, 90].map(Attribute::from_num::<i32>);
        group.bench_function(format!("a plane, {name}"), |bencher| {
            bencher.iter(|| -> Plane<Attribute> { Varying::plane(&setup.gradients(), black_box(values)) });
        });
    }
    group.finish();
}
