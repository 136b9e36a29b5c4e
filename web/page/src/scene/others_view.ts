/** The bodies of a step beside the pair that is shown: faint and grey, or the edges of their boxes. */
import {
    BufferAttribute,
    BufferGeometry,
    DoubleSide,
    Group,
    InstancedMesh,
    LessEqualDepth,
    LineBasicMaterial,
    LineSegments,
    Matrix4,
    MeshLambertMaterial,
    type Plane,
    SRGBColorSpace,
} from "three";
import { cornersOf, type Mesh } from "../base/mesh";
import { apply, compose } from "../base/pose";
import type { Pose, Vec3 } from "../base/types";
import { nearestTriangle, type Ray } from "../viewer/pick";
import { rayIn } from "../viewer/picking";
import type { PoseAt } from "./step_bodies";

const grey = 0.38;
const opacity = 0.26;

/** A body and where it is in the world at each time of the step. */
export interface OtherBody extends Box {
    body: number;
    poseAt: PoseAt;
    /** Null: the edges of its box are drawn. */
    mesh: Mesh | null;
}

interface Box {
    /** The least corner and the size of its box, in its own axes. */
    low: Vec3;
    size: Vec3;
}

/** A body that is posed in A's frame. */
interface PosedBody extends OtherBody {
    pose: Pose;
}

/** The bodies of one mesh. */
interface Shape {
    mesh: Mesh;
    corners: Float32Array;
    geometry: BufferGeometry;
    bodies: number[];
    matrices: Matrix4[];
}

/** Returns the eight corners of a body's box, in A's frame; corner i is high in axis k if bit k of i is set. */
export function boxCornersOf({ pose, low, size }: Box & { pose: Pose }): Vec3[] {
    return Array.from({ length: 8 }, (_, i) =>
        apply(pose, low.map((least, axis) => least + ((i >> axis) & 1) * size[axis]) as Vec3),
    );
}

/** The pairs of corners that an edge joins: those that differ in one axis. */
const edges = [0, 1, 2].flatMap((axis) =>
    Array.from({ length: 8 }, (_, i) => i)
        .filter((i) => ((i >> axis) & 1) === 0)
        .map((i) => [i, i + (1 << axis)] as const),
);

function matrixOf(pose: Pose, centre: Vec3, origin: Vec3): Matrix4 {
    const at = apply(pose, centre);
    return new Matrix4().set(
        ...([pose[0], pose[1], pose[2], at[0] - origin[0]] as const),
        ...([pose[4], pose[5], pose[6], at[1] - origin[1]] as const),
        ...([pose[8], pose[9], pose[10], at[2] - origin[2]] as const),
        ...([0, 0, 0, 1] as const),
    );
}

export class OthersView {
    readonly group = new Group();
    /** What is drawn. */
    bodies: readonly OtherBody[] = [];
    /** How far from the stage's origin something is drawn. */
    reach = 0;
    /** The centre of each body's box in A's frame. */
    centres: { body: number; centre: Vec3 }[] = [];
    private shapes: Shape[] = [];
    private readonly depth = new MeshLambertMaterial({ flatShading: true, side: DoubleSide, colorWrite: false });
    private readonly veil = new MeshLambertMaterial({
        flatShading: true,
        side: DoubleSide,
        transparent: true,
        opacity,
        depthWrite: false,
        depthFunc: LessEqualDepth,
    });
    private readonly line = new LineBasicMaterial({ transparent: true, opacity: 0.5 });

    constructor() {
        this.veil.color.setRGB(grey, grey, grey, SRGBColorSpace);
        this.line.color.setRGB(grey, grey, grey, SRGBColorSpace);
    }

    /**
     * Draws the bodies as they are at a time of the step, about `origin`, a point of A's frame, to which `toA` leads
     * from the world.
     */
    place(toA: Pose, origin: Vec3, tau: number): void {
        const bodies = this.bodies.map((one) => ({ ...one, pose: compose(toA, one.poseAt(tau)) }));
        const old = this.shapes;
        this.clear();
        this.shapes = [];
        for (const one of bodies) {
            if (one.mesh) {
                const shape = this.shapeOf(one.mesh, old);
                shape.bodies.push(one.body);
                shape.matrices.push(matrixOf(one.pose, one.mesh.centre, origin));
            }
        }
        old.filter((one) => !this.shapes.some(({ mesh }) => mesh === one.mesh)).forEach((one) => one.geometry.dispose());
        this.shapes.forEach((shape) => this.addInstances(shape));
        this.addBoxes(bodies.filter(({ mesh }) => mesh === null), origin);
        const corners = bodies.flatMap(boxCornersOf);
        this.centres = bodies.map(({ body, pose, low, size }) => ({
            body,
            centre: apply(pose, low.map((least, axis) => least + size[axis] / 2) as Vec3),
        }));
        this.reach = corners.reduce((most, at) => Math.max(most, Math.hypot(...at.map((x, i) => x - origin[i]))), 0);
    }

    /** Drops what is drawn; geometries of meshes are kept for the next drawing. */
    private clear(): void {
        for (const child of this.group.children) {
            if (child instanceof InstancedMesh) {
                child.dispose();
            } else if (child instanceof LineSegments) {
                child.geometry.dispose();
            }
        }
        this.group.clear();
    }

    private shapeOf(mesh: Mesh, old: readonly Shape[]): Shape {
        const found = this.shapes.find((one) => one.mesh === mesh);
        if (found) {
            return found;
        }
        const kept = old.find((one) => one.mesh === mesh);
        const corners = kept?.corners ?? cornersOf(mesh);
        const geometry = kept?.geometry ?? new BufferGeometry().setAttribute("position", new BufferAttribute(corners, 3));
        const shape: Shape = { mesh, corners, geometry, bodies: [], matrices: [] };
        this.shapes.push(shape);
        return shape;
    }

    /** Draws depth alone, then colour, so that the nearest layer is blended once. */
    private addInstances({ geometry, matrices }: Shape): void {
        [this.depth, this.veil].forEach((material, order) => {
            const drawn = new InstancedMesh(geometry, material, matrices.length);
            matrices.forEach((matrix, i) => drawn.setMatrixAt(i, matrix));
            drawn.frustumCulled = false;
            drawn.renderOrder = order;
            this.group.add(drawn);
        });
    }

    private addBoxes(bodies: readonly PosedBody[], origin: Vec3): void {
        if (bodies.length === 0) {
            return;
        }
        const positions = new Float32Array(bodies.length * edges.length * 6);
        let at = 0;
        for (const one of bodies) {
            const corners = boxCornersOf(one);
            for (const corner of edges.flat()) {
                positions.set(corners[corner].map((value, axis) => value - origin[axis]), at);
                at += 3;
            }
        }
        const geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(positions, 3));
        const drawn = new LineSegments(geometry, this.line);
        drawn.frustumCulled = false;
        this.group.add(drawn);
    }

    clip(planes: Plane[]): void {
        for (const material of [this.depth, this.veil, this.line]) {
            material.clippingPlanes = planes;
        }
    }

    /** Returns the number of the body that a ray meets first, of those drawn with meshes; null if it meets none. */
    bodyAt(ray: Ray, isHidden: (distance: number) => boolean): number | null {
        let least = Infinity;
        let found: number | null = null;
        for (const { corners, bodies, matrices } of this.shapes) {
            matrices.forEach((matrix, i) => {
                const hit = nearestTriangle(corners, rayIn(ray, matrix), isHidden);
                if (hit && hit.distance < least) {
                    [least, found] = [hit.distance, bodies[i]];
                }
            });
        }
        return found;
    }

    dispose(): void {
        this.clear();
        this.shapes.forEach((one) => one.geometry.dispose());
        [this.depth, this.veil, this.line].forEach((material) => material.dispose());
    }
}
