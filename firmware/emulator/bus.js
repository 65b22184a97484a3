// An SPI bus of the RP2040 that takes its time, and what the emulator leaves out of it.

const SSPCR1 = 0x004;
const SPH = 1 << 7;
const SSE = 1 << 1;
const TXDMAE = 1 << 1;

/**
 * Hands each byte that the SPI sends to `byte`, and lets a frame take as long as the bus's clock says.
 *
 * rp2040js has no register SSPCR1, so that it cannot tell whether the bus is enabled; its DMA asks nobody whether the bus
 * wants transfers; and it leaves to its user how long a frame takes. All three are here, and an image that forgets one
 * of them, and would stand still on a board, is stopped.
 */
export function attach(rp2040, spi, byte) {
    const read = spi.readUint32.bind(spi);
    const write = spi.writeUint32.bind(spi);
    spi.readUint32 = (offset) => (offset === SSPCR1 ? spi.control1 : read(offset));
    spi.writeUint32 = (offset, value) => {
        if (offset === SSPCR1) {
            spi.control1 = value;
        } else {
            write(offset, value);
        }
    };
    const sent = rp2040.clock.createAlarm(() => spi.completeTransmit(0));
    spi.onTransmit = (frame) => {
        if (!(spi.control1 & SSE)) {
            throw new Error('the bus is not enabled');
        }
        if (!(spi.dmaControl & TXDMAE) && rp2040.dma.channels.some((channel) => channel.active && channel.treq === spi.dreq.tx)) {
            throw new Error('DMA sends to a bus that does not ask for it');
        }
        const { dataBits } = spi;
        for (let low = dataBits - 8; low >= 0; low -= 8) {
            byte((frame >> low) & 0xff);
        }
        // In modes 0 and 2 the PL022 raises its select line between two frames, for one clock.
        const clocks = dataBits + (spi.control0 & SPH ? 0 : 1);
        sent.schedule((clocks / spi.clockFrequency) * 1e9);
    };
}
