// What ways to draw take of a chip's flash, and whether an image links what it does not use.
//
// Usage: node flash.js CORE OPT-LEVEL FOLDER...      Exit status: 0, 1 where an image links what it does not use.
//
// FOLDER holds the images of the package `footprint`. Prints a line for each: core, opt level, way to draw, bytes of the
// library's code, bytes of the whole image. The library's code is what the image has more than `nothing`: with what only
// it calls, as 64-bit divisions, and with none of the mesh or the start-up code.

import { readFileSync } from 'node:fs';
import { readElf } from './elf.js';

/** Names of functions that belong to what can be left out, as they stand in the images. */
const KINDS = {
    depth: /topleft5depth/,
    texture: /[Tt]extur|sampler/,
    light: /5light|\.\.light\.\.|recip9normalise/,
    perspective: /11perspective|PerPixel|6over_w/,
    floats: /topleft6camera|__(add|sub|mul|div)sf3/,
    'vertex stages': /topleft(6camera|4pose|9transform|4clip)|4math(6matrix|4turn)|list7drawing|7clipped/,
};
/** Files and functions that stand in the debug information where code of theirs was inlined: it is not linked into flash. */
const INLINED = {
    depth: /^src\/depth\/(buffer|depth16|float|painter)\.rs$/,
    // Not `texture.rs`: a list compares where its shaders' texels lie, whatever they are.
    texture: /^src\/shade\/(sampler|textured)\.rs$/,
    light: /^normalise$/,
    perspective: /^src\/shade\/(over_w|perspective\/(per_pixel|subspans|within|divided))\.rs$/,
    'vertex stages': /^src\/(camera|pose|transform|clip|math\/(matrix|turn)|list\/drawing)\.rs$/,
};
/** The ways to draw, in the table's order, and what each does not use. */
const UNUSED = {
    flat: ['depth', 'texture', 'light', 'perspective', 'floats'],
    'flat-depth': ['texture', 'light', 'perspective', 'floats'],
    'gouraud-depth': ['texture', 'light', 'perspective', 'floats'],
    'affine-depth': ['light', 'perspective', 'floats'],
    'lit-affine-depth': ['perspective', 'floats'],
    'perspective-subspan-16-depth': ['light', 'floats'],
    'perspective-depth': ['light', 'floats'],
    'projected-flat-depth': ['texture', 'light', 'perspective', 'floats', 'vertex stages'],
    demo: ['perspective'],
    'demo-thumb': ['perspective'],
    methods: ['light', 'floats'],
    'methods-thumb': ['light', 'floats'],
    everything: [],
};
const WAYS = Object.keys(UNUSED);

const [core, level, folder] = process.argv.slice(2);
if (folder === undefined) {
    console.error('Usage: node flash.js CORE OPT-LEVEL FOLDER');
    process.exit(2);
}

try {
    const files = Object.fromEntries([...WAYS, 'nothing'].map((way) => [way, readFileSync(`${folder}/${way}`)]));
    const images = Object.fromEntries(Object.entries(files).map(([way, file]) => [way, readElf(file)]));
    const bytes = (way) => images[way].segments.reduce((sum, segment) => sum + segment.bytes.length, 0);
    for (const way of WAYS) {
        console.log(`${core},${level},${way},${bytes(way) - bytes('nothing')},${bytes(way)}`);
    }
    const strings = Object.fromEntries(WAYS.map((way) => [way, new Set(files[way].toString('latin1').split('\0'))]));
    const faults = unused((way) => images[way].functions.map(({ name }) => name), (way) => [...strings[way]]);
    faults.forEach((fault) => console.error(`${core}, opt level ${level}: ${fault}`));
    process.exitCode = faults.length === 0 ? 0 : 1;
} catch (error) {
    console.error(`${folder}: ${error.message}`);
    process.exitCode = 1;
}

/** What images link without using it: functions by their names, and what was inlined by the strings of the file. */
function unused(functions, strings) {
    // An image's own functions are named after it, whatever they use.
    const own = (way) => `_ZN${way.length}${way.replaceAll('-', '_')}5image`;
    const linked = (way, kind) =>
        functions(way).filter((name) => KINDS[kind].test(name) && !name.startsWith(own(way)));
    const inlined = (way, kind) => strings(way).filter((string) => INLINED[kind]?.test(string));
    const faults = [];
    for (const kind of Object.keys(KINDS)) {
        // At opt level 3 perspective has no function of its own.
        if (linked('everything', kind).length === 0 && !(kind === 'perspective' && level === '3')) {
            faults.push(`no function is known to be of ${kind}: the check would see nothing`);
        }
        if (kind in INLINED && inlined('everything', kind).length === 0) {
            faults.push(`nothing inlined is known to be of ${kind}: the check would see nothing`);
        }
    }
    for (const way of WAYS) {
        for (const kind of UNUSED[way]) {
            linked(way, kind).forEach((name) => faults.push(`${way} uses no ${kind}, and links ${name}`));
            inlined(way, kind).forEach((name) => faults.push(`${way} uses no ${kind}, and has code of ${name}`));
        }
    }
    return faults;
}
