/** A motion: the paths of both bodies between two keys, and what is proven of its time. */
import { apply, inverse, relativePose } from "../base/pose";
import type { Motion, MotionKey, Pose, Scenario, Vec3 } from "../base/types";

/** At how many times, from begin to end, a path is drawn at least. */
const drawnTimes = 65;

type Quaternion = readonly [number, number, number, number];

function between(from: number, to: number, tau: number): number {
    return (1 - tau) * from + tau * to;
}

/** Returns the rows of [R t] for a quaternion w, x, y, z, which may have any length but 0. */
function poseOf([w, x, y, z]: Quaternion, [tx, ty, tz]: Vec3): Pose {
    const s = 2 / (w * w + x * x + y * y + z * z);
    return [
        ...[1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y), tx],
        ...[s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x), ty],
        ...[s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y), tz],
    ];
}

/**
 * Returns the pose of a body at tau between two keys, the short way round, as
 * common/motion/body_path.hpp has it: quaternion and position are linear in tau.
 */
export function poseBetween(from: MotionKey, to: MotionKey, tau: number): Pose {
    const product = from.slice(0, 4).reduce((sum, value, i) => sum + value * to[i], 0);
    const sign = product > 0 ? 1 : -1;
    const at = (i: number) => between(from[i], i < 4 ? sign * to[i] : to[i], tau);
    return poseOf([at(0), at(1), at(2), at(3)], [at(4), at(5), at(6)]);
}

/** Returns the poses of both bodies in the world at tau. */
export function posesAt({ from, to }: Pick<Motion, "from" | "to">, tau: number): { pose_a: Pose; pose_b: Pose } {
    return { pose_a: poseBetween(from.a, to.a, tau), pose_b: poseBetween(from.b, to.b, tau) };
}

/** Returns where B's origin is in A's frame at tau. */
function originAt({ from, to }: Pick<Motion, "from" | "to">, tau: number): Vec3 {
    const at = (i: number) => between(from.b[i], to.b[i], tau);
    return apply(inverse(poseBetween(from.a, to.a, tau)), [at(4), at(5), at(6)]);
}

/** Returns tau of an instant, exactly. */
export function tauOf(motion: Pick<Motion, "depth">, instant: number): number {
    return instant / 2 ** motion.depth;
}

/** Returns tau of the event, or null. */
export function eventOf(motion: Pick<Motion, "depth" | "event">): number | null {
    return motion.event === null ? null : tauOf(motion, motion.event);
}

/** Returns the time that is shown first: that of the event, or the begin. */
export function startOf(motion: Pick<Motion, "depth" | "event">): number {
    return eventOf(motion) ?? 0;
}

type Posed = Pick<Scenario, "pose_a" | "pose_b" | "motion">;

/** Returns the time of the motion that is shown; null stands for that of the event. Without a motion it is 0. */
export function shownTime({ motion }: Pick<Scenario, "motion">, tau: number | null): number {
    return motion ? (tau ?? startOf(motion)) : 0;
}

/** Returns the poses in the world that are shown; null stands for the time of the event. */
export function shownPoses({ pose_a, pose_b, motion }: Posed, tau: number | null): { pose_a: Pose; pose_b: Pose } {
    return motion ? posesAt(motion, shownTime({ motion }, tau)) : { pose_a, pose_b };
}

/** As `shownPoses`, of B in A's frame. */
export function shownPose(scenario: Posed, tau: number | null): Pose {
    return relativePose(shownPoses(scenario, tau));
}

/**
 * Whether the event of a motion is that the bodies are near: they are inside one another only without
 * contact, so that the event of a motion of class inside is one of a clearance.
 */
export function isNearEvent({ class: kind }: Pick<Scenario, "class">): boolean {
    return kind === "near" || kind === "inside";
}

/** Whether a scenario's contacts are those of the shown time. */
export function hasContactsAt({ motion }: Posed, tau: number | null): boolean {
    return !motion || tau === null || tau === startOf(motion);
}

/** What is known of a time: free, open, with the event, or nothing since the search ended before. */
export type Knowledge = "free" | "open" | "event" | "unknown";

/** A part of a motion's time. With the event it may be an instant. */
export interface Interval {
    from: number;
    to: number;
    kind: Knowledge;
}

/** Returns the parts of the time in order, from 0 to 1. */
export function intervalsOf(motion: Pick<Motion, "depth" | "runs">): Interval[] {
    const found: Interval[] = [];
    const add = (first: number, last: number, kind: Knowledge) => {
        if (first < last || kind === "event") {
            found.push({ from: tauOf(motion, first), to: tauOf(motion, last), kind });
        }
    };
    for (const { state, first, count, event_first, event_last } of motion.runs) {
        if (event_first === null || event_last === null) {
            add(first, first + count, state);
            continue;
        }
        add(first, event_first, "open");
        add(event_first, event_last, "event");
        add(event_last, first + count, "open");
    }
    const last = motion.runs.at(-1);
    add(last ? last.first + last.count : 0, 2 ** motion.depth, "unknown");
    return found;
}

/** Returns what is known of a time. Where parts meet, the event counts, then what is open. */
export function knowledgeAt(intervals: readonly Interval[], tau: number): Knowledge {
    const kinds = intervals.filter(({ from, to }) => from <= tau && tau <= to).map(({ kind }) => kind);
    return (["event", "open", "free"] as const).find((kind) => kinds.includes(kind)) ?? "unknown";
}

/** A piece of the path that B's origin takes in A's frame. */
export interface PathPiece {
    points: Vec3[];
    kind: Knowledge;
}

/** Returns the path by parts of the time, in A's frame. An instant is one point. */
export function pathOf(motion: Motion): PathPiece[] {
    return intervalsOf(motion).map(({ from, to, kind }) => {
        const steps = from === to ? 0 : Math.max(1, Math.ceil((to - from) * (drawnTimes - 1)));
        const points = Array.from({ length: steps + 1 }, (_, i) =>
            originAt(motion, steps === 0 ? from : between(from, to, i / steps)),
        );
        return { points, kind };
    });
}

function shortTime(tau: number): string {
    return String(Number(tau.toPrecision(6)));
}

/** Says what is known of the whole motion, in shares of its time. */
export function motionText(motion: Motion, isNear: boolean): string {
    const [t0, t1] = [motion.t0, motion.t1].map((instant) => shortTime(tauOf(motion, instant)));
    const said = isNear ? "near" : "in contact";
    if (motion.until === "free" && motion.end === "free") {
        return `free from ${t1} of the way on`;
    }
    if (motion.end === "limit" && motion.event === null) {
        return `known up to ${t1} of the way`;
    }
    if (motion.event === null) {
        return motion.runs.some(({ state }) => state === "open") ? "not decided where open" : "free throughout";
    }
    if (motion.until === "free") {
        return `${said} at ${t0} of the way, not free up to ${t1}`;
    }
    return t0 === t1 ? `${said} at ${t1} of the way` : `first ${said} between ${t0} and ${t1} of the way`;
}

/** Says what is known of one time, and whether contacts are drawn. */
export function timeText(motion: Motion, isNear: boolean, tau: number): string {
    const kind = knowledgeAt(intervalsOf(motion), tau);
    const known = {
        free: "free",
        open: "open: not decided",
        event: isNear ? "near" : "in contact",
        unknown: "not searched",
    }[kind];
    const event = eventOf(motion);
    const drawn =
        event === null
            ? "no contacts to draw"
            : tau === event
              ? "the event, contacts are drawn"
              : "contacts are drawn at the event only";
    return `at ${shortTime(tau)} of the way: ${known}; ${drawn}`;
}
