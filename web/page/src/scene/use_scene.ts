/** What the viewer shows of a scene beside the pair of bodies: the steps, and the other bodies of the step. */
import { useEffect, useRef, useState } from "preact/hooks";
import { isAbort, messageOf } from "../base/api";
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

/** The bodies of the step of the scenario that is shown; null until they are read. */
export function useStepBodies(job: Job, steps: Steps | null, contacts: Contacts | null) {
    const [found, setFound] = useState<{ bodies: StepBodies | null; error: string }>({ bodies: null, error: "" });
    const step = contacts?.scenario.step;
    useEffect(() => {
        if (steps === null || step === undefined) {
            return;
        }
        const stop = new AbortController();
        loadStep(job, steps, step, stop.signal).then(
            (bodies) => setFound({ bodies, error: "" }),
            (error) => isAbort(error) || setFound({ bodies: null, error: messageOf(error) }),
        );
        return () => stop.abort();
    }, [job.job, steps, step]);
    return found.bodies?.step === step ? found : { ...found, bodies: null };
}

async function meshesOf(job: Job, others: readonly number[], form: OthersForm): Promise<(Mesh | null)[]> {
    return Promise.all(others.map((body) => (form === "meshes" ? meshOf(job, body) : null)));
}

/** How the other bodies of the step are drawn; `error` says why they are not. */
export interface Others {
    form: OthersForm;
    count: number;
    error: string;
}

/** Draws the other bodies of the step, once they are read. */
export function useOthers(job: Job, viewer: Viewer | null, contacts: Contacts | null, step: StepBodies | null): Others {
    const [drawn, setDrawn] = useState<Others>({ form: "none", count: 0, error: "" });
    useEffect(() => {
        if (!viewer || !contacts || !step) {
            viewer?.showOthers([]);
            setDrawn({ form: "none", count: 0, error: "" });
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
                        const pose = step.poses.get(body) ?? [];
                        return { body, pose, low: low as Vec3, size: size as Vec3, mesh: meshes[i] };
                    }),
                );
                setDrawn({ form, count: others.length, error: "" });
            }
        };
        meshesOf(job, others, form).then(
            finish,
            (error) => isCurrent && setDrawn({ form: "none", count: others.length, error: messageOf(error) }),
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
