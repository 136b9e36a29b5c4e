/** The next scenario in contact, of the chosen parts. */
import { getArray, getJson } from "../base/api";
import { isOfPart, type Mesh } from "../base/mesh";
import type { ViewState } from "./view_state";

export async function nextContact(
    job: string,
    from: number,
    step: 1 | -1,
    state: ViewState,
): Promise<number | null> {
    const query = new URLSearchParams({ from: String(from), step: String(step) });
    if (state.partA) {
        query.set("part_a", state.partA);
    }
    if (state.partB) {
        query.set("part_b", state.partB);
    }
    const path = `jobs/${encodeURIComponent(job)}/scenarios/next?${query}`;
    return (await getJson<{ index: number | null }>(path)).index;
}

/** As `nextContact`, of the scenarios of a report, which are all in contact. */
export async function nextHeldContact(
    job: string,
    scenarios: readonly number[],
    from: number,
    step: 1 | -1,
    state: ViewState,
    meshes: readonly [Mesh, Mesh],
): Promise<number | null> {
    const beyond = scenarios.filter((one) => (one - from) * step > 0).sort((a, b) => (a - b) * step);
    for (const scenario of beyond) {
        if (!state.partA && !state.partB) {
            return scenario;
        }
        const { values } = await getArray(`jobs/${encodeURIComponent(job)}/scenarios/${scenario}/pairs`);
        for (let i = 0; i + 2 < values.length; i += 3) {
            if (isOfPart(meshes[0], values[i], state.partA) && isOfPart(meshes[1], values[i + 1], state.partB)) {
                return scenario;
            }
        }
    }
    return null;
}
