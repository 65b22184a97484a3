import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Frames } from '../frames.js';

// Red when: a frame is shown while its rows are on the bus, or never where it sends none; or its cycles are another's.
test('a frame is shown before the first command after its end', () => {
    const shown = [];
    const frames = new Frames(2, 2, (scene, frame) => shown.push(`${scene}-${frame}`));
    // Before the first frame, as the panel is set up.
    frames.command();
    frames.start(100);
    frames.command();
    assert.deepEqual([shown, frames.isLast], [[], false]);
    frames.start(110);
    assert.deepEqual([shown, frames.isLast], [[], true]);
    frames.command();
    frames.command();
    assert.deepEqual(shown, ['0-0']);
    frames.start(130);
    // This one sends nothing.
    frames.start(160);
    assert.deepEqual(shown, ['0-0']);
    frames.command();
    assert.deepEqual(shown, ['0-0', '0-1', '1-0']);
    frames.start(200);
    assert.ok(!frames.areOver);
    frames.command();
    assert.ok(frames.areOver);
    assert.deepEqual(frames.rows, [[0, 0, 10], [0, 1, 20], [1, 0, 30], [1, 1, 40]]);
});
