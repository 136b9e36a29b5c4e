/** The next scenario in contact or near, of the chosen parts. */
import { ApiError, getArray, getJson, pause } from "../base/api";
import { near, numberOf } from "../base/classes";
import type { BodyParts } from "../base/parts";
import { bodyNames, type BodyPair, isScene, type Job, pairOf, type Scenario } from "../base/types";
import { nearPair } from "./contacts_view";
import type { ViewState } from "./view_state";

/**
 * What is sought, and the parts of two bodies that are wanted; an empty name stands for all. The bodies are those
 * of `bodies`, of a job that is no scene A and B.
 */
export type Wanted = Pick<ViewState, "partA" | "partB" | "seek"> & { filter?: { body: string }; bodies: BodyPair };
type PartsOfBodies = readonly [BodyParts, BodyParts];

/** One search: from a scenario, up (1) or down (-1), until `signal` ends it; `tell` hears how far it came. */
export interface Search {
    job: Job;
    from: number;
    step: 1 | -1;
    signal: AbortSignal;
    tell: (scenario: number) => void;
    /** Only scenarios [first, end) are sought; all if left out. */
    within?: readonly [number, number];
}

interface Found {
    index: number | null;
    /** From where a search without a find goes on; null at the end. */
    searched_to: number | null;
}

const isAny = ({ partA, partB }: Wanted) => !partA && !partB;

function path(job: string, rest: string): string {
    return `jobs/${encodeURIComponent(job)}/scenarios/${rest}`;
}

/** Lets the server look through the records. Returns null at the job's end. */
async function nextRecorded(search: Search, wanted: Wanted): Promise<number | null> {
    const { job, step, signal, tell } = search;
    const [first, end] = search.within ?? [0, Infinity];
    // A search does not look at the scenario from which it begins.
    const from = step > 0 ? Math.max(search.from, first - 1) : Math.min(search.from, end);
    const isBeyond = (scenario: number) => (step > 0 ? scenario >= end : scenario < first);
    const query = new URLSearchParams({ from: String(from), step: String(step) });
    if (wanted.seek !== "contact") {
        query.set("class", wanted.seek);
    }
    const bodies = bodyNames(job, wanted.bodies);
    (["a", "b"] as const).forEach((side, i) => {
        const part = [wanted.partA, wanted.partB][i];
        if (part) {
            query.set(`part_${side}`, part);
        }
        if (part && isScene(job)) {
            query.set(`body_${side}`, bodies[i]);
        }
    });
    if (wanted.filter?.body) {
        query.set("body", wanted.filter.body);
    }
    for (;;) {
        const found = await getJson<Found>(path(job.job, `next?${query}`), signal);
        if (found.index !== null || found.searched_to === null) {
            return found.index === null || isBeyond(found.index) ? null : found.index;
        }
        if (isBeyond(found.searched_to)) {
            return null;
        }
        tell(found.searched_to);
        query.set("from", String(found.searched_to));
    }
}

/** Whether rows of pairs of the bodies `of` have a sought one of both wanted parts. */
export function hasPairOf(
    pairs: ArrayLike<number>,
    { partA, partB, seek, bodies }: Wanted,
    parts: PartsOfBodies,
    of: BodyPair,
): boolean {
    const wanted = [partA, partB].flatMap((part, i) => (part ? [{ part, side: of.indexOf(bodies[i]), of: parts[i] }] : []));
    if (wanted.some(({ side }) => side < 0)) {
        return false;
    }
    for (let i = 0; i + 2 < pairs.length; i += 3) {
        const fits = seek === "either" || (pairs[i + 2] === nearPair) === (seek === "near");
        if (fits && wanted.every((one) => one.of.isOf(pairs[i + one.side], one.part))) {
            return true;
        }
    }
    return false;
}

/** Asks again as long as the server is busy. */
async function patiently<T>(ask: () => Promise<T>): Promise<T> {
    for (;;) {
        try {
            return await ask();
        } catch (error) {
            if (!(error instanceof ApiError && error.isBusy)) {
                throw error;
            }
            await pause();
        }
    }
}

/** Whether a scenario, run again, has a pair of both wanted parts; true also where that cannot be told. */
async function mayHave({ job, signal }: Search, scenario: number, wanted: Wanted, parts: PartsOfBodies) {
    const one = await patiently(() => getJson<Scenario>(path(job.job, String(scenario)), signal));
    if (one.exact_pairs === 0) {
        return one.draw_note !== "";
    }
    const pairs = await patiently(() => getArray(path(job.job, `${scenario}/pairs`), signal));
    return pairs.cut || hasPairOf(pairs.values, wanted, parts, pairOf(one));
}

/** Returns the body of a scene whose scenarios alone can have the wanted parts, or that is wanted; or none. */
function bodyOfParts(job: Job, { partA, bodies, filter }: Wanted): string {
    return isScene(job) && !filter?.body ? bodyNames(job, bodies)[partA ? 0 : 1] : (filter?.body ?? "");
}

/** Returns the next scenario that is sought, null at the job's end. */
export async function nextContact(
    search: Search,
    wanted: Wanted,
    getParts: () => Promise<PartsOfBodies>,
): Promise<number | null> {
    const { level } = search.job;
    if (isAny(wanted) || level === "pairs" || level === "contacts") {
        return nextRecorded(search, wanted);
    }
    // The records have no pairs: each scenario of the sought class is run again.
    const parts = await getParts();
    [wanted.partA, wanted.partB].forEach((part, body) => {
        if (part && !parts[body].names.includes(part)) {
            throw new Error(`the body has no part '${part}'`);
        }
    });
    const records = { ...wanted, partA: "", partB: "", filter: { body: bodyOfParts(search.job, wanted) } };
    for (let from = search.from; ; search.tell(from)) {
        const found = await nextRecorded({ ...search, from }, records);
        if (found === null || (await mayHave(search, found, wanted, parts))) {
            return found;
        }
        from = found;
    }
}

/** Whether a scenario of a report, which is in contact or near, is of the sought class. */
async function isSought(job: Job, scenario: number, { seek }: Wanted): Promise<boolean> {
    if (job.clearance === null || seek === "either") {
        return true;
    }
    const one = await getJson<Scenario>(path(job.job, String(scenario)));
    return (numberOf(one.class) === near) === (seek === "near");
}

/** Whether a scenario of a report has a pair of both wanted parts. */
async function hasParts(job: Job, scenario: number, wanted: Wanted, parts: PartsOfBodies): Promise<boolean> {
    const one = await getJson<Scenario>(path(job.job, String(scenario)));
    const pairs = await getArray(path(job.job, `${scenario}/pairs`));
    return hasPairOf(pairs.values, wanted, parts, pairOf(one));
}

/** As `nextContact`, of the scenarios of a report, which are all in contact or near. */
export async function nextHeldContact(
    { job, from, step }: Pick<Search, "job" | "from" | "step">,
    scenarios: readonly number[],
    wanted: Wanted,
    parts: PartsOfBodies,
): Promise<number | null> {
    const beyond = scenarios.filter((one) => (one - from) * step > 0).sort((a, b) => (a - b) * step);
    for (const scenario of beyond) {
        if (!(await isSought(job, scenario, wanted))) {
            continue;
        }
        if (isAny(wanted) || (await hasParts(job, scenario, wanted, parts))) {
            return scenario;
        }
    }
    return null;
}
