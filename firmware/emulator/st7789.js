// A panel with an ST7789: what it makes of the bytes on its bus.

/** Columns and rows of the memory. */
const WIDTH = 240;
const HEIGHT = 320;

const COMMAND = {
    NOP: 0x00, SWRESET: 0x01, SLPIN: 0x10, SLPOUT: 0x11, NORON: 0x13, INVOFF: 0x20, INVON: 0x21, DISPOFF: 0x28, DISPON: 0x29,
    CASET: 0x2a, RASET: 0x2b, RAMWR: 0x2c, MADCTL: 0x36, COLMOD: 0x3a, RAMWRC: 0x3c,
};
const MADCTL = { MY: 0x80, MX: 0x40, MV: 0x20, BGR: 0x08 };
/** Bytes and pixels that belong together, by the control interface's half of COLMOD. */
const FORMATS = { 3: { bytes: 3, pixels: 2 }, 5: { bytes: 2, pixels: 1 }, 6: { bytes: 3, pixels: 1 } };

export class St7789 {
    constructor() {
        /** Red, green and blue of 6 bits each. */
        this.memory = new Uint8Array(WIDTH * HEIGHT * 3);
        this.reset();
    }

    reset() {
        this.command = COMMAND.NOP;
        this.given = [];
        this.columns = [0, WIDTH - 1];
        this.rows = [0, HEIGHT - 1];
        this.madctl = 0;
        this.format = FORMATS[6];
        this.awake = false;
        this.on = false;
        this.inverted = false;
    }

    /** A byte on the bus, and whether the D/C line says that it is data. */
    byte(value, isData) {
        if (isData) {
            this.data(value);
        } else {
            this.start(value);
        }
    }

    start(command) {
        this.command = command;
        this.given = [];
        switch (command) {
            case COMMAND.SWRESET:
                this.reset();
                break;
            case COMMAND.SLPIN:
            case COMMAND.SLPOUT:
                this.awake = command === COMMAND.SLPOUT;
                break;
            case COMMAND.INVOFF:
            case COMMAND.INVON:
                this.inverted = command === COMMAND.INVON;
                break;
            case COMMAND.DISPOFF:
            case COMMAND.DISPON:
                this.on = command === COMMAND.DISPON;
                break;
            case COMMAND.RAMWR:
                this.at = [this.columns[0], this.rows[0]];
                break;
            case COMMAND.RAMWRC:
                this.at ??= [this.columns[0], this.rows[0]];
                break;
            case COMMAND.NOP:
            case COMMAND.NORON:
            case COMMAND.CASET:
            case COMMAND.RASET:
            case COMMAND.MADCTL:
            case COMMAND.COLMOD:
                break;
            default:
                throw new Error(`the panel is sent command 0x${command.toString(16)}, which is not known`);
        }
    }

    data(value) {
        const { given } = this;
        given.push(value);
        switch (this.command) {
            case COMMAND.CASET:
            case COMMAND.RASET:
                if (given.length === 4) {
                    const range = [(given[0] << 8) | given[1], (given[2] << 8) | given[3]];
                    this[this.command === COMMAND.CASET ? 'columns' : 'rows'] = range;
                }
                break;
            case COMMAND.MADCTL:
                this.madctl = value;
                break;
            case COMMAND.COLMOD:
                this.format = FORMATS[value & 7];
                if (this.format === undefined) {
                    throw new Error(`the panel is sent the pixel format 0x${value.toString(16)}, which is not known`);
                }
                break;
            case COMMAND.RAMWR:
            case COMMAND.RAMWRC:
                if (given.length === this.format.bytes) {
                    this.pixels(given);
                    this.given = [];
                }
                break;
            default:
                throw new Error(`the panel is sent data for command 0x${this.command.toString(16)}, which takes none`);
        }
    }

    pixels([a, b, c]) {
        if (this.format === FORMATS[5]) {
            this.pixel([wide(a >> 3), ((a & 7) << 3) | (b >> 5), wide(b & 31)]);
        } else if (this.format === FORMATS[6]) {
            this.pixel([a >> 2, b >> 2, c >> 2]);
        } else {
            const six = (nibble) => (nibble << 2) | (nibble >> 2);
            this.pixel([six(a >> 4), six(a & 15), six(b >> 4)]);
            this.pixel([six(b & 15), six(c >> 4), six(c & 15)]);
        }
    }

    /** To where the counters are, and on: along the columns, then to the next row, and from the end to the start again. */
    pixel(colour) {
        const [column, row] = this.at;
        const place = this.place(column, row);
        if (place !== undefined) {
            this.memory.set(colour, place);
        }
        if (column < this.columns[1]) {
            this.at = [column + 1, row];
        } else {
            this.at = [this.columns[0], row < this.rows[1] ? row + 1 : this.rows[0]];
        }
    }

    /** Where a column and a row of the window are in memory: MADCTL swaps and mirrors them. Nothing outside of it. */
    place(column, row) {
        let [x, y] = this.madctl & MADCTL.MV ? [row, column] : [column, row];
        x = this.madctl & MADCTL.MX ? WIDTH - 1 - x : x;
        y = this.madctl & MADCTL.MY ? HEIGHT - 1 - y : y;
        return x >= 0 && x < WIDTH && y >= 0 && y < HEIGHT ? (y * WIDTH + x) * 3 : undefined;
    }

    /**
     * The top left of the glass as RGB565 words, row by row, the low byte first: what one sees, which is black while it is
     * off. A glass that lies on its side is turned by a quarter, clockwise. It is an IPS panel: it shows the negative of
     * its memory unless it is told to invert it.
     */
    picture(width, height, onItsSide = false) {
        const bytes = new Uint8Array(width * height * 2);
        if (!this.on || !this.awake) {
            return bytes;
        }
        for (let at = 0; at < width * height; at++) {
            const [x, y] = [at % width, Math.floor(at / width)];
            const from = onItsSide ? (x * WIDTH + WIDTH - 1 - y) * 3 : (y * WIDTH + x) * 3;
            let [red, green, blue] = this.memory.subarray(from, from + 3);
            if (this.madctl & MADCTL.BGR) {
                [red, blue] = [blue, red];
            }
            const word = ((red >> 1) << 11) | (green << 5) | (blue >> 1);
            const seen = this.inverted ? word : ~word;
            bytes[2 * at] = seen & 0xff;
            bytes[2 * at + 1] = (seen >> 8) & 0xff;
        }
        return bytes;
    }
}

/** A channel of 5 bits in 6: the highest is repeated. */
function wide(channel) {
    return (channel << 1) | (channel >> 4);
}
