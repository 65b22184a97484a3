//! The scenes in turn by `DrawList::present`: one strip, and any driver that embedded-graphics draws to.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
mod image {
    use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
    use embedded_hal::digital::StatefulOutputPin;
    use panic_halt as _;
    use pico::{Memory, PANEL, STRIP_CELLS, Show, label};
    use topleft::{Pixel, Strip};

    use pico::chip::Board;

    #[rp2040_hal::entry]
    fn main() -> ! {
        static mut MEMORY: Memory = Memory::new();
        static mut CELLS: [Rgb565; STRIP_CELLS] = [Rgb565::BLACK; STRIP_CELLS];
        static mut DEPTHS: [u16; STRIP_CELLS] = [0; STRIP_CELLS];
        static mut BATCH: [u8; 512] = [0; 512];

        let Some(Board { mut panel, mut next, mut led, .. }) = Board::new(BATCH) else {
            panic!("the board does not start")
        };
        let mut list = MEMORY.list();
        let mut show = Show::new();
        loop {
            let Ok(()) = led.toggle();
            let left_out = show.draw(&mut list);
            let strip = Strip::new(PANEL.width as u16, CELLS).and_then(|strip| strip.with_depth(DEPTHS));
            let Ok(strip) = strip else { panic!("a strip is whole rows of the panel") };
            let mut strip = strip.with_background(Rgb565::from_rgb(show.scene().background));
            // Its errors are the bus's and the pins', which have none.
            let _ = list.present(&mut strip, &mut panel);
            let _ = label(&mut panel, left_out);
            show = if next.is_due() { show.next_scene() } else { show.next_frame() };
        }
    }
}

#[cfg(not(target_os = "none"))]
fn main() {
    eprintln!("this is an image for a Raspberry Pi Pico: cargo build --target thumbv6m-none-eabi");
    std::process::exit(2);
}
