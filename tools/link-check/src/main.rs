//! A firmware image that draws with topleft from const matrices: what it links is looked at, and it is never run.
//!
//! It calls every way to draw that needs no camera. What it draws with goes through `black_box`, so that nothing is
//! computed by the compiler, and so does what comes out. It links only if no panic can be reached.
#![no_std]
#![no_main]

use core::convert::Infallible;
use core::hint::black_box;
use core::panic::PanicInfo;

mod flat_drawing;
mod frame;
mod projected;
mod screen;
#[cfg(feature = "camera")]
mod with_camera;

use screen::Screen;

/// Where the linker starts. There is no stack pointer to set and no memory to clear, as nothing runs.
#[expect(unsafe_code, reason = "the linker looks for this name")]
#[unsafe(no_mangle)]
extern "C" fn _start() -> ! {
    let mut screen = Screen::new();
    let Ok(()) = draw(&mut screen);
    #[cfg(feature = "panic")]
    assert!(black_box(true), "a panic that can be reached");
    loop {
        black_box(&mut screen);
    }
}

fn draw(screen: &mut Screen) -> Result<(), Infallible> {
    frame::with_depth(screen)?;
    frame::with_depth_float(screen)?;
    frame::without_depth(screen)?;
    frame::in_painters_order(screen)?;
    frame::cheapest();
    frame::by_boxes(screen)?;
    projected::draw(screen)?;
    #[cfg(feature = "camera")]
    with_camera::draw(screen)?;
    flat_drawing::draw(screen)
}

#[expect(unsafe_code, reason = "an extern block is unsafe; nothing can be called by it")]
unsafe extern "C" {
    /// Not there: the image links only where no call of the panic handler is left in it.
    safe fn a_panic_can_be_reached() -> !;
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    a_panic_can_be_reached()
}
