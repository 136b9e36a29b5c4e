import type { ComponentChildren } from "preact";
import { jobLink } from "../base/route";
import { bodyNames, isScene, type Job, pairOf } from "../base/types";
import { Name } from "../ui/small";
import type { Contacts } from "./scenario_loader";
import type { Scenarios } from "./scenarios";
import { ScenarioStatus } from "./status";
import type { ContactSearch } from "./use_search";
import type { Seek } from "./view_state";

/** The names of a scene's two bodies. */
function PairNames({ job, contacts }: { job: Job; contacts: Contacts }) {
    const [a, b] = bodyNames(job, pairOf(contacts.scenario));
    return (
        <b class="pair-names">
            <Name text={a} /> <i>×</i> <Name text={b} />
        </b>
    );
}

/** The job's name, the scenario's number, and what came of it. */
export function ViewerHead(props: {
    job: Job;
    isInReport: boolean;
    scenario: number;
    scenarios: Scenarios;
    contacts: Contacts | null;
    move: (place: number) => void;
}) {
    const { job, scenarios } = props;
    const name = <Name text={job.name || job.job} />;
    const choose = (text: string) => props.move(scenarios.placeOf(Math.round(Number(text)) || 0));
    return (
        <div class="viewer-head">
            <h1>
                {props.isInReport ? name : <a href={jobLink(job.job)}>{name}</a>} <span class="note">›</span>{" "}
                <label class="number">
                    #
                    <input
                        type="number"
                        aria-label="scenario"
                        min={scenarios.at(0)}
                        max={scenarios.at(scenarios.count - 1)}
                        value={props.scenario}
                        onChange={(event) => choose(event.currentTarget.value)}
                    />
                </label>
            </h1>
            {props.contacts && isScene(job) && <PairNames job={job} contacts={props.contacts} />}
            {props.contacts && <ScenarioStatus job={job} contacts={props.contacts} />}
        </div>
    );
}

/** The word for what a search finds. */
export function soughtName(seek: Seek): string {
    return { contact: "contact", near: "near scenario", either: "contact or near scenario" }[seek];
}

/** Chooses what a search finds. */
function SeekChoice({ seek, choose }: { seek: Seek; choose: (seek: Seek) => void }) {
    return (
        <select
            aria-label="what previous and next find"
            value={seek}
            onChange={(event) => choose(event.currentTarget.value as Seek)}
        >
            <option value="contact">contacts</option>
            <option value="near">near</option>
            <option value="either">both</option>
        </select>
    );
}

/** Goes through the scenarios: by contacts, by a slider, by itself. */
export function Scrub(props: {
    scenarios: Scenarios;
    isInReport: boolean;
    place: number;
    move: (place: number) => void;
    search: ContactSearch;
    seek: Seek;
    /** Null in a job that knows no near scenarios. */
    chooseSeek: ((seek: Seek) => void) | null;
    isPlaying: boolean;
    /** Null where nothing is drawn that could be played. */
    play: ((isPlaying: boolean) => void) | null;
    children: ComponentChildren;
}) {
    const { scenarios, search, isPlaying, play } = props;
    const last = scenarios.count - 1;
    return (
        <div class="scrub">
            <button type="button" onClick={() => search.start(-1)} title="p">
                ‹ previous {soughtName(props.seek)}
            </button>
            <button type="button" onClick={() => search.start(1)} title="n">
                next {soughtName(props.seek)} ›
            </button>
            {props.chooseSeek && <SeekChoice seek={props.seek} choose={props.chooseSeek} />}
            <input
                type="range"
                aria-label={props.isInReport ? "scenarios of this report" : `scenario, 0 to ${last}`}
                min={0}
                max={last}
                value={props.place}
                onInput={(event) => props.move(Number(event.currentTarget.value))}
            />
            {play && (
                <button type="button" onClick={() => play(!isPlaying)} title="space" aria-pressed={isPlaying}>
                    {isPlaying ? "stop" : "play"}
                </button>
            )}
            {props.children}
            <span class="note" aria-live="polite">
                {search.said}
            </span>
        </div>
    );
}
