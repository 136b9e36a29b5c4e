import {
    BufferAttribute,
    BufferGeometry,
    Color,
    Group,
    type Plane,
    Points,
    PointsMaterial,
    SRGBColorSpace,
} from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import type { Vec3 } from "../base/types";
import { knowledgeColour } from "./colours";
import type { Knowledge, PathPiece } from "./motion";

const knowledges: readonly Knowledge[] = ["free", "open", "event", "unknown"];

/** The path of B's origin, coloured by what is known of each part of the time; instants are dots. */
export class PathView {
    readonly group = new Group();
    /** All points of the path, where they are drawn. */
    points: Vec3[] = [];
    private readonly lines = new Map<Knowledge, LineMaterial>();
    private readonly dot = new PointsMaterial({ size: 10, sizeAttenuation: false });

    constructor() {
        for (const kind of knowledges) {
            this.lines.set(kind, new LineMaterial({ linewidth: 3 }));
        }
    }

    private clear(): void {
        for (const child of [...this.group.children]) {
            (child as LineSegments2 | Points).geometry.dispose();
            child.removeFromParent();
        }
    }

    /** Shows pieces in A's frame; `origin` is the point around which all is drawn. */
    show(pieces: readonly PathPiece[], origin: Vec3, isNear: boolean): void {
        this.clear();
        const place = (point: Vec3) => point.map((value, i) => value - origin[i]) as Vec3;
        const drawn = pieces.map(({ points, kind }) => ({ points: points.map(place), kind }));
        this.points = drawn.flatMap(({ points }) => points);
        for (const [kind, material] of this.lines) {
            material.color = colourFor(kind, isNear);
        }
        this.dot.color = colourFor("event", isNear);
        drawn.forEach((piece) => this.add(piece));
    }

    private add({ points, kind }: PathPiece): void {
        const material = this.lines.get(kind);
        if (points.length === 1 || !material) {
            const positions = new BufferAttribute(new Float32Array(points.flat()), 3);
            this.place(new Points(new BufferGeometry().setAttribute("position", positions), this.dot), 5);
            return;
        }
        const ends = points.slice(1).flatMap((point, i) => [...points[i], ...point]);
        this.place(new LineSegments2(new LineSegmentsGeometry().setPositions(new Float32Array(ends)), material), 4);
    }

    private place(drawn: LineSegments2 | Points, order: number): void {
        drawn.frustumCulled = false;
        drawn.renderOrder = order;
        this.group.add(drawn);
    }

    clip(planes: Plane[]): void {
        for (const material of [...this.lines.values(), this.dot]) {
            material.clippingPlanes = planes;
        }
    }

    dispose(): void {
        this.clear();
        [...this.lines.values(), this.dot].forEach((material) => material.dispose());
    }
}

function colourFor(kind: Knowledge, isNear: boolean): Color {
    const [r, g, b] = knowledgeColour(kind, isNear).map((value) => value / 255);
    return new Color().setRGB(r, g, b, SRGBColorSpace);
}
