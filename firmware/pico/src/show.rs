//! The scenes in turn, and the memory that they are drawn with.

use embedded_graphics::geometry::Size;
use scenes::{SCENES, Scene, View};
use topleft::stages::Traversal;
use topleft::{Depth, DrawError, DrawList, ListStorage, Pixel, Turn};

/// Pixels of the panel.
pub const PANEL: Size = if cfg!(feature = "landscape") { Size::new(320, 240) } else { Size::new(240, 240) };
/// Rows of a strip: the more, the fewer triangles are set up twice.
pub const STRIP_ROWS: usize = 20;
/// Pixels of a strip.
pub const STRIP_CELLS: usize = PANEL.width as usize * STRIP_ROWS;
/// Words of a list's vertices, and its triangles: enough for most scenes. What does not fit is counted on the panel.
pub const WORDS: usize = 4300;
/// The triangles of a list.
pub const TRIANGLES: usize = 1100;

/// A list's storage.
pub type Memory = ListStorage<WORDS, TRIANGLES>;

/// Frames of a full turn.
const FRAMES: u16 = 256;

/// Which scene is shown, and how far it has turned.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Show {
    scene: usize,
    frame: u16,
}

impl Show {
    /// The first scene, and no frame of it so far.
    pub const fn new() -> Self {
        Self { scene: 0, frame: 0 }
    }

    /// What is shown.
    pub fn scene(&self) -> &'static Scene {
        &SCENES[self.scene]
    }

    /// The next scene from its start, or the first after the last.
    #[must_use]
    pub const fn next_scene(self) -> Self {
        Self { scene: (self.scene + 1) % SCENES.len(), frame: 0 }
    }

    /// The next frame of the scene.
    #[must_use]
    pub const fn next_frame(self) -> Self {
        Self { frame: (self.frame + 1) % FRAMES, ..self }
    }

    /// Draws the frame into a list that it empties. Gives the number of triangles that did not fit.
    pub fn draw<P: Pixel, D: Depth, T: Traversal>(&self, list: &mut DrawList<'_, P, D, T>) -> usize {
        list.clear();
        let turn = Turn::new(self.frame * (u16::MAX / FRAMES + 1));
        match self.scene().draw(list, PANEL, &View { turn, ..View::default() }) {
            Err(DrawError::Full { triangles, .. }) => triangles,
            // The scenes have fewer shaders than a list holds, and the panel is not too large.
            Ok(()) | Err(_) => 0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Red when: scenes wrap round too early or not at all, or a new scene goes on at the frame of the last.
    #[test]
    fn all_scenes_come_up_from_their_start() {
        let mut show = Show::new();
        for scene in SCENES {
            assert_eq!((show.scene().name, show.frame), (scene.name, 0));
            show = show.next_frame().next_scene();
        }
        assert_eq!(show, Show::new());
    }

    /// Red when: a turn has a frame more or less than it says.
    #[test]
    fn a_turn_ends_where_it_started() {
        let end = (0..FRAMES).fold(Show::new(), |show, _| show.next_frame());
        assert_eq!(end, Show::new());
        assert_eq!(u32::from(FRAMES) * u32::from(u16::MAX / FRAMES + 1), 1 << 16);
    }
}
