/** All that is seen in the viewer, as the query of a link. */
import { type PartNames, readPart, writePart } from "../base/part_name";
import { isFiltered, noFilter, readFilter, type SceneFilter, writeFilter } from "../scene/filter";

export type Mode = "contacts" | "heat";
export type Ghost = "a" | "b" | "none";
/** What a search for the next scenario finds. */
export type Seek = "contact" | "near" | "either";
export type ClipAxis = "x" | "y" | "z";

export interface Clip {
    axis: ClipAxis;
    /** Where the plane cuts the axis, in A's frame; what lies beyond is hidden. */
    at: number;
}

export interface Pick {
    body: 0 | 1;
    triangle: number;
}

export interface ViewState {
    mode: Mode;
    ghost: Ghost;
    throughWalls: boolean;
    lines: boolean;
    clip: Clip | null;
    /** Eye and target, six numbers in A's frame; null: all is fitted into the view. */
    camera: number[] | null;
    /** The parts of A and B whose contacts are shown; empty: all. */
    partA: string;
    partB: string;
    pick: Pick | null;
    seek: Seek;
    /** Of each line, only the first hit that crosses is shown. */
    onlyFirst: boolean;
    /** The time in a motion that is shown, 0 to 1; null: that of the event. */
    tau: number | null;
    /** Whether the other bodies of a scene's step are drawn. */
    others: boolean;
    /** Which scenarios of a scene next and previous find. */
    filter: SceneFilter;
}

export const startState: ViewState = {
    mode: "contacts",
    ghost: "b",
    throughWalls: true,
    lines: true,
    clip: null,
    camera: null,
    partA: "",
    partB: "",
    pick: null,
    seek: "contact",
    onlyFirst: false,
    tau: null,
    others: true,
    filter: noFilter,
};

function numbersOf(text: string | null, count: number): number[] | null {
    const numbers = (text ?? "").split(",").map(Number);
    return numbers.length === count && numbers.every(Number.isFinite) && text ? numbers : null;
}

function readClip(text: string | null): Clip | null {
    const found = /^([xyz]):(-?[\d.]+(?:e[-+]?\d+)?)$/i.exec(text ?? "");
    return found && Number.isFinite(Number(found[2]))
        ? { axis: found[1] as ClipAxis, at: Number(found[2]) }
        : null;
}

function readPick(text: string | null): Pick | null {
    const found = /^([ab]):(\d+)$/.exec(text ?? "");
    return found ? { body: found[1] === "a" ? 0 : 1, triangle: Number(found[2]) } : null;
}

function readTau(text: string | null): number | null {
    const tau = Number(text);
    return text && tau >= 0 && tau <= 1 ? tau : null;
}

/** Reads the parts of A and B; of two that name no body, the second is of B. */
export function readParts(query: URLSearchParams, names: PartNames): [string, string] {
    const parts: [string, string] = ["", ""];
    for (const text of [query.get("part"), query.get("with")]) {
        if (text) {
            const { body, part } = readPart(text, { ...names, hasA: (one) => parts[0] === "" && names.hasA(one) });
            parts[body] = part;
        }
    }
    return parts;
}

/** Whether two states differ in the camera at most. */
export function isSameView(one: ViewState, other: ViewState): boolean {
    return Object.entries(one).every(
        ([key, value]) => key === "camera" || value === other[key as keyof ViewState],
    );
}

/** Reads a link. Values that mean nothing are ignored. */
export function readState(query: URLSearchParams, names: PartNames): ViewState {
    const ghost = query.get("ghost");
    const seek = query.get("seek");
    const [partA, partB] = readParts(query, names);
    return {
        mode: query.get("mode") === "heat" ? "heat" : "contacts",
        ghost: ghost === "a" || ghost === "none" ? ghost : "b",
        throughWalls: query.get("walls") !== "0",
        lines: query.get("lines") !== "0",
        clip: readClip(query.get("clip")),
        camera: numbersOf(query.get("cam"), 6),
        partA,
        partB,
        pick: readPick(query.get("pick")),
        seek: seek === "near" || seek === "either" ? seek : "contact",
        onlyFirst: query.get("first") === "1",
        tau: readTau(query.get("tau")),
        others: query.get("others") !== "0",
        filter: readFilter(query),
    };
}

function brief(value: number): string {
    return String(Number(value.toPrecision(6)));
}

/** Writes what differs from the start, so that plain views have plain links. */
export function writeState(state: ViewState, bodies: readonly [string, string]): Record<string, string> {
    const query: Record<string, string> = {};
    if (state.mode !== startState.mode) {
        query.mode = state.mode;
    }
    if (state.camera) {
        query.cam = state.camera.map(brief).join(",");
    }
    if (state.ghost !== startState.ghost) {
        query.ghost = state.ghost;
    }
    if (!state.throughWalls) {
        query.walls = "0";
    }
    if (!state.lines) {
        query.lines = "0";
    }
    if (state.partA) {
        query.part = writePart(0, state.partA, bodies);
    }
    if (state.partB) {
        query[state.partA ? "with" : "part"] = writePart(1, state.partB, bodies);
    }
    if (state.clip) {
        query.clip = `${state.clip.axis}:${brief(state.clip.at)}`;
    }
    if (state.pick) {
        query.pick = `${state.pick.body === 0 ? "a" : "b"}:${state.pick.triangle}`;
    }
    if (state.seek !== startState.seek) {
        query.seek = state.seek;
    }
    if (state.onlyFirst) {
        query.first = "1";
    }
    if (state.tau !== null) {
        query.tau = String(state.tau);
    }
    if (!state.others) {
        query.others = "0";
    }
    if (isFiltered(state.filter)) {
        Object.assign(query, writeFilter(state.filter));
    }
    return query;
}
