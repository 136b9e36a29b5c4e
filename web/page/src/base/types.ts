/** The server's JSON, key by key. */
export type Pose = readonly number[]; // Rows of [R t], 12 numbers.
export type Vec3 = [number, number, number];

export interface Source {
    kind: "master" | "folder" | "remote";
    program: string;
    name: string;
    tls: boolean;
    job: string | null;
}

export interface JobRow {
    job: string;
    name: string;
    state: string;
    owner?: string;
    began?: string;
    scenarios: number;
    done: number;
    contact: number;
    failed: number;
    pairs?: number;
    seconds?: number;
    scenarios_per_second?: number;
    digest?: string;
}

export interface WorkerRow {
    worker: string;
    name: string;
    state: string;
    threads: number;
    working: number;
    scenarios: number;
    scenarios_per_second: number;
    cached_bytes: number;
    cache_bytes: number;
    cache_hit_share: number;
    uploaded_bytes: number;
    longest?: { job: string; scenario: number; seconds: number } | null;
}

export interface MeshRow {
    mesh: string;
    name: string;
    triangles: number;
    bytes: number;
    needed: string;
}

export interface Cluster {
    build: string;
    uptime_seconds: number;
    jobs: JobRow[];
    workers: WorkerRow[];
    meshes: MeshRow[];
    alarms: string[];
    alarm_count: number;
    workers_lost: number;
    paused: string;
    bottleneck: string;
    state_bytes: Record<string, number>;
}

export interface History {
    columns: string[];
    rows: number[][];
}

export interface Axis {
    name: string;
    first: number;
    last: number;
    count: number;
}

export interface Body {
    name: string;
    file: string;
    unit: string;
    sha256: string;
    triangles: number;
    parts: number;
    closed: boolean | null;
    bytes: number;
    precision: string;
    size: number[];
    /** The corner of the box with the least coordinates. */
    low: number[];
    /** Whether the body has one pose at all steps of a scene. */
    fixed: boolean;
}

/** The numbers of two bodies of a job, the first of which is A. */
export type BodyPair = readonly [number, number];

/** The bodies of every scenario of a job that is no scene. */
export const firstPair: BodyPair = [0, 1];

/** The names of two bodies of a job. */
export function bodyNames(job: { bodies: readonly Body[] }, [a, b]: BodyPair = firstPair): [string, string] {
    return [job.bodies[a]?.name ?? "", job.bodies[b]?.name ?? ""];
}

export interface Group {
    a: string;
    b: string;
    scenarios: number;
    share: number;
    pairs: number;
    worst: number;
    worst_pairs: number;
    class: string;
    /** Near pairs in all scenarios, and in the worst one. */
    near: number;
    worst_near: number;
}

export interface Poses {
    kind: "grid" | "file" | "random" | "shots" | "curve";
    count: number;
    file?: string;
    axes: Axis[] | null;
    penetration: [number, number] | null;
    seed: string | null; // May exceed 2^53.
    has_ids: boolean;
    has_times: boolean;
    of_both_bodies: boolean;
}

/** What changes of a job while it runs. */
export interface Progress {
    job: string;
    name: string;
    state: string;
    owner: string;
    began: string;
    scenarios: number;
    done: number;
    separate: number;
    touch: number;
    cross: number;
    inside: number;
    contact: number;
    undecided: number;
    failed: number;
    near: number;
    pairs: number;
    near_pairs: number;
    surfaces_only: number;
    insides_skipped: number;
    cut: number;
    seconds: number;
    scenarios_per_second: number;
    digest: string | null;
    failure: string;
    paused: string;
}

export interface Job extends Progress {
    unit: string;
    level: string;
    limit_pairs: number;
    /** Null in a job that does not ask for near pairs. */
    clearance: number | null;
    /** Only in a job that asks how far the bodies are apart, what lines hit, or when bodies meet. */
    question?: "distance" | "shots" | "motion";
    /** In a job of motions: how far bodies move in an open part at most, and what the search is for. */
    resolution?: number;
    until?: Until;
    /** In a job of lines: of each line, only the first hit that crosses counts. */
    first_hits?: boolean;
    /** In a job of a scene: how many steps it has. */
    steps?: number;
    /** Then: bodies farther apart have no distance; null: all that share no point have one. */
    up_to?: number | null;
    maps: boolean;
    map_pairs: number;
    where: string;
    command: string;
    program: string;
    commit: string;
    started: string;
    ended: string;
    simd: string;
    bodies: Body[];
    poses: Poses;
    ignored: number;
    formats?: string[];
    folder: string;
    groups: Group[] | null;
    groups_total?: number;
}

export type Until = "contact" | "free" | "end";

/** A quaternion w, x, y, z of any length, and a position in the world. */
export type MotionKey = readonly number[];

/** Consecutive leaves of a motion, in units of 2^-depth of its time. */
export interface MotionRun {
    state: "free" | "open";
    first: number;
    count: number;
    /** The first and last instant with the event; null if there is none. */
    event_first: number | null;
    event_last: number | null;
}

/** What is proven of a motion. Instants are in units of 2^-depth of its time. */
export interface Motion {
    end: "free" | "contact" | "start" | "limit";
    until: Until;
    depth: number;
    t0: number;
    t1: number;
    event: number | null;
    /** In the job's unit; null if it is not known. */
    bound: number | null;
    runs: MotionRun[];
    from: { a: MotionKey; b: MotionKey };
    to: { a: MotionKey; b: MotionKey };
}

export interface Scenario {
    index: number;
    class: string | null;
    count: number;
    near_count: number;
    listed: number;
    cut: boolean;
    surfaces_only: boolean;
    insides_skipped: boolean;
    distance_bound: number | null;
    failure: string;
    id: string | null;
    time: number | null;
    /** In a job of a scene: the step, and the two bodies. */
    step?: number;
    bodies?: BodyPair;
    pose_a: Pose;
    pose_b: Pose;
    verified: boolean | null;
    verify_note: string;
    /** Why nothing is drawn; empty if pairs are. */
    draw_note: string;
    exact_pairs: number;
    /** The least distance of a near pair; null if there is none, or if not all are listed. */
    least_distance: number | null;
    /** Only if the job asks for it; null in contact, or farther apart than asked for. */
    distance?: number | null;
    /** Only of a motion that did not fail. */
    motion?: Motion;
}

/** Whether a job has come to its end. */
export function isOver(job: Pick<Job, "state">): boolean {
    return job.state !== "running" && job.state !== "paused";
}

/** Whether a job asks how far the bodies are apart. */
export function asksDistance(job: Pick<Job, "question">): boolean {
    return job.question === "distance";
}

/** Whether a job's scenarios are motions. */
export function asksMotion(job: Pick<Job, "question">): boolean {
    return job.question === "motion";
}

/** Whether body B of a job is a bundle of lines, and the job asks what they hit. */
export function asksShots(job: Pick<Job, "question">): boolean {
    return job.question === "shots";
}

/** Whether a job is a scene: each scenario is of two bodies of many, at one step. */
export function isScene(job: Pick<Job, "steps">): boolean {
    return job.steps !== undefined;
}

/** Returns the numbers of a scenario's bodies. */
export function pairOf({ bodies }: Pick<Scenario, "bodies">): BodyPair {
    return bodies ?? firstPair;
}

/** Whether a job's lines are a grid, whose bundles stand in directions; else they are those of a file. */
export function hasDirections(job: Pick<Job, "question" | "poses">): boolean {
    return asksShots(job) && (job.poses.axes ?? []).length > 0;
}

/** The word for what scenarios are counted by. */
export function countNoun(job: Pick<Job, "question">): string {
    return asksShots(job) ? "hit" : "pair";
}
