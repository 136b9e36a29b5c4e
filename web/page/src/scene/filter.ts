/** Which scenarios of a scene are meant: those of one body, and of a range of steps. */
import type { Body } from "../base/types";

/** First and last step. */
export type StepRange = readonly [number, number];

export interface SceneFilter {
    /** A body's name or number; empty: all bodies. */
    body: string;
    /** Null: all steps. */
    steps: StepRange | null;
}

export const noFilter: SceneFilter = { body: "", steps: null };

/** Reads `4-9` or `4`; null for any other text. */
export function readRange(text: string | null): StepRange | null {
    const found = /^(\d{1,9})(?:-(\d{1,9}))?$/.exec(text ?? "");
    const [from, to] = [Number(found?.[1]), Number(found?.[2] ?? found?.[1])];
    return found && from <= to ? [from, to] : null;
}

export function rangeText([from, to]: StepRange): string {
    return from === to ? String(from) : `${from}-${to}`;
}

/** Reads a link. Values that mean nothing are ignored. */
export function readFilter(query: URLSearchParams): SceneFilter {
    return { body: query.get("body") ?? "", steps: readRange(query.get("steps")) };
}

export function writeFilter({ body, steps }: SceneFilter): Record<string, string> {
    return { ...(body ? { body } : {}), ...(steps ? { steps: rangeText(steps) } : {}) };
}

export function isFiltered({ body, steps }: SceneFilter): boolean {
    return body !== "" || steps !== null;
}

/** Returns the number of the body with this name, or else with this number; -1 if there is none. */
export function bodyNumber(bodies: readonly Pick<Body, "name">[], wanted: string): number {
    const named = bodies.findIndex((one) => one.name === wanted);
    if (named >= 0 || !/^\d{1,9}$/.test(wanted)) {
        return named;
    }
    return Number(wanted) < bodies.length ? Number(wanted) : -1;
}
