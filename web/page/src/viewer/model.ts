/** What the viewer needs before its first picture: meshes and parts of both bodies; and heat maps. */
import { ApiError, getArray } from "../base/api";
import { getMesh, type Mesh } from "../base/mesh";
import { type BodyParts, getClosedParts, getParts } from "../base/parts";
import { asksShots, type BodyPair, firstPair, isScene, type Job } from "../base/types";
import { MeshStore } from "../scene/meshes";
import { countsByTriangle } from "./heat";

/** Above this the page does not draw. */
export const trianglesMax = 8_000_000;

export interface Model {
    /** The numbers of both bodies in their job. */
    bodies: BodyPair;
    meshes: [Mesh, Mesh];
    parts: [BodyParts, BodyParts];
    /** Which parts of A are closed, a byte each; null in a job without lines. */
    closed: Uint8Array | null;
    /** Milliseconds until both were read and checked. */
    milliseconds: number;
}

let last: { key: string; model: Promise<Model> } | null = null;
/** The meshes of scenes, and their pairs of bodies that were shown last. */
const meshes = new MeshStore(trianglesMax);
const pairs = new Map<string, Promise<Model>>();
const pairsMax = 16;

async function load(job: Job): Promise<Model> {
    const begin = performance.now();
    const [a, b] = job.bodies.map((body) => body.sha256);
    const first = getMesh(a);
    const parts = Promise.all([getParts(job.job, 0), getParts(job.job, 1)]);
    const meshes = await Promise.all([first, a === b ? first : getMesh(b)]);
    const closed = asksShots(job) ? await getClosedParts(job.job, 0) : null;
    return { bodies: firstPair, meshes, parts: await parts, closed, milliseconds: performance.now() - begin };
}

/** Reads the mesh of a body of a scene, or takes the one that was read for another body. */
export function meshOf(job: Job, body: number) {
    return meshes.get(job.bodies[body]);
}

async function loadTwo(job: Job, pair: BodyPair): Promise<Model> {
    const begin = performance.now();
    const [a, b] = pair;
    const parts = Promise.all([getParts(job.job, a), getParts(job.job, b)]);
    const both = await Promise.all([meshOf(job, a), meshOf(job, b)]);
    const closed = asksShots(job) ? await getClosedParts(job.job, a) : null;
    return { bodies: pair, meshes: both, parts: await parts, closed, milliseconds: performance.now() - begin };
}

/** Loads two bodies of a scene; a pair that was shown lately is the same object again. */
export function loadPair(job: Job, pair: BodyPair): Promise<Model> {
    const key = [job.job, ...pair].join(" ");
    const model = pairs.get(key) ?? loadTwo(job, pair);
    pairs.delete(key);
    pairs.set(key, model);
    model.catch(() => pairs.delete(key));
    if (pairs.size > pairsMax) {
        pairs.delete(pairs.keys().next().value ?? key);
    }
    return model;
}

/** How many triangles the bodies of a pair have. */
export function trianglesOf(job: Job, pair: BodyPair): number {
    return pair.reduce((sum, body) => sum + (job.bodies[body]?.triangles ?? 0), 0);
}

/** Whether a job has too many triangles to be drawn, whichever scenario is shown. */
export function isTooLarge(job: Job): boolean {
    return !isScene(job) && trianglesOf(job, firstPair) > trianglesMax;
}

/** Loads meshes and parts of a job; those of the last job are kept. */
export function loadModel(job: Job): Promise<Model> {
    const key = [job.job, ...job.bodies.map((body) => body.sha256)].join(" ");
    if (last?.key !== key) {
        const model = load(job);
        last = { key, model };
        model.catch(() => {
            last = null; // Asked again when the screen opens again.
        });
    }
    return last.model;
}

/** In how many scenarios each triangle was in contact, of A and of B. */
export interface Heat {
    counts: [Float64Array, Float64Array];
    most: number;
}

/** Loads both maps; null if the job has none. */
export async function loadHeat(job: Job, model: Model): Promise<Heat | null> {
    try {
        const rows = await Promise.all(
            [0, 1].map((body) => getArray(`jobs/${encodeURIComponent(job.job)}/map/${body}`)),
        );
        const counts = rows.map((one, body) =>
            countsByTriangle(one.values, model.meshes[body].triangles.length / 3),
        ) as [Float64Array, Float64Array];
        const most = counts.reduce((high, one) => one.reduce((x, y) => Math.max(x, y), high), 0);
        return { counts, most };
    } catch (error) {
        if (error instanceof ApiError && error.status === 404) {
            return null;
        }
        throw error;
    }
}
