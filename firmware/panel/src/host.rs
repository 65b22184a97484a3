//! What the host draws: each frame as a whole, with the list that the chip has.

use pico::{Cells, Memory, PANEL, Show, label};
use topleft::{Pixel, Strip};

const PIXELS: usize = (PANEL.width * PANEL.height) as usize;

/// A list, and a whole frame.
pub(crate) struct Host {
    memory: Box<Memory>,
    colours: Vec<u16>,
    depths: Vec<u16>,
}

/// A frame, and what it shows.
pub(crate) struct Drawn<'h> {
    pub(crate) scene: &'static str,
    pub(crate) left_out: usize,
    pub(crate) frame: &'h [u16],
}

impl Default for Host {
    fn default() -> Self {
        Self { memory: Box::default(), colours: vec![0; PIXELS], depths: vec![0; PIXELS] }
    }
}

impl Host {
    /// A frame of a scene, both counted from 0.
    pub(crate) fn draw(&mut self, scene: usize, frame: usize) -> Drawn<'_> {
        let show = (0..scene).fold(Show::new(), |show, _| show.next_scene());
        let show = (0..frame).fold(show, |show, _| show.next_frame());
        let mut list = self.memory.list();
        let left_out = show.draw(&mut list);
        let strip = Strip::new(PANEL.width as u16, &mut self.colours);
        let strip =
            strip.and_then(|strip| strip.with_depth(&mut self.depths)).expect("a frame is whole rows");
        let mut strip = strip.with_background(u16::from_rgb(show.scene().background));
        strip.clear();
        list.render(0..PANEL.height as i32, &mut strip);
        let Ok(()) = label(&mut Cells::new(&mut self.colours, 0), left_out);
        Drawn { scene: show.scene().name, left_out, frame: &self.colours }
    }
}

/// How many scenes there are.
pub(crate) fn scenes() -> usize {
    let mut show = Show::new().next_scene();
    let mut count = 1;
    while show != Show::new() {
        (show, count) = (show.next_scene(), count + 1);
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Red when: frames are not told apart, or scenes.
    #[test]
    fn scenes_and_frames_differ() {
        let mut host = Host::default();
        let first = host.draw(0, 0).frame.to_vec();
        assert_ne!(first, host.draw(0, 1).frame);
        assert_ne!(first, host.draw(scenes() - 1, 0).frame);
        assert_eq!(first, host.draw(scenes(), 0).frame);
    }
}
