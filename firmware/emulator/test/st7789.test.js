import assert from 'node:assert/strict';
import { test } from 'node:test';
import { St7789 } from '../st7789.js';

/** A panel that is awake, on, and inverted, as IPS panels want it. */
function panel() {
    const shown = new St7789();
    send(shown, 0x11);
    send(shown, 0x21);
    send(shown, 0x29);
    send(shown, 0x3a, 0x55);
    return shown;
}

function send(shown, command, ...data) {
    shown.byte(command, false);
    data.forEach((byte) => shown.byte(byte, true));
}

function window(shown, [left, right], [top, bottom]) {
    send(shown, 0x2a, left >> 8, left & 255, right >> 8, right & 255);
    send(shown, 0x2b, top >> 8, top & 255, bottom >> 8, bottom & 255);
}

/** The word at a place of the picture. */
function word(shown, x, y, [width, height] = [240, 240], onItsSide = false) {
    const bytes = shown.picture(width, height, onItsSide);
    return bytes[2 * (y * width + x)] | (bytes[2 * (y * width + x) + 1] << 8);
}

// Red when: counters start elsewhere, go on beyond the window, or a word's bytes change places.
test('pixels fill the window row by row, and start again at its end', () => {
    const shown = panel();
    window(shown, [10, 11], [20, 21]);
    send(shown, 0x2c, 0x11, 0x11, 0x22, 0x22, 0x33, 0x33, 0x44, 0x44, 0x55, 0x55);
    assert.deepEqual([word(shown, 10, 20), word(shown, 11, 20)], [0x5555, 0x2222]);
    assert.deepEqual([word(shown, 10, 21), word(shown, 11, 21)], [0x3333, 0x4444]);
    assert.deepEqual([word(shown, 12, 20), word(shown, 10, 22)], [0, 0]);
});

// Red when: another command of no effect on the memory sets the counters back, or RAMWRC does, or RAMWR does not.
test('writing goes on after RAMWRC, and starts anew after RAMWR', () => {
    const shown = panel();
    window(shown, [0, 9], [0, 9]);
    send(shown, 0x2c, 0x11, 0x11);
    send(shown, 0x00);
    send(shown, 0x3c, 0x22, 0x22);
    assert.deepEqual([word(shown, 0, 0), word(shown, 1, 0)], [0x1111, 0x2222]);
    send(shown, 0x2c, 0x33, 0x33);
    assert.deepEqual([word(shown, 0, 0), word(shown, 1, 0)], [0x3333, 0x2222]);
});

// Red when: a channel is cut at another bit, or the two pixels of 12 bits change places.
test('all three pixel formats give their colours', () => {
    for (const [format, bytes, words] of [
        [0x55, [0x8c, 0x51], [0x8c51]],
        [0x66, [0x88, 0x8c, 0x8c], [0x8c71]],
        [0x53, [0xf0, 0x0f, 0x0f], [0xf800, 0xf81f]],
    ]) {
        const shown = panel();
        send(shown, 0x3a, format);
        window(shown, [0, 9], [0, 9]);
        send(shown, 0x2c, ...bytes);
        words.forEach((colour, x) => assert.equal(word(shown, x, 0), colour, `format ${format}`));
    }
});

// Red when: a bit of MADCTL mirrors or swaps something else.
test('MADCTL mirrors, swaps, and changes red with blue', () => {
    for (const [madctl, x, y] of [[0x00, 1, 0], [0x40, 238, 0], [0x20, 0, 1]]) {
        const shown = panel();
        send(shown, 0x36, madctl);
        window(shown, [0, 9], [0, 9]);
        send(shown, 0x2c, 0, 0, 0xf8, 0x00);
        assert.equal(word(shown, x, y), 0xf800, `MADCTL ${madctl}`);
    }
    const shown = panel();
    send(shown, 0x36, 0x88);
    window(shown, [0, 9], [319, 319]);
    send(shown, 0x2c, 0xf8, 0x00);
    assert.equal(word(shown, 0, 0), 0x001f);
});

// Red when: a glass on its side is turned the other way round.
test('a glass on its side is turned by a quarter, clockwise', () => {
    const shown = panel();
    window(shown, [239, 239], [0, 1]);
    send(shown, 0x2c, 0x11, 0x11, 0x22, 0x22);
    const size = [320, 240];
    assert.deepEqual([word(shown, 0, 0, size, true), word(shown, 1, 0, size, true)], [0x1111, 0x2222]);
});

// Red when: a panel shows something while it sleeps or is off, or is not the negative without INVON.
test('a panel is dark until it is on, and negative until it is inverted', () => {
    const shown = new St7789();
    send(shown, 0x11);
    assert.equal(word(shown, 0, 0), 0);
    send(shown, 0x29);
    assert.equal(word(shown, 0, 0), 0xffff);
    send(shown, 0x21);
    assert.equal(word(shown, 0, 0), 0);
});

// Red when: what the panel does not know is passed over.
test('unknown commands and data that no command asks for are refused', () => {
    assert.throws(() => send(panel(), 0xff), /0xff/);
    assert.throws(() => send(panel(), 0x29, 1), /takes none/);
    assert.throws(() => send(panel(), 0x3a, 0x51), /0x51/);
});
