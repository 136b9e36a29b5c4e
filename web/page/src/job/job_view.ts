import { isFiltered, noFilter, readFilter, type SceneFilter, writeFilter } from "../scene/filter";

/** All that is seen of a job's screen, as the query of a link. */
export interface JobView {
    /** The names of the axes across and up; empty: the page chooses. */
    x: string;
    y: string;
    /** Values of a grid's other axes, by their names; those left out are at their first. */
    at: Readonly<Record<string, number>>;
    /** Scenarios [first, end) of the strip; null: all. */
    window: readonly [number, number] | null;
    /** Which scenarios of a scene are meant. */
    filter: SceneFilter;
}

export const startView: JobView = { x: "", y: "", at: {}, window: null, filter: noFilter };

function readValues(text: string | null): Record<string, number> {
    const pairs = (text ?? "").split(",").map((pair) => /^(\w+):(-?[\d.]+(?:e[-+]?\d+)?)$/i.exec(pair));
    return Object.fromEntries(
        pairs.flatMap((pair) => (pair && Number.isFinite(Number(pair[2])) ? [[pair[1], Number(pair[2])]] : [])),
    );
}

function readWindow(first: string | null, last: string | null): [number, number] | null {
    const isWhole = (text: string | null) => /^\d{1,15}$/.test(text ?? "");
    const [from, to] = [Number(first), Number(last)];
    return isWhole(first) && isWhole(last) && from <= to ? [from, to + 1] : null;
}

/** Reads a link. Values that mean nothing are ignored. */
export function readJobView(query: URLSearchParams): JobView {
    return {
        x: query.get("x") ?? "",
        y: query.get("y") ?? "",
        at: readValues(query.get("at")),
        window: readWindow(query.get("from"), query.get("to")),
        filter: readFilter(query),
    };
}

/** Writes what differs from the start, so that plain views have plain links. */
export function writeJobView(view: JobView): Record<string, string> {
    const query: Record<string, string> = {};
    if (view.x && view.y) {
        query.x = view.x;
        query.y = view.y;
    }
    const values = Object.entries(view.at);
    if (values.length > 0) {
        query.at = values.map(([name, value]) => `${name}:${value}`).join(",");
    }
    if (view.window) {
        query.from = String(view.window[0]);
        query.to = String(view.window[1] - 1);
    }
    if (isFiltered(view.filter)) {
        Object.assign(query, writeFilter(view.filter));
    }
    return query;
}
