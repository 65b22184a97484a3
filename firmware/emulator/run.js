// Runs an image for the RP2040 and prints what it prints.
//
// Usage: node run.js [--profile [--addresses]] IMAGE      Exit status: the image's own, or 1 where it cannot be run.
//
// With --profile, each line is followed by where the cycles of its measured parts went.

import { readFileSync } from 'node:fs';
import { readElf } from './elf.js';
import { Machine } from './machine.js';
import { Profile } from './profile.js';

const options = process.argv.slice(2).filter((word) => word.startsWith('--'));
const [image] = process.argv.slice(2).filter((word) => !word.startsWith('--'));
if (image === undefined || options.some((option) => !['--profile', '--addresses'].includes(option))) {
    console.error('Usage: node run.js [--profile [--addresses]] IMAGE');
    process.exit(1);
}

try {
    const { segments, functions } = readElf(readFileSync(image));
    const profile = options.includes('--profile') ? new Profile(functions) : undefined;
    const line = (text) => {
        console.log(text);
        profile?.take({ addresses: options.includes('--addresses') }).forEach((entry) => console.log(entry));
    };
    const machine = new Machine(segments, {
        line,
        named: (name) => profile?.named(name),
        elapsed: () => profile?.elapsed(),
    });
    process.exitCode = machine.run(profile && ((address, cycles) => profile.step(address, cycles)));
} catch (error) {
    console.error(`${image}: ${error.message}`);
    process.exitCode = 1;
}
