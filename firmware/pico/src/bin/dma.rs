//! The scenes in turn, the panel fed by DMA: one strip is sent while the next is drawn.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
mod image {
    use embedded_hal::digital::StatefulOutputPin;
    use panic_halt as _;
    use pico::{Cells, Memory, PANEL, STRIP_CELLS, STRIP_ROWS, Show, Shown, label, strips};
    use topleft::{Pixel, Strip};

    use pico::chip::{Board, Panel};

    #[rp2040_hal::entry]
    fn main() -> ! {
        static mut MEMORY: Memory = Memory::new();
        static mut STRIPS: [[u16; STRIP_CELLS]; 2] = [[0; STRIP_CELLS]; 2];
        static mut DEPTHS: [u16; STRIP_CELLS] = [0; STRIP_CELLS];
        let [cells, spare] = STRIPS;
        let mut cells: &'static mut [u16] = cells;

        // Only to start the panel: it is small, and given back.
        let mut batch = [0; 8];
        let Some(Board { panel, parts, mut next, mut led }) = Board::new(&mut batch) else {
            panic!("the board does not start")
        };
        let mut panel = Panel::new(panel, parts, spare);
        let mut list = MEMORY.list_with_traversal::<_, _, topleft_thumb::Spans>();
        let (mut show, mut shown) = (Show::new(), Shown::default());
        loop {
            let Ok(()) = led.toggle();
            let left_out = show.draw(&mut list);
            let background = u16::from_rgb(show.scene().background);
            // Where the panel shows the background, and nothing else comes, nothing is sent.
            for top in strips(shown.change(background, list.rows(), left_out)) {
                let strip = Strip::new(PANEL.width as u16, cells).and_then(|strip| strip.with_depth(DEPTHS));
                let Ok(strip) = strip else { panic!("a strip is whole rows of the panel") };
                let mut strip = strip.with_background(background);
                strip.clear();
                list.render_next(top..top + STRIP_ROWS as i32, &mut strip);
                let Ok(()) = label(&mut Cells::new(cells, top as usize), left_out);
                (panel, cells) = panel.exchange(cells, top as usize);
            }
            show = if next.is_due() { show.next_scene() } else { show.next_frame() };
        }
    }
}

#[cfg(not(target_os = "none"))]
fn main() {
    eprintln!("this is an image for a Raspberry Pi Pico: cargo build --target thumbv6m-none-eabi");
    std::process::exit(2);
}
