import { useState } from "preact/hooks";
import { numberOf } from "../base/classes";
import { splitPart, writePart } from "../base/part_name";
import { scenarioLink } from "../base/route";
import { asksShots, type Body, bodyNames, isScene, type Group, type Job } from "../base/types";
import { grouped, percent } from "../base/words";
import { ClassMark, Name, Panel } from "../ui/small";
import { type Column, Table } from "../ui/table";

/** Returns the Wilson score interval of a share at 95 % (Wilson 1927, eq. 5). */
export function wilson(count: number, total: number): [number, number] {
    const z = 1.959964;
    const share = count / total;
    const middle = share + (z * z) / (2 * total);
    const half = z * Math.sqrt((share * (1 - share)) / total + (z * z) / (4 * total * total));
    const scale = 1 + (z * z) / total;
    return [Math.max(0, (middle - half) / scale), Math.min(1, (middle + half) / scale)];
}

function Share({ group, job }: { group: Group; job: Job }) {
    const isRandom = job.poses.kind === "random" && !job.poses.penetration && job.done > 0;
    const [low, high] = isRandom ? wilson(group.scenarios, job.done) : [0, 0];
    return (
        <span class="share">
            <meter min={0} max={1} value={group.share} />
            <span>
                {percent(group.share)}
                {isRandom && <small> {`${percent(low)} to ${percent(high)}`}</small>}
            </span>
        </span>
    );
}

/** How a link names the two parts of a group of a scene, whose names hold those of their bodies. */
export function sceneParts(bodies: ReadonlySet<string>, { a, b }: Pick<Group, "a" | "b">): Record<string, string> {
    const [one, other] = [splitPart(a, bodies), splitPart(b, bodies)];
    if (!one || !other) {
        return {};
    }
    const names = [one.body, other.body] as const;
    return { part: writePart(0, one.part, names), with: writePart(1, other.part, names) };
}

/** The names of a job's bodies, made once, since a scene may have many. */
const knownNames = new WeakMap<readonly Body[], ReadonlySet<string>>();

function namesOf(bodies: readonly Body[]): ReadonlySet<string> {
    const names = knownNames.get(bodies) ?? new Set(bodies.map(({ name }) => name));
    knownNames.set(bodies, names);
    return names;
}

/** Opens the worst scenario of a group, with its contacts alone. */
function worstLink(job: Job, group: Group): string {
    const { a, b, worst } = group;
    if (isScene(job)) {
        return scenarioLink(job.job, worst, sceneParts(namesOf(job.bodies), group));
    }
    const bodies = bodyNames(job);
    return scenarioLink(job.job, worst, { part: writePart(0, a, bodies), with: writePart(1, b, bodies) });
}

const nearColumn: Column<Group> = {
    key: "near",
    title: "near pairs",
    cell: (g) => grouped(g.near),
    value: (g) => g.near,
    isNumber: true,
};

/** The columns of parts that lines hit. */
function shotColumns(job: Job): Column<Group>[] {
    return [
        { key: "a", title: "part", cell: (g) => <Name text={g.a} />, value: (g) => g.a },
        { key: "scenarios", title: "in bundles", cell: (g) => grouped(g.scenarios), value: (g) => g.scenarios, isNumber: true },
        { key: "pairs", title: "hits", cell: (g) => grouped(g.pairs), value: (g) => g.pairs, isNumber: true },
        {
            key: "worst",
            title: "most hits",
            cell: (g) => <a href={worstLink(job, g)}>#{grouped(g.worst)}</a>,
            value: (g) => g.worst_pairs,
            isNumber: true,
        },
    ];
}

function columnsOf(job: Job): Column<Group>[] {
    if (asksShots(job)) {
        return shotColumns(job);
    }
    return [
        { key: "a", title: "part of A", cell: (g) => <Name text={g.a} />, value: (g) => g.a },
        { key: "b", title: "part of B", cell: (g) => <Name text={g.b} />, value: (g) => g.b },
        { key: "scenarios", title: "in poses", cell: (g) => grouped(g.scenarios), value: (g) => g.scenarios, isNumber: true },
        { key: "share", title: "share", cell: (g) => <Share group={g} job={job} />, value: (g) => g.share, isNumber: true },
        {
            key: "worst",
            title: "worst",
            cell: (g) => (
                <a href={worstLink(job, g)}>
                    <ClassMark kind={numberOf(g.class)} /> #{grouped(g.worst)}
                </a>
            ),
            value: (g) => g.worst_pairs + g.worst_near,
            isNumber: true,
        },
        ...(job.clearance === null ? [] : [nearColumn]),
    ];
}

/** The pairs of parts that are in contact, or near, in some scenario. */
export function Groups({ job, groups }: { job: Job; groups: Group[] }) {
    const total = job.groups_total ?? groups.length;
    const isCut = total > groups.length;
    const hasLines = asksShots(job);
    const [text, setText] = useState("");
    const wanted = text.toLowerCase();
    const found = groups.filter(({ a, b }) => a.toLowerCase().includes(wanted) || b.toLowerCase().includes(wanted));
    const title = hasLines ? "parts hit" : job.clearance === null ? "parts in contact" : "parts in contact or near";
    return (
        <Panel
            title={title}
            note={isCut ? `the ${grouped(groups.length)} in most ${hasLines ? "bundles" : "poses"}, of ${grouped(total)}` : ""}
        >
            {isScene(job) && (
                <input
                    type="search"
                    aria-label="parts whose name holds"
                    placeholder="body/part"
                    value={text}
                    onInput={(event) => setText(event.currentTarget.value)}
                />
            )}
            <Table
                caption={title}
                columns={columnsOf(job)}
                rows={found}
                rowKey={(group) => `${group.a}\n${group.b}`}
                empty={text ? "no part has such a name" : `no part is ${hasLines ? "hit" : job.clearance === null ? "in contact" : "in contact or near"}`}
            />
        </Panel>
    );
}
