import { useMemo } from "preact/hooks";
import type { BodyParts } from "../base/parts";
import { coordinateOf, isAngle, placementKeys, placementOf, shotKeys } from "../base/pose";
import { asksShots, countNoun, hasDirections, type Job, type Pose } from "../base/types";
import { counted, grouped, percent, short } from "../base/words";
import { shownPose, shownPoses } from "../motion/motion";
import { Name } from "../ui/small";
import { nearPair } from "./contacts_view";
import type { Heat, Model } from "./model";
import type { Contacts } from "./scenario_loader";
import type { Pick, ViewState } from "./view_state";

interface PartPair {
    a: string;
    b: string;
    count: number;
    /** How many of `count` are near pairs. */
    near: number;
}

const shownMax = 100;

/** Counts the pairs of triangles by their parts, the most first. */
export function partPairsOf(pairs: Uint32Array, parts: readonly [BodyParts, BodyParts]): PartPair[] {
    const found = new Map<string, PartPair>();
    for (let i = 0; i + 2 < pairs.length; i += 3) {
        const [a, b] = [0, 1].map((body) => parts[body].nameOf(pairs[i + body]));
        const key = `${a.length}:${a}${b}`;
        const pair = found.get(key);
        const isNear = pairs[i + 2] === nearPair ? 1 : 0;
        if (pair) {
            pair.count += 1;
            pair.near += isNear;
        } else {
            found.set(key, { a, b, count: 1, near: isNear });
        }
    }
    return [...found.values()].sort((one, other) => other.count - one.count);
}

/** The pairs of parts of this scenario; a click shows one alone, a second click all. */
export function PartPairs(props: {
    contacts: Contacts;
    model: Model;
    /** The names of a scene's two bodies, which stand before those of their parts; null in a job of two bodies. */
    bodies: readonly [string, string] | null;
    state: ViewState;
    choose: (a: string, b: string) => void;
}) {
    const { state, bodies } = props;
    const nameOf = (side: 0 | 1, part: string) => (bodies ? `${bodies[side]}/${part}` : part);
    const allOf = (side: 0 | 1) => (bodies ? bodies[side] : `all of ${"AB"[side]}`);
    const all = useMemo(() => partPairsOf(props.contacts.pairs, props.model.parts), [props.contacts, props.model]);
    if (all.length === 0 && !state.partA && !state.partB) {
        return null;
    }
    const hasLines = props.contacts.hits !== null;
    const title = hasLines
        ? "parts hit here"
        : all.some((pair) => pair.near > 0)
          ? "parts in contact or near here"
          : "parts in contact here";
    const isChosen = (pair: PartPair) => state.partA === pair.a && state.partB === pair.b;
    return (
        <section aria-label={title}>
            <h2>{title}</h2>
            <ul class="pairs">
                {all.slice(0, shownMax).map((pair) => (
                    <li key={`${pair.a}\n${pair.b}`}>
                        <button
                            type="button"
                            aria-pressed={isChosen(pair)}
                            onClick={() => (isChosen(pair) ? props.choose("", "") : props.choose(pair.a, pair.b))}
                        >
                            <span>
                                <Name text={nameOf(0, pair.a)} />
                                {!hasLines && (
                                    <>
                                        {" "}
                                        <i>×</i> <Name text={nameOf(1, pair.b)} />
                                    </>
                                )}
                            </span>
                            <b>
                                {grouped(pair.count)}
                                {pair.near > 0 && <i> ({grouped(pair.near)} near)</i>}
                            </b>
                        </button>
                    </li>
                ))}
            </ul>
            {all.length > shownMax && <p class="note">and {counted(all.length - shownMax, "pair")} of parts more</p>}
            {(state.partA || state.partB) && (
                <p class="note">
                    only <Name text={state.partA ? nameOf(0, state.partA) : allOf(0)} /> ×{" "}
                    <Name text={state.partB ? nameOf(1, state.partB) : allOf(1)} />;{" "}
                    <button type="button" class="link" onClick={() => props.choose("", "")}>
                        show all
                    </button>
                </p>
            )}
        </section>
    );
}

/** What is known of the picked triangle. */
export function Picked(props: {
    pick: Pick;
    model: Model;
    contacts: Contacts | null;
    heat: Heat | null;
    job: Job;
    drop: () => void;
}) {
    const { pick, job } = props;
    const mesh = props.model.meshes[pick.body];
    const parts = props.model.parts[pick.body];
    const exists = pick.triangle < mesh.triangles.length / 3;
    const pairs = useMemo(() => {
        let count = 0;
        const list = props.contacts?.pairs ?? new Uint32Array();
        for (let i = pick.body; i < list.length; i += 3) {
            count += list[i] === pick.triangle ? 1 : 0;
        }
        return count;
    }, [props.contacts, pick]);
    const scenarios = props.heat?.counts[pick.body][pick.triangle];
    return (
        <section aria-label="picked triangle" aria-live="polite">
            <h2>
                picked{" "}
                <button type="button" class="link" onClick={props.drop}>
                    drop
                </button>
            </h2>
            {exists ? (
                <p>
                    {pick.body === 0 ? "A" : "B"} triangle <b>{grouped(pick.triangle)}</b>
                    , <Name text={parts.nameOf(pick.triangle)} /> {grouped(parts.placeOf(pick.triangle))}
                    ; in {counted(pairs, countNoun(job))} here
                    {scenarios !== undefined &&
                        (asksShots(job)
                            ? `; crossed ${counted(scenarios, "time")} in all`
                            : `; in ${grouped(scenarios)} of ${counted(job.done, "pose")} (${percent(scenarios / Math.max(1, job.done))})`)}
                </p>
            ) : (
                <p>the mesh has no triangle {grouped(pick.triangle)}</p>
            )}
        </section>
    );
}

function MatrixTable({ pose, title }: { pose: Pose; title: string }) {
    const rows = [pose.slice(0, 4), pose.slice(4, 8), pose.slice(8, 12), [0, 0, 0, 1]];
    return (
        <table class="matrix">
            <caption>{title}</caption>
            <tbody>
                {rows.map((row, i) => (
                    <tr key={i}>
                        {row.map((value, j) => (
                            <td key={j}>{String(value)}</td>
                        ))}
                    </tr>
                ))}
            </tbody>
        </table>
    );
}

/** Azimuth and elevation of a bundle of lines. */
export function directionText(pose: ArrayLike<number>): string {
    return shotKeys.map((key) => `${key} ${short(coordinateOf(key, pose), 5)}°`).join("  ");
}

/** Where B is in A's frame, as numbers and as matrices with all digits. */
export function PoseText({ job, contacts, tau }: { job: Job; contacts: Contacts; tau: number | null }) {
    const relative = shownPose(contacts.scenario, tau);
    if (hasDirections(job)) {
        return (
            <section aria-label="direction">
                <h2>where the lines come from</h2>
                <p>{directionText(relative)}</p>
                <details>
                    <summary>matrix</summary>
                    <MatrixTable pose={relative} title="the bundle in A's frame" />
                </details>
            </section>
        );
    }
    const placement = placementOf(relative);
    const said = placementKeys
        .filter((key) => key !== "distance" && (!isAngle(key) || Math.abs(placement[key]) > 1e-9))
        .map((key) => `${key} ${short(placement[key], 5)}${isAngle(key) ? "°" : ""}`);
    const { pose_a, pose_b } = shownPoses(contacts.scenario, tau);
    return (
        <section aria-label="pose">
            <h2>B in A's frame</h2>
            <p>
                {said.join("  ")} <span class="note">lengths in {job.unit}</span>
            </p>
            <details>
                <summary>matrix</summary>
                {job.poses.of_both_bodies && <MatrixTable pose={pose_a} title="A in the world" />}
                <MatrixTable
                    pose={job.poses.of_both_bodies ? pose_b : relative}
                    title={job.poses.of_both_bodies ? "B in the world" : "B in A's frame"}
                />
            </details>
        </section>
    );
}
