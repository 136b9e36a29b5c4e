/** Classes, counts and poses of a job's scenarios, all of them or an even sample. */
import { getArray } from "../base/api";
import { severity, untested } from "../base/classes";
import type { Job, Source } from "../base/types";

export const sampleSize = 4096;
/** Beyond these the page asks for a sample. */
const classesMax = 1 << 24;
const countsMax = 1 << 22;
const posesMax = 1 << 18;
const masterMax = 65536;

/**
 * What is known of a run of scenarios: element i of `classes` and `counts` is scenario
 * `scenarioAt(i)`.
 */
export class Results {
    constructor(
        /** Scenarios [first, end) of the job. */
        readonly first: number,
        readonly end: number,
        readonly classes: Uint8Array,
        /** Pairs a scenario; 0 where unknown. */
        readonly counts: Uint32Array | null,
    ) {}

    get isExact(): boolean {
        return this.classes.length === this.end - this.first;
    }

    scenarioAt(element: number): number {
        return this.isExact
            ? this.first + element
            : this.first + Math.floor((element * (this.end - this.first)) / this.classes.length);
    }

    /** Returns the class of a scenario; undefined if it is not in the sample. */
    classOf(scenario: number): number | undefined {
        return this.isExact ? this.classes[scenario - this.first] : undefined;
    }

    /** Whether element `a` is worse than element `b`: by class, then by pairs. */
    isWorse(a: number, b: number): boolean {
        const difference = severity(this.classes[a]) - severity(this.classes[b]);
        return difference > 0 || (difference === 0 && this.countAt(a) > this.countAt(b));
    }

    /** Returns the worst scenario of all; 0 if there is none. */
    worst(): number {
        let worst = 0;
        for (let i = 1; i < this.classes.length; ++i) {
            worst = this.isWorse(i, worst) ? i : worst;
        }
        return this.classes.length === 0 ? 0 : this.scenarioAt(worst);
    }

    countAt(element: number): number {
        return this.counts?.[element] ?? 0;
    }
}

function windowMax(source: Source): number {
    return source.kind === "folder" ? 1 << 20 : masterMax;
}

function exactMax(source: Source, folderMax: number): number {
    return source.kind === "folder" ? folderMax : masterMax;
}

async function readAll<T extends Uint8Array | Uint32Array>(
    path: string,
    first: number,
    into: T,
    step: number,
    signal: AbortSignal,
): Promise<T> {
    for (let at = 0; at < into.length; at += step) {
        const count = Math.min(step, into.length - at);
        const part = await getArray(`${path}?first=${first + at}&count=${count}`, signal);
        into.set(part.values, at);
    }
    return into;
}

function pathOf(job: Job, what: string): string {
    return `jobs/${encodeURIComponent(job.job)}/${what}`;
}

/**
 * Loads scenarios [first, end): exactly as far as the source gives that many, else a sample of the
 * whole job.
 */
export async function loadResults(
    source: Source,
    job: Job,
    first: number,
    end: number,
    signal: AbortSignal,
): Promise<Results> {
    const count = end - first;
    const step = windowMax(source);
    if (count > exactMax(source, classesMax)) {
        const [classes, counts] = await Promise.all(
            ["classes", "counts"].map((what) => getArray(`${pathOf(job, what)}?sample=${sampleSize}`, signal)),
        );
        return new Results(0, job.scenarios, classes.values as Uint8Array, counts.values as Uint32Array);
    }
    const classes = await readAll(
        pathOf(job, "classes"),
        first,
        new Uint8Array(count).fill(untested),
        step,
        signal,
    );
    const hasCounts = job.level !== "any" && count <= exactMax(source, countsMax);
    const counts = hasCounts
        ? await readAll(pathOf(job, "counts"), first, new Uint32Array(count), step, signal)
        : null;
    return new Results(first, end, classes, counts);
}

/** Whether scenarios [first, end) can be had exactly. */
export function canBeExact(source: Source, first: number, end: number): boolean {
    return end - first <= exactMax(source, classesMax);
}

/** Poses of scenarios: row i of `values` (12 or 24 doubles) is scenario `scenarios[i]`. */
export interface PoseRows {
    scenarios: Float64Array;
    values: Float64Array;
    width: number;
    isSample: boolean;
}

/** Loads the poses of a file or of random ones: all, or a sample. */
export async function loadPoses(job: Job, signal: AbortSignal): Promise<PoseRows> {
    const width = job.poses.of_both_bodies ? 24 : 12;
    const total = job.scenarios;
    if (total > posesMax) {
        const array = await getArray(`${pathOf(job, "poses")}?sample=${sampleSize}`, signal);
        const size = array.shape[0];
        const scenarios = Float64Array.from({ length: size }, (_, i) => Math.floor((i * total) / size));
        return { scenarios, values: array.values as Float64Array, width, isSample: true };
    }
    const values = new Float64Array(width * total);
    for (let first = 0; first < total; first += masterMax) {
        const count = Math.min(masterMax, total - first);
        const part = await getArray(`${pathOf(job, "poses")}?first=${first}&count=${count}`, signal);
        values.set(part.values, width * first);
    }
    const scenarios = Float64Array.from({ length: total }, (_, i) => i);
    return { scenarios, values, width, isSample: false };
}
