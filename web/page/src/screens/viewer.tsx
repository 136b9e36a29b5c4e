import { useCallback, useEffect, useMemo, useRef, useState } from "preact/hooks";
import type { PartNames } from "../base/part_name";
import { getParts } from "../base/parts";
import { forgetNotes, goTo, noteLink, noteLinkSoon, type Route, scenarioLink } from "../base/route";
import { asksMotion, asksShots, bodyNames, firstPair, isScene, type Job, pairOf, type Source } from "../base/types";
import { grouped, shellWord } from "../base/words";
import { isFiltered, noFilter } from "../scene/filter";
import { FilterNote, StepControls } from "../scene/step_controls";
import { StepPairs } from "../scene/step_pairs";
import { useOthers, useStepBodies, useSteps, useStepTo } from "../scene/use_scene";
import { TimeLine } from "../motion/time_line";
import { usePolled, useTitle } from "../ui/hooks";
import { KeyHelp, useKeys, viewerKeys } from "../ui/keys";
import { Command, Notice } from "../ui/small";
import { type Bounds, CopyLink, ViewControls } from "../viewer/controls";
import { ContactLegend, HeatLegend, nearMeaning } from "../viewer/legend";
import { HitLegend, LineHits } from "../viewer/line_hits";
import { type Model, trianglesMax, trianglesOf } from "../viewer/model";
import { Picture } from "../viewer/picture";
import { PartPairs, Picked, PoseText } from "../viewer/side";
import { Scrub, soughtName, ViewerHead } from "../viewer/scrub";
import { Trust } from "../viewer/status";
import { Scenarios } from "../viewer/scenarios";
import { nextContact, nextHeldContact } from "../viewer/step";
import { type FindNext, useContactSearch } from "../viewer/use_search";
import { useContacts, useDrawing, useHeat, useModel } from "../viewer/use_viewer";
import { type Pick, readParts, readState, type ViewState, writeState } from "../viewer/view_state";
import { useViewerFacts } from "../viewer/viewer_facts";

const playPause = 60; // Milliseconds between the scenarios of a replay.
const turnStep = Math.PI / 24;
const moveStep = 0.05; // Of the distance between eye and target.

function boundsOf(model: Model | null, job: Job): Bounds {
    const size = job.bodies[model?.bodies[1] ?? 1]?.size ?? [0, 0, 0];
    const reach = Math.hypot(size[0], size[1], size[2]) / 2;
    const mesh = model?.meshes[0];
    const bound = (axis: number): [number, number] =>
        mesh ? [mesh.min[axis] - reach, mesh.max[axis] + reach] : [-1, 1];
    return { x: bound(0), y: bound(1), z: bound(2) };
}

/** The report that holds the viewer. */
export interface Report {
    scenarios: readonly number[];
    /** The element around the viewer; only keys that are pressed in it are the viewer's. */
    root: HTMLElement;
}

interface ScreenProps {
    source: Source;
    route: Route;
    report?: Report;
}

/** One scenario in 3D. Its address holds all that is seen. */
export function ViewerScreen(props: ScreenProps) {
    const id = props.route.job;
    const { value: job, error } = usePolled<Job>(`jobs/${encodeURIComponent(id)}`, 1, () => false);
    if (!job) {
        return error ? <Notice kind="bad">{error}</Notice> : <p class="wait">asking for {id}…</p>;
    }
    return <JobViewer {...props} job={job} />;
}

function JobViewer({ source, route, report, job }: ScreenProps & { job: Job }) {
    const [scenario, setScenario] = useState(route.scenario);
    const { value: onlyModel, error: modelError } = useModel(job);
    const { contacts, error: scenarioError } = useContacts(job, scenario);
    const hasSteps = isScene(job);
    const model = hasSteps ? (contacts?.model ?? null) : onlyModel;
    const pair = contacts ? pairOf(contacts.scenario) : firstPair;
    const names = useMemo(
        (): PartNames => ({
            bodies: bodyNames(job, pair),
            hasA: (part) => model?.parts[0].names.includes(part) ?? true,
        }),
        [model],
    );
    const [state, setState] = useState(() => readState(route.query, names));
    const { value: heat, error: heatError } = useHeat(
        job,
        model,
        state.mode === "heat" || (state.pick !== null && job.maps),
    );
    const canvas = useRef<HTMLCanvasElement>(null);
    const [isPlaying, setPlaying] = useState(false);
    const [helps, setHelps] = useState(false);
    const change = useCallback((part: Partial<ViewState>) => setState((old) => ({ ...old, ...part })), []);
    const drawing = useDrawing(canvas, model, contacts, state, heat, (camera) => change({ camera }));
    const { viewer } = drawing;
    const { steps, error: stepsError } = useSteps(report ? undefined : job);
    const found = useStepBodies(job, steps, contacts, report !== undefined);
    const { bodies: stepBodies, error: stepError } = found;
    const others = useOthers(job, viewer, contacts, stepBodies);
    const [listed, setListed] = useState(""); // Bodies whose pairs are listed.
    const bounds = useMemo(() => boundsOf(model, job), [model, job]);
    useTitle(report ? null : `#${scenario} ${job.name}`);
    useViewerFacts({ model, contacts, state, drawing, scenario, canvas, step: stepBodies, others });

    const look = () => {
        if (viewer && state.camera) {
            viewer.view = state.camera;
        }
    };
    // A link that was followed, or the browser's back and forward.
    const [arrivals, setArrivals] = useState(0);
    const arrival = useRef<"link" | "search" | "step">("link"); // How the scenario was reached.
    const sought = useRef(-1);
    useEffect(() => {
        arrival.current = route.scenario === sought.current ? "search" : "link";
        sought.current = -1;
        setScenario(route.scenario);
        setState(readState(route.query, names));
        setArrivals((old) => old + 1);
    }, [route]);
    useEffect(look, [viewer, arrivals]);
    // A link may name a part without its body, which the meshes then tell. Parts of the last pair of bodies do not
    // hold for another pair, unless a search for parts found it.
    useEffect(() => {
        if (!model) {
            return;
        }
        const [partA, partB] = arrival.current === "step" ? ["", ""] : readParts(route.query, names);
        if (arrival.current === "link") {
            change({ partA, partB });
            look();
        } else {
            change({ partA, partB, pick: null, camera: null });
        }
    }, [model]);
    const linkTo = (number: number, camera: number[] | null) =>
        scenarioLink(
            route.job,
            number,
            writeState({ ...state, camera, tau: number === scenario ? state.tau : null }, names.bodies),
        );
    // As it is seen: with the camera, unless whoever opens the scenario anew would see it so.
    const linkHere = () => linkTo(scenario, state.camera ?? viewer?.ownView ?? null);
    const hasLines = asksShots(job);
    const pickedLine = hasLines && state.pick?.body === 1 ? state.pick.triangle : null;
    const alone = hasLines ? "as files" : "as a case of its own";
    const isKnown = !hasSteps || contacts !== null;
    const isTooLarge = isKnown && trianglesOf(job, pair) > trianglesMax;
    const draws = !isTooLarge && drawing.error === "";
    useEffect(() => {
        if (model || isTooLarge) {
            noteLinkSoon(linkHere);
        }
        return forgetNotes;
    }, [scenario, state, contacts, model]);

    const scenarios = useMemo(() => new Scenarios(job.scenarios, report?.scenarios), [job, report]);
    const place = scenarios.placeOf(scenario);
    const move = (to: number) => {
        arrival.current = "step";
        setScenario(scenarios.at(to));
        change({ tau: null });
    };
    const stepTo = useStepTo(job, steps, contacts, state.filter, move);
    useEffect(() => {
        if (!isPlaying || contacts?.scenario.index !== scenario) {
            return;
        }
        const step = contacts.scenario.step ?? 0;
        const next = steps ? steps.nearest(step + 1, 1) : place + 1;
        if (steps ? next <= step : next >= scenarios.count) {
            setPlaying(false);
            return;
        }
        const timer = setTimeout(() => (steps ? stepTo(next, 1) : move(next)), playPause);
        return () => clearTimeout(timer);
    }, [isPlaying, contacts, scenario]);

    const partsOfBodies = async () => model?.parts ?? Promise.all([getParts(job.job, pair[0]), getParts(job.job, pair[1])]);
    const within = steps && state.filter.steps ? steps.rangeOf(...steps.within(state.filter.steps)) : undefined;
    const wanted = { ...state, bodies: pair };
    const find: FindNext = (step, signal, tell) =>
        report && model
            ? nextHeldContact({ job, from: scenario, step }, report.scenarios, wanted, model.parts)
            : nextContact({ job, from: scenario, step, signal, tell, ...(within ? { within } : {}) }, wanted, partsOfBodies);
    const openFound = (found: number) => {
        sought.current = found;
        noteLink(linkHere());
        goTo(linkTo(found, state.camera));
    };
    const search = useContactSearch(find, openFound, job.done === job.scenarios, soughtName(state.seek), [
        route,
        scenario,
        state,
        isPlaying,
    ]);
    const fit = () => {
        change({ camera: null });
        viewer?.fit(false);
    };
    const goToContact = () => {
        viewer?.goToContact();
        change({ camera: viewer?.view ?? null });
    };
    const moveClip = (by: number) => {
        if (state.clip) {
            const [low, high] = bounds[state.clip.axis];
            const at = Math.min(high, Math.max(low, state.clip.at + (by * (high - low)) / 100));
            change({ clip: { ...state.clip, at } });
        }
    };
    const stepNow = contacts?.scenario.step ?? 0;
    const drawingKeys: Record<string, () => void> = {
        " ": () => setPlaying(!isPlaying),
        h: () => change({ mode: state.mode === "heat" || !job.maps ? "contacts" : "heat" }),
        g: () => change({ ghost: state.ghost === "a" ? "b" : state.ghost === "b" ? "none" : "a" }),
        x: () => change({ throughWalls: !state.throughWalls }),
        l: () => change({ lines: !state.lines }),
        s: () =>
            change({ clip: state.clip ? null : { axis: "x", at: (bounds.x[0] + bounds.x[1]) / 2 } }),
        "[": () => moveClip(-1),
        "]": () => moveClip(1),
        f: fit,
        c: goToContact,
        e: () => change({ tau: null }),
        "Shift+ArrowRight": () => viewer?.stage.turn(turnStep, 0),
        "Shift+ArrowLeft": () => viewer?.stage.turn(-turnStep, 0),
        "Shift+ArrowUp": () => viewer?.stage.turn(0, turnStep),
        "Shift+ArrowDown": () => viewer?.stage.turn(0, -turnStep),
        W: () => viewer?.stage.move(0, moveStep),
        S: () => viewer?.stage.move(0, -moveStep),
        A: () => viewer?.stage.move(-moveStep, 0),
        D: () => viewer?.stage.move(moveStep, 0),
        "+": () => viewer?.stage.approach(0.85),
        "-": () => viewer?.stage.approach(1 / 0.85),
    };
    const keys: Record<string, () => void> = {
        n: () => search.start(1),
        p: () => search.start(-1),
        ArrowRight: () => move(place + 1),
        ArrowLeft: () => move(place - 1),
        ...(steps ? { ".": () => stepTo(stepNow + 1, 1), ",": () => stepTo(stepNow - 1, -1) } : {}),
        ...(draws ? drawingKeys : {}),
        Escape: search.stop,
        "?": () => setHelps(true),
    };
    const pick = (found: Pick | null) =>
        setState((old) => (found === null && old.pick === null ? old : { ...old, pick: found }));
    useKeys(keys, report?.root);

    const run = job.folder ? shellWord(job.folder) : source.kind === "folder" ? shellWord(source.name) : job.job;
    const error = modelError || drawing.error || scenarioError || stepsError || stepError || (state.mode === "heat" ? heatError : "");
    return (
        <div class="viewer">
            <ViewerHead
                job={job}
                isInReport={report !== undefined}
                scenario={scenario}
                scenarios={scenarios}
                contacts={contacts}
                move={move}
            />
            <Trust model={model} contacts={contacts} />
            {error && <Notice kind="bad">{error}</Notice>}
            {found.isLeftOut && (
                <Notice kind="warn">
                    This report has no room for the other bodies of this step; <code>cdctl view {run}</code> shows them.
                </Notice>
            )}
            <Scrub
                scenarios={scenarios}
                isInReport={report !== undefined}
                place={place}
                move={move}
                search={search}
                seek={state.seek}
                chooseSeek={job.clearance === null ? null : (seek) => change({ seek })}
                isPlaying={isPlaying}
                play={draws ? setPlaying : null}
            >
                <CopyLink
                    address={() => location.href.split("#")[0] + linkTo(scenario, viewer?.view ?? state.camera)}
                />
                {draws && (
                    <button type="button" onClick={() => void viewer?.stage.save(`${job.name || route.job}-${scenario}`)} disabled={!viewer}>
                        PNG
                    </button>
                )}
                <button type="button" class="quiet" onClick={() => setHelps(true)} title="keys">
                    ?
                </button>
            </Scrub>
            {steps && contacts && <StepControls steps={steps} step={stepNow} stepTo={stepTo} />}
            {isFiltered(state.filter) && <FilterNote filter={state.filter} drop={() => change({ filter: noFilter })} />}
            <div class="stage-row">
                {isTooLarge ? (
                    <div class="stage">
                        <p class="wait">
                            {grouped(trianglesOf(job, pair))} triangles: above {grouped(trianglesMax)} this page does not draw.
                            The exports have it all:{" "}
                            <code>
                                cdctl extract {run} {String(scenario)} --out {hasLines ? "scene --as vtp" : "case"}
                            </code>
                        </p>
                    </div>
                ) : (
                    <div class="stage-column">
                        <Picture
                            job={job}
                            scenario={scenario}
                            contacts={contacts}
                            canvas={canvas}
                            viewer={viewer}
                            waits={!viewer && !error}
                            root={report?.root}
                            pick={pick}
                            pickOther={(body) => setListed(job.bodies[body].name)}
                        />
                        {contacts?.scenario.motion && (
                            <TimeLine
                                scenario={contacts.scenario}
                                motion={contacts.scenario.motion}
                                tau={state.tau}
                                choose={(tau) => change({ tau })}
                            />
                        )}
                    </div>
                )}
                <aside class="side">
                    {draws && (
                        <>
                            <ViewControls
                                state={state}
                                bounds={bounds}
                                hasMap={job.maps}
                                hasOthers={steps !== null || (report !== undefined && stepBodies !== null)}
                                lines={{
                                    areDrawn: hasLines,
                                    hasAllHits: hasLines && job.first_hits !== true,
                                    name: asksMotion(job) ? "path, segments and points" : hasLines ? "lines and hits" : "segments and points",
                                }}
                                change={change}
                                fit={fit}
                                goToContact={goToContact}
                            />
                            {state.mode === "heat" && heat ? (
                                <HeatLegend heat={heat} job={job} />
                            ) : hasLines ? (
                                <HitLegend />
                            ) : (
                                <ContactLegend near={nearMeaning(job)} />
                            )}
                        </>
                    )}
                    {pickedLine !== null && model && contacts && (
                        <LineHits
                            line={pickedLine}
                            job={job}
                            model={model}
                            contacts={contacts}
                            drop={() => change({ pick: null })}
                        />
                    )}
                    {state.pick && pickedLine === null && model && (
                        <Picked
                            pick={state.pick}
                            model={model}
                            contacts={contacts}
                            heat={heat}
                            job={job}
                            drop={() => change({ pick: null })}
                        />
                    )}
                    {stepBodies && (
                        <StepPairs
                            job={job}
                            step={stepBodies}
                            scenario={scenario}
                            others={others}
                            text={listed}
                            setText={setListed}
                            held={report?.scenarios}
                            open={(number) => move(scenarios.placeOf(number))}
                        />
                    )}
                    {contacts && model && (
                        <PartPairs
                            contacts={contacts}
                            model={model}
                            bodies={hasSteps ? names.bodies : null}
                            state={state}
                            choose={(partA, partB) => change({ partA, partB })}
                        />
                    )}
                    {contacts && <PoseText job={job} contacts={contacts} tau={state.tau} />}
                    <section aria-label={alone}>
                        <h2>{alone}</h2>
                        <Command text={`cdctl extract ${run} ${scenario} --out ${hasLines ? "scene --as vtp" : "case"}`} />
                    </section>
                </aside>
            </div>
            {helps && <KeyHelp title="Keys of the viewer" keys={viewerKeys(draws, steps !== null)} close={() => setHelps(false)} />}
        </div>
    );
}
