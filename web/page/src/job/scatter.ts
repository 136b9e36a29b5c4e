/** Poses of a file or random ones, over two of their coordinates. */
import { colourOf, nameOf, severity, untested } from "../base/classes";
import { type Coordinate, isAngle } from "../base/pose";
import { grouped, short } from "../base/words";
import { Cells } from "./cells";
import { traceGlyph } from "./glyphs";
import type { PlotAxis, PlotModel, Spot } from "./plot_model";
import { boundsOf } from "./poses";
import type { Results } from "./results";

export const pointsMax = 50000;
const cellsAside = 128;
const nearPixels = 14;

function axisOf(key: Coordinate, values: Float64Array, unit: string): PlotAxis {
    const [first, last] = boundsOf(values);
    const margin = 0.03 * (last - first);
    return { title: key, first: first - margin, last: last + margin, unit: isAngle(key) ? "°" : ` ${unit}` };
}

/** Points of the unit square; point i is element i of the results. */
class Points implements PlotModel {
    private readonly order: Uint32Array; // The worst is drawn last.

    constructor(
        private readonly results: Results,
        private readonly px: Float64Array,
        private readonly py: Float64Array,
        readonly x: PlotAxis,
        readonly y: PlotAxis,
        private readonly noun: string,
    ) {
        this.order = Uint32Array.from(px, (_, i) => i).sort((a, b) => this.rank(a) - this.rank(b) || a - b);
    }

    private rank(point: number): number {
        return severity(this.kind(point)) + this.results.countAt(point) / 2 ** 32;
    }

    private kind(point: number): number {
        return this.results.classes[point] ?? untested;
    }

    draw(context: OffscreenCanvasRenderingContext2D, width: number, height: number): void {
        const count = this.px.length;
        const radius = (count > 20000 ? 1.5 : count > 2000 ? 2.4 : 3.4) * devicePixelRatio;
        context.lineWidth = Math.max(1, 0.4 * radius);
        // Points of one class follow one another and become one path.
        for (let begin = 0; begin < count; ) {
            const kind = this.kind(this.order[begin]);
            context.beginPath();
            for (; begin < count && this.kind(this.order[begin]) === kind; ++begin) {
                const point = this.order[begin];
                traceGlyph(context, kind, this.px[point] * width, (1 - this.py[point]) * height, radius);
            }
            const [r, g, b] = colourOf(kind);
            context.strokeStyle = `rgb(${r} ${g} ${b} / ${kind === 0 ? 0.6 : 0.9})`;
            context.stroke();
        }
    }

    private spot(point: number): Spot {
        const scenario = this.results.scenarioAt(point);
        const count = this.results.countAt(point);
        const place = [this.x, this.y].map((axis, i) => {
            const share = i === 0 ? this.px[point] : this.py[point];
            return `${axis.title} ${short(axis.first + share * (axis.last - axis.first))}${axis.unit}`;
        });
        const pairs = count > 0 ? `, ${grouped(count)} ${this.noun}s` : "";
        return {
            scenario,
            text: `#${scenario} ${nameOf(this.kind(point))}${pairs} at ${place.join(", ")}`,
            x: this.px[point],
            y: this.py[point],
            width: 0,
            height: 0,
        };
    }

    at(x: number, y: number, width: number, height: number): Spot | null {
        let best = -1;
        let least = nearPixels * nearPixels;
        for (let i = 0; i < this.px.length; ++i) {
            const dx = (this.px[i] - x) * width;
            const dy = (this.py[i] - y) * height;
            const square = dx * dx + dy * dy;
            if (square < least || (square === least && best >= 0 && this.rank(i) > this.rank(best))) {
                least = square;
                best = i;
            }
        }
        return best < 0 ? null : this.spot(best);
    }

    step(spot: Spot | null, dx: number, dy: number): Spot | null {
        // The nearest point within 45 degrees of the direction.
        const from = spot ?? { x: 0.5, y: 0.5 };
        let best = -1;
        let least = Infinity;
        for (let i = 0; i < this.px.length; ++i) {
            const [x, y] = [this.px[i] - from.x, this.py[i] - from.y];
            const along = x * dx + y * dy;
            const square = x * x + y * y;
            if (along > 0 && 2 * along * along >= square && square < least) {
                least = square;
                best = i;
            }
        }
        return best < 0 ? spot : this.spot(best);
    }
}

/** Returns points, or beyond `pointsMax` the shares of contacts in 128 x 128 cells. */
export function scatterOf(
    results: Results,
    [xKey, xValues]: readonly [Coordinate, Float64Array],
    [yKey, yValues]: readonly [Coordinate, Float64Array],
    unit: string,
    noun = "pair",
): PlotModel {
    const [x, y] = [axisOf(xKey, xValues, unit), axisOf(yKey, yValues, unit)];
    const share = (axis: PlotAxis, value: number) => (value - axis.first) / (axis.last - axis.first);
    const count = Math.min(xValues.length, results.classes.length);
    if (count <= pointsMax) {
        const along = (axis: PlotAxis, values: Float64Array) =>
            values.subarray(0, count).map((value) => share(axis, value));
        return new Points(results, along(x, xValues), along(y, yValues), x, y, noun);
    }
    const cells = new Cells(results, x, y, cellsAside, cellsAside, true, () => "");
    const cellOf = (axis: PlotAxis, value: number) => Math.floor(share(axis, value) * cellsAside);
    for (let i = 0; i < count; ++i) {
        cells.add(cellOf(x, xValues[i]), cellOf(y, yValues[i]), i);
    }
    return cells;
}
