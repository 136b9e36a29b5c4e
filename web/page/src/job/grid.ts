/** Grids of poses: which scenario has which place, and a slice of them as cells. */
import { isAngle } from "../base/pose";
import type { Axis, Job } from "../base/types";
import { short } from "../base/words";
import { Cells } from "./cells";
import type { PlotAxis } from "./plot_model";
import type { Results } from "./results";

const cellsMax = 512;
const sampledCellsMax = 40; // So that most cells hold some of a sample.

/** The axes of a grid, the slowest first, with each one's step in the scenarios' numbers. */
export class Grid {
    readonly strides: number[];

    constructor(
        readonly axes: Axis[],
        private readonly unit: string,
    ) {
        this.strides = axes.map((_, i) => axes.slice(i + 1).reduce((product, axis) => product * axis.count, 1));
    }

    /** The axes that have more than one value. */
    varying(): number[] {
        return this.axes.flatMap((axis, i) => (axis.count > 1 ? [i] : []));
    }

    value(axis: number, number: number): number {
        const { first, last, count } = this.axes[axis];
        return number === 0 ? first : number === count - 1 ? last : first + ((last - first) * number) / (count - 1);
    }

    /** Returns the number along an axis of a scenario. */
    numberOf(axis: number, scenario: number): number {
        return Math.floor(scenario / this.strides[axis]) % this.axes[axis].count;
    }

    unitOf(axis: number): string {
        return isAngle(this.axes[axis].name) ? "°" : ` ${this.unit}`;
    }

    plotAxis(axis: number): PlotAxis {
        const { name, first, last } = this.axes[axis];
        return { title: name, first, last, unit: this.unitOf(axis) };
    }

    /** Returns the number along an axis whose value is nearest. */
    nearest(axis: number, value: number): number {
        const { first, last, count } = this.axes[axis];
        const at = last === first ? 0 : ((value - first) / (last - first)) * (count - 1);
        return Math.min(count - 1, Math.max(0, Math.round(at)));
    }

    /** Returns the shortest value that `nearest` leads back to the number. */
    brief(axis: number, number: number): number {
        const value = this.value(axis, number);
        const digits = [4, 6, 9, 12].find((count) => this.nearest(axis, Number(value.toPrecision(count))) === number);
        return digits === undefined ? value : Number(value.toPrecision(digits));
    }

    /** Returns the axis with this name; undefined unless it has more than one value. */
    varyingNamed(name: string): number | undefined {
        return this.varying().find((axis) => this.axes[axis].name === name);
    }

    valueText(axis: number, number: number): string {
        return `${this.axes[axis].name} ${short(this.value(axis, number))}${this.unitOf(axis)}`;
    }

    describe(scenario: number): string {
        const values = this.varying().map((axis) => this.valueText(axis, this.numberOf(axis, scenario)));
        return values.length === 0 ? "" : ` at ${values.join(", ")}`;
    }
}

/**
 * Returns the slice of a grid in which the axes other than `x` and `y` have the numbers `fixed`. Of a
 * sample, and of the results of a slice, all elements are shown, whatever their other axes.
 */
export function gridCells(grid: Grid, results: Results, x: number, y: number, fixed: number[]): Cells {
    const most = results.isSample ? sampledCellsMax : cellsMax;
    const columns = Math.min(most, grid.axes[x].count);
    const rows = Math.min(most, grid.axes[y].count);
    const cells = new Cells(results, grid.plotAxis(x), grid.plotAxis(y), columns, rows, false, (scenario) =>
        grid.describe(scenario),
    );
    const columnOf = (number: number) => Math.floor((number * columns) / grid.axes[x].count);
    const rowOf = (number: number) => Math.floor((number * rows) / grid.axes[y].count);
    if (!results.isExact) {
        for (let i = 0; i < results.classes.length; ++i) {
            const scenario = results.scenarioAt(i);
            cells.add(columnOf(grid.numberOf(x, scenario)), rowOf(grid.numberOf(y, scenario)), i);
        }
        return cells;
    }
    const base = fixed.reduce(
        (sum, number, axis) => sum + (axis === x || axis === y ? 0 : number * grid.strides[axis]),
        0,
    );
    for (let i = 0; i < grid.axes[x].count; ++i) {
        for (let j = 0; j < (x === y ? 1 : grid.axes[y].count); ++j) {
            const scenario = base + i * grid.strides[x] + (x === y ? 0 : j * grid.strides[y]);
            cells.add(columnOf(i), x === y ? 0 : rowOf(j), scenario - results.first);
        }
    }
    return cells;
}

export function gridOf(job: Job): Grid | null {
    return job.poses.kind === "grid" && job.poses.axes ? new Grid(job.poses.axes, job.unit) : null;
}
