/** The two bodies and the step of a job's scenarios, and what is counted of them. */
import { getArray } from "../base/api";
import { isContact, near } from "../base/classes";
import type { Job } from "../base/types";
import { masterMax, pathOf, Results, sampleSize } from "../job/results";
import type { StepRange } from "./filter";

/** Up to so many scenarios all rows are read, beyond it those of an even sample. */
const rowsMax = 1 << 20;

export class SceneRows {
    constructor(
        readonly results: Results,
        /** Rows of step, body A, body B. */
        private readonly rows: ArrayLike<number>,
        /** How many scenarios the job has. */
        private readonly total: number,
    ) {}

    get count(): number {
        return this.rows.length / 3;
    }

    /** Whether these are the rows of all scenarios rather than of a sample. */
    get areAll(): boolean {
        return this.count === this.total;
    }

    stepOf(row: number): number {
        return this.rows[3 * row];
    }

    pairOf(row: number): [number, number] {
        return [this.rows[3 * row + 1], this.rows[3 * row + 2]];
    }

    /** Returns the element of the results that a row is about. */
    elementOf(row: number): number {
        const isSameSample = this.count === this.results.classes.length;
        return isSameSample ? row : Math.floor((row * this.total) / this.count);
    }

    classOf(row: number): number {
        return this.results.classes[this.elementOf(row)];
    }

    /** Returns the rows of a body, -1 for all, in a range of steps. */
    chosen(body: number, steps: StepRange | null): number[] {
        return Array.from({ length: this.count }, (_, row) => row).filter((row) => {
            const step = this.stepOf(row);
            const isInside = !steps || (step >= steps[0] && step <= steps[1]);
            return isInside && (body < 0 || this.pairOf(row).includes(body));
        });
    }

    /** Returns the results of these rows alone. */
    resultsOf(rows: readonly number[]): Results {
        const { results } = this;
        const elements = rows.map((row) => this.elementOf(row));
        const counts = results.counts;
        const distances = results.distances;
        return new Results(
            results.first,
            results.end,
            Uint8Array.from(elements, (one) => results.classes[one]),
            counts && Uint32Array.from(elements, (one) => counts[one]),
            Float64Array.from(elements, (one) => results.scenarioAt(one)),
            distances && Float64Array.from(elements, (one) => distances[one]),
        );
    }
}

/** How often a body takes part. */
export interface BodySum {
    body: number;
    scenarios: number;
    contacts: number;
    near: number;
    /** The element of its worst scenario; -1 without one. */
    worst: number;
}

/** Returns the sums of all bodies, by their numbers. */
export function sumsByBody(rows: SceneRows, bodies: number): BodySum[] {
    const sums = Array.from({ length: bodies }, (_, body): BodySum => ({ body, scenarios: 0, contacts: 0, near: 0, worst: -1 }));
    for (let row = 0; row < rows.count; ++row) {
        const [kind, element] = [rows.classOf(row), rows.elementOf(row)];
        for (const body of rows.pairOf(row)) {
            const sum = sums[body];
            sum.scenarios += 1;
            sum.contacts += isContact(kind) ? 1 : 0;
            sum.near += kind === near ? 1 : 0;
            sum.worst = sum.worst < 0 || rows.results.isWorse(element, sum.worst) ? element : sum.worst;
        }
    }
    return sums;
}

/** Returns at most `count` of the bodies whose names hold a text: most contacts first, then near, then scenarios. */
export function topBodies(sums: readonly BodySum[], names: readonly string[], text: string, count: number): BodySum[] {
    const wanted = text.toLowerCase();
    const order = (a: BodySum, b: BodySum) =>
        b.contacts - a.contacts || b.near - a.near || b.scenarios - a.scenarios || a.body - b.body;
    return sums.filter(({ body }) => names[body].toLowerCase().includes(wanted)).sort(order).slice(0, count);
}

/** Loads the rows of the scenarios that `results` has, all of them if there are not too many. */
export async function loadRows(job: Job, results: Results, signal: AbortSignal): Promise<SceneRows> {
    const path = pathOf(job, "bodies");
    const total = job.scenarios;
    if (!results.isExact || total > rowsMax) {
        const sample = await getArray(`${path}?sample=${sampleSize}`, signal);
        return new SceneRows(results, sample.values, total);
    }
    const rows = new Uint32Array(3 * total);
    for (let first = 0; first < total; first += masterMax) {
        const count = Math.min(masterMax, total - first);
        const part = await getArray(`${path}?first=${first}&count=${count}`, signal);
        rows.set(part.values as Uint32Array, 3 * first);
    }
    return new SceneRows(results, rows, total);
}
