import { useMemo } from "preact/hooks";
import { coordinateOf, shotKeys } from "../base/pose";
import { scenarioLink } from "../base/route";
import { hasDirections, type Job } from "../base/types";
import { grouped, short } from "../base/words";
import { getArray } from "../base/api";
import { useReloaded } from "../ui/hooks";
import { Notice, Panel } from "../ui/small";
import { type Column, Table } from "../ui/table";
import { pathOf, type Results } from "./results";

const shownMax = 10;

/** Returns the elements with most hits, the most first, of equal ones the first; without hits none. */
export function mostHitOf(results: Results, count = shownMax): number[] {
    const elements = Array.from(results.classes, (_, i) => i).filter((one) => results.countAt(one) > 0);
    return elements.sort((a, b) => results.countAt(b) - results.countAt(a) || a - b).slice(0, count);
}

interface Row {
    scenario: number;
    hits: number;
    /** The pose of the bundle; null while it is not read. */
    pose: ArrayLike<number> | null;
}

/** Reads where the bundles of a few scenarios stand. */
async function loadPoses(job: Job, scenarios: readonly number[], signal: AbortSignal): Promise<ArrayLike<number>[]> {
    const read = (one: number) => getArray(`${pathOf(job, "poses")}?first=${one}&count=1`, signal);
    return Promise.all(scenarios.map(async (one) => (await read(one)).values as Float64Array));
}

/** The bundles of lines with most hits, and where their lines come from. */
export function MostHits({ job, results }: { job: Job; results: Results }) {
    const most = useMemo(() => mostHitOf(results), [results]);
    const scenarios = most.map((one) => results.scenarioAt(one));
    const key = hasDirections(job) && scenarios.length > 0 ? scenarios.join(" ") : null;
    const poses = useReloaded(key, 0, (signal) => loadPoses(job, scenarios, signal));
    const rows = most.map(
        (one, i): Row => ({ scenario: scenarios[i], hits: results.countAt(one), pose: poses.value?.[i] ?? null }),
    );
    const angles = (hasDirections(job) ? shotKeys : []).map(
        (angle): Column<Row> => ({
            key: angle,
            title: `${angle} [°]`,
            cell: ({ pose }) => (pose ? short(coordinateOf(angle, pose), 5) : ""),
            value: ({ pose }) => (pose ? coordinateOf(angle, pose) : 0),
            isNumber: true,
        }),
    );
    return (
        <Panel title="most hits" note={results.isExact ? "" : "of the sample"}>
            {poses.error && <Notice kind="bad">{poses.error}</Notice>}
            <Table
                caption="most hits"
                rows={rows}
                rowKey={(row) => String(row.scenario)}
                empty="no line hits anything"
                columns={[
                    {
                        key: "scenario",
                        title: "bundle",
                        cell: (row) => <a href={scenarioLink(job.job, row.scenario)}>#{grouped(row.scenario)}</a>,
                        value: (row) => row.scenario,
                        isNumber: true,
                    },
                    ...angles,
                    { key: "hits", title: "hits", cell: (row) => grouped(row.hits), value: (row) => row.hits, isNumber: true },
                ]}
            />
        </Panel>
    );
}
