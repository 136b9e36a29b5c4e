/** Which triangle a ray meets first. */
import type { Vec3 } from "../base/types";

export interface Ray {
    origin: Vec3;
    direction: Vec3;
}

export interface Hit {
    /** Position among the triangles of `corners`. */
    triangle: number;
    /** In lengths of the ray's direction. */
    distance: number;
}

/**
 * Returns the nearest triangle that a ray meets from either side (Möller and Trumbore 1997). `corners`
 * has nine floats a triangle. Hits for which `isHidden` holds are passed over.
 */
export function nearestTriangle(
    corners: Float32Array,
    { origin: [ox, oy, oz], direction: [dx, dy, dz] }: Ray,
    isHidden: (distance: number) => boolean,
): Hit | null {
    let nearest: Hit | null = null;
    let least = Infinity;
    for (let i = 0; i < corners.length; i += 9) {
        const [ax, ay, az] = [corners[i], corners[i + 1], corners[i + 2]];
        const [ux, uy, uz] = [corners[i + 3] - ax, corners[i + 4] - ay, corners[i + 5] - az];
        const [vx, vy, vz] = [corners[i + 6] - ax, corners[i + 7] - ay, corners[i + 8] - az];
        const [px, py, pz] = [dy * vz - dz * vy, dz * vx - dx * vz, dx * vy - dy * vx];
        const determinant = ux * px + uy * py + uz * pz;
        if (determinant === 0) {
            continue;
        }
        const [sx, sy, sz] = [ox - ax, oy - ay, oz - az];
        const u = (sx * px + sy * py + sz * pz) / determinant;
        if (!(u >= 0 && u <= 1)) {
            continue;
        }
        const [qx, qy, qz] = [sy * uz - sz * uy, sz * ux - sx * uz, sx * uy - sy * ux];
        const v = (dx * qx + dy * qy + dz * qz) / determinant;
        if (!(v >= 0 && u + v <= 1)) {
            continue;
        }
        const distance = (vx * qx + vy * qy + vz * qz) / determinant;
        if (distance > 0 && distance < least && !isHidden(distance)) {
            least = distance;
            nearest = { triangle: i / 9, distance };
        }
    }
    return nearest;
}
