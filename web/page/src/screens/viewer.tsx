import { useCallback, useEffect, useMemo, useRef, useState } from "preact/hooks";
import { messageOf } from "../base/api";
import { tellFacts } from "../base/facts";
import { forgetNotes, goTo, jobLink, noteLink, noteLinkSoon, type Route, scenarioLink } from "../base/route";
import type { Job, Source, Vec3 } from "../base/types";
import { fileName, grouped, shellWord } from "../base/words";
import { usePolled, useTitle } from "../ui/hooks";
import { isTyping, KeyHelp } from "../ui/keys";
import { Command, Name, Notice } from "../ui/small";
import { type Bounds, CopyLink, ViewControls } from "../viewer/controls";
import { ContactLegend, HeatLegend } from "../viewer/legend";
import { type Model, trianglesMax } from "../viewer/model";
import { PartPairs, Picked, PoseText } from "../viewer/side";
import { ScenarioStatus, Trust } from "../viewer/status";
import { Scenarios } from "../viewer/scenarios";
import { nextContact, nextHeldContact } from "../viewer/step";
import { type Drawing, trianglesOf, useContacts, useDrawing, useHeat, useModel } from "../viewer/use_viewer";
import { readParts, readState, type ViewState, writeState } from "../viewer/view_state";
import type { Contacts } from "../viewer/scenario_loader";

const playPause = 60; // Milliseconds between the scenarios of a replay.
const dragPixels = 4;
const turnStep = Math.PI / 24;

function boundsOf(model: Model | null, job: Job | undefined): Bounds {
    const size = job?.bodies[1]?.size ?? [0, 0, 0];
    const reach = Math.hypot(size[0], size[1], size[2]) / 2;
    const mesh = model?.meshes[0];
    const bound = (axis: number): [number, number] =>
        mesh ? [mesh.min[axis] - reach, mesh.max[axis] + reach] : [-1, 1];
    return { x: bound(0), y: bound(1), z: bound(2) };
}

function useViewerFacts(values: {
    job: Job | undefined;
    model: Model | null;
    contacts: Contacts | null;
    state: ViewState;
    drawing: Drawing;
    scenario: number;
    canvas: { current: HTMLCanvasElement | null };
}): void {
    const now = useRef(values);
    now.current = values;
    useEffect(
        () =>
            tellFacts("viewer", () => {
                const { model, contacts, state, drawing, scenario, canvas } = now.current;
                const viewer = drawing.viewer;
                const box = canvas.current?.getBoundingClientRect();
                const onPage = ([x, y]: [number, number]) => [x + (box?.left ?? 0), y + (box?.top ?? 0)];
                const points = contacts?.points ?? new Float64Array();
                const rows = Array.from({ length: Math.min(8, points.length / 4) }, (_, i) =>
                    Array.from(points.subarray(4 * i + 1, 4 * i + 4)),
                );
                return {
                    ready: viewer?.isShowing(state) === true && drawing.drawn.current === scenario,
                    scenario: contacts?.scenario.index,
                    class: contacts?.scenario.class,
                    verified: contacts?.scenario.verified,
                    mode: state.mode,
                    ghost: state.ghost,
                    throughWalls: state.throughWalls,
                    clip: state.clip,
                    camera: viewer?.view,
                    parts: [state.partA, state.partB],
                    pick: state.pick,
                    trianglesDrawn: viewer?.bodies.map((body) => body.triangles) ?? [0, 0],
                    highlighted: viewer?.highlighted ?? [[], []],
                    shaChecked: model?.meshes.map((mesh) => mesh.checked),
                    meshMilliseconds: model?.milliseconds,
                    firstFrameMilliseconds: drawing.firstFrame.current,
                    frames: viewer?.stage.frames,
                    pointPixels: viewer ? rows.map((row) => onPage(viewer.pixelOfWorld(row as Vec3))) : [],
                };
            }),
        [],
    );
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
export function ViewerScreen({ source, route, report }: ScreenProps) {
    const { value: job, error: jobError } = usePolled<Job>(`jobs/${encodeURIComponent(route.job)}`, 1, () => false);
    const { value: model, error: modelError } = useModel(job);
    const hasA = useCallback(
        (part: string) => model?.meshes[0].parts.some((one) => one.name === part) ?? true,
        [model],
    );
    const [scenario, setScenario] = useState(route.scenario);
    const [state, setState] = useState(() => readState(route.query, hasA));
    const { contacts, error: scenarioError } = useContacts(job, scenario);
    const { value: heat, error: heatError } = useHeat(
        job,
        model,
        state.mode === "heat" || (state.pick !== null && job?.maps === true),
    );
    const canvas = useRef<HTMLCanvasElement>(null);
    const [isPlaying, setPlaying] = useState(false);
    const [said, say] = useState("");
    const [helps, setHelps] = useState(false);
    const change = useCallback((part: Partial<ViewState>) => setState((old) => ({ ...old, ...part })), []);
    const drawing = useDrawing(canvas, model, contacts, state, heat, (camera) => change({ camera }));
    const { viewer } = drawing;
    const bounds = useMemo(() => boundsOf(model, job), [model, job]);
    useTitle(report ? null : `#${scenario} ${job?.name ?? ""}`);
    useViewerFacts({ job, model, contacts, state, drawing, scenario, canvas });

    const look = () => {
        if (viewer && state.camera) {
            viewer.view = state.camera;
        }
    };
    // A link that was followed, or the browser's back and forward.
    const [arrivals, setArrivals] = useState(0);
    useEffect(() => {
        setScenario(route.scenario);
        setState(readState(route.query, hasA));
        setArrivals((old) => old + 1);
    }, [route]);
    useEffect(look, [viewer, arrivals]);
    // Whose part a link names without a body is known with the meshes.
    useEffect(() => {
        if (model) {
            const [partA, partB] = readParts(route.query, hasA);
            change({ partA, partB });
        }
    }, [model]);
    useEffect(() => {
        noteLinkSoon(scenarioLink(route.job, scenario, writeState(state)));
        return forgetNotes;
    }, [scenario, state]);

    const scenarios = useMemo(() => new Scenarios(job?.scenarios ?? 1, report?.scenarios), [job, report]);
    const place = scenarios.placeOf(scenario);
    const move = (to: number) => setScenario(scenarios.at(to));
    useEffect(() => {
        if (!isPlaying || contacts?.scenario.index !== scenario) {
            return;
        }
        if (place + 1 >= scenarios.count) {
            setPlaying(false);
            return;
        }
        const timer = setTimeout(() => move(place + 1), playPause);
        return () => clearTimeout(timer);
    }, [isPlaying, contacts, scenario]);

    const step = async (by: 1 | -1) => {
        say("");
        try {
            const found =
                report && model
                    ? await nextHeldContact(route.job, report.scenarios, scenario, by, state, model.meshes)
                    : await nextContact(route.job, scenario, by, state);
            if (found === null) {
                say(by > 0 ? "no contact after this scenario" : "no contact before this scenario");
            } else {
                noteLink(scenarioLink(route.job, scenario, writeState(state)));
                goTo(scenarioLink(route.job, found, writeState(state)));
            }
        } catch (error) {
            say(messageOf(error));
        }
    };
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
    const keys: Record<string, () => void> = {
        n: () => void step(1),
        p: () => void step(-1),
        ArrowRight: () => move(place + 1),
        ArrowLeft: () => move(place - 1),
        " ": () => setPlaying(!isPlaying),
        h: () => change({ mode: state.mode === "heat" || !job?.maps ? "contacts" : "heat" }),
        g: () => change({ ghost: state.ghost === "a" ? "b" : state.ghost === "b" ? "none" : "a" }),
        x: () => change({ throughWalls: !state.throughWalls }),
        l: () => change({ lines: !state.lines }),
        s: () =>
            change({ clip: state.clip ? null : { axis: "x", at: (bounds.x[0] + bounds.x[1]) / 2 } }),
        "[": () => moveClip(-1),
        "]": () => moveClip(1),
        f: fit,
        c: goToContact,
        "Shift+ArrowRight": () => viewer?.stage.turn(turnStep, 0),
        "Shift+ArrowLeft": () => viewer?.stage.turn(-turnStep, 0),
        "Shift+ArrowUp": () => viewer?.stage.turn(0, turnStep),
        "Shift+ArrowDown": () => viewer?.stage.turn(0, -turnStep),
        "+": () => viewer?.stage.approach(0.85),
        "-": () => viewer?.stage.approach(1 / 0.85),
        "?": () => setHelps(true),
    };
    const press = useRef((_: KeyboardEvent) => {});
    press.current = (event) => {
        const isTurn = event.shiftKey && event.key.startsWith("Arrow");
        const action = keys[isTurn ? `Shift+${event.key}` : event.key];
        if (action && !isTyping(event)) {
            action();
            event.preventDefault();
        }
    };
    useEffect(() => {
        const target: EventTarget = report?.root ?? document;
        const listener = (event: Event) => press.current(event as KeyboardEvent);
        target.addEventListener("keydown", listener);
        return () => target.removeEventListener("keydown", listener);
    }, []);

    const down = useRef<[number, number]>([0, 0]);
    const click = (event: MouseEvent) => {
        const moved = Math.hypot(event.clientX - down.current[0], event.clientY - down.current[1]);
        if (viewer && moved < dragPixels) {
            const pick = viewer.pickAt(event.offsetX, event.offsetY, event.shiftKey);
            setState((old) => (pick === null && old.pick === null ? old : { ...old, pick }));
        }
    };
    // The wheel moves a report on, unless the viewer was clicked before.
    const leaveWheel = (event: WheelEvent) => {
        if (report && (report.root.getRootNode() as ShadowRoot).activeElement !== canvas.current) {
            event.stopPropagation();
        }
    };
    const savePicture = async () => {
        const blob = await viewer?.stage.picture();
        if (blob) {
            const link = document.createElement("a");
            link.href = URL.createObjectURL(blob);
            link.download = `${job?.name || route.job}-${scenario}.png`.replaceAll(/[^\w.-]+/g, "_");
            link.click();
            setTimeout(() => URL.revokeObjectURL(link.href), 1000);
        }
    };

    if (!job) {
        return jobError ? <Notice kind="bad">{jobError}</Notice> : <p class="wait">asking for {route.job}…</p>;
    }
    const isTooLarge = trianglesOf(job) > trianglesMax;
    const run = job.folder ? shellWord(job.folder) : source.kind === "folder" ? shellWord(source.name) : job.job;
    const error = modelError || drawing.error || scenarioError || (state.mode === "heat" ? heatError : "");
    return (
        <div class="viewer">
            <div class="viewer-head">
                <h1>
                    {report ? (
                        <Name text={job.name || job.job} />
                    ) : (
                        <a href={jobLink(job.job)}>
                            <Name text={job.name || job.job} />
                        </a>
                    )}{" "}
                    <span class="note">›</span>{" "}
                    <label class="number">
                        #
                        <input
                            type="number"
                            aria-label="scenario"
                            min={scenarios.at(0)}
                            max={scenarios.at(scenarios.count - 1)}
                            value={scenario}
                            onChange={(event) =>
                                move(scenarios.placeOf(Math.round(Number(event.currentTarget.value)) || 0))
                            }
                        />
                    </label>
                </h1>
                {contacts && <ScenarioStatus job={job} contacts={contacts} />}
            </div>
            <Trust model={model} contacts={contacts} />
            {error && <Notice kind="bad">{error}</Notice>}
            <div class="scrub">
                <button type="button" onClick={() => void step(-1)} title="p">
                    ‹ previous contact
                </button>
                <button type="button" onClick={() => void step(1)} title="n">
                    next contact ›
                </button>
                <input
                    type="range"
                    aria-label={report ? "scenarios of this report" : `scenario, 0 to ${scenarios.count - 1}`}
                    min={0}
                    max={scenarios.count - 1}
                    value={place}
                    onInput={(event) => move(Number(event.currentTarget.value))}
                />
                <button type="button" onClick={() => setPlaying(!isPlaying)} title="space" aria-pressed={isPlaying}>
                    {isPlaying ? "stop" : "play"}
                </button>
                <CopyLink address={() => location.href.split("#")[0] + scenarioLink(route.job, scenario, writeState(state))} />
                <button type="button" onClick={() => void savePicture()} disabled={!viewer}>
                    PNG
                </button>
                <button type="button" class="quiet" onClick={() => setHelps(true)} title="keys">
                    ?
                </button>
                <span class="note" aria-live="polite">
                    {said}
                </span>
            </div>
            <div class="stage-row">
                <div class="stage" onWheelCapture={leaveWheel}>
                    {isTooLarge ? (
                        <p class="wait">
                            {grouped(trianglesOf(job))} triangles: above {grouped(trianglesMax)} this page does not draw.
                            The exports have it all: <code>cdctl extract {run} {String(scenario)} --out case</code>
                        </p>
                    ) : (
                        <>
                            <canvas
                                ref={canvas}
                                tabIndex={0}
                                role="img"
                                aria-label={`scenario ${scenario}: ${contacts?.scenario.class ?? ""}, ${contacts?.scenario.count ?? 0} pairs`}
                                onPointerDown={(event) => {
                                    down.current = [event.clientX, event.clientY];
                                }}
                                onClick={click}
                            />
                            {!viewer && !error && <p class="wait over">reading {grouped(trianglesOf(job))} triangles…</p>}
                            <div class="corner">
                                <span class="swatch a" /> A <Name text={fileName(job.bodies[0].file)} />{" "}
                                <span class="swatch b" /> B <Name text={fileName(job.bodies[1].file)} />
                                <span class="note">drawn in single precision</span>
                            </div>
                        </>
                    )}
                </div>
                <aside class="side">
                    <ViewControls
                        state={state}
                        bounds={bounds}
                        hasMap={job.maps}
                        change={change}
                        fit={fit}
                        goToContact={goToContact}
                    />
                    {state.mode === "heat" && heat ? <HeatLegend heat={heat} job={job} /> : <ContactLegend />}
                    {state.pick && model && (
                        <Picked
                            pick={state.pick}
                            model={model}
                            contacts={contacts}
                            heat={heat}
                            job={job}
                            drop={() => change({ pick: null })}
                        />
                    )}
                    {contacts && model && (
                        <PartPairs
                            contacts={contacts}
                            model={model}
                            state={state}
                            choose={(partA, partB) => change({ partA, partB })}
                        />
                    )}
                    {contacts && viewer && (
                        <PoseText job={job} contacts={contacts} relative={viewer.relativePose(contacts.scenario)} />
                    )}
                    <section aria-label="as a case of its own">
                        <h2>as a case of its own</h2>
                        <Command text={`cdctl extract ${run} ${scenario} --out case`} />
                    </section>
                </aside>
            </div>
            {helps && <KeyHelp close={() => setHelps(false)} />}
        </div>
    );
}
