import {
    BufferAttribute,
    BufferGeometry,
    Group,
    LineBasicMaterial,
    LineSegments,
    type Matrix4,
    Mesh as DrawnMesh,
    type MeshLambertMaterial,
    type Plane,
    Points,
    PointsMaterial,
} from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import { colourOf, near } from "../base/classes";
import { apply } from "../base/pose";
import type { Pose, Vec3 } from "../base/types";
import { makeMaterial } from "./body_view";

/** Classes of pairs. */
export const proper = 3;
export const nearPair = 4;

/** Returns how bad a class of pairs is; near is better than all others. */
function badness(kind: number): number {
    return kind === nearPair ? 0 : kind;
}

/** The triangles of one body in contact or near, each with the worst class of its pairs. */
export type Highlight = Map<number, number>;

/** Returns the triangles of A and of B in pairs that `isShown` allows. */
export function highlightsOf(
    pairs: Uint32Array,
    isShown: (a: number, b: number) => boolean,
): [Highlight, Highlight] {
    const both: [Highlight, Highlight] = [new Map(), new Map()];
    for (let i = 0; i + 2 < pairs.length; i += 3) {
        if (!isShown(pairs[i], pairs[i + 1])) {
            continue;
        }
        both.forEach((highlight, body) => {
            const triangle = pairs[i + body];
            const before = highlight.get(triangle);
            if (before === undefined || badness(pairs[i + 2]) > badness(before)) {
                highlight.set(triangle, pairs[i + 2]);
            }
        });
    }
    return both;
}

/** How a triangle is drawn; the later ones are drawn over the earlier. */
type Look = "near" | "touch" | "proper";
const looks: readonly Look[] = ["near", "touch", "proper"];

function lookOf(kind: number): Look {
    return kind === proper ? "proper" : kind === nearPair ? "near" : "touch";
}

function trianglesOf(highlight: Highlight, look: Look): number[] {
    return [...highlight].flatMap(([triangle, kind]) => (lookOf(kind) === look ? [triangle] : []));
}

export function pickCorners(corners: Float32Array, triangles: readonly number[]): Float32Array {
    const picked = new Float32Array(9 * triangles.length);
    triangles.forEach((triangle, i) => picked.set(corners.subarray(9 * triangle, 9 * triangle + 9), 9 * i));
    return picked;
}

/** Returns the three edges of each triangle as segments. */
export function edgesOf(corners: Float32Array): Float32Array {
    const edges = new Float32Array(2 * corners.length);
    for (let i = 0; i < corners.length; i += 9) {
        const [a, b, c] = [0, 3, 6].map((at) => corners.subarray(i + at, i + at + 3));
        [a, b, b, c, c, a].forEach((corner, k) => edges.set(corner, 2 * i + 3 * k));
    }
    return edges;
}

interface Shapes {
    segments: number[];
    points: number[];
    /** The segments between the nearest points of near pairs. */
    gaps: number[];
}

/**
 * Sorts the points of each pair: one is a point, two a segment, more a convex polygon; the two of a near
 * pair are a gap. `kindOf` gives a pair's class, or null for a pair that is not shown.
 */
export function shapesOf(
    points: Float64Array,
    place: (point: Vec3) => Vec3,
    kindOf: (pair: number) => number | null,
): Shapes {
    const shapes: Shapes = { segments: [], points: [], gaps: [] };
    for (let first = 0; first < points.length; ) {
        const pair = points[first];
        let end = first;
        const corners: Vec3[] = [];
        for (; end < points.length && points[end] === pair; end += 4) {
            corners.push(place([points[end + 1], points[end + 2], points[end + 3]]));
        }
        first = end;
        const kind = kindOf(pair);
        if (kind === null) {
            continue;
        }
        if (kind === nearPair) {
            shapes.gaps.push(...corners.flat());
            continue;
        }
        if (corners.length === 1) {
            shapes.points.push(...corners[0]);
        }
        const sides = corners.length > 2 ? corners.length : corners.length - 1;
        for (let i = 0; i < sides; ++i) {
            shapes.segments.push(...corners[i], ...corners[(i + 1) % corners.length]);
        }
    }
    return shapes;
}

interface Drawn {
    geometry: { dispose(): void };
    material: { dispose(): void };
}

/** The triangles in contact or near, what they share, and gaps. Made anew for each scenario. */
export class ContactsView {
    readonly group = new Group();
    readonly lines = new Group();
    private readonly red: MeshLambertMaterial;
    private readonly yellow: MeshLambertMaterial;
    private readonly orange: MeshLambertMaterial;
    private readonly outline = new LineBasicMaterial({ color: 0x5a4500 });
    private readonly segment = new LineMaterial({ color: 0x000000, linewidth: 2.5 });
    private readonly gap = new LineMaterial({ color: 0xa84e00, linewidth: 3.5 });
    private readonly dot = new PointsMaterial({ color: 0x000000, size: 7, sizeAttenuation: false });

    constructor() {
        this.red = makeMaterial(colourOf(2));
        this.yellow = makeMaterial(colourOf(1));
        this.orange = makeMaterial(colourOf(near));
        this.red.emissive.copy(this.red.color).multiplyScalar(0.45);
        this.yellow.emissive.copy(this.yellow.color).multiplyScalar(0.35);
        this.orange.emissive.copy(this.orange.color).multiplyScalar(0.35);
        this.group.add(this.lines);
    }

    private get materials() {
        return [this.red, this.yellow, this.orange, this.outline, this.segment, this.gap, this.dot];
    }

    private clear(): void {
        for (const child of [...this.group.children, ...this.lines.children]) {
            if (child !== this.lines) {
                (child as unknown as Drawn).geometry.dispose();
                child.removeFromParent();
            }
        }
    }

    /** Shows triangles of one body; touching ones are yellow and near ones orange, with an outline. */
    private addBody(corners: Float32Array, highlight: Highlight, matrix: Matrix4): void {
        const materials = { near: this.orange, touch: this.yellow, proper: this.red };
        for (const look of looks) {
            const chosen = pickCorners(corners, trianglesOf(highlight, look));
            if (chosen.length === 0) {
                continue;
            }
            const geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(chosen, 3));
            this.addPlaced(new DrawnMesh(geometry, materials[look]), matrix);
            if (look !== "proper") {
                const edges = new BufferGeometry().setAttribute(
                    "position",
                    new BufferAttribute(edgesOf(chosen), 3),
                );
                this.addPlaced(new LineSegments(edges, this.outline), matrix);
            }
        }
    }

    private addPlaced(drawn: DrawnMesh | LineSegments, matrix: Matrix4): void {
        drawn.matrixAutoUpdate = false;
        drawn.matrix.copy(matrix);
        drawn.frustumCulled = false;
        this.group.add(drawn);
    }

    show(
        bodies: readonly [Float32Array, Float32Array],
        highlights: readonly [Highlight, Highlight],
        matrices: readonly [Matrix4, Matrix4],
    ): void {
        this.clear();
        bodies.forEach((corners, i) => this.addBody(corners, highlights[i], matrices[i]));
    }

    private addLines(ends: readonly number[], material: LineMaterial): void {
        if (ends.length === 0) {
            return;
        }
        const geometry = new LineSegmentsGeometry().setPositions(new Float32Array(ends));
        const drawn = new LineSegments2(geometry, material);
        drawn.frustumCulled = false;
        drawn.renderOrder = 4;
        this.lines.add(drawn);
    }

    /**
     * Adds the points of pairs (`shapesOf`); `fromWorld` leads into A's frame, `origin` is subtracted in
     * double. Returns the number of gaps.
     */
    addPoints(points: Float64Array, fromWorld: Pose, origin: Vec3, kindOf: (pair: number) => number | null): number {
        const place = (point: Vec3) => apply(fromWorld, point).map((value, i) => value - origin[i]) as Vec3;
        const shapes = shapesOf(points, place, kindOf);
        this.addLines(shapes.segments, this.segment);
        this.addLines(shapes.gaps, this.gap);
        if (shapes.points.length > 0) {
            const positions = new BufferAttribute(new Float32Array(shapes.points), 3);
            const drawn = new Points(new BufferGeometry().setAttribute("position", positions), this.dot);
            drawn.frustumCulled = false;
            drawn.renderOrder = 5;
            this.lines.add(drawn);
        }
        return shapes.gaps.length / 6;
    }

    clip(planes: Plane[]): void {
        for (const material of this.materials) {
            material.clippingPlanes = planes;
        }
    }

    dispose(): void {
        this.clear();
        this.materials.forEach((material) => material.dispose());
    }
}
