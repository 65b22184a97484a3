// An RP2040 that runs an image from flash and answers its semihosting calls.

import { RP2040 } from 'rp2040js';

const FLASH = 0x10000000;
/** The second stage of the boot takes the first 256 bytes of flash; the vector table follows. */
const VECTORS = FLASH + 0x100;

const BKPT_SEMIHOSTING = 0xab;
const SYS = {
    OPEN: 0x01, CLOSE: 0x02, WRITEC: 0x03, WRITE0: 0x04, WRITE: 0x05, ISTTY: 0x09, EXIT: 0x18, EXIT_EXTENDED: 0x20,
    ELAPSED: 0x30,
};
const EXITED = 0x20026;

export class Machine {
    /**
     * `segments` go to flash; `line` gets each line that the image prints, `named` the text of its debugger's calls, and
     * `elapsed` the cycles so far each time the image asks for them.
     */
    constructor(segments, { line, named = () => {}, elapsed = () => {} }) {
        this.handlers = { line, named, elapsed };
        this.rp2040 = new RP2040();
        this.rp2040.logger = { debug() {}, info() {}, warn: refuse, error: refuse };
        this.rp2040.onBreak = (code) => this.semihosting(code);
        for (const { address, bytes } of segments) {
            if (address < FLASH || address + bytes.length > FLASH + this.rp2040.flash.length) {
                throw new Error(`a segment at 0x${address.toString(16)} is not in flash`);
            }
            this.rp2040.flash.set(bytes, address - FLASH);
        }
        const { core } = this.rp2040;
        core.VTOR = VECTORS;
        core.SP = this.rp2040.readUint32(VECTORS);
        core.PC = this.rp2040.readUint32(VECTORS + 4) & ~1;
        this.text = '';
        this.status = undefined;
    }

    /** Runs until the image exits; `step` is called with the address and the cycles of each instruction. */
    run(step) {
        const { core } = this.rp2040;
        if (step === undefined) {
            while (this.status === undefined) {
                core.executeInstruction();
            }
            return this.status;
        }
        while (this.status === undefined) {
            const { PC } = core;
            step(PC, core.executeInstruction());
        }
        return this.status;
    }

    /** The same, and whatever the chip's own clock moves: its timer, its buses, its DMA. */
    runOnTime() {
        const { rp2040 } = this;
        const { core, clock } = rp2040;
        while (this.status === undefined) {
            clock.tick((core.executeInstruction() / rp2040.clkSys) * 1e9);
        }
        return this.status;
    }

    semihosting(code) {
        if (code !== BKPT_SEMIHOSTING) {
            throw new Error(`a breakpoint ${code} that is not semihosting`);
        }
        const { handlers, rp2040 } = this;
        const { core } = rp2040;
        const [operation, argument] = [core.registers[0] >>> 0, core.registers[1] >>> 0];
        const word = (i) => rp2040.readUint32(argument + 4 * i);
        let result = 0;
        switch (operation) {
            case SYS.OPEN:
                result = 1;
                break;
            case SYS.CLOSE:
                break;
            case SYS.ISTTY:
                result = 1;
                break;
            case SYS.WRITEC:
                this.print([rp2040.readUint8(argument)]);
                break;
            case SYS.WRITE0:
                handlers.named(this.string(argument));
                break;
            case SYS.WRITE: {
                const [start, length] = [word(1), word(2)];
                this.print(Array.from({ length }, (_, i) => rp2040.readUint8(start + i)));
                break;
            }
            case SYS.ELAPSED:
                rp2040.writeUint32(argument, core.cycles % 2 ** 32);
                rp2040.writeUint32(argument + 4, Math.floor(core.cycles / 2 ** 32));
                handlers.elapsed(core.cycles);
                break;
            case SYS.EXIT:
                this.status = argument === EXITED ? 0 : 1;
                break;
            case SYS.EXIT_EXTENDED:
                this.status = word(0) === EXITED ? word(1) : 1;
                break;
            default:
                throw new Error(`semihosting operation 0x${operation.toString(16)} is not known`);
        }
        core.registers[0] = result;
    }

    string(at) {
        const bytes = [];
        for (let byte; (byte = this.rp2040.readUint8(at + bytes.length)) !== 0; ) {
            bytes.push(byte);
        }
        return String.fromCharCode(...bytes);
    }

    print(bytes) {
        const lines = (this.text + String.fromCharCode(...bytes)).split('\n');
        this.text = lines.pop();
        lines.forEach((line) => this.handlers.line(line));
    }
}

/** What the emulator would only warn of, such as a stack that runs out of RAM, stops it. */
function refuse(component, message) {
    throw new Error(`${component}: ${message}`);
}
