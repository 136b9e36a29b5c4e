/** Reads from the server that served this page, or from the file that holds it. */
import { type NpyArray, parseNpy } from "./npy";

export interface Answer {
    bytes: ArrayBuffer;
    /** Whether rows beyond a limit were left out. */
    cut: boolean;
}

/** An answer that is no success. `status` is 0 if the server did not answer at all. */
export class ApiError extends Error {
    constructor(
        readonly status: number,
        text: string,
    ) {
        super(text);
    }

    /** Whether the same request may be answered a little later. */
    get isBusy(): boolean {
        return this.status === 503;
    }
}

const busyWait = 300; // Milliseconds.

/** Waits before a busy server is asked again. */
export function pause(): Promise<void> {
    return new Promise((resolve) => setTimeout(resolve, busyWait));
}

const storageName = "cdcluster.key";
let memoryKey = "";

function storedKey(): string {
    try {
        return localStorage.getItem(storageName) ?? memoryKey;
    } catch {
        return memoryKey; // Storage is switched off in this browser.
    }
}

/**
 * Moves the key from the address (`#key=...`, perhaps with `&/jobs/...` behind it) into the storage
 * of this origin, so that it is in no link that somebody copies.
 */
export function takeKey(): void {
    const found = /^#key=([^&]*)&?(.*)$/.exec(location.hash);
    if (!found) {
        return;
    }
    memoryKey = found[1];
    try {
        localStorage.setItem(storageName, memoryKey);
    } catch {
        // The key then lives as long as this tab.
    }
    history.replaceState(null, "", `${location.pathname}#${found[2]}`);
}

async function errorText(answer: Response): Promise<string> {
    try {
        const body: unknown = await answer.json();
        if (typeof body === "object" && body !== null && "error" in body) {
            return String(body.error);
        }
    } catch {
        // No JSON: the status has to do.
    }
    return `the server answered ${answer.status}`;
}

async function askServer(path: string, signal?: AbortSignal): Promise<Answer> {
    const key = storedKey();
    const headers: Record<string, string> = key === "" ? {} : { Authorization: `Bearer ${key}` };
    let answer: Response;
    try {
        answer = await fetch(`api/v1/${path}`, {
            headers,
            credentials: "same-origin",
            ...(signal ? { signal } : {}),
        });
    } catch (error) {
        if (signal?.aborted) {
            throw error;
        }
        throw new ApiError(0, "the server does not answer: has it ended?");
    }
    if (!answer.ok) {
        throw new ApiError(answer.status, await errorText(answer));
    }
    return { bytes: await answer.arrayBuffer(), cut: answer.headers.get("X-Cut") === "true" };
}

let get = askServer;

/** Lets `other` answer in place of the server; it throws ApiError for what it does not have. */
export function answerFrom(other: typeof get): void {
    get = other;
}

export async function getText(path: string, signal?: AbortSignal): Promise<string> {
    return new TextDecoder().decode((await get(path, signal)).bytes);
}

export async function getJson<T>(path: string, signal?: AbortSignal): Promise<T> {
    return JSON.parse(await getText(path, signal)) as T;
}

/** An array, and whether rows beyond a limit were left out. */
export interface AnsweredArray extends NpyArray {
    cut: boolean;
}

export async function getArray(path: string, signal?: AbortSignal): Promise<AnsweredArray> {
    const { bytes, cut } = await get(path, signal);
    return { ...parseNpy(bytes), cut };
}

export async function getBytes(path: string, signal?: AbortSignal): Promise<ArrayBuffer> {
    return (await get(path, signal)).bytes;
}

export function isAbort(error: unknown): boolean {
    return error instanceof DOMException && error.name === "AbortError";
}

export function messageOf(error: unknown): string {
    return error instanceof Error ? error.message : String(error);
}
