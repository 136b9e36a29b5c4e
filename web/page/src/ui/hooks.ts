import { useEffect, useRef, useState } from "preact/hooks";
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

export interface Reloaded<T> {
    value: T | null;
    error: string;
}

/** What is loaded again rests for so many times as long as loading took: the server has other work. */
const restFactor = 4;

/**
 * Loads what `key` names, and again when `version` has changed since; keeps the old value until then.
 * A change of the key drops the value; null loads nothing.
 */
export function useReloaded<T>(
    key: string | null,
    version: unknown,
    load: (signal: AbortSignal) => Promise<T>,
): Reloaded<T> {
    const [loaded, setLoaded] = useState<Reloaded<T> & { key: string | null; version: unknown; rests: number }>({
        value: null,
        error: "",
        key: null,
        version: null,
        rests: 0, // Until this time, in milliseconds.
    });
    const [turn, setTurn] = useState(0);
    const isLoading = useRef(false);
    const now = useRef({ version, load });
    now.current = { version, load };
    useEffect(() => {
        if (key === null) {
            return;
        }
        const stop = new AbortController();
        const asked = now.current.version;
        const began = performance.now();
        isLoading.current = true;
        const finish = (value: T | null, error: string) => {
            isLoading.current = false;
            const now = performance.now();
            setLoaded((old) => ({
                value: value ?? (old.key === key ? old.value : null),
                error,
                key,
                version: asked,
                rests: now + restFactor * (now - began),
            }));
        };
        now.current.load(stop.signal).then(
            (value) => stop.signal.aborted || finish(value, ""),
            (error) => isAbort(error) || stop.signal.aborted || finish(null, messageOf(error)),
        );
        return () => stop.abort();
    }, [key, turn]);
    useEffect(() => {
        if (loaded.key !== key || key === null || loaded.version === version || isLoading.current) {
            return;
        }
        const timer = setTimeout(() => setTurn((old) => old + 1), Math.max(0, loaded.rests - performance.now()));
        return () => clearTimeout(timer);
    }, [key, version, loaded]);
    return loaded.key === key ? loaded : { value: null, error: "" };
}
