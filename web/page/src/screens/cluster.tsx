import type { Cluster, History, JobRow, WorkerRow } from "../base/types";
import { bytes, bytesOf, counted, duration, grouped, percent, rate, wireRate } from "../base/words";
import { scenarioLink } from "../base/route";
import { tellFacts } from "../base/facts";
import { Chart } from "../ui/chart";
import { usePolled, useTitle } from "../ui/hooks";
import { Name, Notice, Panel } from "../ui/small";
import { type Column, Table } from "../ui/table";
import { JobsTable } from "./jobs";
import { useEffect } from "preact/hooks";

/** How much a worker's state needs somebody: silent and lost ones come first. */
function urgency(state: string): number {
    const order = ["lost", "silent", "quarantined", "draining"];
    const found = order.indexOf(state.split(" ")[0]);
    return found < 0 ? order.length : found;
}

const stateClasses = ["bad", "bad", "warn", "warn", ""];

const workerColumns: Column<WorkerRow>[] = [
    { key: "worker", title: "worker", cell: (w) => w.worker, value: (w) => w.worker },
    { key: "name", title: "name", cell: (w) => <Name text={w.name} />, value: (w) => w.name },
    {
        key: "state",
        title: "state",
        cell: (w) => <span class={`state ${stateClasses[urgency(w.state)]}`}>{w.state}</span>,
        value: (w) => w.state,
    },
    { key: "threads", title: "threads", cell: (w) => grouped(w.threads), value: (w) => w.threads, isNumber: true },
    { key: "working", title: "working", cell: (w) => grouped(w.working), value: (w) => w.working, isNumber: true },
    { key: "done", title: "done", cell: (w) => grouped(w.scenarios), value: (w) => w.scenarios, isNumber: true },
    {
        key: "rate",
        title: "rate",
        cell: (w) => rate(w.scenarios_per_second),
        value: (w) => w.scenarios_per_second,
        isNumber: true,
    },
    {
        key: "cache",
        title: "cache",
        cell: (w) => (w.cache_bytes ? bytesOf(w.cached_bytes, w.cache_bytes) : bytes(w.cached_bytes)),
        value: (w) => w.cached_bytes,
        isNumber: true,
    },
    { key: "hits", title: "hits", cell: (w) => percent(w.cache_hit_share), value: (w) => w.cache_hit_share, isNumber: true },
    { key: "peers", title: "to peers", cell: (w) => bytes(w.uploaded_bytes ?? 0), value: (w) => w.uploaded_bytes ?? 0, isNumber: true },
    {
        key: "longest",
        title: "longest",
        cell: (w) =>
            w.longest ? (
                <a href={scenarioLink(w.longest.job, w.longest.scenario)}>
                    #{w.longest.scenario} {duration(w.longest.seconds)}
                </a>
            ) : (
                "-"
            ),
        value: (w) => w.longest?.seconds ?? 0,
        isNumber: true,
    },
];

function Charts({ history }: { history: History }) {
    const column = (name: string) => {
        const at = history.columns.indexOf(name);
        return history.rows.map((row) => row[at] ?? 0);
    };
    const times = column("time");
    return (
        <div class="two">
            <Panel title="throughput" note="scenarios a second, ten minutes">
                <Chart
                    title="throughput"
                    times={times}
                    format={rate}
                    lines={[{ title: "scenarios", colour: "--accent", values: column("scenarios_per_second") }]}
                />
            </Panel>
            <Panel title="wire" note="bytes a second, seen from the master">
                <Chart
                    title="wire"
                    times={times}
                    format={wireRate}
                    lines={[
                        { title: "out", colour: "--accent", values: column("sent_per_second") },
                        { title: "in", colour: "--second", values: column("received_per_second"), dash: [6, 3] },
                        { title: "peer to peer", colour: "--third", values: column("peer_per_second"), dash: [2, 3] },
                    ]}
                />
            </Panel>
        </div>
    );
}

function Numbers({ cluster }: { cluster: Cluster }) {
    const here = cluster.workers.filter((worker) => !worker.state.startsWith("lost"));
    const threads = here.reduce((sum, worker) => sum + worker.threads, 0);
    const total = here.reduce((sum, worker) => sum + worker.scenarios_per_second, 0);
    const running = cluster.jobs.filter((job) => job.state === "running").length;
    return (
        <dl class="numbers">
            <div>
                <dt>scenarios</dt>
                <dd>{rate(total)}</dd>
            </div>
            <div>
                <dt>{here.length === 1 ? "worker" : "workers"}</dt>
                <dd>{grouped(here.length)}</dd>
            </div>
            <div>
                <dt>threads</dt>
                <dd>{grouped(threads)}</dd>
            </div>
            <div>
                <dt>{running === 1 ? "job runs" : "jobs run"}</dt>
                <dd>{grouped(running)}</dd>
            </div>
            <div>
                <dt>up</dt>
                <dd>{duration(cluster.uptime_seconds)}</dd>
            </div>
            <div>
                <dt>free on the disk</dt>
                <dd>{bytes(cluster.state_bytes?.free ?? 0)}</dd>
            </div>
        </dl>
    );
}

/** A cluster: throughput, workers, jobs. Asks once a second. */
export function ClusterScreen() {
    const { value: cluster, error } = usePolled<Cluster>("cluster", 1);
    const { value: history } = usePolled<History>("history", 2);
    useTitle("cluster");
    useEffect(
        () =>
            tellFacts("cluster", () => ({
                ready: cluster !== undefined,
                workers: cluster?.workers.map((worker) => ({ name: worker.name, state: worker.state })),
                jobs: cluster?.jobs.map((job) => ({ job: job.job, done: job.done, state: job.state })),
            })),
        [cluster],
    );
    if (!cluster) {
        return error ? <Notice kind="bad">{error}</Notice> : <p class="wait">asking the master…</p>;
    }
    const order = (a: WorkerRow, b: WorkerRow) => urgency(a.state) - urgency(b.state);
    const newest = (a: JobRow, b: JobRow) => Number(b.state === "running") - Number(a.state === "running");
    return (
        <>
            {error && <Notice kind="bad">{error}; below is what it said last</Notice>}
            {cluster.paused && <Notice kind="bad">jobs are paused: {cluster.paused}</Notice>}
            {cluster.alarms.map((alarm, i) => (
                <Notice key={i} kind="warn">
                    <b>alarm</b> <Name text={alarm} />
                </Notice>
            ))}
            <Numbers cluster={cluster} />
            <p class="line">
                <b>bottleneck</b> {cluster.bottleneck}
                {cluster.workers_lost > 0 && <> · {counted(cluster.workers_lost, "worker")} lost so far</>}
                {cluster.alarms.length === 0 && <> · no alarms</>}
            </p>
            {history && <Charts history={history} />}
            <Table
                caption="workers"
                columns={workerColumns}
                rows={cluster.workers}
                rowKey={(worker) => worker.worker}
                order={order}
                rowClass={(worker) => stateClasses[urgency(worker.state)]}
                empty="no worker is connected: start cdworker --master HOST:7600"
            />
            <JobsTable jobs={cluster.jobs} order={newest} />
        </>
    );
}
