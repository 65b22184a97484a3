//! Labels beside their places that cover neither markers nor each other.

use super::canvas::{Anchor, Canvas, Colour, width};

/// What is taken already: rectangles from a corner to the other.
#[derive(Clone, Debug)]
pub(crate) struct Labels {
    inside: [[i32; 2]; 2],
    taken: Vec<[[i32; 2]; 2]>,
    /// Lines: a label stands on one of them rather than nowhere.
    lines: Vec<[[i32; 2]; 2]>,
}

const HEIGHT: i32 = 13;

impl Labels {
    /// For labels inside a rectangle.
    pub(crate) const fn new(inside: [[i32; 2]; 2]) -> Self {
        Self { inside, taken: Vec::new(), lines: Vec::new() }
    }

    /// Keeps a marker clear.
    pub(crate) fn keep_clear(&mut self, [x, y]: [i32; 2]) {
        self.taken.push([[x - 7, y - 7], [x + 7, y + 7]]);
    }

    /// Keeps a rectangle clear.
    pub(crate) fn keep_block_clear(&mut self, block: [[i32; 2]; 2]) {
        self.taken.push(block);
    }

    /// Keeps a line clear.
    pub(crate) fn keep_line_clear(&mut self, [from, to]: [[i32; 2]; 2]) {
        let steps = (from[0].abs_diff(to[0]).max(from[1].abs_diff(to[1])) / 4).max(1) as i32;
        for step in 0..=steps {
            let [x, y] = [0, 1].map(|k| from[k] + (to[k] - from[k]) * step / steps);
            self.lines.push([[x - 1, y - 1], [x + 1, y + 1]]);
        }
    }

    /// Writes a label as near to its place as there is room, with a thin line where that is not beside it.
    pub(crate) fn write(&mut self, canvas: &Canvas<'_>, text: &str, [x, y]: [i32; 2], colour: Colour) {
        let wide = width(text, HEIGHT);
        for on_lines in [false, true] {
            for ring in 1..8 {
                for [right, down] in [[1, 0], [-1, 0], [0, -1], [0, 1], [1, -1], [1, 1], [-1, -1], [-1, 1]] {
                    // Beside its place the label starts or ends there; above and below its middle does.
                    let across = x + right * (9 + 12 * (ring - 1));
                    let anchor = match right {
                        1 => Anchor::Left,
                        -1 => Anchor::Right,
                        _ => Anchor::Middle,
                    };
                    let left = across - wide * (1 - right) / 2;
                    let middle = y + down * (HEIGHT + 2) * if right == 0 { ring } else { 1.max(ring - 1) };
                    let block = [[left, middle - HEIGHT / 2 - 1], [left + wide, middle + HEIGHT / 2 + 1]];
                    if self.is_free(block, on_lines) {
                        if ring > 1 {
                            let end = [across - 2 * right, middle - down * (HEIGHT / 2)];
                            let line = [[x + right * 6, y + down * 6], end];
                            canvas.line(&line, colour, 1);
                            self.keep_line_clear(line);
                        }
                        canvas.text(text, [across, middle], HEIGHT, colour, anchor);
                        self.taken.push(block);
                        return;
                    }
                }
            }
        }
    }

    fn is_free(&self, [low, high]: [[i32; 2]; 2], on_lines: bool) -> bool {
        let within = (0..2).all(|k| low[k] >= self.inside[0][k] && high[k] <= self.inside[1][k]);
        let apart = |other: &[[i32; 2]; 2]| (0..2).any(|k| high[k] < other[0][k] || other[1][k] < low[k]);
        within && self.taken.iter().all(apart) && (on_lines || self.lines.iter().all(apart))
    }
}

#[cfg(test)]
mod tests {
    use super::super::canvas::svg;
    use super::*;

    // Red when a label's place is not kept clear of the next.
    #[test]
    fn labels_at_one_place_keep_clear_of_each_other() {
        let _ = svg([300, 300], |canvas| {
            let mut labels = Labels::new([[0, 0], [300, 300]]);
            labels.keep_clear([150, 150]);
            for _ in 0..5 {
                labels.write(canvas, "a label", [150, 150], [0; 3]);
            }
            assert_eq!(labels.taken.len(), 6);
            for (k, [low, high]) in labels.taken.iter().enumerate() {
                for other in &labels.taken[k + 1..] {
                    assert!((0..2).any(|k| high[k] < other[0][k] || other[1][k] < low[k]));
                }
            }
        });
    }
}
