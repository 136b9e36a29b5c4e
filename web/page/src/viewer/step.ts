/** The next scenario in contact, of the chosen parts. */
import { getArray, getJson } from "../base/api";
import type { BodyParts } from "../base/parts";
import type { ViewState } from "./view_state";

interface Found {
    index: number | null;
    /** From where a search without a find goes on; null at the end. */
    searched_to: number | null;
}

/** Searches until `signal` ends it; `tell` hears how far it came. Returns null at the job's end. */
export async function nextContact(
    job: string,
    from: number,
    step: 1 | -1,
    state: ViewState,
    signal: AbortSignal,
    tell: (scenario: number) => void,
): Promise<number | null> {
    const query = new URLSearchParams({ from: String(from), step: String(step) });
    if (state.partA) {
        query.set("part_a", state.partA);
    }
    if (state.partB) {
        query.set("part_b", state.partB);
    }
    for (;;) {
        const found = await getJson<Found>(`jobs/${encodeURIComponent(job)}/scenarios/next?${query}`, signal);
        if (found.index !== null || found.searched_to === null) {
            return found.index;
        }
        tell(found.searched_to);
        query.set("from", String(found.searched_to));
    }
}

/** As `nextContact`, of the scenarios of a report, which are all in contact. */
export async function nextHeldContact(
    job: string,
    scenarios: readonly number[],
    from: number,
    step: 1 | -1,
    state: ViewState,
    parts: readonly [BodyParts, BodyParts],
): Promise<number | null> {
    const beyond = scenarios.filter((one) => (one - from) * step > 0).sort((a, b) => (a - b) * step);
    for (const scenario of beyond) {
        if (!state.partA && !state.partB) {
            return scenario;
        }
        const { values } = await getArray(`jobs/${encodeURIComponent(job)}/scenarios/${scenario}/pairs`);
        for (let i = 0; i + 2 < values.length; i += 3) {
            if (parts[0].isOf(values[i], state.partA) && parts[1].isOf(values[i + 1], state.partB)) {
                return scenario;
            }
        }
    }
    return null;
}
