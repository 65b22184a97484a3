//! What methods take on this machine: times of one run, compared with each other.

use std::time::{Duration, Instant};

use scenes::{View, by_name};
use topleft::stages::Correction;
use topleft::{Cull, Depth16, DrawList, Flat, ListTriangle, Material, Strip};

use crate::method::{self, EachMethod, Family, Method, PER_PIXEL};
use crate::texels::{PANEL, SCENES};

/// Rounds in which all are drawn in turn.
const ROUNDS: usize = 60;

/// One method in one scene.
#[derive(Clone, Debug)]
pub(crate) struct Timed {
    pub(crate) scene: &'static str,
    pub(crate) row: &'static str,
    /// The least time of all rounds to render a list, and what making it took more than where nothing is chosen.
    pub(crate) least: Duration,
    /// The median of its ratios to `grid240`, flat and without depth, in the same round.
    pub(crate) ratio: f64,
}

/// Of making a list, and of rendering it.
type Draw = Box<dyn FnMut() -> [Duration; 2]>;

struct Case {
    scene: &'static str,
    family: Family,
    row: &'static str,
    draw: Draw,
}

/// Makes a list and renders it into a whole frame that was cleared before, and takes the times of both.
macro_rules! timed {
    ($depth:ty, $strip:ident, $list:ident, $fill:expr) => {{
        let (mut words, mut triangles) = (vec![0; 1 << 15], vec![ListTriangle::EMPTY; 2000]);
        let mut colours = vec![0_u16; (PANEL.width * PANEL.height) as usize];
        let mut depths = vec![0_u16; colours.len()];
        Box::new(move || {
            let mut $list = DrawList::<u16, $depth>::new(&mut words, &mut triangles);
            let start = Instant::now();
            $fill;
            let made = start.elapsed();
            let $strip = Strip::new(PANEL.width as u16, &mut colours).expect("whole rows");
            let mut strip = $strip.with_depth(&mut depths).expect("as many");
            strip.clear();
            let start = Instant::now();
            $list.render(0..PANEL.height as i32, &mut strip);
            [made, start.elapsed()]
        })
    }};
}

/// All methods in all scenes; `done` is called after each round.
pub(crate) fn all(mut done: impl FnMut()) -> Vec<Timed> {
    struct Cases(Vec<Case>);
    impl EachMethod for Cases {
        fn method(&mut self, method: Method, correction: impl Correction + 'static) {
            for scene in SCENES.into_iter().filter_map(by_name) {
                let draw = timed!(Depth16, strip, list, {
                    scene
                        .draw_textured(&mut list, PANEL, &View::default(), correction)
                        .expect("the list is long enough");
                });
                self.0.push(Case { scene: scene.name, family: method.family, row: method.row, draw });
            }
        }
    }
    let mut cases = Cases(Vec::new());
    method::for_each(&mut cases);
    let mut cases = cases.0;
    let grid = by_name("grid240").expect("it is there");
    let mut yardstick: Draw = timed!(Depth16, strip, list, {
        list.set_cull(Cull::None);
        grid.draw_with(&mut list, PANEL, &View::default(), |_| Flat::new(Material::OfMesh))
            .expect("the list is long enough");
    });
    let mut times = vec![Vec::with_capacity(ROUNDS); cases.len()];
    let mut yardsticks = Vec::with_capacity(ROUNDS);
    for _ in 0..ROUNDS {
        let [_, yardstick] = yardstick();
        yardsticks.push(yardstick);
        for (case, times) in cases.iter_mut().zip(&mut times) {
            times.push((case.draw)());
        }
        done();
    }
    // What `Within` chooses when a list is made: what that takes more than with a method that chooses nothing.
    let making = |scene, row| {
        let case = cases.iter().position(|case| case.scene == scene && case.row == row)?;
        times[case].iter().map(|&[made, _]| made).min()
    };
    let timed = |(case, times): (&Case, &Vec<[Duration; 2]>)| {
        let than = if case.family == Family::Within { PER_PIXEL } else { case.row };
        let chosen = making(case.scene, case.row).zip(making(case.scene, than));
        let chosen = chosen.map_or(Duration::ZERO, |(made, than)| made.saturating_sub(than));
        let times: Vec<Duration> = times.iter().map(|&[_, rendered]| rendered + chosen).collect();
        let mut ratios: Vec<f64> =
            times.iter().zip(&yardsticks).map(|(a, b)| a.as_secs_f64() / b.as_secs_f64()).collect();
        ratios.sort_by(f64::total_cmp);
        let least = times.iter().min().copied().unwrap_or_default();
        Timed { scene: case.scene, row: case.row, least, ratio: ratios[ROUNDS / 2] }
    };
    cases.iter().zip(&times).map(timed).collect()
}

/// How many rounds there are.
pub(crate) const fn rounds() -> usize {
    ROUNDS
}
