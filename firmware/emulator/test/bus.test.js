import assert from 'node:assert/strict';
import { test } from 'node:test';
import { RP2040 } from 'rp2040js';
import { attach } from '../bus.js';

const [CR0, CR1, DR, CPSR, DMACR] = [0x00, 0x04, 0x08, 0x10, 0x24];

/** A bus of 16 bits in mode 3 at half of 125 MHz, enabled, and the bytes that came out of it. */
function bus() {
    const rp2040 = new RP2040();
    const spi = rp2040.spi[1];
    const bytes = [];
    attach(rp2040, spi, (byte) => bytes.push(byte));
    spi.writeUint32(CPSR, 2);
    spi.writeUint32(CR0, 0xcf);
    spi.writeUint32(CR1, 2);
    return { rp2040, spi, bytes };
}

// Red when: a frame's bytes change places, or it takes no time, or another time than its clocks.
test('a frame is two bytes, the high one first, and takes its time', () => {
    const { rp2040, spi, bytes } = bus();
    spi.writeUint32(DR, 0x1234);
    assert.deepEqual(bytes, [0x12, 0x34]);
    const time = (16 / spi.clockFrequency) * 1e9;
    rp2040.clock.tick(time * 0.99);
    assert.ok(spi.busy);
    rp2040.clock.tick(time * 0.02);
    assert.ok(!spi.busy);
});

// Red when: the gap between frames is left out in mode 0, or is there in mode 3.
test('mode 0 leaves a clock between frames', () => {
    const { rp2040, spi } = bus();
    spi.writeUint32(CR0, 0x0f);
    spi.writeUint32(DR, 1);
    rp2040.clock.tick((16.5 / spi.clockFrequency) * 1e9);
    assert.ok(spi.busy);
    rp2040.clock.tick((1 / spi.clockFrequency) * 1e9);
    assert.ok(!spi.busy);
});

// Red when: an image that would stand still on a board is let go on.
test('a bus that is off, or does not ask for DMA, sends nothing', () => {
    const off = bus();
    off.spi.writeUint32(CR1, 0);
    assert.throws(() => off.spi.writeUint32(DR, 1), /not enabled/);

    const { rp2040, spi } = bus();
    spi.writeUint32(DMACR, 0);
    Object.assign(rp2040.dma.channels[0], { ctrl: (1 << 24) | 1, treqValue: spi.dreq.tx });
    assert.throws(() => spi.writeUint32(DR, 1), /does not ask/);
    spi.writeUint32(DMACR, 2);
    spi.busy = false;
    spi.writeUint32(DR, 1);
});
