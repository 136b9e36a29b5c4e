/** The steps of a scene: which scenarios belong to each. */
import { getArray } from "../base/api";
import type { Job } from "../base/types";

/** So many steps the server gives at a time. */
const windowMax = 65536;
/** A scene of more steps is shown without them. */
export const stepsMax = 1 << 20;

export class Steps {
    constructor(
        /** The first scenario of each step; without one, that of the next step. */
        private readonly firsts: ArrayLike<number>,
        private readonly times: ArrayLike<number>,
        /** How many scenarios all steps have. */
        private readonly scenarios: number,
    ) {}

    get count(): number {
        return this.firsts.length;
    }

    timeOf(step: number): number {
        return this.times[step];
    }

    /** Returns the scenarios [first, end) of the steps `from` to `to`. */
    rangeOf(from: number, to = from): [number, number] {
        return [this.firsts[from], to + 1 < this.count ? this.firsts[to + 1] : this.scenarios];
    }

    hasScenarios(step: number): boolean {
        const [first, end] = this.rangeOf(step);
        return first < end;
    }

    /**
     * Returns the nearest step with scenarios, from `step` on upwards (1) or downwards (-1), else on the
     * other side; -1 if no step has any.
     */
    nearest(step: number, by: 1 | -1): number {
        const inside = Math.min(this.count - 1, Math.max(0, step));
        const search = (from: number, way: number) => {
            for (let at = from; at >= 0 && at < this.count; at += way) {
                if (this.hasScenarios(at)) {
                    return at;
                }
            }
            return -1;
        };
        const found = search(inside, by);
        return found >= 0 ? found : search(inside, -by);
    }

    /** Returns steps that exist, of a range that may go beyond the last. */
    within([from, to]: readonly [number, number]): [number, number] {
        const last = this.count - 1;
        return [Math.min(from, last), Math.min(to, last)];
    }
}

let last: { job: string; steps: Promise<Steps | null> } | null = null;

async function load(job: Job, count: number): Promise<Steps> {
    const firsts = new Float64Array(count);
    const times = new Float64Array(count);
    for (let at = 0; at < count; at += windowMax) {
        const size = Math.min(windowMax, count - at);
        const rows = await getArray(`jobs/${encodeURIComponent(job.job)}/steps?first=${at}&count=${size}`);
        for (let i = 0; i < size; ++i) {
            firsts[at + i] = rows.values[2 * i];
            times[at + i] = rows.values[2 * i + 1];
        }
    }
    return new Steps(firsts, times, job.scenarios);
}

/** Loads the steps of a job; null if it is no scene, or has too many. Those of the last job are kept. */
export function loadSteps(job: Job): Promise<Steps | null> {
    if (last?.job !== job.job) {
        const count = job.steps ?? 0;
        const steps = count === 0 || count > stepsMax ? Promise.resolve(null) : load(job, count);
        last = { job: job.job, steps };
        steps.catch(() => {
            last = null; // Asked again when a screen opens again.
        });
    }
    return last.steps;
}
