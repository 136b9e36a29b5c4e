/** A picture of the pose space that can be asked what is where. */
export interface PlotAxis {
    title: string;
    first: number;
    last: number;
    unit: string;
}

/** A place in the unit square, y upwards, and the scenario that it opens. */
export interface Spot {
    scenario: number;
    text: string;
    x: number;
    y: number;
    width: number;
    height: number;
}

export interface PlotModel {
    readonly x: PlotAxis;
    readonly y: PlotAxis;
    /** Draws into a canvas of this many pixels. */
    draw(context: OffscreenCanvasRenderingContext2D, width: number, height: number): void;
    /** Returns what is at a point of the unit square, drawn on this many pixels. */
    at(x: number, y: number, width: number, height: number): Spot | null;
    /** Returns the neighbour in a direction (-1, 0, 1 each); some spot if there is none yet. */
    step(spot: Spot | null, dx: number, dy: number): Spot | null;
}
