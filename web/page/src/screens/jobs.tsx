import { useEffect } from "preact/hooks";
import { tellFacts } from "../base/facts";
import { goTo, jobLink } from "../base/route";
import type { JobRow } from "../base/types";
import { duration, grouped, percent, rate } from "../base/words";
import { usePolled, useTitle } from "../ui/hooks";
import { Name, Notice, Progress } from "../ui/small";
import { type Column, Table } from "../ui/table";

function remaining(job: JobRow): number {
    const speed = job.scenarios_per_second ?? 0;
    return job.state === "running" && speed > 0 ? (job.scenarios - job.done) / speed : NaN;
}

const columns: Column<JobRow>[] = [
    { key: "job", title: "job", cell: (j) => <a href={jobLink(j.job)}>{j.job}</a>, value: (j) => j.job },
    { key: "name", title: "name", cell: (j) => <Name text={j.name} />, value: (j) => j.name },
    {
        key: "state",
        title: "state",
        cell: (j) => (
            <span class={`state ${j.state === "failed" ? "bad" : j.state === "paused" ? "warn" : ""}`}>{j.state}</span>
        ),
        value: (j) => j.state,
    },
    { key: "owner", title: "owner", cell: (j) => <Name text={j.owner || "-"} />, value: (j) => j.owner ?? "" },
    { key: "began", title: "began", cell: (j) => (j.began ?? "").replace("T", " ").replace(/Z$/, " UTC"), value: (j) => j.began ?? "" },
    { key: "scenarios", title: "scenarios", cell: (j) => grouped(j.scenarios), value: (j) => j.scenarios, isNumber: true },
    {
        key: "done",
        title: "done",
        cell: (j) => <Progress done={j.done} total={j.scenarios} />,
        value: (j) => j.done / Math.max(1, j.scenarios),
        isNumber: true,
    },
    {
        key: "contact",
        title: "in contact",
        cell: (j) => (j.done === 0 ? "-" : percent(j.contact / j.done)),
        value: (j) => j.contact / Math.max(1, j.done),
        isNumber: true,
    },
    {
        key: "failed",
        title: "failed",
        cell: (j) => <span class={j.failed > 0 ? "state bad" : ""}>{grouped(j.failed)}</span>,
        value: (j) => j.failed,
        isNumber: true,
    },
    {
        key: "rate",
        title: "rate",
        cell: (j) => rate(j.scenarios_per_second ?? 0),
        value: (j) => j.scenarios_per_second ?? 0,
        isNumber: true,
    },
    { key: "eta", title: "ends in", cell: (j) => duration(remaining(j)), value: (j) => remaining(j) || 0, isNumber: true },
];

export function JobsTable(props: { jobs: JobRow[]; order?: (a: JobRow, b: JobRow) => number }) {
    return (
        <Table
            caption="jobs"
            columns={columns}
            rows={props.jobs}
            rowKey={(job) => job.job}
            {...(props.order ? { order: props.order } : {})}
            empty="no job yet: cdctl run job.toml --master HOST:7600"
        />
    );
}

/** All jobs. A source with one job shows that job instead. */
export function JobsScreen() {
    const { value, error } = usePolled<{ jobs: JobRow[] }>("jobs", 2);
    useTitle("jobs");
    useEffect(
        () => tellFacts("jobs", () => ({ ready: value !== undefined, jobs: value?.jobs.map((job) => job.job) })),
        [value],
    );
    useEffect(() => {
        if (value?.jobs.length === 1 && value.jobs[0].job === "folder") {
            goTo(jobLink("folder"));
        }
    }, [value]);
    if (!value) {
        return error ? <Notice kind="bad">{error}</Notice> : <p class="wait">asking for the jobs…</p>;
    }
    return (
        <>
            {error && <Notice kind="bad">{error}; below is what it said last</Notice>}
            <JobsTable jobs={value.jobs} />
        </>
    );
}
