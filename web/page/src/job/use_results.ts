import { useEffect, useState } from "preact/hooks";
import { isAbort, messageOf } from "../base/api";
import type { Job, Source } from "../base/types";
import { loadResults, type Results } from "./results";

const reloadPause = 3000; // Milliseconds.

interface LoadedResults {
    results: Results | null;
    error: string;
    /** How many scenarios were done when these were asked for. */
    done: number;
    at: number;
}

/** Loads the results, and again when the job has more of them, at most every three seconds. */
export function useResults(source: Source, job: Job | undefined): LoadedResults {
    const [loaded, setLoaded] = useState<LoadedResults>({ results: null, error: "", done: -1, at: 0 });
    const [turn, setTurn] = useState(0);
    useEffect(() => {
        if (!job) {
            return;
        }
        const stop = new AbortController();
        const finish = (results: Results | null, error: string) =>
            setLoaded((old) => ({
                results: results ?? old.results,
                error,
                done: job.done,
                at: performance.now(),
            }));
        loadResults(source, job, 0, job.scenarios, stop.signal).then(
            (results) => finish(results, ""),
            (reason) => isAbort(reason) || finish(null, messageOf(reason)),
        );
        return () => stop.abort();
    }, [job?.job, turn]);
    useEffect(() => {
        if (!job || loaded.done < 0 || job.done === loaded.done) {
            return;
        }
        const wait = Math.max(0, loaded.at + reloadPause - performance.now());
        const timer = setTimeout(() => setTurn((old) => old + 1), wait);
        return () => clearTimeout(timer);
    }, [job?.done, loaded]);
    return loaded;
}
