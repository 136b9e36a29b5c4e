import { useMemo } from "preact/hooks";
import { scenarioLink } from "../base/route";
import { bodyNames, type Job } from "../base/types";
import { counted, grouped } from "../base/words";
import { ClassMark, Name, Panel } from "../ui/small";
import { type Column, Table } from "../ui/table";
import { type SceneEpisode, sceneEpisodesOf } from "./scene_episodes";
import type { SceneRows } from "./scene_rows";

const shownMax = 1000;

function columnsOf(job: Job, { results }: SceneRows): Column<SceneEpisode>[] {
    const name = ({ pair }: SceneEpisode, side: 0 | 1) => bodyNames(job, pair)[side];
    return [
        { key: "a", title: "body A", cell: (e) => <Name text={name(e, 0)} />, value: (e) => name(e, 0) },
        { key: "b", title: "body B", cell: (e) => <Name text={name(e, 1)} />, value: (e) => name(e, 1) },
        { key: "first", title: "first step", cell: (e) => grouped(e.first), value: (e) => e.first, isNumber: true },
        { key: "last", title: "last step", cell: (e) => grouped(e.last), value: (e) => e.last, isNumber: true },
        {
            key: "worst",
            title: "worst",
            cell: (e) => (
                <a href={scenarioLink(job.job, results.scenarioAt(e.worst))}>
                    <ClassMark kind={results.classes[e.worst]} /> #{grouped(results.scenarioAt(e.worst))}
                </a>
            ),
            value: (e) => results.countAt(e.worst),
            isNumber: true,
        },
    ];
}

/** Episodes of a scene: from which step to which two bodies are in contact, or near with a clearance. */
export function SceneEpisodes({ job, rows }: { job: Job; rows: SceneRows }) {
    const episodes = useMemo(() => (rows.areAll ? sceneEpisodesOf(rows, job, shownMax) : null), [rows]);
    if (!episodes) {
        return null;
    }
    const state = job.clearance === null ? "in contact" : "in contact or near";
    const listed = episodes.count > shownMax ? `; the first ${grouped(shownMax)} are listed` : "";
    return (
        <Panel title="episodes" note={`${counted(episodes.count, "run")} of steps at which two bodies are ${state}${listed}`}>
            <Table
                caption="episodes"
                rows={episodes.listed}
                rowKey={(one) => `${one.pair.join(" ")} ${one.first}`}
                empty={`no two bodies are ${state}`}
                columns={columnsOf(job, rows)}
            />
        </Panel>
    );
}
