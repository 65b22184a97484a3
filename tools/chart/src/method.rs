//! The ways to find a texel that are charted, and what each may be off by.

use topleft::stages::Correction;
use topleft::{Affine, Attribute, Divided, PerPixel, Portable, Subspans, Within};

/// What has one marker and one line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Family {
    Affine,
    Subspans,
    Within,
    PerPixel,
    Divided,
}

impl Family {
    pub(crate) const ALL: [Self; 5] =
        [Self::Affine, Self::Subspans, Self::Within, Self::PerPixel, Self::Divided];

    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Affine => "Affine",
            Self::Subspans => "Subspans",
            Self::Within => "Within",
            Self::PerPixel => "PerPixel",
            Self::Divided => "Divided",
        }
    }
}

/// How far off the texels of a method may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Bound {
    /// By the closed form over a whole triangle.
    Triangle,
    /// A reciprocal every few pixels, and linear steps between.
    Every(i64),
    /// What the caller asks for.
    Asked(f64),
    /// A reciprocal a pixel, by table.
    Pixel,
    /// The same by division.
    Quotient,
}

/// A reciprocal a pixel, in the tables of cycles and instructions.
pub(crate) const PER_PIXEL: &str = "perspective-pixel+depth";

/// A method at one setting.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Method {
    pub(crate) family: Family,
    /// What is written beside its marker.
    pub(crate) setting: &'static str,
    /// The method's name in the tables of cycles and instructions.
    pub(crate) row: &'static str,
    pub(crate) bound: Bound,
}

/// What is done with each method: they are types.
pub(crate) trait EachMethod {
    fn method(&mut self, method: Method, correction: impl Correction + 'static);
}

/// Calls for all methods, family by family.
pub(crate) fn for_each(each: &mut impl EachMethod) {
    let method = |family, setting, row, bound| Method { family, setting, row, bound };
    each.method(method(Family::Affine, "", "affine+depth", Bound::Triangle), Affine);
    for (setting, row, subspans) in [
        ("32 px", "perspective-subspan-32+depth", Subspans::Of32),
        ("16 px", "perspective-subspan-16+depth", Subspans::Of16),
        ("8 px", "perspective-subspan-8+depth", Subspans::Of8),
        ("4 px", "perspective-subspan-4+depth", Subspans::Of4),
    ] {
        each.method(method(Family::Subspans, setting, row, Bound::Every(subspans.pixels().into())), subspans);
    }
    for (setting, row, error) in [
        ("2", "perspective-within-2+depth", 2.0),
        ("1", "perspective-within-1+depth", 1.0),
        ("1/2", "perspective-within-1/2+depth", 0.5),
        ("1/4", "perspective-within-1/4+depth", 0.25),
        ("1/16", "perspective-within-1/16+depth", 0.0625),
    ] {
        let within = Within::texels(Attribute::from_num(error));
        each.method(method(Family::Within, setting, row, Bound::Asked(error)), within);
    }
    each.method(method(Family::PerPixel, "", PER_PIXEL, Bound::Pixel), PerPixel);
    let divided = method(Family::Divided, "", "perspective-divided+depth", Bound::Quotient);
    each.method(divided, Divided::<Portable>::new());
}

/// How many there are.
pub(crate) fn count() -> usize {
    struct Count(usize);
    impl EachMethod for Count {
        fn method(&mut self, _: Method, _: impl Correction) {
            self.0 += 1;
        }
    }
    let mut count = Count(0);
    for_each(&mut count);
    count.0
}
