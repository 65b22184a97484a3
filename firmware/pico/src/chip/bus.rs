//! Strips to the panel by DMA: one is sent while the next is drawn.

use embedded_hal::digital::OutputPin;
use embedded_hal::spi::SpiBus;
use rp2040_hal::dma::single_buffer::{Config, Transfer};
use rp2040_hal::dma::{CH0, Channel};
use rp2040_hal::fugit::RateExtU32;
use rp2040_hal::spi::Spi;

use super::board::{BUS_HZ, Bus, DataCommand, Driver, MODE, Parts};
use super::device::Only;
use crate::PANEL;

/// The cells of a strip, which a DMA channel reads.
type Strip = &'static mut [u16];

/// The panel, as it was set up by mipidsi, on a bus with frames of 16 bits: a pixel is one frame, and no byte has to be
/// swapped on its way.
///
/// A command has 8 bits. It goes out behind a zero, which is the panel's command to do nothing.
pub struct Panel {
    data_command: DataCommand,
    sending: Sending,
}

/// A strip on its way, or one that waits to be drawn to.
enum Sending {
    Strip(Transfer<Channel<CH0>, Strip, Bus<16>>),
    Nothing(Channel<CH0>, Strip, Bus<16>),
}

const COLUMNS: u16 = 0x2A;
const ROWS: u16 = 0x2B;
const WRITE: u16 = 0x2C;

impl Panel {
    /// Takes the panel from its driver. The first strip is exchanged for `spare`.
    pub fn new(driver: Driver<'_>, parts: Parts, spare: Strip) -> Self {
        let Parts { dma, mut resets, peripheral_hz } = parts;
        let (interface, _, _) = driver.release();
        let (Only(bus), data_command) = interface.release();
        let (device, pins) = bus.disable().free();
        let bus = Spi::new(device, pins).init(&mut resets, peripheral_hz.Hz(), BUS_HZ.Hz(), MODE);
        Self { data_command, sending: Sending::Nothing(dma, spare, bus) }
    }

    /// Starts to send whole rows from `top` on, once the strip before has gone. Gives that one back.
    pub fn exchange(self, strip: Strip, top: usize) -> (Self, Strip) {
        let Self { mut data_command, sending } = self;
        let (dma, spare, mut bus) = match sending {
            Sending::Strip(transfer) => transfer.wait(),
            Sending::Nothing(dma, spare, bus) => (dma, spare, bus),
        };
        let mut send = |command: u16, arguments: &[u16]| {
            // The last frames of a strip may still be on the bus: the line belongs to them.
            let Ok(()) = bus.flush();
            let Ok(()) = data_command.set_low();
            let Ok(()) = bus.write(&[command]);
            let Ok(()) = bus.flush();
            let Ok(()) = data_command.set_high();
            let Ok(()) = bus.write(arguments);
        };
        let rows = strip.len() / PANEL.width as usize;
        send(COLUMNS, &[0, PANEL.width as u16 - 1]);
        send(ROWS, &[top as u16, (top + rows) as u16 - 1]);
        send(WRITE, &[]);
        let transfer = Config::new(dma, strip, bus).start();
        (Self { data_command, sending: Sending::Strip(transfer) }, spare)
    }
}
