// What an image takes of the RAM: its buffers, and the deepest that its stack was, by painting what lies below it.

import { RAM } from './elf.js';

const PAINT = 0xa5;

export class Ram {
    /** Paints the RAM between the end of the image's statics and the top of its stack. */
    constructor(machine, { end, objects }) {
        this.sram = machine.rp2040.sram;
        this.bottom = end - RAM;
        this.top = machine.rp2040.core.SP - RAM;
        this.objects = objects.filter(({ address, size }) => address >= RAM && size > 0);
        this.sram.fill(PAINT, this.bottom, this.top);
    }

    /** Bytes from the top of the stack down to the lowest byte that was written. */
    stack() {
        let low = this.bottom;
        while (low < this.top && this.sram[low] === PAINT) {
            low++;
        }
        if (low === this.bottom) {
            throw new Error('the stack ran into the statics');
        }
        return this.top - low;
    }

    /** Bytes by what they are for; the names are those of the statics in the images. */
    row() {
        const sum = (name) => this.objects.filter((object) => name.test(object.name)).reduce((bytes, { size }) => bytes + size, 0);
        const [colours, depths, list] = [/(STRIPS|CELLS)/, /DEPTHS/, /MEMORY/].map(sum);
        const tables = sum(/topleft/);
        const [all, stack] = [this.bottom, this.stack()];
        return [colours, depths, list, tables, all - colours - depths - list - tables, stack, all + stack].join(',');
    }
}
