/** A slice of a grid of which not all classes are at hand: read window by window. */
import type { Job } from "../base/types";
import type { Grid } from "./grid";
import { masterMax, readWindow, Results } from "./results";

/** A slice that lies in more windows than this is not read: each costs the master a reading. */
export const sliceWindowsMax = 16;

export interface Window {
    first: number;
    count: number;
}

/** Returns the scenarios of a slice, ascending; null if they are too many to read. */
export function scenariosOfSlice(grid: Grid, x: number, y: number, fixed: readonly number[]): Float64Array | null {
    const axes = [...new Set([x, y])].sort((a, b) => grid.strides[b] - grid.strides[a]);
    const size = axes.reduce((product, axis) => product * grid.axes[axis].count, 1);
    if (size > sliceWindowsMax * masterMax) {
        return null;
    }
    let scenarios = Float64Array.of(
        fixed.reduce((sum, number, axis) => sum + (axes.includes(axis) ? 0 : number * grid.strides[axis]), 0),
    );
    for (const axis of axes) {
        const [before, count, stride] = [scenarios, grid.axes[axis].count, grid.strides[axis]];
        scenarios = Float64Array.from(
            { length: before.length * count },
            (_, i) => before[Math.floor(i / count)] + (i % count) * stride,
        );
    }
    return scenarios;
}

/** Returns the fewest windows that hold ascending scenarios; null if they are more than are read. */
export function windowsOf(scenarios: Float64Array): Window[] | null {
    const windows: Window[] = [];
    for (const scenario of scenarios) {
        const last = windows.at(-1);
        if (last && scenario < last.first + masterMax) {
            last.count = scenario - last.first + 1;
        } else if (windows.length === sliceWindowsMax) {
            return null;
        } else {
            windows.push({ first: scenario, count: 1 });
        }
    }
    return windows;
}

/** Reads classes and counts of ascending scenarios that lie in these windows. */
export async function loadSlice(
    job: Job,
    scenarios: Float64Array,
    windows: readonly Window[],
    signal: AbortSignal,
): Promise<Results> {
    const classes = new Uint8Array(scenarios.length);
    const counts = new Uint32Array(scenarios.length);
    let at = 0;
    for (const { first, count } of windows) {
        const part = await readWindow(job, first, count, signal);
        for (; at < scenarios.length && scenarios[at] < first + count; ++at) {
            classes[at] = part.classes[scenarios[at] - first];
            counts[at] = part.counts?.[scenarios[at] - first] ?? 0;
        }
    }
    return new Results(0, job.scenarios, classes, counts, scenarios);
}
