//! What a list says of the faces that were drawn into it.

use topleft::{DrawError, Stats};

/// Whether every face of a mesh is accounted for by a list's figures, before and after it was drawn.
pub(crate) fn adds_up(
    before: Stats,
    after: Stats,
    result: Result<(), DrawError>,
    faces: usize,
) -> Result<(), String> {
    let left_out = match result {
        Ok(()) => 0,
        Err(DrawError::Full { triangles, .. }) => triangles,
        Err(other) => return Err(format!("{other:?}")),
    };
    let more = |of: fn(&Stats) -> usize| of(&after) - of(&before);
    let clipped = more(|stats| stats.clipped);
    let known = more(|stats| stats.drawn + stats.culled + stats.outside) + left_out;
    // A face that is cut becomes up to seven triangles, or none.
    let right = (faces.saturating_sub(clipped)..=faces + 6 * clipped).contains(&known);
    if more(|stats| stats.faces) == faces && right {
        Ok(())
    } else {
        Err(format!("{faces} faces do not add up: {after:?} after {before:?}, {left_out} left out"))
    }
}
