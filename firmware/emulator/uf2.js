// Writes an image as a UF2 file, which a Pico takes as a file on the disk that it shows while BOOTSEL is held.
//
// Usage: node uf2.js IMAGE FILE.uf2      Exit status: 0, or 2 where the image cannot be read or the file not written.

import { readFileSync, writeFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { readElf } from './elf.js';

const BLOCK = 512;
/** Bytes of flash in a block: one page. */
const PAGE = 256;
const MAGIC = [0x0a324655, 0x9e5d5157, 0x0ab16f30];
const HAS_FAMILY = 0x2000;
const RP2040 = 0xe48bff56;

/** Blocks with whole pages of flash: what no segment fills is zero. */
export function toUf2(segments) {
    const pages = new Map();
    for (const { address, bytes } of segments) {
        bytes.forEach((byte, at) => {
            const start = address + at - ((address + at) % PAGE);
            if (!pages.has(start)) {
                pages.set(start, new Uint8Array(PAGE));
            }
            pages.get(start)[(address + at) % PAGE] = byte;
        });
    }
    const file = new Uint8Array(pages.size * BLOCK);
    const view = new DataView(file.buffer);
    [...pages].sort(([a], [b]) => a - b).forEach(([start, page], number) => {
        const words = [MAGIC[0], MAGIC[1], HAS_FAMILY, start, PAGE, number, pages.size, RP2040];
        words.forEach((word, at) => view.setUint32(number * BLOCK + 4 * at, word, true));
        file.set(page, number * BLOCK + 32);
        view.setUint32((number + 1) * BLOCK - 4, MAGIC[2], true);
    });
    return file;
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) {
    const [image, file] = process.argv.slice(2);
    try {
        if (file === undefined) {
            throw new Error('Usage: node uf2.js IMAGE FILE.uf2');
        }
        writeFileSync(file, toUf2(readElf(readFileSync(image)).segments));
    } catch (error) {
        console.error(file === undefined ? error.message : `${image}: ${error.message}`);
        process.exitCode = 2;
    }
}
