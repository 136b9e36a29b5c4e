import { useEffect, useMemo, useState } from "preact/hooks";
import { isAbort, messageOf } from "../base/api";
import { placementKeys } from "../base/pose";
import { goTo, scenarioLink } from "../base/route";
import { tellFacts } from "../base/facts";
import type { Job } from "../base/types";
import { grouped } from "../base/words";
import { Notice, Panel } from "../ui/small";
import { type Grid, gridCells, gridOf } from "./grid";
import type { PlotModel } from "./plot_model";
import { PosePlot } from "./pose_plot";
import { loadPoses, type PoseRows, type Results } from "./results";
import { bestCoordinates, type Coordinate, coordinatesOf, pointsMax, scatterOf } from "./scatter";

/** Publishes where scenarios are drawn, so that tests can point at them. */
function useSpotFacts(model: PlotModel | null) {
    useEffect(
        () =>
            tellFacts("pose space", () => {
                const spot = model?.step(null, 1, 0) ?? null;
                return { poseSpace: spot && { ...spot, axes: [model?.x.title, model?.y.title] } };
            }),
        [model],
    );
}

function Choice(props: { label: string; value: string; all: readonly string[]; choose: (one: string) => void }) {
    return (
        <label>
            {props.label}{" "}
            <select value={props.value} onChange={(event) => props.choose(event.currentTarget.value)}>
                {props.all.map((one) => (
                    <option key={one} value={one}>
                        {one}
                    </option>
                ))}
            </select>
        </label>
    );
}

function startOf(grid: Grid): { x: number; y: number; fixed: number[] } {
    const varying = grid.varying();
    return {
        x: varying[0] ?? 0,
        y: varying[1] ?? varying[0] ?? 0,
        fixed: grid.axes.map(() => 0),
    };
}

function GridSpace({ job, grid, results }: { job: Job; grid: Grid; results: Results }) {
    const [{ x, y, fixed }, choose] = useState(() => startOf(grid));
    const model = useMemo(() => gridCells(grid, results, x, y, fixed), [grid, results, x, y, fixed]);
    useSpotFacts(model);
    const varying = grid.varying();
    const names = varying.map((axis) => grid.axes[axis].name);
    const pick = (which: "x" | "y", name: string) => {
        const axis = grid.axes.findIndex((one) => one.name === name);
        const [here, there] = which === "x" ? [x, y] : [y, x];
        const other = axis === there ? here : there; // The axes change places.
        choose({ x: which === "x" ? axis : other, y: which === "x" ? other : axis, fixed });
    };
    const others = varying.filter((axis) => axis !== x && axis !== y);
    return (
        <Panel
            title="pose space"
            note={results.isExact ? "" : `a sample of ${grouped(results.classes.length)}, other axes folded`}
        >
            <div class="controls">
                {varying.length > 1 && (
                    <>
                        <Choice label="across" value={grid.axes[x].name} all={names} choose={(name) => pick("x", name)} />
                        <Choice label="up" value={grid.axes[y].name} all={names} choose={(name) => pick("y", name)} />
                    </>
                )}
                {results.isExact &&
                    others.map((axis) => (
                        <label key={axis} class="slider">
                            <input
                                type="range"
                                min={0}
                                max={grid.axes[axis].count - 1}
                                value={fixed[axis]}
                                onInput={(event) => {
                                    const number = Number(event.currentTarget.value);
                                    choose({ x, y, fixed: fixed.map((old, i) => (i === axis ? number : old)) });
                                }}
                            />{" "}
                            {grid.valueText(axis, fixed[axis])}
                        </label>
                    ))}
            </div>
            <PosePlot model={model} open={(scenario) => goTo(scenarioLink(job.job, scenario))} />
        </Panel>
    );
}

function CloudSpace({ job, results }: { job: Job; results: Results }) {
    const [rows, setRows] = useState<PoseRows | null>(null);
    const [error, setError] = useState("");
    const [axes, setAxes] = useState<[Coordinate, Coordinate] | null>(null);
    useEffect(() => {
        const stop = new AbortController();
        loadPoses(job, stop.signal).then(setRows, (reason) => isAbort(reason) || setError(messageOf(reason)));
        return () => stop.abort();
    }, [job.job, job.scenarios]);
    const all = useMemo(() => (rows ? coordinatesOf(rows) : null), [rows]);
    const [x, y] = axes ?? (all ? bestCoordinates(all) : ["x", "y"]);
    const model = useMemo(
        () => (rows && all ? scatterOf(results, rows, all, x, y, job.unit) : null),
        [results, rows, all, x, y],
    );
    useSpotFacts(model);
    const shownShares = rows !== null && rows.scenarios.length > pointsMax;
    const note = [
        rows?.isSample || !results.isExact ? `a sample of ${grouped(Math.min(rows?.scenarios.length ?? 0, results.classes.length))}` : "",
        shownShares ? "share of contacts in each cell" : "",
        job.poses.penetration ? "poses pushed to contact" : "",
    ];
    return (
        <Panel title="pose space" note={note.filter((text) => text !== "").join(", ")}>
            {error && <Notice kind="bad">{error}</Notice>}
            <div class="controls">
                <Choice label="across" value={x} all={placementKeys} choose={(name) => setAxes([name as Coordinate, y])} />
                <Choice label="up" value={y} all={placementKeys} choose={(name) => setAxes([x, name as Coordinate])} />
                <span class="note">of B in A's frame</span>
            </div>
            {model ? (
                <PosePlot model={model} open={(scenario) => goTo(scenarioLink(job.job, scenario))} />
            ) : (
                <p class="wait">reading the poses…</p>
            )}
        </Panel>
    );
}

/** The poses in space: cells of a grid, points of a file or of random poses. */
export function PoseSpace({ job, results }: { job: Job; results: Results }) {
    const grid = useMemo(() => gridOf(job), [job.job]);
    return grid ? (
        <GridSpace job={job} grid={grid} results={results} />
    ) : (
        <CloudSpace job={job} results={results} />
    );
}
