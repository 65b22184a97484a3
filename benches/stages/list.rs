//! Whole frames, as each scene is: vertices to the screen, and pixels.

use criterion::Criterion;
use scenes::{SCENES, View};
use topleft::{Depth16, DrawList, Strip};

use crate::{Buffers, FITS, PANEL};

pub(crate) fn bench(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("list");
    for scene in SCENES {
        let mut buffers = Buffers::new();
        let strip = Strip::new(PANEL.width as u16, &mut buffers.colours).expect("whole rows");
        let mut strip = strip.with_depth(&mut buffers.depths).expect("as many");
        group.bench_function(scene.name, |bencher| {
            bencher.iter(|| {
                let mut list = DrawList::<u16, Depth16>::new(&mut buffers.words, &mut buffers.triangles);
                scene.draw(&mut list, PANEL, &View::default()).expect(FITS);
                strip.clear();
                list.render(0..PANEL.height as i32, &mut strip);
            });
        });
    }
    group.finish();
}
