/** Rigid motions in double: 12 numbers, rows of [R t], x' = R x + t. */
import type { Pose, Vec3 } from "./types";

export function apply(pose: Pose, [x, y, z]: Vec3): Vec3 {
    return [
        pose[0] * x + pose[1] * y + pose[2] * z + pose[3],
        pose[4] * x + pose[5] * y + pose[6] * z + pose[7],
        pose[8] * x + pose[9] * y + pose[10] * z + pose[11],
    ];
}

/** Returns the inverse of a rigid motion: [Rᵀ, -Rᵀ t]. */
export function inverse(p: Pose): Pose {
    const r = [p[0], p[4], p[8], p[1], p[5], p[9], p[2], p[6], p[10]];
    const t = (row: number) => -(r[row] * p[3] + r[row + 1] * p[7] + r[row + 2] * p[11]);
    return [r[0], r[1], r[2], t(0), r[3], r[4], r[5], t(3), r[6], r[7], r[8], t(6)];
}

/** Returns the motion that applies `second` after `first`. */
export function compose(second: Pose, first: Pose): Pose {
    const result: number[] = [];
    for (let row = 0; row < 12; row += 4) {
        for (let column = 0; column < 4; ++column) {
            result.push(
                second[row] * first[column] +
                    second[row + 1] * first[column + 4] +
                    second[row + 2] * first[column + 8] +
                    (column === 3 ? second[row + 3] : 0),
            );
        }
    }
    return result;
}

/** Returns the pose of B in A's frame, of both poses in the world. */
export function relativePose({ pose_a, pose_b }: { pose_a: Pose; pose_b: Pose }): Pose {
    return compose(inverse(pose_a), pose_b);
}

export interface Placement {
    x: number;
    y: number;
    z: number;
    roll: number; // Degrees, R = Rz(yaw) Ry(pitch) Rx(roll).
    pitch: number;
    yaw: number;
    distance: number; // Between the two origins.
}

export const placementKeys = ["x", "y", "z", "roll", "pitch", "yaw", "distance"] as const;
/** Where the lines of a bundle come from, in degrees (docs/shots.md). */
export const shotKeys = ["azimuth", "elevation"] as const;
export type Coordinate = (typeof placementKeys)[number] | (typeof shotKeys)[number];

const degrees = 180 / Math.PI;

/** Returns one number of the placement whose pose begins at `at` in `p`. */
export function coordinateOf(key: Coordinate, p: ArrayLike<number>, at = 0): number {
    switch (key) {
        case "x":
            return p[at + 3];
        case "y":
            return p[at + 7];
        case "z":
            return p[at + 11];
        case "roll":
            return Math.atan2(p[at + 9], p[at + 10]) * degrees;
        case "pitch":
            return Math.asin(Math.max(-1, Math.min(1, -p[at + 8]))) * degrees;
        case "yaw":
            return Math.atan2(p[at + 4], p[at]) * degrees;
        case "distance":
            return Math.hypot(p[at + 3], p[at + 7], p[at + 11]);
        case "azimuth": {
            const angle = Math.atan2(p[at + 4], p[at]) * degrees;
            return angle < -1e-9 ? angle + 360 : Math.max(0, angle);
        }
        case "elevation":
            return Math.asin(Math.max(-1, Math.min(1, p[at + 8]))) * degrees;
    }
}

export function placementOf(p: ArrayLike<number>): Placement {
    return Object.fromEntries(placementKeys.map((key) => [key, coordinateOf(key, p)])) as unknown as Placement;
}

export function isAngle(axis: string): boolean {
    return ["roll", "pitch", "yaw", ...shotKeys].includes(axis);
}
