import { useEffect, useState } from "preact/hooks";
import { getJson, isAbort, messageOf } from "../base/api";
import { onTheme } from "../base/theme";

export interface Polled<T> {
    value: T | undefined;
    error: string;
}

/**
 * Asks for `path` now and, while `again` says so of the answer, `seconds` after each answer. Keeps
 * the last answer when a later one fails.
 */
export function usePolled<T>(
    path: string | null,
    seconds: number,
    again: (value: T) => boolean = () => true,
): Polled<T> {
    const [polled, setPolled] = useState<Polled<T> & { path: string | null }>({
        value: undefined,
        error: "",
        path,
    });
    useEffect(() => {
        if (path === null) {
            return;
        }
        const stop = new AbortController();
        let timer = 0;
        const ask = async () => {
            let more = true;
            try {
                const value = await getJson<T>(path, stop.signal);
                more = again(value);
                setPolled({ value, error: "", path });
            } catch (error) {
                if (isAbort(error)) {
                    return;
                }
                setPolled((old) => ({ ...old, error: messageOf(error), path }));
            }
            if (more && !stop.signal.aborted) {
                timer = window.setTimeout(ask, 1000 * seconds);
            }
        };
        void ask();
        return () => {
            stop.abort();
            clearTimeout(timer);
        };
    }, [path]);
    return polled.path === path ? polled : { value: undefined, error: "" };
}

/** Draws again when light and dark change; the number differs after each change. */
export function useTheme(): number {
    const [count, setCount] = useState(0);
    useEffect(() => onTheme(() => setCount((old) => old + 1)), []);
    return count;
}

/** Sets the title of the tab; null leaves it as it is. */
export function useTitle(title: string | null): void {
    useEffect(() => {
        if (title !== null) {
            document.title = title === "" ? "cdcluster" : `${title} - cdcluster`;
        }
    }, [title]);
}
