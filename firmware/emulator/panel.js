// Runs an image for a Pico with a panel, and writes what the panel shows: FRAMES of each scene, then the button is pressed.
//
// Usage: node panel.js IMAGE FOLDER SCENES FRAMES      Exit status: 0, or 1 where the image does what a board would not.
//
// SCENES is how many are to be shown, or a number and a comma and another: how many are passed over, and how many are
// shown. The folder gets NUMBER-FRAME.rgb565 of each, 240x240 words with the low byte first, and frames.csv: the cycles
// from the first row of a frame to the first row of the next one, and the time in which the bus sent nothing.

import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { attach } from './bus.js';
import { readElf } from './elf.js';
import { Machine } from './machine.js';
import { St7789 } from './st7789.js';

const SIDE = 240;
const DATA_COMMAND = 8;
const RESET = 12;
const BUTTON = 15;

const [image, folder, scenes, frames] = process.argv.slice(2);
const [skipped, shown] = (scenes ?? '').includes(',') ? scenes.split(',').map(Number) : [0, Number(scenes)];
if (!(shown > 0 && skipped >= 0 && Number(frames) > 0)) {
    console.error('Usage: node panel.js IMAGE FOLDER [SKIPPED,]SCENES FRAMES');
    process.exit(2);
}

try {
    mkdirSync(folder, { recursive: true });
    run();
} catch (error) {
    console.error(`${image}: ${error.message}`);
    process.exitCode = 1;
}

function run() {
    const { segments } = readElf(readFileSync(image));
    const machine = new Machine(segments, { line: (text) => console.log(text) });
    const { rp2040 } = machine;
    const [pin, button] = [rp2040.gpio[DATA_COMMAND], rp2040.gpio[BUTTON]];
    button.setInputValue(true);

    const rows = ['number,frame,cycles'];
    // Frames of a scene that is passed over: one, in which the button is pressed.
    const wanted = (number) => (number < skipped ? 1 : Number(frames));
    let [number, frame, started] = [0, -1, 0];
    const panel = new St7789({
        write: ([first]) => {
            if (first === 0) {
                next();
            }
        },
    });
    /** A frame starts: the one before it is done. */
    function next() {
        const { cycles } = rp2040.core;
        if (frame >= 0 && number >= skipped) {
            writeFileSync(`${folder}/${number}-${frame}.rgb565`, panel.picture(SIDE, SIDE));
            rows.push(`${number},${frame},${cycles - started}`);
        }
        started = cycles;
        frame++;
        if (frame === wanted(number)) {
            [number, frame] = [number + 1, 0];
            machine.status = number === skipped + shown ? 0 : undefined;
        }
        // The image looks at the button once a frame, at its end.
        button.setInputValue(frame !== wanted(number) - 1);
    }
    attach(rp2040, rp2040.spi[1], (byte) => panel.byte(byte, pin.outputValue));
    rp2040.gpio[RESET].addListener((state) => state === 0 && panel.reset());

    machine.runOnTime();
    writeFileSync(`${folder}/frames.csv`, `${rows.join('\n')}\n`);
}
