import { useMemo } from "preact/hooks";
import { isHit } from "../base/classes";
import { scenarioLink } from "../base/route";
import { isScene, type Job } from "../base/types";
import { counted, grouped } from "../base/words";
import { ClassMark, Panel } from "../ui/small";
import { Table } from "../ui/table";
import type { Results } from "./results";

export interface Episode {
    first: number;
    last: number;
    worst: number; // An element of the results.
}

const shownMax = 1000;

/** Returns how many runs of consecutive scenarios are in contact or near, and the first of them. */
export function episodesOf(results: Results): { count: number; listed: Episode[] } {
    const listed: Episode[] = [];
    let count = 0;
    let open: Episode | null = null;
    results.classes.forEach((kind, i) => {
        if (!isHit(kind)) {
            open = null;
        } else if (open) {
            open.last = results.first + i;
            open.worst = results.isWorse(i, open.worst) ? i : open.worst;
        } else {
            open = { first: results.first + i, last: results.first + i, worst: i };
            count += 1;
            if (count <= shownMax) {
                listed.push(open);
            }
        }
    });
    return { count, listed };
}

/** Episodes of a trajectory: where contacts begin and end; in a job with a clearance also what is near. */
export function Episodes({ job, results }: { job: Job; results: Results }) {
    const isShown = job.poses.kind === "file" && results.isExact && !isScene(job);
    const episodes = useMemo(() => (isShown ? episodesOf(results) : null), [results, isShown]);
    if (!episodes) {
        return null;
    }
    const state = job.clearance === null ? "in contact" : "in contact or near";
    const link = (scenario: number) => <a href={scenarioLink(job.job, scenario)}>#{grouped(scenario)}</a>;
    return (
        <Panel
            title="episodes"
            note={`${counted(episodes.count, "run")} of consecutive scenarios ${state}${
                episodes.count > shownMax ? `; the first ${grouped(shownMax)} are listed` : ""
            }`}
        >
            <Table
                caption="episodes"
                rows={episodes.listed}
                rowKey={(one) => String(one.first)}
                empty={`no scenario is ${state}`}
                columns={[
                    { key: "first", title: "first", cell: (e) => link(e.first), value: (e) => e.first, isNumber: true },
                    { key: "last", title: "last", cell: (e) => link(e.last), value: (e) => e.last, isNumber: true },
                    {
                        key: "length",
                        title: "scenarios",
                        cell: (e) => grouped(e.last - e.first + 1),
                        value: (e) => e.last - e.first,
                        isNumber: true,
                    },
                    {
                        key: "worst",
                        title: "worst",
                        cell: (e) => (
                            <>
                                <ClassMark kind={results.classes[e.worst]} /> {link(results.scenarioAt(e.worst))}
                            </>
                        ),
                        value: (e) => results.countAt(e.worst),
                        isNumber: true,
                    },
                    {
                        key: "pairs",
                        title: "pairs there",
                        cell: (e) => (results.counts ? grouped(results.countAt(e.worst)) : "-"),
                        value: (e) => results.countAt(e.worst),
                        isNumber: true,
                    },
                ]}
            />
        </Panel>
    );
}
