//! What traversals cost by the size of triangles: read from the tables of cycles and instructions.

use crate::cost::Core;
use crate::table::{Table, number};

/// By the names of their rows in the tables; `Spans` is what `flat` is.
const TRAVERSALS: [(&str, &str); 3] =
    [("Spans", "flat"), ("BoxWalk", "flat-box"), ("BySize", "flat-by-size")];

/// Cost of a triangle by every traversal, for each core, opt-level and size, without depth and with it.
pub(crate) fn table(cores: &[Core]) -> Table {
    let mut table = Table::new(&["core", "opt_level", "side_px", "px", "depth"]);
    table.header.extend(TRAVERSALS.map(|(name, _)| name.to_owned()));
    for core in cores {
        for level in ["3", "s"] {
            let is_level = [("opt_level", level), ("method", "flat")];
            for flat in core.table.find(&is_level).filter(|row| row["scene"].starts_with("small-")) {
                for (depth, suffix) in [("no", ""), ("yes", "+depth")] {
                    let cost = |way: &str| {
                        let method = format!("{way}{suffix}");
                        let wanted = [("scene", flat["scene"]), ("opt_level", level), ("method", &method)];
                        let row = core.table.find(&wanted).next()?;
                        Some(number(&row, core.total)? / number(&row, "triangles")?)
                    };
                    let pixels =
                        number(&flat, "pixels").zip(number(&flat, "triangles")).map(|(px, n)| px / n);
                    let side = flat["scene"].trim_start_matches("small-");
                    let mut row: Vec<String> = [core.name, level, side].map(str::to_owned).into();
                    row.push(pixels.map_or(String::new(), |pixels| format!("{pixels:.0}")));
                    row.push(depth.into());
                    let costs = TRAVERSALS.map(|(_, way)| cost(way));
                    row.extend(costs.map(|cost| cost.map_or(String::new(), |cost| format!("{cost:.0}"))));
                    table.rows.push(row);
                }
            }
        }
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;

    // Red when a cost is not a triangle's, or of another traversal or depth.
    #[test]
    fn each_cost_is_in_its_own_column() {
        let mut measured = Table::new(&["scene", "method", "opt_level", "triangles", "pixels", "total"]);
        for (method, cost) in
            [("flat", "640"), ("flat-box", "320"), ("flat+depth", "1280"), ("flat-by-size+depth", "960")]
        {
            measured.rows.push(["small-4", method, "s", "64", "384", cost].map(str::to_owned).into());
        }
        let core = Core { name: "m4", total: "total", per_pixel: "per_px", table: measured };
        let rows: Vec<String> = table(&[core]).rows.iter().map(|row| row.join(",")).collect();
        assert_eq!(rows, ["m4,s,4,6,no,10,5,", "m4,s,4,6,yes,20,,15"]);
    }
}
