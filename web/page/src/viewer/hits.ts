/** What lines hit, in exact order, and their ways through closed parts (docs/shots.md). */
import type { Mesh } from "../base/mesh";
import type { BodyParts } from "../base/parts";
import type { Vec3 } from "../base/types";

/** Bits of a hit's flags (common/shots/line_hit.hpp). */
const crosses = 1;
const back = 4;

/** A crossing that enters or leaves the side of the normal, or a hit that only grazes the surface. */
export type HitKind = "enters" | "leaves" | "grazes";
export const hitKinds: readonly HitKind[] = ["enters", "leaves", "grazes"];

/** The hits of a bundle: row i of `rows` (depth, flags, rank) is of row i of `pairs`. */
export class Hits {
    private readonly byLine = new Map<number, number[]>();

    constructor(
        /** Rows of triangle of A, line, class of the pair. */
        private readonly pairs: Uint32Array,
        private readonly rows: Float64Array,
    ) {
        for (let i = 0; i < this.count; ++i) {
            const line = this.lineOf(i);
            const hits = this.byLine.get(line);
            if (hits) {
                hits.push(i);
            } else {
                this.byLine.set(line, [i]);
            }
        }
        this.byLine.forEach((hits) => hits.sort((one, other) => this.compare(one, other)));
    }

    get count(): number {
        return Math.min(this.rows.length, this.pairs.length) / 3;
    }

    triangleOf(hit: number): number {
        return this.pairs[3 * hit];
    }

    lineOf(hit: number): number {
        return this.pairs[3 * hit + 1];
    }

    depthOf(hit: number): number {
        return this.rows[3 * hit];
    }

    doesCross(hit: number): boolean {
        return (this.rows[3 * hit + 1] & crosses) !== 0;
    }

    kindOf(hit: number): HitKind {
        return !this.doesCross(hit) ? "grazes" : (this.rows[3 * hit + 1] & back) !== 0 ? "leaves" : "enters";
    }

    /** Compares by exact depth, which depth and rank tell; at one point those that leave come first. */
    private compare(one: number, other: number): number {
        const enters = (hit: number) => ((this.rows[3 * hit + 1] & back) === 0 ? 1 : 0);
        return (
            this.depthOf(one) - this.depthOf(other) ||
            this.rows[3 * one + 2] - this.rows[3 * other + 2] ||
            enters(one) - enters(other) ||
            this.triangleOf(one) - this.triangleOf(other)
        );
    }

    /** The lines that hit something. */
    get lines(): number[] {
        return [...this.byLine.keys()];
    }

    /** Returns the hits of a line in exact order. */
    ofLine(line: number): readonly number[] {
        return this.byLine.get(line) ?? [];
    }

    /** Returns the hits that are shown: all, or with `onlyFirst` the first crossing of each line. */
    shown(onlyFirst: boolean): number[] {
        return [...this.byLine.values()].flatMap((hits) =>
            onlyFirst ? hits.filter((hit) => this.doesCross(hit)).slice(0, 1) : hits,
        );
    }
}

/** A line's way through a part; without an end where the part has no inside. */
export interface Passage {
    part: number;
    /** The hit where it begins, and the one where it ends. */
    in: number;
    out: number | null;
}

/**
 * Returns the passages of one line, whose hits are in order, by where they begin. The crossings of a part
 * for which `isPaired` holds are taken two by two.
 */
export function passagesOf(
    hits: Hits,
    line: number,
    partOf: (triangle: number) => number,
    isPaired: (part: number) => boolean,
): Passage[] {
    const passages: Passage[] = [];
    const begun = new Map<number, Passage>();
    for (const hit of hits.ofLine(line).filter((one) => hits.doesCross(one))) {
        const part = partOf(hits.triangleOf(hit));
        const open = begun.get(part);
        if (open) {
            open.out = hit;
            begun.delete(part);
            continue;
        }
        const passage = { part, in: hit, out: null };
        passages.push(passage);
        if (isPaired(part)) {
            begun.set(part, passage);
        }
    }
    return passages;
}

/** Returns start and end of a line, in the bundle's coordinates. */
export function endsOf(lines: Mesh, line: number): [Vec3, Vec3] {
    const end = (corner: number) => {
        const vertex = 3 * lines.triangles[3 * line + corner];
        return Array.from(lines.vertices.subarray(vertex, vertex + 3)) as Vec3;
    };
    return [end(0), end(1)];
}

/** Returns the point of a line at a depth. */
export function pointAt([start, end]: readonly [Vec3, Vec3], depth: number): Vec3 {
    const length = Math.hypot(...end.map((value, axis) => value - start[axis]));
    return start.map((value, axis) => value + ((end[axis] - value) / length) * depth) as Vec3;
}

/** Whether no end of a line lies in the box around a part. */
export function startsAndEndsOutside(ends: readonly Vec3[], mesh: Mesh, parts: BodyParts, part: number): boolean {
    const low: Vec3 = [Infinity, Infinity, Infinity];
    const high: Vec3 = [-Infinity, -Infinity, -Infinity];
    for (let i = 0; i < mesh.triangles.length; ++i) {
        if (parts.partOf(Math.floor(i / 3)) !== part) {
            continue;
        }
        for (let axis = 0; axis < 3; ++axis) {
            const value = mesh.vertices[3 * mesh.triangles[i] + axis];
            low[axis] = Math.min(low[axis], value);
            high[axis] = Math.max(high[axis], value);
        }
    }
    return !ends.some((end) => end.every((value, axis) => value >= low[axis] && value <= high[axis]));
}
