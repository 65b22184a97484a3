// Where the cycles go: a histogram of addresses for each measured part of a row, and sums by function.

export class Profile {
    constructor(functions) {
        this.functions = functions;
        this.parts = new Map();
        this.name = undefined;
        this.histogram = undefined;
    }

    /** What is measured from the next question for the time to the one after it. */
    named(name) {
        this.name = name;
    }

    elapsed() {
        if (this.histogram !== undefined) {
            this.histogram = undefined;
            return;
        }
        if (!this.parts.has(this.name)) {
            this.parts.set(this.name, new Map());
        }
        this.histogram = this.parts.get(this.name);
    }

    step(address, cycles) {
        this.histogram?.set(address, (this.histogram.get(address) ?? 0) + cycles);
    }

    /** The parts since the last call, as text: functions by their cycles, the most first. */
    take({ least = 0.005, addresses = false } = {}) {
        const lines = [];
        for (const [part, histogram] of this.parts) {
            const all = [...histogram.values()].reduce((sum, cycles) => sum + cycles, 0);
            const sums = new Map();
            for (const [address, cycles] of histogram) {
                const name = this.functionAt(address);
                sums.set(name, (sums.get(name) ?? 0) + cycles);
            }
            lines.push(`  ${part}: ${all}`);
            for (const [name, cycles] of [...sums].sort((a, b) => b[1] - a[1])) {
                if (cycles >= all * least) {
                    lines.push(`    ${String(cycles).padStart(10)} ${(cycles / all * 100).toFixed(1).padStart(5)}% ${readable(name)}`);
                }
            }
            if (addresses) {
                const hot = [...histogram].sort((a, b) => a[0] - b[0]);
                lines.push(...hot.map(([address, cycles]) => `    @ ${part} 0x${address.toString(16)} ${cycles}`));
            }
        }
        this.parts.clear();
        return lines;
    }

    functionAt(address) {
        let [low, high] = [0, this.functions.length];
        while (low < high) {
            const middle = (low + high) >> 1;
            if (this.functions[middle].address <= address) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return this.functions[low - 1]?.name ?? '?';
    }
}

/** A mangled Rust name as a path, without its hash; other names as they are. */
function readable(name) {
    const legacy = /^_ZN(.*)17h[0-9a-f]{16}E/.exec(name);
    if (legacy === null) {
        return name;
    }
    const parts = [];
    for (let rest = legacy[1], length; (length = /^\d+/.exec(rest)); ) {
        const end = length[0].length + Number(length[0]);
        parts.push(rest.slice(length[0].length, end));
        rest = rest.slice(end);
    }
    const escapes = { LT: '<', GT: '>', u20: ' ', u7b: '{', u7d: '}', RF: '&', C: ',', BP: '*', LP: '(', RP: ')' };
    return parts.join('::').replace(/\$(\w+)\$/g, (all, code) => escapes[code] ?? all).replace(/\.\./g, '::').replace(/^_</, '<');
}
