//! When the next scene is due.

use embedded_hal::digital::InputPin;
use rp2040_hal::Timer;
use rp2040_hal::fugit::{ExtU64, MicrosDurationU64};
use rp2040_hal::timer::Instant;

/// How long a scene is shown: a full turn at 13 frames a second.
const SHOWN: MicrosDurationU64 = MicrosDurationU64::secs(20);

/// A button that is pressed, or a scene that was shown long enough.
pub struct Next<B> {
    button: B,
    timer: Timer,
    since: Instant,
    /// Frames are long enough for the contacts to come to rest: one look a frame.
    was_pressed: bool,
}

impl<B: InputPin> Next<B> {
    /// The button pulls the pin low.
    pub fn new(button: B, timer: Timer) -> Self {
        Self { button, timer, since: timer.get_counter(), was_pressed: false }
    }

    /// Whether the next scene is due: to be asked once a frame.
    pub fn is_due(&mut self) -> bool {
        let pressed = self.button.is_low().unwrap_or(false);
        let now = self.timer.get_counter();
        let elapsed = now.checked_duration_since(self.since).unwrap_or(0.micros());
        let due = (pressed && !self.was_pressed) || elapsed >= SHOWN;
        self.was_pressed = pressed;
        if due {
            self.since = now;
        }
        due
    }
}
