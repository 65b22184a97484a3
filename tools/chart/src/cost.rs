//! What is read from the tables of cycles and instructions: cost a pixel, a triangle and their pixels apart, and what
//! each thing adds, in bytes too.

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
        self.value([scene, method, "3", strip_rows], self.per_pixel)
    }

    /// In strips of 16 rows, and with what a list takes more than another way's to be made: what is done once a frame.
    pub(crate) fn per_pixel_from_the_list(
        &self,
        scene: &str,
        [method, than]: [&str; 2],
        opt_level: &str,
    ) -> Option<f64> {
        let vertex = self.total.replace("total", "vertex");
        let value = |method, column: &str| self.value([scene, method, opt_level, "16"], column);
        let more = value(method, &vertex)? - value(than, &vertex)?;
        Some(value(method, self.per_pixel)? + more / value(method, "pixels")?)
    }

    fn value(&self, names: [&str; 4], column: &str) -> Option<f64> {
        let [scene, method, opt_level, strip_rows] = names;
        let wanted =
            [("scene", scene), ("method", method), ("opt_level", opt_level), ("strip_rows", strip_rows)];
        self.table.find(&wanted).next().and_then(|row| number(&row, column))
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

/// A way to draw: its names in the tables of cycles and of flash.
struct Way {
    shading: &'static str,
    image: &'static str,
}

const fn way(shading: &'static str, image: &'static str) -> Way {
    Way { shading, image }
}

const FLAT: Way = way("flat", "flat");
const FLAT_DEPTH: Way = way("flat+depth", "flat-depth");
const GOURAUD: Way = way("gouraud+depth", "gouraud-depth");
const AFFINE: Way = way("affine+depth", "affine-depth");
const LIT_AFFINE: Way = way("lit-affine+depth", "lit-affine-depth");
const SUBSPANS: Way = way("perspective-subspan-16+depth", "perspective-subspan-16-depth");
const PER_PIXEL: Way = way("perspective-pixel+depth", "perspective-depth");

/// A thing, and the two ways to draw that differ in it alone.
const PARTS: [(&str, Way, Way); 6] = [
    ("depth", FLAT_DEPTH, FLAT),
    ("colour by vertex", GOURAUD, FLAT_DEPTH),
    ("texture", AFFINE, FLAT_DEPTH),
    ("perspective by subspans of 16", SUBSPANS, AFFINE),
    ("perspective by pixel", PER_PIXEL, AFFINE),
    ("light on a texture", LIT_AFFINE, AFFINE),
];

/// The images that flash is read of: the core that has the least of it, and the opt level that takes the least.
const FLASH: [(&str, &str); 2] = [("core", "thumbv6m-none-eabi"), ("opt_level", "s")];

/// What each thing adds: to a pixel and to a triangle on each core, to flash, and to RAM. A cell is empty where a table
/// lacks one of its two ways.
pub(crate) fn parts(setup_and_fill: &Table, cores: &[Core], flash: &Table, ram: &Table) -> Table {
    let names: Vec<&str> = cores.iter().map(|core| core.name).collect();
    let mut header = vec!["part".to_owned()];
    header.extend(names.iter().flat_map(|name| [format!("{name}_per_px"), format!("{name}_per_triangle")]));
    header.extend(["flash_bytes", "ram_bytes"].map(str::to_owned));
    let mut table = Table { header, rows: Vec::new() };
    for (part, with, without) in PARTS {
        let mut row = vec![part.to_owned()];
        let whole = |bytes: f64| format!("{bytes:.0}");
        for name in &names {
            let added = |column: &str| {
                let wanted = |way: &Way| [("core", *name), ("shading", way.shading)];
                difference(setup_and_fill, column, &wanted(&with), &wanted(&without))
            };
            row.push(added("per_px").map(figure).unwrap_or_default());
            row.push(added("per_triangle").map(whole).unwrap_or_default());
        }
        let image = |way: &Way| [FLASH[0], FLASH[1], ("draws", way.image)];
        let flash = difference(flash, "topleft_bytes", &image(&with), &image(&without));
        let shading = |way: &Way| [("shading", way.shading)];
        let ram = difference(ram, "ram_bytes", &shading(&with), &shading(&without));
        row.extend([flash, ram].map(|bytes| bytes.map(whole).unwrap_or_default()));
        table.rows.push(row);
    }
    table
}

/// What a column has more in one row than in another, if both are there.
fn difference(table: &Table, column: &str, with: &[(&str, &str)], without: &[(&str, &str)]) -> Option<f64> {
    let of = |wanted| table.find(wanted).next().and_then(|row| number(&row, column));
    Some(of(with)? - of(without)?)
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

    /// A table of one column of numbers.
    fn numbers(names: &[&str], column: &str, rows: &[(&[&str], f64)]) -> Table {
        let mut table = Table::new(&[names, &[column]].concat());
        for (cells, number) in rows {
            table.rows.push(cells.iter().map(|&cell| cell.to_owned()).chain([number.to_string()]).collect());
        }
        table
    }

    // Red when ways are subtracted the other way round; when flash is another core's or another opt level's, or an image
    // is looked for by its shading; when RAM is taken for flash; when a missing way counts as nothing.
    #[test]
    fn a_part_is_the_difference_of_two_ways() {
        let (m0, m4) = ("thumbv6m-none-eabi", "thumbv7em-none-eabihf");
        let flash = numbers(
            &["core", "opt_level", "draws"],
            "topleft_bytes",
            &[
                (&[m0, "3", "flat"], 9000.0),
                (&[m0, "3", "flat-depth"], 9900.0),
                (&[m4, "s", "flat"], 8000.0),
                (&[m4, "s", "flat-depth"], 8800.0),
                (&[m0, "s", "flat"], 7000.0),
                (&[m0, "s", "flat-depth"], 7700.0),
                (&[m0, "s", "affine-depth"], 8000.0),
                (&[m0, "s", "perspective-depth"], 8500.0),
            ],
        );
        let ram = numbers(&["shading"], "ram_bytes", &[(&["flat"], 10.0), (&["flat+depth"], 16.0)]);
        let mut costs = Table::new(&["core", "shading", "per_triangle", "per_px"]);
        for row in [["m0plus", "flat", "1500", "7.5"], ["m0plus", "flat+depth", "2100", "28"]] {
            costs.rows.push(row.map(str::to_owned).into());
        }
        let core = Core { name: "m0plus", total: "", per_pixel: "", table: Table::default() };
        let parts = parts(&costs, &[core], &flash, &ram);
        let row = |part| parts.rows.iter().find(|row| row[0] == part).unwrap()[1..].join(",");
        assert_eq!(row("depth"), "20.50,600,700,6");
        assert_eq!(row("texture"), ",,300,");
        assert_eq!(row("perspective by pixel"), ",,500,");
        assert_eq!(row("light on a texture"), ",,,");
    }

    // Red when points count by their size: two large ones that are off by 5 % would decide alone.
    #[test]
    fn each_point_counts_by_its_share() {
        let points = [[1.0, 1010.0], [10.0, 1100.0], [1000.0, 11_550.0], [2000.0, 19_950.0]];
        let [a, b] = fit(&points);
        assert!((a + b - 1010.0).abs() < 100.0, "{a} {b}");
    }
}
