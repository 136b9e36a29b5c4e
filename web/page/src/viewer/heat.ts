/** The heat map: in how many scenarios each triangle was in contact, on a logarithmic scale. */
import type { Rgb } from "../base/classes";

// Nine colours of viridis (van der Walt and Smith 2015), evenly spaced; between them linear.
const viridis: readonly Rgb[] = [
    [68, 1, 84],
    [71, 45, 123],
    [59, 82, 139],
    [44, 114, 142],
    [33, 145, 140],
    [40, 174, 128],
    [94, 201, 98],
    [173, 220, 48],
    [253, 231, 37],
];

/** Returns the colour at 0 to 1. */
export function viridisAt(position: number): Rgb {
    const at = Math.min(1, Math.max(0, position)) * (viridis.length - 1);
    const below = Math.min(viridis.length - 2, Math.floor(at));
    const share = at - below;
    return [0, 1, 2].map((i) =>
        Math.round(viridis[below][i] + (viridis[below + 1][i] - viridis[below][i]) * share),
    ) as unknown as Rgb;
}

/** Returns 256 RGBA colours; the first is for triangles that were never in contact. */
export function heatTable(never: Rgb): Uint8Array {
    const table = new Uint8Array(4 * 256);
    for (let i = 0; i < 256; ++i) {
        table.set([...(i === 0 ? never : viridisAt((i - 1) / 254)), 255], 4 * i);
    }
    return table;
}

/** Returns 1 + 254 log(count) / log(most), 1 to 255; 0 for a count of 0. */
export function heatByte(count: number, most: number): number {
    if (count === 0) {
        return 0;
    }
    return most <= 1 ? 255 : 1 + Math.round((254 * Math.log(count)) / Math.log(most));
}

/** Counts by triangle, from rows of triangle and count. */
export function countsByTriangle(rows: ArrayLike<number>, triangles: number): Float64Array {
    const counts = new Float64Array(triangles);
    for (let i = 0; i + 1 < rows.length; i += 2) {
        counts[rows[i]] = rows[i + 1];
    }
    return counts;
}

/** Returns a byte for each corner. */
export function heatBytes(counts: Float64Array, most: number): Uint8Array {
    const bytes = new Uint8Array(3 * counts.length);
    for (let i = 0; i < counts.length; ++i) {
        bytes.fill(heatByte(counts[i], most), 3 * i, 3 * i + 3);
    }
    return bytes;
}
