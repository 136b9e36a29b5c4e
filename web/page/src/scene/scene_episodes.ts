/** Episodes of a scene: runs of consecutive steps at which two bodies are in contact, or near. */
import { isHit } from "../base/classes";
import type { SceneRows } from "./scene_rows";

export interface SceneEpisode {
    pair: [number, number];
    first: number; // Steps.
    last: number;
    worst: number; // An element of the results.
}

/**
 * Returns how many episodes there are, and at most `listedMax`, in the order of their first steps. Two fixed
 * bodies are tested at step 0 alone, and are so at all steps.
 */
export function sceneEpisodesOf(
    rows: SceneRows,
    job: { bodies: readonly { fixed: boolean }[]; steps?: number },
    listedMax: number,
): { count: number; listed: SceneEpisode[] } {
    const open = new Map<string, SceneEpisode>();
    const listed: SceneEpisode[] = [];
    let count = 0;
    for (let row = 0; row < rows.count; ++row) {
        if (!isHit(rows.classOf(row))) {
            continue;
        }
        const [step, pair, element] = [rows.stepOf(row), rows.pairOf(row), rows.elementOf(row)];
        const key = pair.join(" ");
        const old = open.get(key);
        if (old && old.last + 1 === step) {
            old.last = step;
            old.worst = rows.results.isWorse(element, old.worst) ? element : old.worst;
            continue;
        }
        const last = pair.every((body) => job.bodies[body].fixed) ? (job.steps ?? 1) - 1 : step;
        const episode: SceneEpisode = { pair, first: step, last, worst: element };
        open.set(key, episode);
        count += 1;
        if (count <= listedMax) {
            listed.push(episode);
        }
    }
    return { count, listed };
}
