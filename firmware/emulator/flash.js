// What ways to draw take of a chip's flash, and whether an image links what it does not use.
//
// Usage: node flash.js CORE OPT-LEVEL FOLDER...      Exit status: 0, 1 where an image links what it does not use.
//
// FOLDER holds the images of the package `footprint`. Prints a line for each: core, opt level, way to draw, bytes of the
// library's code, bytes of the whole image. The library's code is what the image has more than `nothing`: with what only
// it calls, as 64-bit divisions, and with none of the mesh or the start-up code.

import { readFileSync } from 'node:fs';
import { readElf } from './elf.js';

const WAYS = ['flat', 'flat-depth', 'gouraud-depth', 'perspective-depth', 'everything'];

/** Names of functions that belong to what can be left out, as they stand in the images. */
const KINDS = {
    depth: /topleft5depth/,
    texture: /[Tt]extur|sampler/,
    light: /5light|recip9normalise/,
    perspective: /11perspective|PerPixel|6over_w/,
    floats: /topleft6camera|__(add|sub|mul|div)sf3/,
};
/** What each way to draw does not use. */
const UNUSED = {
    flat: ['depth', 'texture', 'light', 'perspective', 'floats'],
    'flat-depth': ['texture', 'light', 'perspective', 'floats'],
    'gouraud-depth': ['texture', 'light', 'perspective', 'floats'],
    'perspective-depth': ['light', 'floats'],
    everything: [],
};

const [core, level, folder] = process.argv.slice(2);
if (folder === undefined) {
    console.error('Usage: node flash.js CORE OPT-LEVEL FOLDER');
    process.exit(2);
}

try {
    const images = Object.fromEntries([...WAYS, 'nothing'].map((way) => [way, readElf(readFileSync(`${folder}/${way}`))]));
    const bytes = (way) => images[way].segments.reduce((sum, segment) => sum + segment.bytes.length, 0);
    for (const way of WAYS) {
        console.log(`${core},${level},${way},${bytes(way) - bytes('nothing')},${bytes(way)}`);
    }
    const faults = unused((way) => images[way].functions.map(({ name }) => name));
    faults.forEach((fault) => console.error(`${core}, opt level ${level}: ${fault}`));
    process.exitCode = faults.length === 0 ? 0 : 1;
} catch (error) {
    console.error(`${folder}: ${error.message}`);
    process.exitCode = 1;
}

/** What images link without using it. A kind whose functions are all inlined, even where it is used, is not looked for. */
function unused(functions) {
    const linked = (way, kind) =>
        functions(way).filter((name) => KINDS[kind].test(name) && !/^_ZN\d+(flat|gouraud|perspective|everything)_?[a-z]*5image/.test(name));
    const faults = [];
    for (const kind of Object.keys(KINDS)) {
        // At opt level 3 perspective has no function of its own.
        if (linked('everything', kind).length === 0 && !(kind === 'perspective' && level === '3')) {
            faults.push(`no function is known to be of ${kind}: the check would see nothing`);
        }
    }
    for (const way of WAYS) {
        for (const kind of UNUSED[way]) {
            linked(way, kind).forEach((name) => faults.push(`${way} uses no ${kind}, and links ${name}`));
        }
    }
    return faults;
}
