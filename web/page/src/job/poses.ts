/** Coordinates of the poses of a file or of random ones: B in A's frame. */
import { getArray } from "../base/api";
import { compose, type Coordinate, coordinateOf, inverse, isAngle, placementKeys, shotKeys } from "../base/pose";
import { hasDirections, type Job, type Source } from "../base/types";
import { canBeExact, masterMax, pathOf, sampleSize } from "./results";

/** Up to this many scenarios all coordinates are kept, beyond it those that are drawn. */
const allKeysMax = 1 << 20;

/** Element i belongs to element i of the job's results. */
export type Coordinates = ReadonlyMap<Coordinate, Float64Array>;

/** Returns the coordinates that the poses of a job are shown by. */
export function keysOf(job: Job): readonly Coordinate[] {
    return hasDirections(job) ? shotKeys : placementKeys;
}

/** Adds the coordinates of rows of 12 or 24 numbers, the first of which becomes element `first`. */
export function addRows(into: Coordinates, rows: ArrayLike<number>, width: number, first: number): void {
    for (let i = 0; i * width < rows.length; ++i) {
        let [pose, at]: [ArrayLike<number>, number] = [rows, i * width];
        if (width === 24) {
            const both = Array.from({ length: 24 }, (_, k) => rows[24 * i + k]);
            [pose, at] = [compose(inverse(both.slice(0, 12)), both.slice(12)), 0];
        }
        for (const [key, values] of into) {
            values[first + i] = coordinateOf(key, pose, at);
        }
    }
}

function emptyCoordinates(keys: readonly Coordinate[], count: number): Coordinates {
    return new Map(keys.map((key) => [key, new Float64Array(count)]));
}

function widthOf(job: Job): number {
    return job.poses.of_both_bodies ? 24 : 12;
}

async function loadSample(job: Job, keys: readonly Coordinate[], signal: AbortSignal): Promise<Coordinates> {
    const size = Math.min(sampleSize, job.scenarios);
    const rows = await getArray(`${pathOf(job, "poses")}?sample=${size}`, signal);
    const sample = emptyCoordinates(keys, size);
    addRows(sample, rows.values, widthOf(job), 0);
    return sample;
}

export function boundsOf(values: Float64Array): [number, number] {
    let [low, high] = [Infinity, -Infinity];
    for (const value of values) {
        low = value < low ? value : low;
        high = value > high ? value : high;
    }
    return low < high ? [low, high] : [low - 0.5, low + 0.5];
}

/** Returns the two coordinates that differ most, lengths before angles. */
export function bestCoordinates(all: Coordinates): [Coordinate, Coordinate] {
    const spread = (key: Coordinate) => {
        const [low, high] = boundsOf(all.get(key) ?? new Float64Array(1));
        return (high - low) * (isAngle(key) ? 1e-6 : 1);
    };
    const keys = [...all.keys()];
    const [first, second] = keys.filter((key) => key !== "distance").sort((a, b) => spread(b) - spread(a));
    return keys.indexOf(first) < keys.indexOf(second) ? [first, second] : [second, first];
}

/** Chooses what to draw of a long job, by an even sample of its poses. */
export async function chooseCoordinates(job: Job, signal: AbortSignal): Promise<[Coordinate, Coordinate]> {
    return bestCoordinates(await loadSample(job, keysOf(job), signal));
}

/** Whether all coordinates are loaded at once, rather than those that are drawn. */
export function keepsAllCoordinates(source: Source, job: Job): boolean {
    return job.scenarios <= allKeysMax || !canBeExact(source, 0, job.scenarios);
}

/**
 * Loads coordinates of the scenarios of which `loadResults` gives the classes: all, window by window,
 * or the even sample. `tell` hears which share is there.
 */
export async function loadCoordinates(
    source: Source,
    job: Job,
    keys: readonly Coordinate[],
    signal: AbortSignal,
    tell: (share: number) => void,
): Promise<Coordinates> {
    const total = job.scenarios;
    if (!canBeExact(source, 0, total)) {
        return loadSample(job, keys, signal);
    }
    const all = emptyCoordinates(keys, total);
    for (let first = 0; first < total; first += masterMax) {
        const count = Math.min(masterMax, total - first);
        const rows = await getArray(`${pathOf(job, "poses")}?first=${first}&count=${count}`, signal);
        addRows(all, rows.values, widthOf(job), first);
        tell((first + count) / total);
    }
    return all;
}
