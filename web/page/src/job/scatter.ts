/** Poses of a file or random ones, over two of their coordinates. */
import { colourOf, nameOf, severity, untested } from "../base/classes";
import { compose, inverse, isAngle, type Placement, placementKeys, placementOf } from "../base/pose";
import { grouped, short } from "../base/words";
import { Cells } from "./cells";
import type { PlotAxis, PlotModel, Spot } from "./plot_model";
import type { PoseRows, Results } from "./results";

export type Coordinate = (typeof placementKeys)[number];

export const pointsMax = 50000;
const cellsAside = 128;
const nearPixels = 14;

/** Each coordinate of B in A's frame, of all rows. */
export type Coordinates = Record<Coordinate, Float64Array>;

export function coordinatesOf(rows: PoseRows): Coordinates {
    const count = rows.scenarios.length;
    const all = Object.fromEntries(placementKeys.map((key) => [key, new Float64Array(count)])) as Coordinates;
    for (let i = 0; i < count; ++i) {
        let placement: Placement;
        if (rows.width === 24) {
            const a = Array.from(rows.values.subarray(24 * i, 24 * i + 12));
            const b = Array.from(rows.values.subarray(24 * i + 12, 24 * i + 24));
            placement = placementOf(compose(inverse(a), b));
        } else {
            placement = placementOf(rows.values, 12 * i);
        }
        for (const key of placementKeys) {
            all[key][i] = placement[key];
        }
    }
    return all;
}

/** Returns the two coordinates that differ most, lengths before angles. */
export function bestCoordinates(all: Coordinates): [Coordinate, Coordinate] {
    const spread = (key: Coordinate) => {
        const [low, high] = boundsOf(all[key]);
        return (high - low) * (isAngle(key) ? 1e-6 : 1);
    };
    const [first, second] = placementKeys
        .filter((key) => key !== "distance")
        .sort((a, b) => spread(b) - spread(a));
    return placementKeys.indexOf(first) < placementKeys.indexOf(second) ? [first, second] : [second, first];
}

function boundsOf(values: Float64Array): [number, number] {
    let [low, high] = [Infinity, -Infinity];
    for (const value of values) {
        low = Math.min(low, value);
        high = Math.max(high, value);
    }
    return low < high ? [low, high] : [low - 0.5, low + 0.5];
}

function axisOf(key: Coordinate, values: Float64Array, unit: string): PlotAxis {
    const [first, last] = boundsOf(values);
    const margin = 0.03 * (last - first);
    return { title: key, first: first - margin, last: last + margin, unit: isAngle(key) ? "°" : ` ${unit}` };
}

class Points implements PlotModel {
    private readonly order: Uint32Array; // The worst is drawn last.

    constructor(
        private readonly results: Results,
        private readonly elements: Int32Array,
        private readonly px: Float64Array,
        private readonly py: Float64Array,
        readonly x: PlotAxis,
        readonly y: PlotAxis,
    ) {
        this.order = Uint32Array.from(px, (_, i) => i).sort((a, b) => this.rank(a) - this.rank(b) || a - b);
    }

    private rank(point: number): number {
        return severity(this.kind(point));
    }

    private kind(point: number): number {
        return this.elements[point] < 0 ? untested : this.results.classes[this.elements[point]];
    }

    draw(context: OffscreenCanvasRenderingContext2D, width: number, height: number): void {
        const count = this.px.length;
        const radius = (count > 20000 ? 1 : count > 2000 ? 1.6 : 2.6) * devicePixelRatio;
        for (const point of this.order) {
            const kind = this.kind(point);
            const [x, y] = [this.px[point] * width, (1 - this.py[point]) * height];
            const [r, g, b] = colourOf(kind);
            context.fillStyle = `rgb(${r} ${g} ${b} / ${kind === 0 ? 0.6 : 0.9})`;
            context.beginPath();
            if (kind === 0 || kind === 1) {
                context.arc(x, y, radius, 0, 2 * Math.PI);
            } else if (kind === 2) {
                context.rect(x - radius, y - radius, 2 * radius, 2 * radius);
            } else {
                context.moveTo(x, y - 1.4 * radius);
                context.lineTo(x + 1.4 * radius, y + radius);
                context.lineTo(x - 1.4 * radius, y + radius);
            }
            context.fill();
        }
    }

    private spot(point: number): Spot {
        const scenario = this.results.scenarioAt(Math.max(0, this.elements[point]));
        const count = this.results.countAt(this.elements[point]);
        const place = [this.x, this.y].map((axis, i) => {
            const share = i === 0 ? this.px[point] : this.py[point];
            return `${axis.title} ${short(axis.first + share * (axis.last - axis.first))}${axis.unit}`;
        });
        const pairs = count > 0 ? `, ${grouped(count)} pairs` : "";
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
    rows: PoseRows,
    all: Coordinates,
    xKey: Coordinate,
    yKey: Coordinate,
    unit: string,
): PlotModel {
    const [x, y] = [axisOf(xKey, all[xKey], unit), axisOf(yKey, all[yKey], unit)];
    const share = (axis: PlotAxis, value: number) => (value - axis.first) / (axis.last - axis.first);
    const px = all[xKey].map((value) => share(x, value));
    const py = all[yKey].map((value) => share(y, value));
    // Without all classes the poses are the same sample, element by element.
    const elements = Int32Array.from(rows.scenarios, (scenario, i) =>
        results.isExact ? scenario - results.first : i < results.classes.length && rows.isSample ? i : -1,
    );
    if (!results.isExact && !rows.isSample) {
        for (let i = 0; i < results.classes.length; ++i) {
            elements[results.scenarioAt(i)] = i;
        }
    }
    if (px.length <= pointsMax) {
        const shown = elements.every((element) => element >= 0)
            ? null
            : [...elements.keys()].filter((i) => elements[i] >= 0);
        return shown
            ? new Points(
                  results,
                  Int32Array.from(shown, (i) => elements[i]),
                  Float64Array.from(shown, (i) => px[i]),
                  Float64Array.from(shown, (i) => py[i]),
                  x,
                  y,
              )
            : new Points(results, elements, px, py, x, y);
    }
    const cells = new Cells(results, x, y, cellsAside, cellsAside, true, () => "");
    for (let i = 0; i < px.length; ++i) {
        if (elements[i] >= 0) {
            cells.add(Math.floor(px[i] * cellsAside), Math.floor(py[i] * cellsAside), elements[i]);
        }
    }
    return cells;
}
