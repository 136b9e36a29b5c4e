import { useEffect, useMemo, useState } from "preact/hooks";
import type { Coordinate } from "../base/pose";
import { goTo, scenarioLink } from "../base/route";
import { tellFacts } from "../base/facts";
import { asksShots, countNoun, hasDirections, type Job, type Source } from "../base/types";
import { grouped, percent } from "../base/words";
import { useReloaded } from "../ui/hooks";
import { Notice, Panel } from "../ui/small";
import { type Grid, gridCells, gridOf } from "./grid";
import type { JobView } from "./job_view";
import type { PlotModel } from "./plot_model";
import { PosePlot } from "./pose_plot";
import { bestCoordinates, chooseCoordinates, keepsAllCoordinates, keysOf, loadCoordinates } from "./poses";
import { masterMax, type Results } from "./results";
import { pointsMax, scatterOf } from "./scatter";
import { loadSlice, scenariosOfSlice, sliceWindowsMax, windowsOf } from "./slice";

const slicePause = 150; // Milliseconds, so that a slider that moves reads no slice.

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

interface SpaceProps {
    source: Source;
    job: Job;
    results: Results;
    view: JobView;
    change: (part: Partial<JobView>) => void;
}

/** Returns the axes that a view names, or else the first two that vary. */
function axesOf(grid: Grid, view: JobView): [number, number] {
    const [first = 0, second = first] = grid.varying();
    const [x, y] = [grid.varyingNamed(view.x), grid.varyingNamed(view.y)];
    return x !== undefined && y !== undefined && (x !== y || first === second) ? [x, y] : [first, second];
}

/** The slice that is shown: of all results, or read by itself where these are a sample. */
function useSlice(props: SpaceProps, grid: Grid, x: number, y: number, fixed: readonly number[]) {
    const { job, results } = props;
    const key = results.isExact ? null : [x, y, ...fixed].join(" ");
    const scenarios = useMemo(() => (key === null ? null : scenariosOfSlice(grid, x, y, fixed)), [key]);
    const windows = useMemo(() => scenarios && windowsOf(scenarios), [scenarios]);
    const slice = useReloaded(windows && key, results, async (signal) => {
        await new Promise((resolve) => setTimeout(resolve, slicePause));
        return loadSlice(job, scenarios ?? new Float64Array(), windows ?? [], signal);
    });
    return { ...slice, isTooScattered: key !== null && windows === null };
}

function sliceNote(results: Results, slice: { value: Results | null; isTooScattered: boolean }): string {
    if (results.isExact || slice.value) {
        return "";
    }
    const why = slice.isTooScattered
        ? `: this slice lies in more than ${sliceWindowsMax} windows of ${grouped(masterMax)}`
        : "; reading the slice…";
    return `a sample of ${grouped(results.classes.length)}, other axes folded${why}`;
}

function GridSpace(props: SpaceProps & { grid: Grid }) {
    const { job, grid, results, view, change } = props;
    const [x, y] = axesOf(grid, view);
    const numbers = grid.axes.map(({ name }, axis) => (name in view.at ? grid.nearest(axis, view.at[name]) : 0));
    const isFixed = (axis: number) => axis !== x && axis !== y;
    const fixed = useMemo(() => numbers.map((one, axis) => (isFixed(axis) ? one : 0)), [x, y, ...numbers]);
    const slice = useSlice(props, grid, x, y, fixed);
    const shown = slice.value ?? results;
    const model = useMemo(() => gridCells(grid, shown, x, y, fixed), [grid, shown, x, y, fixed]);
    useSpotFacts(model);
    const varying = grid.varying();
    const nameOf = (axis: number) => grid.axes[axis].name;
    const names = varying.map(nameOf);
    const pick = (which: "x" | "y", name: string) => {
        const axis = grid.varyingNamed(name) ?? x;
        const [here, there] = which === "x" ? [x, y] : [y, x];
        const other = axis === there ? here : there; // The axes change places.
        const [across, up] = which === "x" ? [axis, other] : [other, axis];
        change({ x: nameOf(across), y: nameOf(up) });
    };
    return (
        <Panel title="pose space" note={sliceNote(results, slice)}>
            {slice.error && <Notice kind="bad">{slice.error}</Notice>}
            <div class="controls">
                {varying.length > 1 && (
                    <>
                        <Choice label="across" value={nameOf(x)} all={names} choose={(name) => pick("x", name)} />
                        <Choice label="up" value={nameOf(y)} all={names} choose={(name) => pick("y", name)} />
                    </>
                )}
                {!slice.isTooScattered &&
                    varying.filter(isFixed).map((axis) => (
                        <label key={axis} class="slider">
                            <input
                                type="range"
                                min={0}
                                max={grid.axes[axis].count - 1}
                                value={fixed[axis]}
                                onInput={(event) => {
                                    const value = grid.brief(axis, Number(event.currentTarget.value));
                                    change({ at: { ...view.at, [nameOf(axis)]: value } });
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

function isCoordinate(name: string, keys: readonly Coordinate[]): name is Coordinate {
    return (keys as readonly string[]).includes(name);
}

/** The coordinates that a view names, or else those that differ most; with their values. */
function useCloud({ source, job, view }: SpaceProps, tell: (share: number) => void) {
    const named = isCoordinate(view.x, keysOf(job)) && isCoordinate(view.y, keysOf(job)) ? ([view.x, view.y] as const) : null;
    const keepsAll = keepsAllCoordinates(source, job);
    const chosen = useReloaded(named || keepsAll ? null : job.job, 0, (signal) => chooseCoordinates(job, signal));
    const keys = keepsAll ? keysOf(job) : (named ?? chosen.value);
    const loaded = useReloaded(keys && keys.join(" "), 0, (signal) =>
        loadCoordinates(source, job, keys ?? [], signal, tell),
    );
    const all = loaded.value;
    const best = useMemo(() => (keepsAll ? all && bestCoordinates(all) : chosen.value), [all, chosen.value]);
    return { drawn: named ?? best, all, error: chosen.error || loaded.error };
}

function CloudSpace(props: SpaceProps) {
    const { job, results, change } = props;
    const [share, tell] = useState(0);
    const { drawn, all, error } = useCloud(props, tell);
    const [x, y] = drawn ?? keysOf(job);
    const [xs, ys] = [all?.get(x), all?.get(y)];
    const model = useMemo(
        () => (xs && ys ? scatterOf(results, [x, xs], [y, ys], job.unit, countNoun(job)) : null),
        [results, x, y, xs, ys],
    );
    useSpotFacts(model);
    const note = [
        results.isExact ? "" : `a sample of ${grouped(results.classes.length)}`,
        results.classes.length > pointsMax ? "share of contacts in each cell" : "",
        job.poses.penetration ? "poses pushed to contact" : "",
    ];
    return (
        <Panel title={hasDirections(job) ? "directions" : "pose space"} note={note.filter((text) => text !== "").join(", ")}>
            {error && <Notice kind="bad">{error}</Notice>}
            <div class="controls">
                <Choice label="across" value={x} all={keysOf(job)} choose={(name) => change({ x: name, y })} />
                <Choice label="up" value={y} all={keysOf(job)} choose={(name) => change({ x, y: name })} />
                <span class="note">{hasDirections(job) ? "where the lines come from" : "of B in A's frame"}</span>
            </div>
            {model ? (
                <PosePlot model={model} open={(scenario) => goTo(scenarioLink(job.job, scenario))} />
            ) : (
                <p class="wait">reading the poses… {share > 0 && percent(share)}</p>
            )}
        </Panel>
    );
}

/** The poses in space: cells of a grid, points of a file or of random poses. */
export function PoseSpace(props: SpaceProps) {
    const grid = useMemo(() => gridOf(props.job), [props.job.job]);
    if (asksShots(props.job) && !hasDirections(props.job)) {
        return null; // All lines of a file stand in one pose.
    }
    return grid ? <GridSpace {...props} grid={grid} /> : <CloudSpace {...props} />;
}
