/** The parts of a body, as the groups of a job name them: named parts, or connected pieces. */
import { getArray, getJson } from "./api";

export class BodyParts {
    constructor(
        readonly names: readonly string[],
        /** Rows of first triangle and number of the part, in rising order from triangle 0. */
        private readonly runs: ArrayLike<number>,
    ) {}

    /** Returns the run of consecutive triangles that holds a triangle. */
    private runOf(triangle: number): number {
        let low = 0;
        let high = this.runs.length / 2;
        while (high - low > 1) {
            const middle = (low + high) >> 1;
            if (this.runs[2 * middle] <= triangle) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return low;
    }

    /** Returns the number of a triangle's part. */
    partOf(triangle: number): number {
        return this.runs[2 * this.runOf(triangle) + 1];
    }

    nameOf(triangle: number): string {
        return this.names[this.partOf(triangle)] ?? "";
    }

    /** Whether a triangle is of the part with this name; an empty name stands for all. */
    isOf(triangle: number, name: string): boolean {
        return name === "" || this.nameOf(triangle) === name;
    }

    /** Returns the number of a triangle within its part. */
    placeOf(triangle: number): number {
        const run = this.runOf(triangle);
        let place = triangle - this.runs[2 * run];
        for (let i = 0; i < run; ++i) {
            if (this.runs[2 * i + 1] === this.runs[2 * run + 1]) {
                place += this.runs[2 * i + 2] - this.runs[2 * i];
            }
        }
        return place;
    }
}

/** Gets which parts of a body are closed by themselves: a byte each, 0 or 1. */
export async function getClosedParts(job: string, body: number): Promise<Uint8Array> {
    const closed = await getArray(`jobs/${encodeURIComponent(job)}/parts/${body}/closed`);
    return closed.values as Uint8Array;
}

export async function getParts(job: string, body: number): Promise<BodyParts> {
    const path = `jobs/${encodeURIComponent(job)}/parts/${body}`;
    const [runs, names] = await Promise.all([getArray(path), getJson<string[]>(`${path}/names`)]);
    return new BodyParts(names, runs.values);
}
