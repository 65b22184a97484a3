//! Numbers of which most are small: any bits alone would nearly always be out of sight.

use arbitrary::{Arbitrary, Unstructured};
use topleft::{Length, Pose, Turn};

/// Something usual seven times of eight, else anything: so that nearly half of all frames show something, although any
/// part of one can be odd.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Mostly<U, A> {
    Usual(U),
    Any(A),
}

impl<'a, U: Arbitrary<'a>, A: Arbitrary<'a>> Arbitrary<'a> for Mostly<U, A> {
    fn arbitrary(bytes: &mut Unstructured<'a>) -> arbitrary::Result<Self> {
        let usual = u8::arbitrary(bytes)? < 224;
        Ok(if usual { Self::Usual(bytes.arbitrary()?) } else { Self::Any(bytes.arbitrary()?) })
    }
}

/// Any 32 bits.
pub(crate) type Number = Mostly<i16, i32>;

impl Number {
    pub(crate) fn bits(self) -> i32 {
        match self {
            Self::Usual(bits) => bits.into(),
            Self::Any(bits) => bits,
        }
    }

    /// Usual ones are up to 2 of the scene's unit.
    pub(crate) fn length(self) -> Length {
        Length::from_bits(match self {
            Self::Usual(bits) => i32::from(bits) << 2,
            Self::Any(bits) => bits,
        })
    }
}

/// Any float.
pub(crate) type Real = Mostly<i16, f32>;

impl Real {
    /// Usual ones are up to 8.
    pub(crate) fn value(self) -> f32 {
        match self {
            Self::Usual(steps) => f32::from(steps) / 4096.0,
            Self::Any(value) => value,
        }
    }
}

/// Any pose: turned, and now and then scaled and moved.
pub(crate) type Place = Mostly<[u16; 3], ([u16; 3], Number, [Number; 3])>;

impl Place {
    pub(crate) fn pose(&self) -> Pose {
        let turned = |turns: [u16; 3]| {
            let [x, y, z] = turns.map(Turn::new);
            Pose::new().turned_x(x).turned_y(y).turned_z(z)
        };
        match *self {
            Self::Usual(turns) => turned(turns),
            Self::Any((turns, scale, at)) => turned(turns).scaled(scale.length()).at(at.map(Number::length)),
        }
    }
}
