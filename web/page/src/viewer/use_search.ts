import { useEffect, useRef, useState } from "preact/hooks";
import { isAbort, messageOf } from "../base/api";
import { grouped } from "../base/words";

type Step = 1 | -1;

/** Looks for the next scenario that is sought until `signal` ends it; null at the end of the job. */
export type FindNext = (by: Step, signal: AbortSignal, tell: (scenario: number) => void) => Promise<number | null>;

export interface ContactSearch {
    /** How the search goes, or how it ended. */
    said: string;
    start: (by: Step) => void;
    stop: () => void;
}

/**
 * Searches for the next scenario, and opens it. `sought` says what is sought, for messages. A search ends
 * when something in `seen` changes.
 */
export function useContactSearch(
    find: FindNext,
    open: (scenario: number) => void,
    isOver: boolean,
    sought: string,
    seen: readonly unknown[],
): ContactSearch {
    const [said, say] = useState("");
    const running = useRef<{ by: Step; stop: AbortController } | null>(null);
    const stop = () => {
        if (running.current) {
            running.current.stop.abort();
            running.current = null;
            say((old) => old.replace("searching", "stopped"));
        }
    };
    const start = async (by: Step) => {
        if (running.current?.by === by) {
            return;
        }
        stop();
        say("");
        const mine = { by, stop: new AbortController() };
        running.current = mine;
        try {
            const found = await find(by, mine.stop.signal, (scenario) => {
                if (running.current === mine) {
                    say(`searching, at #${grouped(scenario)}`);
                }
            });
            if (running.current !== mine) {
                return;
            }
            running.current = null;
            if (found !== null) {
                say("");
                open(found);
            } else {
                say(`no ${sought} ${by > 0 ? "after" : "before"} this scenario${isOver ? "" : " so far"}`);
            }
        } catch (error) {
            if (running.current === mine) {
                running.current = null;
                say(isAbort(error) ? "" : messageOf(error));
            }
        }
    };
    useEffect(
        () => () => {
            stop();
            say("");
        },
        seen,
    );
    return { said, start: (by) => void start(by), stop };
}
