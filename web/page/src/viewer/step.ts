/** The next scenario in contact, of the chosen parts. */
import { getJson } from "../base/api";
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
