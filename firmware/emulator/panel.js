// Runs an image for a Pico with a panel, and writes what the panel shows: FRAMES of each scene, then the button is pressed.
//
// Usage: node panel.js [--landscape] IMAGE FOLDER SCENES FRAMES
//
// The folder gets NUMBER-FRAME.rgb565 of each, 240x240 words with the low byte first, or 320x240 of a panel that lies on
// its side; frames.csv: the cycles from the start of a frame to the start of the next one; and ram.csv: bytes of strips,
// depths, list, tables, other statics and the stack, and all together.
//
// A frame starts where the image changes the level of the Pico's light.
//
// Exit status: 0, or 1 where the image does what a board would not.

import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { GPIOPinState } from 'rp2040js';
import { attach } from './bus.js';
import { readElf } from './elf.js';
import { Frames } from './frames.js';
import { Machine } from './machine.js';
import { Ram } from './ram.js';
import { St7789 } from './st7789.js';

const HEIGHT = 240;
const DATA_COMMAND = 8;
const RESET = 12;
const BUTTON = 15;
const LED = 25;
/** Levels of a pin that is no input. */
const DRIVEN = [GPIOPinState.Low, GPIOPinState.High];

const words = process.argv.slice(2);
const landscape = words[0] === '--landscape';
const [image, folder, scenes, frames] = landscape ? words.slice(1) : words;
const width = landscape ? 320 : 240;
if (!(Number(scenes) > 0 && Number(frames) > 0)) {
    console.error('Usage: node panel.js [--landscape] IMAGE FOLDER SCENES FRAMES');
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
    const elf = readElf(readFileSync(image));
    const machine = new Machine(elf.segments, { line: (text) => console.log(text) });
    const { rp2040 } = machine;
    const [pin, button] = [rp2040.gpio[DATA_COMMAND], rp2040.gpio[BUTTON]];
    button.setInputValue(true);

    const ram = new Ram(machine, elf);
    const panel = new St7789();
    const shown = new Frames(Number(scenes), Number(frames), (scene, frame) => {
        writeFileSync(`${folder}/${scene}-${frame}.rgb565`, panel.picture(width, HEIGHT, landscape));
    });
    rp2040.gpio[LED].addListener((level, before) => {
        if (DRIVEN.includes(level) && DRIVEN.includes(before)) {
            shown.start(rp2040.core.cycles);
            // The image looks at the button once a frame, at its end.
            button.setInputValue(!shown.isLast);
        }
    });
    attach(rp2040, rp2040.spi[1], (byte) => {
        const isData = pin.outputValue;
        if (!isData) {
            shown.command();
            machine.status = shown.areOver ? 0 : undefined;
        }
        panel.byte(byte, isData);
    });
    rp2040.gpio[RESET].addListener((state) => state === 0 && panel.reset());

    machine.runOnTime();
    writeFileSync(`${folder}/ram.csv`, `${ram.row()}\n`);
    writeFileSync(`${folder}/frames.csv`, `${['number,frame,cycles', ...shown.rows].join('\n')}\n`);
}
