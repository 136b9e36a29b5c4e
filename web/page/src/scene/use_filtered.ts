import { useMemo } from "preact/hooks";
import type { Results } from "../job/results";
import { isScene, type Job } from "../base/types";
import { useReloaded } from "../ui/hooks";
import { bodyNumber, isFiltered, type SceneFilter } from "./filter";
import { loadRows, type SceneRows } from "./scene_rows";

/** The results of the scenarios that are meant, and the bodies of all; `rows` is null until these are read. */
export interface Filtered {
    rows: SceneRows | null;
    results: Results | null;
    error: string;
}

/** Filters the results of a job by a body and by steps. Those of a job that is no scene stay as they are. */
export function useFiltered(job: Job | undefined, results: Results | null, filter: SceneFilter): Filtered {
    const isAsked = job !== undefined && results !== null && isScene(job);
    const loaded = useReloaded(isAsked ? job.job : null, results, (signal) =>
        job && results ? loadRows(job, results, signal) : Promise.reject(new Error("there are no results")),
    );
    const rows = loaded.value;
    const body = job && filter.body ? bodyNumber(job.bodies, filter.body) : -1;
    const isUnknown = filter.body !== "" && body < 0;
    const chosen = useMemo(() => {
        if (!rows || !isFiltered(filter)) {
            return rows?.results ?? results;
        }
        return rows.resultsOf(isUnknown ? [] : rows.chosen(body, filter.steps));
    }, [rows, results, filter, body]);
    return { rows, results: chosen, error: loaded.error || (job && isUnknown ? `the job has no body '${filter.body}'` : "") };
}
