//! The committed tables and this host: every case draws the same bytes on every chip, whole frame and in strips.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::OnceLock;

use bench::{Clock, PANEL, Row};
use scenes::{SCENES, Scene, View, by_name};
use topleft::{Depth16, DrawList, ListTriangle, Pixel, Strip};

struct Nothing;

impl Clock for Nothing {
    fn now(&mut self) -> u64 {
        0
    }
}

/// This host's rows. The bench counts pixels in a static: it runs once for all tests.
fn host() -> &'static [Row] {
    static ROWS: OnceLock<Vec<Row>> = OnceLock::new();
    ROWS.get_or_init(|| {
        let mut rows = Vec::new();
        bench::run(&mut Nothing, &mut |row| rows.push(*row));
        rows
    })
}

/// Scene, method, rows of a strip, triangles, pixels, checksum.
type Drawn = BTreeSet<[String; 6]>;

fn table(name: &str) -> Drawn {
    let path = format!("{}/../../docs/measured/{name}", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    let mut lines = text.lines().filter(|line| !line.starts_with('#'));
    let names: Vec<_> = lines.next().unwrap().split(',').collect();
    let columns = ["scene", "method", "strip_rows", "triangles", "pixels", "crc"]
        .map(|wanted| names.iter().position(|name| *name == wanted).unwrap());
    lines
        .map(|line| {
            let cells: Vec<_> = line.split(',').collect();
            columns.map(|column| cells[column].to_string())
        })
        .collect()
}

/// Red when: a chip, a compiler or an opt level draws another byte of any scene than this host; a table is of other scenes.
#[test]
fn host_and_chips_draw_the_same_bytes() {
    let host: Drawn = host()
        .iter()
        .map(|row| {
            [
                row.scene.to_string(),
                row.method.to_string(),
                row.strip_rows.to_string(),
                row.triangles.to_string(),
                row.pixels.to_string(),
                format!("{:08x}", row.crc),
            ]
        })
        .collect();
    for name in ["rp2040.csv", "cortex-m4.csv", "riscv.csv"] {
        assert_eq!(table(name), host, "{name}: run firmware/measure.sh");
    }
}

/// Red when: the rows of a strip change a pixel, or something is no longer drawn in two ways.
#[test]
fn strips_halves_and_whole_frames_are_the_same_bytes() {
    let mut frames: BTreeMap<_, BTreeMap<_, _>> = BTreeMap::new();
    for row in host() {
        frames.entry((row.scene, row.method)).or_default().insert(row.strip_rows, row.crc);
    }
    let twice = |scene: &str| frames.iter().filter(|((of, _), crcs)| *of == scene && crcs.len() == 2).count();
    assert_eq!(twice("grid240"), 18);
    for scene in SCENES.iter().filter(|scene| scene.name != "grid240") {
        // And sorted, two of them.
        let ways = 1 + usize::from(["knot", "teapot"].contains(&scene.name));
        assert_eq!(twice(scene.name), ways, "{}", scene.name);
    }
    for ((scene, method), crcs) in &frames {
        // No chip of 264 KB has room for a whole frame of a scene, its depths and its list: this host has.
        let whole = by_name(scene).filter(|_| *method == "as-it-is+depth").map(whole_frame);
        let whole = whole.or(crcs.get(&240).or(crcs.get(&120)).copied());
        for (rows, crc) in crcs {
            assert_eq!(Some(*crc), whole.or(Some(*crc)), "{scene}, {method}, {rows} rows");
        }
    }
}

/// The checksum of a scene that is drawn as a whole.
fn whole_frame(scene: &Scene) -> u32 {
    let (mut words, mut triangles) = (vec![0; 20_000], vec![ListTriangle::EMPTY; 4000]);
    let mut list: DrawList<'_, u16, Depth16> = DrawList::new(&mut words, &mut triangles);
    scene.draw(&mut list, PANEL, &View::default()).unwrap();
    let (mut colours, mut depths) = (vec![0; 240 * 240], vec![0; 240 * 240]);
    let strip = Strip::new(240, &mut colours).unwrap().with_depth(&mut depths).unwrap();
    let mut strip = strip.with_background(u16::from_rgb(scene.background));
    strip.clear();
    list.render(0..240, &mut strip);
    bench::checksum(strip.colours())
}

/// Red when: a triangle of the grid is lost, or covers a pixel that another one does.
#[test]
fn the_grid_covers_each_pixel_once() {
    for row in host().iter().filter(|row| row.scene == "grid240") {
        assert_eq!((row.triangles, row.pixels), (512, 240 * 240), "{row}");
    }
}
