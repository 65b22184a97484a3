// The parts of an ELF image that the emulator needs: what goes into flash, and the names of functions and objects.

const PT_LOAD = 1;
const SHT_SYMTAB = 2;
/** The first address of an RP2040's RAM. */
export const RAM = 0x20000000;
const STT_OBJECT = 1;
const STT_FUNC = 2;

/**
 * Reads a 32-bit little-endian ELF file: `segments` with their bytes and load addresses, `end` of what is in RAM when the
 * image starts, and `functions` and `objects` by address.
 */
export function readElf(bytes) {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    const u32 = (at) => view.getUint32(at, true);
    const u16 = (at) => view.getUint16(at, true);
    if (bytes.length < 52 || u32(0) !== 0x464c457f || bytes[4] !== 1) {
        throw new Error('not a 32-bit ELF file');
    }
    const segments = [];
    let end = 0;
    for (let i = 0; i < u16(44); i++) {
        const header = u32(28) + i * u16(42);
        const [offset, address, size] = [u32(header + 4), u32(header + 12), u32(header + 16)];
        const [place, extent] = [u32(header + 8), u32(header + 20)];
        if (u32(header) === PT_LOAD && place >= RAM && extent > 0) {
            end = Math.max(end, place + extent);
        }
        if (u32(header) === PT_LOAD && size > 0) {
            segments.push({ address, bytes: bytes.subarray(offset, offset + size) });
        }
    }
    const symbols = (type) => readSymbols(bytes, u32, u16, type);
    return { segments, end, functions: symbols(STT_FUNC), objects: symbols(STT_OBJECT) };
}

function readSymbols(bytes, u32, u16, type) {
    const section = (i) => u32(32) + i * u16(46);
    const symbols = [];
    for (let i = 0; i < u16(48); i++) {
        if (u32(section(i) + 4) !== SHT_SYMTAB) {
            continue;
        }
        const [start, size] = [u32(section(i) + 16), u32(section(i) + 20)];
        const names = u32(section(u32(section(i) + 24)) + 16);
        for (let at = start; at < start + size; at += 16) {
            if ((bytes[at + 12] & 15) === type) {
                const from = names + u32(at);
                const name = new TextDecoder().decode(bytes.subarray(from, bytes.indexOf(0, from)));
                symbols.push({ address: (u32(at + 4) & (type === STT_FUNC ? ~1 : ~0)) >>> 0, size: u32(at + 8), name });
            }
        }
    }
    return symbols.sort((a, b) => a.address - b.address);
}
