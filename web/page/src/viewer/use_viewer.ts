/** The pieces of the viewer's life as hooks: the loaded model, the drawing, the scenario that is shown. */
import type { RefObject } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { messageOf } from "../base/api";
import { onTheme } from "../base/theme";
import { asksShots, isScene, type Job, pairOf, type Scenario } from "../base/types";
import { type Heat, isTooLarge, loadHeat, loadModel, loadPair, type Model, trianglesMax, trianglesOf } from "./model";
import { type Contacts, ScenarioLoader } from "./scenario_loader";
import type { ViewState } from "./view_state";
import { Viewer } from "./viewer";

interface Loaded<T> {
    value: T | null;
    error: string;
}

/** Loads the bodies of a job that is no scene. */
export function useModel(job: Job | undefined): Loaded<Model> {
    const [loaded, setLoaded] = useState<Loaded<Model>>({ value: null, error: "" });
    useEffect(() => {
        let isCurrent = true;
        if (job && !isScene(job) && !isTooLarge(job)) {
            loadModel(job).then(
                (value) => isCurrent && setLoaded({ value, error: "" }),
                (error) => isCurrent && setLoaded({ value: null, error: messageOf(error) }),
            );
        }
        return () => {
            isCurrent = false;
        };
    }, [job?.job]);
    return loaded;
}

/** Loads the maps when they are first needed. */
export function useHeat(job: Job | undefined, model: Model | null, isNeeded: boolean): Loaded<Heat> {
    const [loaded, setLoaded] = useState<Loaded<Heat>>({ value: null, error: "" });
    const isAsked = useRef(false);
    useEffect(() => {
        if (job && model && isNeeded && !isAsked.current) {
            isAsked.current = true;
            loadHeat(job, model).then(
                (value) => setLoaded({ value, error: value ? "" : "this job has no heat map" }),
                (error) => setLoaded({ value: null, error: messageOf(error) }),
            );
        }
    }, [job, model, isNeeded]);
    return loaded;
}

/** Loads the two bodies of a scene's scenario; null if they have too many triangles. */
async function modelOf(job: Job, scenario: Scenario): Promise<Model | null> {
    const pair = pairOf(scenario);
    return isScene(job) && trianglesOf(job, pair) <= trianglesMax ? loadPair(job, pair) : null;
}

/** The scenario that was loaded last, and why the wanted one could not be. */
export function useContacts(job: Job | undefined, scenario: number) {
    const [contacts, setContacts] = useState<Contacts | null>(null);
    const [failed, setFailed] = useState({ scenario: -1, error: "" });
    const loader = useRef<ScenarioLoader | null>(null);
    useEffect(() => {
        if (!job) {
            return;
        }
        loader.current = new ScenarioLoader(
            job.job,
            asksShots(job),
            (one) => modelOf(job, one),
            setContacts,
            (number, error) => setFailed({ scenario: number, error: messageOf(error) }),
        );
        return () => loader.current?.close();
    }, [job?.job]);
    useEffect(() => loader.current?.want(scenario), [job?.job, scenario]);
    return { contacts, error: failed.scenario === scenario ? failed.error : "" };
}

export interface Drawing {
    viewer: Viewer | null;
    error: string;
    /** Milliseconds from the model to the first frame with a scenario; 0 before it. */
    firstFrame: RefObject<number>;
    /** The scenario of the frame that is on the screen. */
    drawn: RefObject<number>;
}

/** Makes the drawing once canvas and model are there, and keeps it as `contacts` and `state` say. */
export function useDrawing(
    canvas: RefObject<HTMLCanvasElement | null>,
    model: Model | null,
    contacts: Contacts | null,
    state: ViewState,
    heat: Heat | null,
    moved: (view: number[]) => void,
): Drawing {
    const [viewer, setViewer] = useState<Viewer | null>(null);
    const [error, setError] = useState("");
    const firstFrame = useRef(0);
    const drawn = useRef(-1);
    const shown = useRef(-1);
    const onMoved = useRef(moved);
    onMoved.current = moved;
    useEffect(() => {
        if (!canvas.current || !model) {
            return;
        }
        const begin = performance.now();
        let made: Viewer;
        try {
            made = new Viewer(
                canvas.current,
                model,
                () => onMoved.current(made.view),
                () => {
                    drawn.current = shown.current;
                    if (firstFrame.current === 0 && shown.current >= 0) {
                        firstFrame.current = performance.now() - begin;
                    }
                },
            );
        } catch (reason) {
            setError(`this browser draws no 3D (WebGL 2): ${messageOf(reason)}. All else on this page works.`);
            return;
        }
        setViewer(made);
        const forget = onTheme(() => made.refreshTheme());
        return () => {
            forget();
            made.dispose();
            setViewer(null);
        };
    }, [model !== null]);
    useEffect(() => {
        if (viewer && model) {
            viewer.use(model);
        }
    }, [viewer, model]);
    useEffect(() => {
        if (viewer && contacts) {
            viewer.show(contacts, state);
            shown.current = contacts.scenario.index;
        }
    }, [viewer, contacts]);
    useEffect(() => viewer?.setState(state), [viewer, state]);
    useEffect(() => {
        if (viewer && heat) {
            viewer.setHeat(heat.counts, heat.most);
        }
    }, [viewer, heat]);
    return { viewer, error, firstFrame, drawn };
}
