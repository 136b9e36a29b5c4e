/** The address behind '#': which screen, and what is seen there. */
export interface Route {
    screen: "cluster" | "jobs" | "job" | "viewer" | "none";
    job: string;
    scenario: number;
    query: URLSearchParams;
}

export function parseRoute(hash: string): Route {
    const [path, query] = hash.replace(/^#/, "").split("?", 2);
    const route: Route = {
        screen: "none",
        job: "",
        scenario: 0,
        query: new URLSearchParams(query ?? ""),
    };
    const words = path.split("/").filter((word) => word !== "");
    if (words.length === 1 && (words[0] === "cluster" || words[0] === "jobs")) {
        return { ...route, screen: words[0] };
    }
    if (words[0] !== "jobs" || words.length < 2 || words.length > 3) {
        return route;
    }
    const job = decode(words[1]);
    if (words.length === 2) {
        return { ...route, screen: "job", job };
    }
    return /^\d+$/.test(words[2])
        ? { ...route, screen: "viewer", job, scenario: Number(words[2]) }
        : route;
}

function decode(word: string): string {
    try {
        return decodeURIComponent(word);
    } catch {
        return word;
    }
}

type Query = Record<string, string>;

function queryText(query: Query): string {
    // Commas, colons and slashes need no escape behind '#', and links stay readable.
    const text = new URLSearchParams(query)
        .toString()
        .replaceAll("%2C", ",")
        .replaceAll("%3A", ":")
        .replaceAll("%2F", "/");
    return text === "" ? "" : `?${text}`;
}

export function jobLink(job: string, query: Query = {}): string {
    return `#/jobs/${encodeURIComponent(job)}${queryText(query)}`;
}

export function scenarioLink(job: string, scenario: number, query: Query = {}): string {
    return `#/jobs/${encodeURIComponent(job)}/${scenario}${queryText(query)}`;
}

/** The address that the page shows; null at first. The browser tells of a new one a little later. */
let shown: string | null = null;
let timer = 0;
let waiting: (() => string) | null = null;

/** Goes to another screen; the browser's back button returns to what was noted last. */
export function goTo(link: string): void {
    settleNotes();
    location.hash = link;
}

/** Reads the address that the page shows from now on. */
export function readRoute(): Route {
    shown = location.hash;
    return parseRoute(shown);
}

/**
 * Changes the address without a step in the browser's history and without a new screen; not if the address
 * is already another one than that of the view.
 */
export function noteLink(link: string): void {
    forgetNotes();
    if (shown === null || location.hash === shown) {
        history.replaceState(null, "", link);
        shown = location.hash;
    }
}

/**
 * As `noteLink`, once nothing else has been noted for a while: browsers limit how often. The link is made
 * then.
 */
export function noteLinkSoon(link: () => string): void {
    forgetNotes();
    waiting = link;
    timer = window.setTimeout(settleNotes, 200);
}

/** Notes at once what waits to be noted. */
function settleNotes(): void {
    if (waiting) {
        noteLink(waiting());
    }
}

/** Drops what waits to be noted, because the address is about another view now. */
export function forgetNotes(): void {
    clearTimeout(timer);
    waiting = null;
}
