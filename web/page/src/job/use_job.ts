import { useMemo } from "preact/hooks";
import { isOver, type Job, type Progress } from "../base/types";
import { type Polled, usePolled } from "../ui/hooks";

/**
 * Loads a job. While it runs, asks each second for its progress alone, since the description of many
 * bodies is large; loads the job again once it is over.
 */
export function useJob(id: string): Polled<Job> {
    const path = `jobs/${encodeURIComponent(id)}`;
    const begun = usePolled<Job>(path, 1, () => false);
    const runs = begun.value !== undefined && !isOver(begun.value);
    const progress = usePolled<Progress>(runs ? `${path}/progress` : null, 1, (one) => !isOver(one));
    const ends = progress.value !== undefined && isOver(progress.value);
    const ended = usePolled<Job>(ends ? path : null, 1, () => false);
    const value = useMemo(
        () => ended.value ?? (begun.value && { ...begun.value, ...progress.value }),
        [begun.value, progress.value, ended.value],
    );
    return { value, error: begun.error || progress.error || ended.error };
}
