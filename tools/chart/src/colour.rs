//! What it gains to allow colours to be off: read from the tables of cycles and instructions.

use crate::cost::Core;
use crate::table::{Table, figure};

/// The scenes of smooth shading that `firmware/bench` draws with every error.
const SCENES: [&str; 4] = ["teapot", "sphere", "globe", "knot"];
const ERRORS: [&str; 5] = ["0", "1", "2", "4", "8"];

/// Cost a pixel of each error in each scene, and how much that is of what it costs without one.
pub(crate) fn table(cores: &[Core]) -> Table {
    let names =
        cores.iter().flat_map(|core| [format!("{}_per_px", core.name), format!("{}_percent", core.name)]);
    let header = ["scene", "codes_allowed"].map(str::to_owned).into_iter().chain(names).collect();
    let mut table = Table { header, rows: Vec::new() };
    for scene in SCENES {
        for error in core::iter::once(None).chain(ERRORS.map(Some)) {
            let method =
                error.map_or("gouraud+depth".into(), |codes| format!("gouraud-within-{codes}+depth"));
            let mut row = vec![scene.to_owned(), error.unwrap_or("Gouraud").to_owned()];
            for core in cores {
                let of = |method: &str| core.per_pixel(scene, method, "16");
                let cost = of(&method);
                row.push(cost.map_or(String::new(), figure));
                let share = cost.zip(of("gouraud+depth")).map(|(cost, exact)| 100.0 * cost / exact);
                row.push(share.map_or(String::new(), |percent| format!("{percent:.1}")));
            }
            // Until they are measured there is nothing to show.
            if row[2..].iter().any(|cell| !cell.is_empty()) {
                table.rows.push(row);
            }
        }
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;

    // Red when a share is of another scene or method, or what was not measured has a row.
    #[test]
    fn each_share_is_of_its_own_scene() {
        let mut measured = Table::new(&["scene", "method", "opt_level", "strip_rows", "per_px"]);
        for (scene, method, cost) in [
            ("sphere", "gouraud+depth", "80"),
            ("sphere", "gouraud-within-8+depth", "60"),
            ("knot", "gouraud+depth", "100"),
        ] {
            measured.rows.push([scene, method, "3", "16", cost].map(str::to_owned).into());
        }
        let core = Core { name: "m0plus", total: "total", per_pixel: "per_px", table: measured };
        let rows: Vec<String> = table(&[core]).rows.iter().map(|row| row.join(" ")).collect();
        assert_eq!(rows, ["sphere Gouraud 80.00 100.0", "sphere 8 60.00 75.0", "knot Gouraud 100.0 100.0"]);
    }
}
