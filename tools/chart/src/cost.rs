//! What is read from the tables of cycles and instructions: cost a pixel, a triangle and their pixels apart, and what
//! each thing adds.

use crate::table::{Table, figure, number};

/// A core's table: its name here, and the column of what set-up and raster cost together.
#[derive(Clone, Debug)]
pub(crate) struct Core {
    pub(crate) name: &'static str,
    pub(crate) total: &'static str,
    pub(crate) per_pixel: &'static str,
    pub(crate) table: Table,
}

impl Core {
    /// Of a scene in one way, at opt-level 3, in strips of so many rows.
    pub(crate) fn per_pixel(&self, scene: &str, method: &str, strip_rows: &str) -> Option<f64> {
        let wanted = [("scene", scene), ("method", method), ("opt_level", "3"), ("strip_rows", strip_rows)];
        self.table.find(&wanted).next().and_then(|row| number(&row, self.per_pixel))
    }

    /// The same, and what a list takes more than another way's to be made: what is done once a frame.
    pub(crate) fn per_pixel_from_the_list(&self, scene: &str, [method, than]: [&str; 2]) -> Option<f64> {
        let vertex = self.total.replace("total", "vertex");
        let value = |method, column: &str| {
            let wanted = [("scene", scene), ("method", method), ("opt_level", "3"), ("strip_rows", "16")];
            self.table.find(&wanted).next().and_then(|row| number(&row, column))
        };
        let more = value(method, &vertex)? - value(than, &vertex)?;
        Some(self.per_pixel(scene, method, "16")? + more / value(method, "pixels")?)
    }

    /// Pixels a triangle and cost a triangle, by size, with the ways to shade in the table's order.
    fn by_size(&self) -> Vec<(String, Vec<[f64; 2]>)> {
        let mut ways: Vec<(String, Vec<[f64; 2]>)> = Vec::new();
        for row in self.table.find(&[("opt_level", "3")]).filter(|row| row["scene"].starts_with("side-")) {
            let values = ["triangles", "pixels", self.total].map(|column| number(&row, column));
            let [Some(triangles), Some(pixels), Some(total)] = values else { continue };
            let point = [pixels / triangles, total / triangles];
            match ways.iter_mut().find(|(way, _)| way == row["method"]) {
                Some((_, points)) => points.push(point),
                None => ways.push((row["method"].to_owned(), vec![point])),
            }
        }
        ways
    }
}

/// `a + b x` through points, by the least sum of squares of what it is off by, as a share of each.
fn fit(points: &[[f64; 2]]) -> [f64; 2] {
    let [mut s, mut sx, mut sy, mut sxx, mut sxy] = [0.0; 5];
    for [x, y] in points {
        let weight = 1.0 / (y * y);
        s += weight;
        sx += weight * x;
        sy += weight * y;
        sxx += weight * x * x;
        sxy += weight * x * y;
    }
    let b = (s * sxy - sx * sy) / (s * sxx - sx * sx);
    [(sy - b * sx) / s, b]
}

/// A triangle and its pixels apart, for every way to shade; and what each is of, as measured.
pub(crate) fn setup_and_fill(cores: &[Core]) -> Table {
    let mut table =
        Table::new(&["core", "shading", "per_triangle", "per_px", "off_by_percent", "px", "cost"]);
    for core in cores {
        for (way, points) in core.by_size() {
            let [a, b] = fit(&points);
            let off = points.iter().map(|[x, y]| ((a + b * x) / y - 1.0).abs() * 100.0).fold(0.0, f64::max);
            let list = |axis: usize| {
                points.iter().map(|point| format!("{:.0}", point[axis])).collect::<Vec<_>>().join(" ")
            };
            table.rows.push(vec![
                core.name.into(),
                way,
                format!("{a:.0}"),
                figure(b),
                format!("{off:.1}"),
                list(0),
                list(1),
            ]);
        }
    }
    table
}

/// A thing, and the two ways to draw that differ in it alone.
const PARTS: [(&str, &str, &str); 6] = [
    ("depth", "flat+depth", "flat"),
    ("colour by vertex", "gouraud", "flat"),
    ("texture", "affine", "flat"),
    ("perspective by subspans of 16", "perspective-subspan-16", "affine"),
    ("perspective by pixel", "perspective-pixel", "affine"),
    ("light on a texture", "lit-affine+depth", "affine+depth"),
];

/// What each thing adds: to a pixel and to a triangle on each core, and to flash and RAM where tables of them are there.
pub(crate) fn parts(setup_and_fill: &Table, cores: &[Core], memories: &[(&str, Option<Table>)]) -> Table {
    let names: Vec<&str> = cores.iter().map(|core| core.name).collect();
    let mut header = vec!["part".to_owned()];
    header.extend(names.iter().flat_map(|name| [format!("{name}_per_px"), format!("{name}_per_triangle")]));
    header.extend(memories.iter().map(|(name, _)| format!("{name}_bytes")));
    let mut table = Table { header, rows: Vec::new() };
    for (part, with, without) in PARTS {
        let added = |core: &str, column: &str| {
            let of = |way: &str| {
                setup_and_fill
                    .find(&[("core", core), ("shading", way)])
                    .next()
                    .and_then(|row| number(&row, column))
            };
            Some(of(with)? - of(without)?)
        };
        let mut row = vec![part.to_owned()];
        for name in &names {
            row.push(added(name, "per_px").map_or(String::new(), figure));
            row.push(added(name, "per_triangle").map_or(String::new(), |a| format!("{a:.0}")));
        }
        row.extend(memories.iter().map(|(_, memory)| {
            memory.as_ref().and_then(|memory| memory_of(memory, part, [with, without])).unwrap_or_default()
        }));
        if row[1..].iter().any(|cell| !cell.is_empty()) {
            table.rows.push(row);
        }
    }
    table
}

/// The bytes of a part in a table of bytes: as they stand there by the part's name, or the difference of two ways to draw.
fn memory_of(memory: &Table, part: &str, ways: [&str; 2]) -> Option<String> {
    let bytes = memory.header.iter().find(|column| column.ends_with("bytes"))?;
    let first = memory.header.first()?;
    let of = |name: &str| memory.find(&[(first, name)]).next().and_then(|row| number(&row, bytes));
    let [with, without] = ways.map(of);
    of(part).or_else(|| Some(with? - without?)).map(|bytes| format!("{bytes:.0}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    // Red when a and b change places, or x counts as y.
    #[test]
    fn a_line_is_found_again() {
        let [a, b] = fit(&[7.0, 28.0, 110.0, 440.0, 1700.0].map(|x| [x, 900.0 + 6.5 * x]));
        assert!((a - 900.0).abs() < 1e-6 && (b - 6.5).abs() < 1e-9, "{a} {b}");
    }

    // Red when a part's own row is not looked for, or ways are subtracted the other way round.
    #[test]
    fn memory_is_found_by_part_or_by_ways() {
        let mut memory = Table::new(&["what", "opt_level", "flash_bytes"]);
        for (what, bytes) in [("depth", "640"), ("affine", "3000"), ("flat", "1800")] {
            memory.rows.push([what, "s", bytes].map(str::to_owned).into());
        }
        assert_eq!(memory_of(&memory, "depth", ["flat+depth", "flat"]).as_deref(), Some("640"));
        assert_eq!(memory_of(&memory, "texture", ["affine", "flat"]).as_deref(), Some("1200"));
        assert_eq!(memory_of(&memory, "light", ["lit", "affine"]), None);
    }

    // Red when points count by their size: two large ones that are off by 5 % would decide alone.
    #[test]
    fn each_point_counts_by_its_share() {
        let points = [[1.0, 1010.0], [10.0, 1100.0], [1000.0, 11_550.0], [2000.0, 19_950.0]];
        let [a, b] = fit(&points);
        assert!((a + b - 1010.0).abs() < 100.0, "{a} {b}");
    }
}
