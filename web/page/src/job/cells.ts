/** Cells over two axes of the pose space; each shows the worst of its scenarios. */
import { colourOf, isContact, nameOf, type Rgb, untested } from "../base/classes";
import { grouped, percent, short } from "../base/words";
import { traceGlyph } from "./glyphs";
import type { PlotAxis, PlotModel, Spot } from "./plot_model";
import type { Results } from "./results";

const glyphPixelsMin = 10;

export class Cells implements PlotModel {
    /** The worst element in each cell; -1 if the cell is empty. */
    private readonly worst: Int32Array;
    private readonly number: Uint32Array;
    private readonly tested: Uint32Array;
    private readonly contacts: Uint32Array;

    constructor(
        private readonly results: Results,
        readonly x: PlotAxis,
        readonly y: PlotAxis,
        private readonly columns: number,
        private readonly rows: number,
        /** Whether colours show the share of scenarios in contact rather than the worst class. */
        private readonly showsShares: boolean,
        private readonly describe: (scenario: number) => string,
    ) {
        const size = columns * rows;
        this.worst = new Int32Array(size).fill(-1);
        this.number = new Uint32Array(size);
        this.tested = new Uint32Array(size);
        this.contacts = new Uint32Array(size);
    }

    /** Adds an element of the results to a cell. */
    add(column: number, row: number, element: number): void {
        const cell = row * this.columns + column;
        const kind = this.results.classes[element];
        this.number[cell] += 1;
        this.tested[cell] += kind === untested ? 0 : 1;
        this.contacts[cell] += isContact(kind) ? 1 : 0;
        if (this.worst[cell] < 0 || this.results.isWorse(element, this.worst[cell])) {
            this.worst[cell] = element;
        }
    }

    private colour(cell: number): Rgb {
        const kind = this.results.classes[this.worst[cell]];
        if (!this.showsShares || this.tested[cell] === 0) {
            return colourOf(kind);
        }
        const share = this.contacts[cell] / this.tested[cell];
        const [free, clash] = [colourOf(0), colourOf(2)];
        return [0, 1, 2].map((i) => free[i] + (clash[i] - free[i]) * share) as unknown as Rgb;
    }

    draw(context: OffscreenCanvasRenderingContext2D, width: number, height: number): void {
        const image = new ImageData(this.columns, this.rows);
        for (let cell = 0; cell < this.worst.length; ++cell) {
            if (this.worst[cell] < 0) {
                continue;
            }
            const row = this.rows - 1 - Math.floor(cell / this.columns);
            const at = 4 * (row * this.columns + (cell % this.columns));
            image.data.set([...this.colour(cell), 255], at);
        }
        const small = new OffscreenCanvas(this.columns, this.rows);
        small.getContext("2d")?.putImageData(image, 0, 0);
        context.imageSmoothingEnabled = false;
        context.drawImage(small, 0, 0, width, height);
        this.drawGlyphs(context, width / this.columns, height / this.rows);
    }

    private drawGlyphs(context: OffscreenCanvasRenderingContext2D, width: number, height: number): void {
        const size = Math.min(width, height);
        if (size < glyphPixelsMin || this.showsShares) {
            return;
        }
        context.strokeStyle = "rgb(0 0 0 / 0.3)";
        context.lineWidth = Math.max(1, size / 14);
        context.beginPath();
        for (let cell = 0; cell < this.worst.length; ++cell) {
            if (this.worst[cell] >= 0) {
                const x = ((cell % this.columns) + 0.5) * width;
                const y = (this.rows - 0.5 - Math.floor(cell / this.columns)) * height;
                const kind = this.results.classes[this.worst[cell]];
                if (kind !== 0 && kind !== untested) {
                    traceGlyph(context, kind, x, y, size * 0.2);
                }
            }
        }
        context.stroke();
    }

    private spot(column: number, row: number): Spot | null {
        const cell = row * this.columns + column;
        if (column < 0 || row < 0 || column >= this.columns || row >= this.rows || this.worst[cell] < 0) {
            return null;
        }
        return {
            scenario: this.results.scenarioAt(this.worst[cell]),
            text: this.text(cell),
            x: column / this.columns,
            y: row / this.rows,
            width: 1 / this.columns,
            height: 1 / this.rows,
        };
    }

    private text(cell: number): string {
        const element = this.worst[cell];
        const scenario = this.results.scenarioAt(element);
        const count = this.results.countAt(element);
        const pairs = count > 0 ? `, ${grouped(count)} pairs` : "";
        const one = `#${scenario} ${nameOf(this.results.classes[element])}${pairs}${this.describe(scenario)}`;
        if (this.number[cell] === 1) {
            return one;
        }
        const share = percent(this.contacts[cell] / Math.max(1, this.tested[cell]));
        return `${grouped(this.number[cell])} scenarios, ${share} in contact; the worst is ${one}`;
    }

    at(x: number, y: number): Spot | null {
        return this.spot(Math.floor(x * this.columns), Math.floor(y * this.rows));
    }

    step(spot: Spot | null, dx: number, dy: number): Spot | null {
        let column = spot ? Math.round(spot.x * this.columns) : Math.floor(this.columns / 2) - dx;
        let row = spot ? Math.round(spot.y * this.rows) : Math.floor(this.rows / 2) - dy;
        for (;;) {
            column += dx;
            row += dy;
            if (column < 0 || row < 0 || column >= this.columns || row >= this.rows) {
                return spot;
            }
            const found = this.spot(column, row);
            if (found) {
                return found;
            }
        }
    }
}

/** The text of a value on an axis: at most four digits and its unit. */
export function axisText(axis: PlotAxis, value: number): string {
    return `${short(value)}${axis.unit}`;
}
