/** A sign for each class of scenarios, so that classes differ without their colours, too. */
import { near, untested } from "../base/classes";

/** What a sign is traced into: the path of a canvas. */
export type Path = Pick<CanvasPath, "moveTo" | "lineTo" | "arc" | "rect">;

/**
 * Adds the sign of a class, of radius `r`, to a path: a dot for separate, a ring for touch, X for cross,
 * a square for inside, a stroke for contact, a bar for undecided, two bars for near, a triangle for failed.
 */
export function traceGlyph(path: Path, kind: number, x: number, y: number, r: number): void {
    if (kind === 0 || kind === untested || kind === 1) {
        const radius = r * (kind === 1 ? 0.85 : kind === 0 ? 0.35 : 0.15);
        path.moveTo(x + radius, y);
        path.arc(x, y, radius, 0, 2 * Math.PI);
    } else if (kind === 2 || kind === 4) {
        path.moveTo(x - r, y - r);
        path.lineTo(x + r, y + r);
        if (kind === 2) {
            path.moveTo(x + r, y - r);
            path.lineTo(x - r, y + r);
        }
    } else if (kind === 3) {
        path.rect(x - r, y - r, 2 * r, 2 * r);
    } else if (kind === 5) {
        path.moveTo(x - r, y);
        path.lineTo(x + r, y);
    } else if (kind === near) {
        for (const side of [-0.5, 0.5]) {
            path.moveTo(x + side * r, y - r);
            path.lineTo(x + side * r, y + r);
        }
    } else {
        path.moveTo(x, y - r);
        path.lineTo(x + r, y + r);
        path.lineTo(x - r, y + r);
        path.lineTo(x, y - r);
    }
}
