/** Which triangle of posed bodies a ray meets first. */
import { type Matrix4, Vector3 } from "three";
import type { Vec3 } from "../base/types";
import { nearestTriangle, type Ray } from "./pick";
import type { Clip, Pick } from "./view_state";

/** A body, or some of its triangles. */
export interface Target {
    body: 0 | 1;
    /** Nine floats a triangle of the whole body. */
    corners: Float32Array;
    matrix: Matrix4;
    /** Null: all triangles. */
    triangles: readonly number[] | null;
}

/** Returns the ray in the coordinates of a body that `matrix` places. */
export function rayIn({ origin, direction }: Ray, matrix: Matrix4): Ray {
    const back = matrix.clone().invert();
    return {
        origin: new Vector3(...origin).applyMatrix4(back).toArray() as Vec3,
        direction: new Vector3(...direction).transformDirection(back).toArray() as Vec3,
    };
}

/** Tells of distances along a ray whether the section plane hides what is there. `about` is the stage's origin. */
export function hiddenBy(clip: Clip | null | undefined, about: Vec3, ray: Ray): (distance: number) => boolean {
    const axis = clip ? "xyz".indexOf(clip.axis) : 0;
    const limit = clip ? clip.at - about[axis] : Infinity;
    return (distance) => ray.origin[axis] + distance * ray.direction[axis] > limit;
}

function cornersOf({ corners, triangles }: Target): Float32Array {
    if (!triangles) {
        return corners;
    }
    const chosen = new Float32Array(9 * triangles.length);
    triangles.forEach((one, i) => chosen.set(corners.subarray(9 * one, 9 * one + 9), 9 * i));
    return chosen;
}

/** Returns the nearest triangle under a ray; null if it meets none. */
export function pickAmong(ray: Ray, targets: readonly Target[], isHidden: (distance: number) => boolean): Pick | null {
    let least = Infinity;
    let pick: Pick | null = null;
    for (const target of targets) {
        const hit = nearestTriangle(cornersOf(target), rayIn(ray, target.matrix), isHidden);
        if (hit && hit.distance < least) {
            least = hit.distance;
            pick = { body: target.body, triangle: target.triangles ? target.triangles[hit.triangle] : hit.triangle };
        }
    }
    return pick;
}

/** Returns the centre of some triangles' middles, and how far from it they are at most. */
export function ballOf(corners: Float32Array, triangles: readonly number[]): { centre: Vector3; radius: number } {
    const middles = triangles.map((triangle) => {
        const [a, b, c] = [0, 3, 6].map((at) => new Vector3().fromArray(corners, 9 * triangle + at));
        return a.add(b).add(c).divideScalar(3);
    });
    const centre = middles.reduce((sum, one) => sum.add(one), new Vector3()).divideScalar(Math.max(1, middles.length));
    return { centre, radius: middles.reduce((most, one) => Math.max(most, one.distanceTo(centre)), 0) };
}

/** Returns the corners of the box about a ball, four of them. */
export function boxAround(centre: Vector3, radius: number): Vec3[] {
    const [low, high] = [centre.clone().subScalar(radius), centre.clone().addScalar(radius)];
    return [low, high].flatMap(({ x, z }) => [low, high].map(({ y }): Vec3 => [x, y, z]));
}
