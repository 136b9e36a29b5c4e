import { useEffect, useMemo, useState } from "preact/hooks";
import { classNames, near, shownOrder } from "../base/classes";
import { tellFacts } from "../base/facts";
import { forgetNotes, jobLink, noteLinkSoon, type Route, scenarioLink } from "../base/route";
import {
    asksDistance,
    asksShots,
    type Body,
    countNoun,
    hasDirections,
    isOver,
    isScene,
    type Job,
    type Source,
} from "../base/types";
import { bytes, counted, duration, fileName, grouped, percent, rate, shellWord, short } from "../base/words";
import { Distances } from "../job/distances";
import { Episodes } from "../job/episodes";
import { Groups } from "../job/groups";
import { Histogram } from "../job/histogram";
import { type JobView, readJobView, writeJobView } from "../job/job_view";
import { MostHits } from "../job/most_hits";
import { PoseSpace } from "../job/pose_space";
import type { Results } from "../job/results";
import { Strip } from "../job/strip";
import { useJob } from "../job/use_job";
import { useResults } from "../job/use_results";
import { BodiesPanel } from "../scene/bodies_panel";
import { SceneEpisodes } from "../scene/episodes_panel";
import { isFiltered, type SceneFilter, writeFilter } from "../scene/filter";
import { meshRows, SceneCard } from "../scene/scene_card";
import { type Filtered, useFiltered } from "../scene/use_filtered";
import { useSteps } from "../scene/use_scene";
import { useTitle } from "../ui/hooks";
import { jobKeys, KeyHelp, useKeys } from "../ui/keys";
import { ClassCount, Command, Name, Notice, Progress } from "../ui/small";

function contactsOf(job: Job): number {
    return job.touch + job.cross + job.inside + job.contact;
}

/** What the verdict says of scenarios that are only near; empty without a clearance. */
function nearText(job: Job): string {
    if (job.clearance === null) {
        return "";
    }
    const apart = `at most ${short(job.clearance, 6)} ${job.unit} apart`;
    return ` In ${counted(job.near, "scenario")} without contact the bodies are ${apart}, with ${counted(job.near_pairs, "near pair")}.`;
}

/** What the verdict says of contacts. */
function contactText(job: Job): string {
    const contacts = contactsOf(job);
    const noun = asksShots(job) ? "bundle" : "scenario";
    const all = job.done === job.scenarios ? "" : ` tested so far, of ${grouped(job.scenarios)}`;
    const share = percent(contacts / Math.max(1, job.done));
    const are = contacts === 1 ? "is" : "are";
    const tested = `${counted(job.done, noun)}${all}`;
    if (asksShots(job)) {
        const hits = job.first_hits ? `${counted(job.pairs, "line")} that cross A` : counted(job.pairs, "hit");
        return contacts === 0
            ? `No line hits anything in ${tested}.`
            : `${grouped(contacts)} of ${tested} ${are} hit (${share}), with ${hits}.`;
    }
    const pairs = asksDistance(job) ? "" : `, with ${counted(job.pairs, "pair")} of triangles`;
    return contacts === 0
        ? `No contact in ${tested}.`
        : `${grouped(contacts)} of ${tested} ${are} in contact (${share})${pairs}.`;
}

function Verdict({ job }: { job: Job }) {
    return (
        <div class="verdict">
            <h1>
                <Name text={job.name || job.job} />
                <span class={`state ${job.state === "failed" ? "bad" : ""}`}>{job.state}</span>
                {!isOver(job) && <Progress done={job.done} total={job.scenarios} />}
            </h1>
            <p class="sentence">
                {contactText(job)}
                {nearText(job)}
            </p>
            <p class="counts">
                {shownOrder.map((kind) => {
                    const name = classNames[kind];
                    const usual = asksShots(job) ? "contact" : "cross";
                    const always = name === "separate" || name === usual || name === "failed";
                    return (
                        <ClassCount
                            key={name}
                            kind={kind}
                            count={job[name]}
                            always={always || (kind === near && job.clearance !== null)}
                        />
                    );
                })}
                {job.digest && (
                    <span class="count">
                        digest <code title={job.digest}>{job.digest.slice(0, 16)}</code>
                    </span>
                )}
            </p>
        </div>
    );
}

function Caveats({ job }: { job: Job }) {
    const said: string[] = [];
    if (job.surfaces_only > 0) {
        said.push(`Containment was not tested in ${counted(job.surfaces_only, "scenario")}: a body is open.`);
    }
    if (job.insides_skipped > 0) {
        said.push(
            `Containment was not tested in ${counted(job.insides_skipped, "scenario")}: triangles are ignored, and the rest of a body is open.`,
        );
    }
    if (job.cut > 0) {
        said.push(`The list of ${countNoun(job)}s ends at ${grouped(job.limit_pairs)} in ${counted(job.cut, "scenario")}; counts are true.`);
    }
    if (job.map_pairs > 0) {
        said.push(`The heat map counts the first ${grouped(job.map_pairs)} ${countNoun(job)}s of a scenario.`);
    }
    return said.length === 0 ? null : <p class="caveats">{said.join(" ")}</p>;
}

function BodyCard({ body, letter, unit }: { body: Body; letter: string; unit: string }) {
    const closed = body.closed === null ? "" : body.closed ? ", closed" : ", open";
    return (
        <div class="card">
            <b class="letter">{letter}</b>
            <div>
                <Name text={fileName(body.file)} />
                {body.name.toLowerCase() !== letter.toLowerCase() && (
                    <span class="note">
                        {" "}
                        called <Name text={body.name} />
                    </span>
                )}
                <div class="note">
                    {counted(body.triangles, "triangle")}, {counted(body.parts, "part")}
                    {closed}
                </div>
                <div class="note">
                    {body.size.map((length) => short(length)).join(" × ")} {unit} · {body.precision}
                </div>
            </div>
        </div>
    );
}

/** The card of a body that is a bundle of lines. */
function LinesCard({ job, body }: { job: Job; body: Body }) {
    const axes = (job.poses.axes ?? []).map((axis) => `${axis.name} ${grouped(axis.count)}`);
    return (
        <div class="card">
            <b class="letter">B</b>
            <div>
                <Name text={body.name} />
                <div class="note">
                    {counted(body.triangles, "line")}
                    {hasDirections(job) ? " a bundle" : ""}
                </div>
                <div class="note">
                    {hasDirections(job) ? `directions ${axes.join(" × ")}` : `file ${fileName(job.poses.file ?? "")}`}
                </div>
            </div>
        </div>
    );
}

function posesText(job: Job): string {
    const { poses } = job;
    if (poses.kind === "shots") {
        return hasDirections(job) ? "bundles of lines" : "lines of a file";
    }
    if (poses.kind === "grid") {
        const axes = (poses.axes ?? []).filter((axis) => axis.count > 1);
        return `grid ${axes.map((axis) => `${axis.name} ${grouped(axis.count)}`).join(" × ")}`;
    }
    if (poses.kind === "random") {
        return `random, seed ${poses.seed ?? "-"}${
            poses.penetration ? `, pushed ${poses.penetration.map((depth) => percent(depth)).join(" to ")} into contact` : ""
        }`;
    }
    return `file ${fileName(poses.file ?? "")}`;
}

function PosesCard({ job }: { job: Job }) {
    return (
        <div class="card">
            <b class="letter">×</b>
            <div>
                <span>{job.steps === undefined ? counted(job.poses.count, "pose") : counted(job.steps, "step")}</span>
                <div class="note">
                    {isScene(job) ? counted(job.scenarios, "scenario") : posesText(job)}
                    {job.poses.of_both_bodies && !isScene(job) ? ", of both bodies" : ""}
                </div>
                <div class="note">
                    level {asksDistance(job) ? "distance" : job.level}
                    {job.first_hits && ", the first hit of each line"}
                    {typeof job.up_to === "number" && `, up to ${short(job.up_to, 6)} ${job.unit}`}
                    {job.clearance !== null && `, clearance ${short(job.clearance, 6)} ${job.unit}`}
                    {job.ignored > 0 && `, ${counted(job.ignored, "range")} ignored`}
                </div>
            </div>
        </div>
    );
}

function HowItRan({ job }: { job: Job }) {
    const rows: [string, string][] = [
        ["where", job.where],
        ["instructions", job.simd],
        ["time", job.seconds > 0 ? `${duration(job.seconds)}, ${rate(job.scenarios_per_second)}` : ""],
        ["owner", job.owner],
        ["started", job.started || job.began],
        ["ended", job.ended],
        ["command", job.command],
        ["program", [job.program, job.commit].filter((text) => text !== "").join(", commit ")],
        ["digest", job.digest ?? ""],
        ...(isScene(job)
            ? meshRows(job, 20)
            : job.bodies.map(
                  (body): [string, string] => [`mesh ${body.name}`, `${body.sha256} (${bytes(body.bytes)}), ${body.file}`],
              )),
    ];
    const place = job.folder ? shellWord(job.folder) : job.job;
    const had = (job.formats ?? []).length > 0 ? `the folder has ${job.formats?.join(", ")}; more:` : "";
    return (
        <details class="how">
            <summary>how it ran, and exports</summary>
            <dl>
                {rows
                    .filter(([, text]) => text)
                    .map(([name, text]) => (
                        <div key={name}>
                            <dt>{name}</dt>
                            <dd>
                                <bdi>{text}</bdi>
                            </dd>
                        </div>
                    ))}
            </dl>
            <p class="note">
                {had} <Command text={`cdctl results ${place}${job.folder ? "" : " --out out"} --formats csv,npz`} />
            </p>
        </details>
    );
}

function useJobFacts(job: Job | undefined, results: Results | null, { rows, results: shown }: Filtered): void {
    useEffect(
        () =>
            tellFacts("job", () => ({
                ready: job !== undefined && results !== null,
                job: job?.job,
                done: job?.done,
                isExact: results?.isExact,
                rows: rows?.count,
                shown: shown && Array.from(shown.classes.subarray(0, 64), (_, i) => shown.scenarioAt(i)),
                tested: results?.classes.reduce((sum, kind) => sum + (kind === 255 ? 0 : 1), 0),
            })),
        [job, results, rows, shown],
    );
}

/** What is seen, which the address holds, and a function that changes a part of it. */
function useJobView(route: Route): [JobView, (part: Partial<JobView>) => void] {
    const [view, setView] = useState(() => readJobView(route.query));
    useEffect(() => setView(readJobView(route.query)), [route]);
    useEffect(() => {
        noteLinkSoon(() => jobLink(route.job, writeJobView(view)));
        return forgetNotes;
    }, [view]);
    return [view, (part) => setView((old) => ({ ...old, ...part }))];
}

/** One job: verdict, inputs, pose space, parts, order, histogram. */
export function JobScreen({ source, route }: { source: Source; route: Route }) {
    const id = route.job;
    const [view, change] = useJobView(route);
    const [helps, setHelps] = useState(false);
    const { value: job, error } = useJob(id);
    const { results, error: resultsError } = useResults(source, job);
    const filtered = useFiltered(job, results, view.filter);
    const { steps } = useSteps(job);
    const worst = useMemo(() => filtered.results?.worst() ?? 0, [filtered.results]);
    useTitle(job ? job.name || id : id);
    useJobFacts(job, results, filtered);
    useKeys({ "?": () => setHelps(true) });
    if (!job) {
        return error ? <Notice kind="bad">{error}</Notice> : <p class="wait">asking for {id}…</p>;
    }
    const problem = error || resultsError || filtered.error;
    const range = steps && view.filter.steps ? steps.rangeOf(...steps.within(view.filter.steps)) : undefined;
    const filterBy = (filter: SceneFilter) => change({ filter, window: null });
    return (
        <>
            {problem && <Notice kind="bad">{problem}</Notice>}
            {job.failure && (
                <Notice kind="bad">
                    failed: <Name text={job.failure} />
                </Notice>
            )}
            {job.paused && <Notice kind="warn">paused: {job.paused}</Notice>}
            <Verdict job={job} />
            <div class="cards">
                {isScene(job) && <SceneCard job={job} />}
                {(isScene(job) ? [] : job.bodies).map((body, i) =>
                    asksShots(job) && i === 1 ? (
                        <LinesCard key={i} job={job} body={body} />
                    ) : (
                        <BodyCard key={i} body={body} letter={i === 0 ? "A" : "B"} unit={job.unit} />
                    ),
                )}
                <PosesCard job={job} />
                <a class="card go" href={scenarioLink(job.job, worst, writeFilter(view.filter))}>
                    see it in 3D
                </a>
            </div>
            <Caveats job={job} />
            {results ? (
                <>
                    <div class="two">
                        {!isScene(job) ? (
                            <PoseSpace source={source} job={job} results={results} view={view} change={change} />
                        ) : filtered.rows ? (
                            <BodiesPanel job={job} rows={filtered.rows} filter={view.filter} change={filterBy} />
                        ) : (
                            <p class="wait">reading the bodies of the scenarios…</p>
                        )}
                        {job.groups ? <Groups job={job} groups={job.groups} /> : <Histogram job={job} results={results} />}
                    </div>
                    <Strip
                        source={source}
                        job={job}
                        results={filtered.results ?? results}
                        chosenOf={isFiltered(view.filter) && filtered.rows?.areAll === false ? filtered.rows.count : 0}
                        {...(range && range[0] < range[1] ? { range } : {})}
                        view={view}
                        change={change}
                    />
                    {asksDistance(job) && (
                        <div class="two">
                            <Distances job={job} results={results} />
                        </div>
                    )}
                    {asksShots(job) && (
                        <div class="two">
                            <MostHits job={job} results={results} />
                        </div>
                    )}
                    <div class="two">
                        {job.groups && <Histogram job={job} results={results} />}
                        {filtered.rows ? (
                            <SceneEpisodes job={job} rows={filtered.rows} />
                        ) : (
                            <Episodes job={job} results={results} />
                        )}
                    </div>
                </>
            ) : (
                <p class="wait">reading the results…</p>
            )}
            <HowItRan job={job} />
            <button type="button" class="quiet" onClick={() => setHelps(true)}>
                keys of this page
            </button>
            {helps && <KeyHelp title="Keys of a job's page" keys={jobKeys} close={() => setHelps(false)} />}
        </>
    );
}
