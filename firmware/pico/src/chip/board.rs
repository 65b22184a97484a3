//! A Raspberry Pi Pico with a panel of 240x240 pixels, set up by mipidsi. The pins are those of Waveshare's Pico-LCD-1.3.

use mipidsi::interface::SpiInterface;
use mipidsi::models::ST7789;
use mipidsi::options::{ColorInversion, Orientation, Rotation};
use mipidsi::{Builder, Display};
use rp2040_hal::clocks::init_clocks_and_plls;
use rp2040_hal::dma::{CH0, Channel, DMAExt};
use rp2040_hal::fugit::RateExtU32;
use rp2040_hal::gpio::bank0::{Gpio8, Gpio10, Gpio11, Gpio12, Gpio15, Gpio25};
use rp2040_hal::gpio::{
    FunctionSio, FunctionSpi, Pin, PinState, Pins, PullDown, PullUp, SioInput, SioOutput,
};
use rp2040_hal::pac::{Peripherals, RESETS, SPI1};
use rp2040_hal::spi::{Enabled, Spi};
use rp2040_hal::{Clock, Sio, Timer, Watchdog};

use super::button::Next;
use super::device::Only;
use crate::PANEL;

/// The crystal of the board.
const CRYSTAL_HZ: u32 = 12_000_000;
/// A write of the ST7789 takes 16 ns at the least. The peripherals' 125 MHz are twice as fast.
pub(super) const BUS_HZ: u32 = 62_500_000;

type Output<I> = Pin<I, FunctionSio<SioOutput>, PullDown>;
type BusPins = (Pin<Gpio11, FunctionSpi, PullDown>, Pin<Gpio10, FunctionSpi, PullDown>);

/// Data, or command.
pub(super) type DataCommand = Output<Gpio8>;
/// The bus in frames of so many bits.
pub(super) type Bus<const BITS: u8> = Spi<Enabled, SPI1, BusPins, BITS>;
/// The panel as a target of embedded-graphics.
pub type Driver<'b> = Display<SpiInterface<'b, Only, DataCommand>, ST7789, Output<Gpio12>>;

/// What the images use of the board.
pub struct Board<'b> {
    /// The panel, black and on.
    pub panel: Driver<'b>,
    /// For DMA.
    pub parts: Parts,
    /// The button A.
    pub next: Next<Pin<Gpio15, FunctionSio<SioInput>, PullUp>>,
    /// The board's own light, to be toggled where a frame starts: it flickers at half of the frames' rate.
    pub led: Output<Gpio25>,
}

/// What a transfer by DMA needs beside the panel.
pub struct Parts {
    /// A free channel.
    pub dma: Channel<CH0>,
    /// To start the bus anew.
    pub resets: RESETS,
    /// The clock that the bus's is made of.
    pub peripheral_hz: u32,
}

impl<'b> Board<'b> {
    /// Starts the clocks and the panel. `batch` holds the pixels that mipidsi sends at a time.
    ///
    /// Nothing where the chip's peripherals are in use already or its crystal does not start: neither can happen once, at
    /// the start of an image.
    pub fn new(batch: &'b mut [u8]) -> Option<Self> {
        let mut chip = Peripherals::take()?;
        let mut watchdog = Watchdog::new(chip.WATCHDOG);
        let clocks = init_clocks_and_plls(
            CRYSTAL_HZ,
            chip.XOSC,
            chip.CLOCKS,
            chip.PLL_SYS,
            chip.PLL_USB,
            &mut chip.RESETS,
            &mut watchdog,
        )
        .ok()?;
        let mut timer = Timer::new(chip.TIMER, &mut chip.RESETS, &clocks);
        let sio = Sio::new(chip.SIO);
        let pins = Pins::new(chip.IO_BANK0, chip.PADS_BANK0, sio.gpio_bank0, &mut chip.RESETS);

        // The panel is selected, and its light is on: for good.
        let _ = pins.gpio9.into_push_pull_output_in_state(PinState::Low);
        let _ = pins.gpio13.into_push_pull_output_in_state(PinState::High);
        let peripheral_hz = clocks.peripheral_clock.freq().to_Hz();
        let bus = Spi::new(chip.SPI1, (pins.gpio11.into_function(), pins.gpio10.into_function()));
        let bus = bus.init(&mut chip.RESETS, peripheral_hz.Hz(), BUS_HZ.Hz(), MODE);
        let interface = SpiInterface::new(Only(bus), pins.gpio8.into_push_pull_output(), batch);
        let panel = Builder::new(ST7789, interface)
            .display_size(PANEL.height as u16, PANEL.width as u16)
            .orientation(if PANEL.width > PANEL.height {
                Orientation::new().rotate(Rotation::Deg90)
            } else {
                Orientation::new()
            })
            // Panels of this kind show the negative of what they are sent, unless they are told to invert it.
            .invert_colors(ColorInversion::Inverted)
            .reset_pin(pins.gpio12.into_push_pull_output())
            .init(&mut timer)
            .ok()?;
        Some(Self {
            panel,
            parts: Parts { dma: chip.DMA.split(&mut chip.RESETS).ch0, resets: chip.RESETS, peripheral_hz },
            next: Next::new(pins.gpio15.into_pull_up_input(), timer),
            led: pins.gpio25.into_push_pull_output(),
        })
    }
}

/// Data is taken at a rising edge, and the clock rests high. In this mode the bus leaves no gap between frames; and
/// panels without a select pin want it.
pub(super) const MODE: embedded_hal::spi::Mode = embedded_hal::spi::MODE_3;
