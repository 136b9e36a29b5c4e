/** Classes, counts and distances of a job's scenarios, all of them or an even sample. */
import { getArray } from "../base/api";
import { severity, untested } from "../base/classes";
import { asksDistance, type Job, type Source } from "../base/types";

export const sampleSize = 4096;
/** Beyond so many scenarios the page asks for a sample of a folder: it keeps 21 bytes of each, 29 with distances. */
export const folderMax = 1 << 24;
/** So many scenarios a master gives at a time, and a folder the poses of so many. */
export const masterMax = 65536;

/**
 * What is known of scenarios: element i of `classes`, `counts` and `distances` is scenario `scenarioAt(i)`. Without
 * `chosen`, these are all of a range, or an even sample of it.
 */
export class Results {
    constructor(
        /** Scenarios [first, end) of the job. */
        readonly first: number,
        readonly end: number,
        readonly classes: Uint8Array,
        /** Pairs a scenario; 0 where unknown. */
        readonly counts: Uint32Array | null,
        /** The scenarios that were chosen. */
        private readonly chosen: Float64Array | null = null,
        /** NaN where there is none; null in a job that does not ask for distances. */
        readonly distances: Float64Array | null = null,
    ) {}

    get isExact(): boolean {
        return this.classes.length === this.end - this.first;
    }

    get isSample(): boolean {
        return !this.isExact && this.chosen === null;
    }

    scenarioAt(element: number): number {
        if (this.chosen) {
            return this.chosen[element];
        }
        return this.isExact
            ? this.first + element
            : this.first + Math.floor((element * (this.end - this.first)) / this.classes.length);
    }

    /** Returns the class of a scenario; undefined if it is not in the sample. */
    classOf(scenario: number): number | undefined {
        return this.isExact ? this.classes[scenario - this.first] : undefined;
    }

    /** Whether element `a` is worse than element `b`: by class, then by pairs, then if it is nearer. */
    isWorse(a: number, b: number): boolean {
        const difference =
            severity(this.classes[a]) - severity(this.classes[b]) || this.countAt(a) - this.countAt(b);
        return difference > 0 || (difference === 0 && (this.distanceAt(a) ?? Infinity) < (this.distanceAt(b) ?? Infinity));
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

    /** Returns the distance of an element; null without one. */
    distanceAt(element: number): number | null {
        const distance = this.distances?.[element] ?? Number.NaN;
        return Number.isNaN(distance) ? null : distance;
    }
}

function windowMax(source: Source): number {
    return source.kind === "folder" ? 1 << 20 : masterMax;
}

/** Up to so many scenarios are had exactly. */
export function exactMax(source: Source): number {
    return source.kind === "folder" ? folderMax : masterMax;
}

async function readAll<T extends Uint8Array | Uint32Array | Float64Array>(
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

export function pathOf(job: Job, what: string): string {
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
    if (!canBeExact(source, first, end)) {
        const topics = ["classes", "counts", ...(asksDistance(job) ? ["distances"] : [])];
        const [classes, counts, distances] = await Promise.all(
            topics.map((what) => getArray(`${pathOf(job, what)}?sample=${sampleSize}`, signal)),
        );
        return new Results(
            0,
            job.scenarios,
            classes.values as Uint8Array,
            counts.values as Uint32Array,
            null,
            (distances?.values as Float64Array | undefined) ?? null,
        );
    }
    return readExactly(job, first, end - first, windowMax(source), signal);
}

async function readExactly(job: Job, first: number, count: number, step: number, signal: AbortSignal): Promise<Results> {
    const into = new Uint8Array(count).fill(untested);
    const classes = await readAll(pathOf(job, "classes"), first, into, step, signal);
    const counts =
        job.level === "any" ? null : await readAll(pathOf(job, "counts"), first, new Uint32Array(count), step, signal);
    const distances = asksDistance(job)
        ? await readAll(pathOf(job, "distances"), first, new Float64Array(count).fill(Number.NaN), step, signal)
        : null;
    return new Results(first, first + count, classes, counts, null, distances);
}

/** Reads at most `masterMax` scenarios. */
export function readWindow(job: Job, first: number, count: number, signal: AbortSignal): Promise<Results> {
    return readExactly(job, first, count, masterMax, signal);
}

/** Whether scenarios [first, end) can be had exactly. */
export function canBeExact(source: Source, first: number, end: number): boolean {
    return end - first <= exactMax(source);
}
