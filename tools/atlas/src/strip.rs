//! Strips of four pictures: naive, topleft, reference, and how far the naive one is from the reference: the difference
//! of each channel, amplified.

use crate::canvas::{Canvas, Colour, INK, LINE, Stands, text_width};

/// A picture before it is enlarged, in rows from the top: what is shown, and what is compared.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Picture {
    width: usize,
    pixels: Vec<Colour>,
    values: Vec<[u8; 3]>,
}

impl Picture {
    /// Of colours.
    pub(crate) fn new(width: usize, pixels: Vec<Colour>) -> Self {
        Self { width, values: pixels.clone(), pixels }
    }

    /// From RGB565 words.
    pub(crate) fn from_rgb565(width: usize, words: impl IntoIterator<Item = u16>) -> Self {
        let colour = |word: u16| reference::shade::to_rgb888(reference::shade::from_rgb565(word));
        Self::new(width, words.into_iter().map(colour).collect())
    }

    /// How often each pixel was hit: 0 is dark, 1 pale, and more are red.
    pub(crate) fn of_hits(width: usize, hits: impl IntoIterator<Item = u32>) -> Self {
        let colour = |hits: u32| match hits {
            0 => [36, 40, 64],
            1 => [168, 196, 216],
            2 => [230, 60, 40],
            _ => [255, 176, 32],
        };
        let hits: Vec<u32> = hits.into_iter().collect();
        let value = |&hits: &u32| [hits.min(255) as u8; 3];
        Self {
            width,
            values: hits.iter().map(value).collect(),
            pixels: hits.into_iter().map(colour).collect(),
        }
    }

    fn height(&self) -> usize {
        self.pixels.len() / self.width
    }

    /// How many pixels differ, and by how much the furthest.
    fn differs(&self, other: &Self) -> (usize, u8) {
        let apart = self
            .values
            .iter()
            .zip(&other.values)
            .map(|(a, b)| [0, 1, 2].map(|k| a[k].abs_diff(b[k])).into_iter().max().unwrap_or(0));
        apart.fold((0, 0), |(count, most), apart| (count + usize::from(apart != 0), most.max(apart)))
    }
}

/// One failure.
pub(crate) struct Strip {
    pub(crate) title: &'static str,
    /// What the naive method is.
    pub(crate) naive_method: &'static str,
    pub(crate) naive: Picture,
    pub(crate) topleft: Picture,
    pub(crate) reference: Picture,
    /// Screen pixels for each pixel.
    pub(crate) zoom: i32,
    /// What the difference is multiplied with, and its unit: one of it.
    pub(crate) times: u16,
    pub(crate) unit: &'static str,
    /// What is to be seen.
    pub(crate) notes: Vec<String>,
}

const MARGIN: i32 = 10;
const GAP: i32 = 10;
const TOP: i32 = 42;

impl Strip {
    fn difference(&self) -> Picture {
        let times = |a: u8, b: u8| (u16::from(a.abs_diff(b)) * self.times).min(255) as u8;
        let pairs = self.naive.values.iter().zip(&self.reference.values);
        Picture::new(self.naive.width, pairs.map(|(a, b)| [0, 1, 2].map(|k| times(a[k], b[k]))).collect())
    }

    fn differing(&self, name: &str, picture: &Picture) -> String {
        let (count, most) = picture.differs(&self.reference);
        let of = self.reference.pixels.len();
        match count {
            0 => format!("{name}: no pixel of {of} differs from the reference."),
            _ => {
                let most = self.amount(most.into());
                format!("{name}: {count} of {of} px differ from the reference, by up to {most}.")
            }
        }
    }

    fn amount(&self, number: u16) -> String {
        format!("{number} {}{}", self.unit, if number == 1 { "" } else { "s" })
    }

    pub(crate) fn draw(&self) -> Canvas {
        let difference = self.difference();
        let labels = [
            format!("naive: {}", self.naive_method),
            "topleft".into(),
            "reference".into(),
            format!("difference x {}, white: {}", self.times, self.amount(255 / self.times)),
        ];
        let pictures = [&self.naive, &self.topleft, &self.reference, &difference];
        for picture in pictures {
            assert_eq!(picture.width, self.naive.width, "{}", self.title);
            assert_eq!(picture.pixels.len(), self.naive.pixels.len(), "{}", self.title);
        }
        let mut notes = self.notes.clone();
        notes.push(self.differing("naive", &self.naive));
        notes.push(self.differing("topleft", &self.topleft));
        let size = [self.naive.width, self.naive.height()].map(|c| c as i32 * self.zoom);
        let under = TOP + size[1] + 8;
        let texts = notes.iter().map(|note| text_width(note));
        let width = (4 * size[0] + 3 * GAP).max(texts.max().unwrap_or(0)) + 2 * MARGIN;
        let height = under + notes.len() as i32 * (LINE + 3) + MARGIN - 3;
        let mut canvas = Canvas::new(width, height);
        canvas.heading([MARGIN, 8], self.title);
        for ((picture, label), index) in pictures.into_iter().zip(labels).zip(0..) {
            let left = MARGIN + index * (size[0] + GAP);
            assert!(text_width(&label) <= size[0] + GAP, "{label}: too long for {} px", size[0]);
            canvas.text([left, TOP - LINE - 4], &label, Stands::Right);
            canvas.frame([left, TOP], size, INK);
            for (pixel, number) in picture.pixels.iter().zip(0..) {
                let (x, y) = (number % picture.width as i32, number / picture.width as i32);
                canvas.fill([left + x * self.zoom, TOP + y * self.zoom], [self.zoom; 2], *pixel);
            }
        }
        for (note, index) in notes.iter().zip(0..) {
            canvas.text([MARGIN, under + index * (LINE + 3)], note, Stands::Right);
        }
        canvas
    }
}
