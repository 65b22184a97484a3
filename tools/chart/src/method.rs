//! The ways to find a texel that are charted, and what each may be off by.

use topleft::stages::Correction;
use topleft::{Affine, PerPixel};

/// What has one marker and one line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Family {
    Affine,
    PerPixel,
}

impl Family {
    pub(crate) const ALL: [Self; 2] = [Self::Affine, Self::PerPixel];

    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Affine => "Affine",
            Self::PerPixel => "PerPixel",
        }
    }
}

/// How far off the texels of a method may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Bound {
    /// By the closed form over a whole triangle.
    Triangle,
    /// A reciprocal a pixel.
    Pixel,
}

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
    each.method(method(Family::PerPixel, "", "perspective-pixel+depth", Bound::Pixel), PerPixel);
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
