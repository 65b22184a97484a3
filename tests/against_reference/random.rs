//! Numbers that are random enough, and the same on every run; and the triangles that are hard to interpolate over.

use reference::setup::{Triangle, area2};

/// A stream of numbers (`SplitMix64`).
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    pub(crate) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        mixed ^ (mixed >> 31)
    }

    /// From `low` to `high`, both possible.
    pub(crate) fn within(&mut self, low: i64, high: i64) -> i64 {
        low + (self.next() % (high - low + 1) as u64) as i64
    }

    /// From 0 up to 1.
    pub(crate) fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// Kinds of triangles, in 1/256 px, for a target of 320 x 240 with a guard margin of 1024 px.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Ordinary,
    Small,
    FullScreen,
    Sliver,
    Needle,
    Guard,
    FarAnchor,
}

impl Kind {
    pub(crate) const ALL: [Self; 7] = [
        Self::Ordinary,
        Self::Small,
        Self::FullScreen,
        Self::Sliver,
        Self::Needle,
        Self::Guard,
        Self::FarAnchor,
    ];

    /// Its name in a table.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Ordinary => "ordinary triangles",
            Self::Small => "small triangles",
            Self::FullScreen => "full-screen triangles",
            Self::Sliver => "slivers",
            Self::Needle => "needles",
            Self::Guard => "guard-sized triangles",
            Self::FarAnchor => "triangles with a far anchor",
        }
    }

    /// A triangle of this kind that has an area.
    pub(crate) fn triangle(self, random: &mut Random) -> Triangle {
        loop {
            let triangle = self.any(random);
            if area2(triangle) != 0 {
                return triangle;
            }
        }
    }

    fn any(self, random: &mut Random) -> Triangle {
        let mut at = |left: i64, right: i64, top: i64, bottom: i64| {
            [random.within(left * 256, right * 256) as i32, random.within(top * 256, bottom * 256) as i32]
        };
        let (left, top) = (-1024, -1024);
        let (right, bottom) = (320 + 1024, 240 + 1024);
        match self {
            Self::Ordinary => [at(0, 320, 0, 240), at(0, 320, 0, 240), at(0, 320, 0, 240)],
            Self::Small => {
                let [x, y] = at(0, 310, 0, 230);
                [at(0, 10, 0, 10), at(0, 10, 0, 10), at(0, 10, 0, 10)].map(|[u, v]| [x + u, y + v])
            }
            Self::FullScreen => [at(-20, 20, -20, 20), at(300, 340, -20, 120), at(0, 320, 220, 260)],
            // A third corner a few steps beside an edge.
            Self::Sliver | Self::Needle => {
                let (a, b) = (at(0, 320, 0, 240), at(0, 320, 0, 240));
                let part = random.within(0, 256) as i32;
                let beside = if self == Self::Needle { 1 } else { 40 };
                let mut aside = || random.within(-beside, beside) as i32;
                let between = |from: i32, to: i32| from + (((to - from) * part) >> 8);
                [a, b, [between(a[0], b[0]) + aside(), between(a[1], b[1]) + aside()]]
            }
            Self::Guard => {
                let corners = [[left, top], [right, top], [right, bottom], [left, bottom]];
                let skipped = random.within(0, 3) as usize;
                let mut near = |[x, y]: [i64; 2]| {
                    let (u, v) = (random.within(0, 60 * 256) as i32, random.within(0, 60 * 256) as i32);
                    let inwards = |c: i64, by: i32| c as i32 * 256 + if c < 0 { by } else { -by };
                    [inwards(x, u), inwards(y, v)]
                };
                let kept: Vec<_> = (0..4).filter(|&i| i != skipped).map(|i| near(corners[i])).collect();
                [kept[0], kept[1], kept[2]]
            }
            // The first vertex is far above the screen, the others are on it or far to a side.
            Self::FarAnchor => [at(left, right, top, -900), at(left, 320, 0, 240), at(0, right, 0, bottom)],
        }
    }
}
