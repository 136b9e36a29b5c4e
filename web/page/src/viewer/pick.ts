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
        const ax = corners[i];
        const ay = corners[i + 1];
        const az = corners[i + 2];
        const ux = corners[i + 3] - ax;
        const uy = corners[i + 4] - ay;
        const uz = corners[i + 5] - az;
        const vx = corners[i + 6] - ax;
        const vy = corners[i + 7] - ay;
        const vz = corners[i + 8] - az;
        const px = dy * vz - dz * vy;
        const py = dz * vx - dx * vz;
        const pz = dx * vy - dy * vx;
        const determinant = ux * px + uy * py + uz * pz;
        if (determinant === 0) {
            continue;
        }
        const sx = ox - ax;
        const sy = oy - ay;
        const sz = oz - az;
        const u = (sx * px + sy * py + sz * pz) / determinant;
        if (!(u >= 0 && u <= 1)) {
            continue;
        }
        const qx = sy * uz - sz * uy;
        const qy = sz * ux - sx * uz;
        const qz = sx * uy - sy * ux;
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
