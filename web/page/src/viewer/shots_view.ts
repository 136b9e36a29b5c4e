import {
    BufferAttribute,
    BufferGeometry,
    Color,
    Group,
    LineBasicMaterial,
    LineSegments,
    type Plane,
    Points,
    PointsMaterial,
    SRGBColorSpace,
} from "three";
import type { Rgb } from "../base/classes";
import type { Mesh } from "../base/mesh";
import type { Vec3 } from "../base/types";
import { endsOf, type HitKind, hitKinds, type Hits, pointAt } from "./hits";

const colours: Record<HitKind, Rgb> = { enters: [16, 132, 74], leaves: [190, 44, 132], grazes: [232, 188, 38] };

/** The colour of hits of a kind. */
export function hitColour(kind: HitKind): string {
    const [r, g, b] = colours[kind];
    return `rgb(${r} ${g} ${b})`;
}

function positionsOf(numbers: readonly number[]): BufferGeometry {
    return new BufferGeometry().setAttribute("position", new BufferAttribute(new Float32Array(numbers), 3));
}

/** The lines of a bundle that hit something, the others fainter, and the hits as points. */
export class ShotsView {
    readonly group = new Group();
    /** Where each shown hit is drawn. */
    points: { hit: number; at: Vec3 }[] = [];
    /** How many lines are drawn, and how many of them hit something. */
    lines: [number, number] = [0, 0];
    private readonly hitting = new LineBasicMaterial({ color: 0x2b66c4, transparent: true, opacity: 0.75 });
    private readonly missing = new LineBasicMaterial({ color: 0x8a919a, transparent: true, opacity: 0.2 });
    private readonly dots = new Map<HitKind, PointsMaterial>();

    constructor(private readonly bundle: Mesh) {
        for (const kind of hitKinds) {
            const [r, g, b] = colours[kind].map((value) => value / 255);
            const color = new Color().setRGB(r, g, b, SRGBColorSpace);
            this.dots.set(kind, new PointsMaterial({ color, size: 6, sizeAttenuation: false }));
        }
    }

    private get materials() {
        return [this.hitting, this.missing, ...this.dots.values()];
    }

    private add(drawn: LineSegments | Points, order: number): void {
        drawn.frustumCulled = false;
        drawn.renderOrder = order;
        this.group.add(drawn);
    }

    private clear(): void {
        for (const child of [...this.group.children]) {
            (child as LineSegments).geometry.dispose();
            child.removeFromParent();
        }
    }

    /** Shows these hits, and all lines; `place` leads from the bundle to the stage. */
    show(hits: Hits, shown: readonly number[], place: (point: Vec3) => Vec3): void {
        this.clear();
        const ends = Array.from({ length: this.bundle.triangles.length / 3 }, (_, line) => endsOf(this.bundle, line));
        const segment = (line: number) => ends[line].flatMap((end) => place(end));
        const isHit = new Set(shown.map((hit) => hits.lineOf(hit)));
        const others = ends.flatMap((_, line) => (isHit.has(line) ? [] : [line]));
        this.lines = [ends.length, isHit.size];
        this.add(new LineSegments(positionsOf(others.flatMap(segment)), this.missing), 3);
        this.add(new LineSegments(positionsOf([...isHit].flatMap(segment)), this.hitting), 4);
        this.points = shown.map((hit) => ({ hit, at: place(pointAt(ends[hits.lineOf(hit)], hits.depthOf(hit))) }));
        for (const [kind, material] of this.dots) {
            const chosen = this.points.filter(({ hit }) => hits.kindOf(hit) === kind);
            this.add(new Points(positionsOf(chosen.flatMap(({ at }) => at)), material), 5);
        }
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
