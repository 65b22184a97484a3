// The parts of an ELF image that the emulator needs: what goes into flash, and the functions' names.

const PT_LOAD = 1;
const SHT_SYMTAB = 2;
const STT_FUNC = 2;

/** Reads a 32-bit little-endian ELF file: `segments` with their bytes and load addresses, and `functions` by address. */
export function readElf(bytes) {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    const u32 = (at) => view.getUint32(at, true);
    const u16 = (at) => view.getUint16(at, true);
    if (bytes.length < 52 || u32(0) !== 0x464c457f || bytes[4] !== 1) {
        throw new Error('not a 32-bit ELF file');
    }
    const segments = [];
    for (let i = 0; i < u16(44); i++) {
        const header = u32(28) + i * u16(42);
        const [offset, address, size] = [u32(header + 4), u32(header + 12), u32(header + 16)];
        if (u32(header) === PT_LOAD && size > 0) {
            segments.push({ address, bytes: bytes.subarray(offset, offset + size) });
        }
    }
    return { segments, functions: readFunctions(bytes, u32, u16) };
}

function readFunctions(bytes, u32, u16) {
    const section = (i) => u32(32) + i * u16(46);
    const functions = [];
    for (let i = 0; i < u16(48); i++) {
        if (u32(section(i) + 4) !== SHT_SYMTAB) {
            continue;
        }
        const [start, size] = [u32(section(i) + 16), u32(section(i) + 20)];
        const names = u32(section(u32(section(i) + 24)) + 16);
        for (let at = start; at < start + size; at += 16) {
            if ((bytes[at + 12] & 15) === STT_FUNC) {
                const from = names + u32(at);
                const name = new TextDecoder().decode(bytes.subarray(from, bytes.indexOf(0, from)));
                functions.push({ address: u32(at + 4) & ~1, size: u32(at + 8), name });
            }
        }
    }
    return functions.sort((a, b) => a.address - b.address);
}
