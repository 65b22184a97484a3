//! The committed tables and this host: every case draws the same bytes on every chip, whole frame and in strips.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::OnceLock;

use bench::{Clock, Row};

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
    for name in ["rp2040.csv", "cortex-m4.csv"] {
        assert_eq!(table(name), host, "{name}: run firmware/measure.sh");
    }
}

#[test]
fn strips_and_whole_frames_are_the_same_bytes() {
    let rows = host();
    let grid = rows.iter().filter(|row| row.scene == "grid240");
    let mut frames: BTreeMap<_, BTreeMap<_, _>> = BTreeMap::new();
    for row in grid {
        assert_eq!((row.triangles, row.pixels), (512, 240 * 240), "{row}");
        frames.entry(row.method).or_default().insert(row.strip_rows, row.crc);
    }
    assert_eq!(frames.len(), 9);
    for (method, crcs) in frames {
        assert_eq!(crcs.len(), 2, "{method}");
        assert_eq!(crcs[&16], crcs[&240], "{method}");
    }
}
