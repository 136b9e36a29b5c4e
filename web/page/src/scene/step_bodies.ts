/** One step of a scene: its scenarios, and where the bodies that take part in them are. */
import { getArray } from "../base/api";
import { asksMotion, type Body, type Job, type MotionKey, type Pose } from "../base/types";
import { poseBetween } from "../motion/motion";
import type { Steps } from "./steps";

/** So many scenarios of a step are read. */
const readMax = 65536;
/** Above so many other bodies, or triangles in all, boxes are drawn instead of meshes. */
export const othersMax = 200;
export const drawnTrianglesMax = 8_000_000;

/** Where a body is in the world, at a time of the step from 0 to 1. */
export type PoseAt = (tau: number) => Pose;

export interface StepBodies {
    step: number;
    /** The step's first scenario. */
    first: number;
    /** Rows of step, body A, body B: one for each scenario. */
    rows: ArrayLike<number>;
    /** The class of each scenario. */
    classes: ArrayLike<number>;
    /** Where each body is that takes part, by its number. Bodies move in a step of motions only. */
    poses: ReadonlyMap<number, PoseAt>;
    /** Whether the step has more scenarios than were read. */
    isCut: boolean;
}

/** Calls `take` with each body that rows of step, A, B name, once, with the place of the row and the side. */
function forEachBody(rows: ArrayLike<number>, take: (body: number, place: number, side: number) => void): void {
    const known = new Set<number>();
    for (let i = 0; 3 * i < rows.length; ++i) {
        for (const side of [0, 1]) {
            const body = rows[3 * i + 1 + side];
            if (!known.has(body)) {
                known.add(body);
                take(body, i, side);
            }
        }
    }
}

/** Returns the poses of bodies from rows of step, A, B and of 24 numbers: the poses of A and of B. */
export function posesOf(rows: ArrayLike<number>, numbers: ArrayLike<number>): Map<number, PoseAt> {
    const poses = new Map<number, PoseAt>();
    forEachBody(rows, (body, place, side) => {
        const pose = Array.from({ length: 12 }, (_, k) => numbers[24 * place + 12 * side + k]);
        poses.set(body, () => pose);
    });
    return poses;
}

/**
 * Returns the poses of bodies on their way, from rows of step, A, B and of 28 numbers: the keys of A and of B at
 * the step's begin, then at its end.
 */
export function movingPosesOf(rows: ArrayLike<number>, numbers: ArrayLike<number>): Map<number, PoseAt> {
    const poses = new Map<number, PoseAt>();
    forEachBody(rows, (body, place, side) => {
        const key = (end: number): MotionKey =>
            Array.from({ length: 7 }, (_, k) => numbers[28 * place + 14 * end + 7 * side + k]);
        const [from, to] = [key(0), key(1)];
        poses.set(body, (tau) => poseBetween(from, to, tau));
    });
    return poses;
}

function chosen(job: Job, what: string, first: number, count: number, signal: AbortSignal) {
    return getArray(`jobs/${encodeURIComponent(job.job)}/${what}?first=${first}&count=${count}`, signal);
}

/** Reads the scenarios [first, end) of one step, where those of all steps are not known. */
export async function readRange(job: Job, step: number, signal: AbortSignal): Promise<[number, number]> {
    const count = Math.min(2, (job.steps ?? 0) - step);
    const { values } = await chosen(job, "steps", step, count, signal);
    return [values[0], count === 2 ? values[2] : job.scenarios];
}

/** Loads a step; `steps` are null where they are not known. */
export async function loadStep(job: Job, steps: Steps | null, step: number, signal: AbortSignal): Promise<StepBodies> {
    const [first, end] = steps?.rangeOf(step) ?? (await readRange(job, step, signal));
    const count = Math.min(readMax, end - first);
    const moves = asksMotion(job);
    const [rows, classes, poses] = await Promise.all(
        ["bodies", "classes", moves ? "keys" : "poses"].map((what) => chosen(job, what, first, count, signal)),
    );
    return {
        step,
        first,
        rows: rows.values,
        classes: classes.values,
        poses: (moves ? movingPosesOf : posesOf)(rows.values, poses.values),
        isCut: count < end - first,
    };
}

/**
 * Returns the place of the row that is wanted most: of this pair, else of the wanted body, else the first.
 */
export function bestRow(rows: ArrayLike<number>, [a, b]: readonly [number, number], wanted: number): number {
    let ofBody = -1;
    for (let i = 0; 3 * i < rows.length; ++i) {
        const [one, other] = [rows[3 * i + 1], rows[3 * i + 2]];
        if (one === a && other === b) {
            return i;
        }
        if (ofBody < 0 && (one === wanted || other === wanted)) {
            ofBody = i;
        }
    }
    return Math.max(0, ofBody);
}

/** Returns the scenario of a step that is opened when one comes from a scenario of `pair`. */
export async function scenarioOfStep(
    job: Job,
    steps: Steps,
    step: number,
    pair: readonly [number, number],
    wanted: number,
    signal: AbortSignal,
): Promise<number> {
    const [first, end] = steps.rangeOf(step);
    const rows = await chosen(job, "bodies", first, Math.min(readMax, end - first), signal);
    return first + bestRow(rows.values, pair, wanted);
}

/** Returns the bodies of a step that are not of the pair, in rising order. */
export function othersOf({ poses }: Pick<StepBodies, "poses">, pair: readonly [number, number]): number[] {
    return [...poses.keys()].filter((body) => !pair.includes(body)).sort((a, b) => a - b);
}

export type OthersForm = "meshes" | "boxes" | "none";

/** Returns how other bodies are drawn beside a pair. */
export function formOf(
    bodies: readonly Pick<Body, "triangles">[],
    pair: readonly [number, number],
    others: readonly number[],
): OthersForm {
    if (others.length === 0) {
        return "none";
    }
    const triangles = [...pair, ...others].reduce((sum, body) => sum + bodies[body].triangles, 0);
    return others.length > othersMax || triangles > drawnTrianglesMax ? "boxes" : "meshes";
}
