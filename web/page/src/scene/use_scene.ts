/** What the viewer shows of a scene beside the pair of bodies: the steps, and the other bodies of the step. */
import { useEffect, useRef, useState } from "preact/hooks";
import { ApiError, isAbort, messageOf } from "../base/api";
import type { Mesh } from "../base/mesh";
import { type Job, pairOf, type Vec3 } from "../base/types";
import { meshOf } from "../viewer/model";
import type { Contacts } from "../viewer/scenario_loader";
import type { Viewer } from "../viewer/viewer";
import { bodyNumber, type SceneFilter } from "./filter";
import type { OtherBody } from "./others_view";
import { formOf, loadStep, othersOf, type OthersForm, scenarioOfStep, type StepBodies } from "./step_bodies";
import { loadSteps, type Steps } from "./steps";

/** The steps of a job; null until they are read, and in jobs that are shown without. */
export function useSteps(job: Job | undefined): { steps: Steps | null; error: string } {
    const [loaded, setLoaded] = useState<{ steps: Steps | null; error: string }>({ steps: null, error: "" });
    useEffect(() => {
        let isCurrent = true;
        if (job) {
            loadSteps(job).then(
                (steps) => isCurrent && setLoaded({ steps, error: "" }),
                (error) => isCurrent && setLoaded({ steps: null, error: messageOf(error) }),
            );
        }
        return () => {
            isCurrent = false;
        };
    }, [job?.job]);
    return loaded;
}

/** Whether a report lacks what was asked for, since it had no room for it. */
function isLeftOut(error: unknown): boolean {
    return error instanceof ApiError && error.status === 404;
}

/** What is known of a step: its bodies, null until they are read; else why they are not. */
interface FoundStep {
    bodies: StepBodies | null;
    error: string;
    /** Whether this report had no room for the step of the scenario. */
    isLeftOut: boolean;
}

const noStep: FoundStep = { bodies: null, error: "", isLeftOut: false };

/** The bodies of the step of the scenario that is shown. A report asks for single steps, and has no `steps`. */
export function useStepBodies(
    job: Job,
    steps: Steps | null,
    contacts: Contacts | null,
    isInReport: boolean,
): FoundStep {
    const [found, setFound] = useState<FoundStep & { step?: number }>(noStep);
    const step = contacts?.scenario.step;
    useEffect(() => {
        if ((steps === null && !isInReport) || step === undefined) {
            return;
        }
        const stop = new AbortController();
        const fail = (error: unknown) => {
            const lacks = isInReport && isLeftOut(error);
            setFound({ ...noStep, step, error: lacks ? "" : messageOf(error), isLeftOut: lacks });
        };
        loadStep(job, steps, step, stop.signal).then(
            (bodies) => stop.signal.aborted || setFound({ ...noStep, step, bodies }),
            (error) => isAbort(error) || stop.signal.aborted || fail(error),
        );
        return () => stop.abort();
    }, [job.job, steps, step]);
    return found.step === step ? found : noStep;
}

/** Returns the mesh of each body; null for one that is drawn as a box, as one is for which a report had no room. */
async function meshesOf(job: Job, others: readonly number[], form: OthersForm): Promise<(Mesh | null)[]> {
    const read = (body: number) =>
        meshOf(job, body).catch((error: unknown) => (isLeftOut(error) ? null : Promise.reject(error)));
    return Promise.all(others.map((body) => (form === "meshes" ? read(body) : null)));
}

/** How the other bodies of the step are drawn; `error` says why they are not. */
export interface Others {
    form: OthersForm;
    count: number;
    /** How many are drawn as boxes although meshes are drawn. */
    boxes: number;
    error: string;
}

const noOthers: Others = { form: "none", count: 0, boxes: 0, error: "" };

/** Draws the other bodies of the step, once they are read. */
export function useOthers(job: Job, viewer: Viewer | null, contacts: Contacts | null, step: StepBodies | null): Others {
    const [drawn, setDrawn] = useState(noOthers);
    useEffect(() => {
        if (!viewer || !contacts || !step) {
            viewer?.showOthers([]);
            setDrawn(noOthers);
            return;
        }
        let isCurrent = true;
        const pair = pairOf(contacts.scenario);
        const others = othersOf(step, pair);
        const form = formOf(job.bodies, pair, others);
        const finish = (meshes: readonly (Mesh | null)[]) => {
            if (isCurrent) {
                viewer.showOthers(
                    others.map((body, i): OtherBody => {
                        const { low, size } = job.bodies[body];
                        const poseAt = step.poses.get(body) ?? (() => []);
                        return { body, poseAt, low: low as Vec3, size: size as Vec3, mesh: meshes[i] };
                    }),
                );
                const boxes = form === "meshes" ? meshes.filter((mesh) => mesh === null).length : 0;
                setDrawn({ form, count: others.length, boxes, error: "" });
            }
        };
        meshesOf(job, others, form).then(
            finish,
            (error) => isCurrent && setDrawn({ ...noOthers, count: others.length, error: messageOf(error) }),
        );
        return () => {
            isCurrent = false;
        };
    }, [viewer, contacts, step]);
    return drawn;
}

/** Returns a function that opens a step near one that is wanted, at best with the same pair of bodies. */
export function useStepTo(
    job: Job,
    steps: Steps | null,
    contacts: Contacts | null,
    filter: SceneFilter,
    open: (scenario: number) => void,
): (step: number, by: 1 | -1) => void {
    const running = useRef<AbortController | null>(null);
    useEffect(() => () => running.current?.abort(), []);
    return (wanted, by) => {
        const step = steps?.nearest(wanted, by) ?? -1;
        if (!steps || !contacts || step < 0 || step === contacts.scenario.step) {
            return;
        }
        running.current?.abort();
        const stop = new AbortController();
        running.current = stop;
        const body = filter.body ? bodyNumber(job.bodies, filter.body) : -1;
        scenarioOfStep(job, steps, step, pairOf(contacts.scenario), body, stop.signal).then(
            (scenario) => stop.signal.aborted || open(scenario),
            () => undefined, // A later wish, or the server has ended, as the scenario's own request says.
        );
    };
}
