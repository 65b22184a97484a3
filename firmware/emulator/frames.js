// Which frame of which scene an image is at, how long each takes, and when the panel shows it.

export class Frames {
    /** So many scenes, and frames of each; `show` gets the numbers of a scene and of its frame once the panel shows it. */
    constructor(scenes, frames, show) {
        Object.assign(this, { scenes, frames, show });
        [this.scene, this.frame] = [0, -1];
        /** Scene, frame, and cycles from its start to the next one's. */
        this.rows = [];
        this.unseen = [];
    }

    /** A frame starts: the one before it is done, but its last rows may still be on the bus. */
    start(cycles) {
        if (this.frame >= 0) {
            this.unseen.push([this.scene, this.frame]);
            this.rows.push([this.scene, this.frame, cycles - this.started]);
        }
        this.started = cycles;
        this.frame++;
        if (this.frame === this.frames) {
            [this.scene, this.frame] = [this.scene + 1, 0];
        }
    }

    /** The panel is about to get a command: it has all rows before. */
    command() {
        this.unseen.splice(0).forEach(([scene, frame]) => this.show(scene, frame));
    }

    /** Whether the scene ends with this frame. */
    get isLast() {
        return this.frame === this.frames - 1;
    }

    /** Whether all were shown. */
    get areOver() {
        return this.scene >= this.scenes && this.unseen.length === 0;
    }
}
