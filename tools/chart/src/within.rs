//! What `Within` promises of its cost: hardly more than the cheapest method that a program could have pinned instead.

use crate::method::Family;
use crate::table::{Table, figure, number};
use crate::texels::SCENES;

/// What is asked for, in texels: by the setting's name.
const ERRORS: [(&str, f64); 5] = [("2", 2.0), ("1", 1.0), ("1/2", 0.5), ("1/4", 0.25), ("1/16", 0.0625)];

/// A core, and its cost in the texels' table.
const CORES: [(&str, &str); 2] = [("m0plus", "m0_cycles_per_px"), ("m4", "m4_instructions_per_px")];

/// What it may cost, in costs of the cheapest.
const AT_MOST: f64 = 1.1;

/// Of each scene, error and core: what `Within` costs, and the cheapest other method whose worst texel is no further off.
/// Cells are empty where one of the two was not measured.
pub(crate) fn table(texels: &Table) -> Table {
    let mut table = Table::new(&["scene", "texels", "core", "within", "cheapest_pinned", "pinned", "ratio"]);
    for scene in SCENES {
        for (name, error) in ERRORS {
            for (core, column) in CORES {
                let wanted = [("scene", scene), ("family", Family::Within.name()), ("setting", name)];
                let within = texels.find(&wanted).next().and_then(|row| number(&row, column));
                let pinned = texels
                    .find(&[("scene", scene)])
                    .filter(|row| row["family"] != Family::Within.name())
                    .filter(|row| number(row, "texel_worst").is_some_and(|worst| worst <= error))
                    .filter_map(|row| Some((number(&row, column)?, row)))
                    .min_by(|a, b| a.0.total_cmp(&b.0));
                let ratio = within.zip(pinned.as_ref()).map(|(within, (cheapest, _))| within / cheapest);
                let mut row = [scene, name, core].map(str::to_owned).to_vec();
                row.push(within.map(figure).unwrap_or_default());
                row.extend(pinned.map_or(Default::default(), |(cost, row)| {
                    [figure(cost), format!("{} {}", row["family"], row["setting"]).trim_end().to_owned()]
                }));
                row.push(ratio.map(|ratio| format!("{ratio:.3}")).unwrap_or_default());
                table.rows.push(row);
            }
        }
    }
    table
}

/// # Errors
/// A line that tells how many rows of the table cost too much and which the most, or which one was not measured.
pub(crate) fn kept(table: &Table) -> Result<(), String> {
    let (mut worst, mut count) = ((AT_MOST, String::new()), 0);
    for row in table.records() {
        let name = format!("{} within {} texels on {}", row["scene"], row["texels"], row["core"]);
        let ratio = number(&row, "ratio").ok_or_else(|| format!("{name}: not measured"))?;
        if ratio > AT_MOST {
            count += 1;
            if ratio > worst.0 {
                let pinned = row["pinned"];
                worst = (ratio, format!("the most {name}, {ratio:.3} times {pinned}"));
            }
        }
    }
    if count == 0 {
        return Ok(());
    }
    Err(format!(
        "`Within` costs more than {AT_MOST} times the cheapest method that is as near, in {count} of {} cases: {}",
        table.rows.len(),
        worst.1
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Methods in `globe`, each with its worst texel and its cost on both cores.
    fn texels(methods: &[(&str, &str, f64, f64)]) -> Table {
        let columns = ["scene", "family", "setting", "texel_worst", CORES[0].1, CORES[1].1];
        let mut table = Table::new(&columns);
        for &(family, setting, worst, cost) in methods {
            let numbers = [worst, cost, cost / 2.0].map(|number| number.to_string());
            let names = ["globe", family, setting].map(str::to_owned);
            table.rows.push(names.into_iter().chain(numbers).collect());
        }
        table
    }

    const METHODS: [(&str, &str, f64, f64); 8] = [
        ("Affine", "", 0.25, 100.0),
        ("Subspans", "4 px", 0.0626, 150.0),
        ("PerPixel", "", 0.001, 200.0),
        ("Within", "2", 1.9, 105.0),
        ("Within", "1", 0.9, 80.0),
        ("Within", "1/2", 0.4, 100.0),
        ("Within", "1/4", 0.2, 110.0),
        ("Within", "1/16", 0.05, 221.0),
    ];

    /// The rows of `globe` on one core, without their names.
    fn rows(table: &Table, core: &str) -> Vec<String> {
        let rows = table.rows.iter().filter(|row| row[0] == "globe" && row[2] == core);
        rows.map(|row| row[3..].join(",")).collect()
    }

    // Red when a method that is too far off counts, or one that is just near enough does not; when `Within` at another
    // setting is taken for a pinned one; when the dearest is taken, or another core's cost.
    #[test]
    fn within_is_compared_with_the_cheapest_that_is_as_near() {
        let table = table(&texels(&METHODS));
        let m0plus = [
            "105.0,100.0,Affine,1.050",
            "80.00,100.0,Affine,0.800",
            "100.0,100.0,Affine,1.000",
            "110.0,100.0,Affine,1.100",
            "221.0,200.0,PerPixel,1.105",
        ];
        assert_eq!(rows(&table, "m0plus"), m0plus);
        assert_eq!(rows(&table, "m4")[0], "52.50,50.00,Affine,1.050");
    }

    /// The table of `globe` alone: the other scenes have no methods here.
    fn globe(methods: &[(&str, &str, f64, f64)]) -> Table {
        let mut table = table(&texels(methods));
        table.rows.retain(|row| row[0] == "globe");
        table
    }

    // Red when a ratio of just what is allowed fails, or one above does not; when the line names another row than the
    // worst; when cases of one core or scene are left out.
    #[test]
    fn what_costs_too_much_is_told() {
        let line = kept(&globe(&METHODS)).unwrap_err();
        assert!(line.contains("in 2 of 10 cases"), "{line}");
        assert!(
            line.ends_with("the most globe within 1/16 texels on m0plus, 1.105 times PerPixel"),
            "{line}"
        );
        assert!(!line.contains('\n'));
        let mut dearer = METHODS;
        dearer[3].3 = 125.0;
        let line = kept(&globe(&dearer)).unwrap_err();
        assert!(line.contains("in 4 of 10 cases") && line.contains("globe within 2 texels"), "{line}");
        let mut right = METHODS;
        right[7].3 = 220.0;
        assert_eq!(kept(&globe(&right)), Ok(()));
    }

    // Red when what was not measured counts as kept.
    #[test]
    fn what_is_not_measured_is_told() {
        let line = kept(&table(&texels(&METHODS))).unwrap_err();
        assert_eq!(line, "leaning-cube within 2 texels on m0plus: not measured");
        let without_within = &METHODS[..3];
        assert_eq!(
            kept(&globe(without_within)).unwrap_err(),
            "globe within 2 texels on m0plus: not measured"
        );
    }
}
