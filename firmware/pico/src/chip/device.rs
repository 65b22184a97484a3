//! A bus with one device, which stays selected: mipidsi takes a device, and DMA wants the bus back.

use core::convert::Infallible;

use embedded_hal::spi::{ErrorType, Operation, SpiBus, SpiDevice};

use super::board::Bus;

/// The only device of a bus.
pub struct Only(pub Bus<8>);

impl ErrorType for Only {
    type Error = Infallible;
}

impl SpiDevice for Only {
    fn transaction(&mut self, operations: &mut [Operation<'_, u8>]) -> Result<(), Infallible> {
        let Self(bus) = self;
        for operation in operations {
            match operation {
                Operation::Read(words) => bus.read(words)?,
                Operation::Write(words) => bus.write(words)?,
                Operation::Transfer(read, write) => bus.transfer(read, write)?,
                Operation::TransferInPlace(words) => bus.transfer_in_place(words)?,
                // Between commands the panel needs none.
                Operation::DelayNs(_) => {}
            }
        }
        bus.flush()
    }
}
