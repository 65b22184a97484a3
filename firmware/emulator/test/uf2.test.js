import assert from 'node:assert/strict';
import { test } from 'node:test';
import { toUf2 } from '../uf2.js';

// Red when: a page is lost or written twice, a block has another address, or the numbers of blocks are wrong.
test('segments are found again in the blocks', () => {
    const segments = [
        { address: 0x10000100, bytes: Uint8Array.from({ length: 300 }, (_, at) => at) },
        { address: 0x10000000, bytes: Uint8Array.of(1, 2, 3) },
    ];
    const file = toUf2(segments);
    assert.equal(file.length, 3 * 512);
    const view = new DataView(file.buffer);
    const flash = new Map();
    for (let block = 0; block < 3; block++) {
        const word = (at) => view.getUint32(block * 512 + at, true);
        assert.deepEqual([word(0), word(4), word(508)], [0x0a324655, 0x9e5d5157, 0x0ab16f30]);
        assert.deepEqual([word(16), word(20), word(24), word(28)], [256, block, 3, 0xe48bff56]);
        file.subarray(block * 512 + 32, block * 512 + 288).forEach((byte, at) => flash.set(word(12) + at, byte));
    }
    for (const { address, bytes } of segments) {
        bytes.forEach((byte, at) => assert.equal(flash.get(address + at), byte));
    }
});
