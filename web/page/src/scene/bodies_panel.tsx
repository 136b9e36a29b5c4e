import { useMemo, useState } from "preact/hooks";
import { scenarioLink } from "../base/route";
import type { Job } from "../base/types";
import { counted, grouped } from "../base/words";
import { ClassMark, Name, Panel } from "../ui/small";
import { type Column, Table } from "../ui/table";
import { isFiltered, noFilter, rangeText, readRange, type SceneFilter, writeFilter } from "./filter";
import { type BodySum, type SceneRows, sumsByBody, topBodies } from "./scene_rows";

const shownMax = 100;

interface PanelProps {
    job: Job;
    rows: SceneRows;
    filter: SceneFilter;
    change: (filter: SceneFilter) => void;
}

function worstCell({ job, rows, filter }: PanelProps, { worst }: BodySum) {
    if (worst < 0) {
        return "-";
    }
    const scenario = rows.results.scenarioAt(worst);
    return (
        <a href={scenarioLink(job.job, scenario, writeFilter(filter))}>
            <ClassMark kind={rows.results.classes[worst]} /> #{grouped(scenario)}
        </a>
    );
}

function columnsOf(props: PanelProps, names: readonly string[]): Column<BodySum>[] {
    const { job, filter, change } = props;
    const number = (key: "scenarios" | "contacts" | "near", title: string): Column<BodySum> => ({
        key,
        title,
        cell: (sum) => grouped(sum[key]),
        value: (sum) => sum[key],
        isNumber: true,
    });
    const isChosen = ({ body }: BodySum) => filter.body === names[body];
    return [
        {
            key: "body",
            title: "body",
            cell: (sum) => (
                <button
                    type="button"
                    class="link"
                    aria-pressed={isChosen(sum)}
                    onClick={() => change({ ...filter, body: isChosen(sum) ? "" : names[sum.body] })}
                >
                    <Name text={names[sum.body]} />
                </button>
            ),
            value: ({ body }) => names[body],
        },
        number("contacts", "in contact"),
        ...(job.clearance === null ? [] : [number("near", "near")]),
        number("scenarios", "scenarios"),
        {
            key: "worst",
            title: "worst",
            cell: (sum) => worstCell(props, sum),
            value: ({ worst }) => (worst < 0 ? 0 : props.rows.results.countAt(worst)),
            isNumber: true,
        },
    ];
}

/** Which scenarios are shown, and fields that change it. */
function FilterFields({ job, filter, change }: Omit<PanelProps, "rows">) {
    const steps = filter.steps ? rangeText(filter.steps) : "";
    return (
        <div class="controls">
            <label>
                steps{" "}
                <input
                    type="text"
                    size={12}
                    aria-label="range of steps"
                    placeholder={`0-${(job.steps ?? 1) - 1}`}
                    value={steps}
                    onChange={(event) => change({ ...filter, steps: readRange(event.currentTarget.value) })}
                />
            </label>
            {isFiltered(filter) && (
                <span class="note">
                    only {filter.body ? <Name text={filter.body} /> : "scenarios"}
                    {steps && ` in steps ${steps}`}{" "}
                    <button type="button" class="link" onClick={() => change(noFilter)}>
                        show all
                    </button>
                </span>
            )}
        </div>
    );
}

/** The bodies of a scene, those in most contacts first; a click shows the scenarios of one alone. */
export function BodiesPanel(props: PanelProps) {
    const { job, rows } = props;
    const [text, setText] = useState("");
    const names = useMemo(() => job.bodies.map(({ name }) => name), [job.job]);
    const sums = useMemo(() => sumsByBody(rows, names.length), [rows, names]);
    const shown = useMemo(() => topBodies(sums, names, text, shownMax), [sums, names, text]);
    const sample = rows.areAll ? "" : `; counted in a sample of ${counted(rows.count, "scenario")}`;
    const part = names.length > shownMax ? `at most ${shownMax} of ` : "";
    return (
        <Panel title="bodies" note={`${part}${grouped(names.length)} bodies, most contacts first${sample}`}>
            <FilterFields job={job} filter={props.filter} change={props.change} />
            <input
                type="search"
                aria-label="bodies whose name holds"
                placeholder="a body's name"
                value={text}
                onInput={(event) => setText(event.currentTarget.value)}
            />
            <Table
                caption="bodies"
                rows={shown}
                rowKey={({ body }) => String(body)}
                empty="no body has such a name"
                columns={columnsOf(props, names)}
            />
        </Panel>
    );
}
