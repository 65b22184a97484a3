//! What the tables say is what was set as a goal, at the better opt level of each.

use std::collections::HashMap;

type Row = HashMap<String, String>;

/// The rows of a table in `docs/measured`.
fn table(name: &str) -> Vec<Row> {
    let path = format!("{}/../../docs/measured/{name}.csv", env!("CARGO_MANIFEST_DIR"));
    let table = std::fs::read_to_string(path).unwrap();
    let mut lines = table.lines().filter(|line| !line.starts_with('#'));
    let columns: Vec<_> = lines.next().unwrap().split(',').collect();
    let row = |line: &str| {
        columns.iter().map(|&column| column.to_owned()).zip(line.split(',').map(str::to_owned)).collect()
    };
    lines.map(row).collect()
}

/// The least of a column in those rows that have these cells, of which there is one at each opt level at least.
fn least(rows: &[Row], cells: &[(&str, &str)], column: &str) -> u32 {
    let found = rows.iter().filter(|row| cells.iter().all(|&(column, cell)| row[column] == cell));
    found.map(|row| row[column].parse().unwrap()).min().unwrap_or_else(|| panic!("no row has {cells:?}"))
}

/// Red when: 512 triangles of `grid240` on a Cortex-M0+ take more cycles, set up and drawn.
#[test]
fn triangles_are_in_time() {
    let rows = table("rp2040");
    let of = |method: &str, column: &str| {
        least(&rows, &[("scene", "grid240"), ("method", method), ("strip_rows", "240")], column)
    };
    let goals = [
        ("flat", 800_000),
        ("flat+depth", 1_900_000),
        ("gouraud+depth", 2_800_000),
        ("affine", 2_400_000),
        ("perspective-pixel+depth", 6_000_000),
    ];
    for (method, goal) in goals {
        let cycles = of(method, "cycles_total");
        assert!(cycles <= goal, "{method}: {cycles} of {goal}");
    }
    // With what is chosen when the list is made.
    let within = "perspective-within-1/4+depth";
    let choice = of(within, "cycles_vertex") - of("perspective-pixel+depth", "cycles_vertex");
    let cycles = of(within, "cycles_total") + choice;
    assert!(cycles <= 4_000_000, "{within}: {cycles}");
}

/// Red when: the library takes more flash on a Cortex-M0+.
#[test]
fn code_is_small() {
    let rows = table("flash");
    // Flat with depth is of vertices on the screen, as `grid240` has them: through mesh and camera it is more.
    for (draws, goal) in
        [("projected-flat-depth", 8 << 10), ("methods", 28 << 10), ("methods-thumb", 28 << 10)]
    {
        let bytes = least(&rows, &[("core", "thumbv6m-none-eabi"), ("draws", draws)], "topleft_bytes");
        assert!(bytes <= goal, "{draws}: {bytes} of {goal}");
    }
}

/// Red when: the image for a panel of 240 by 240 takes more RAM, its deepest stack included.
#[test]
fn all_ram_is_64_kb() {
    let bytes = least(&table("ram"), &[("panel", "240x240"), ("image", "dma")], "total");
    assert!(bytes <= 64 << 10, "{bytes}");
}
