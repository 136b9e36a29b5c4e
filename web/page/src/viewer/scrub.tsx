import type { ComponentChildren } from "preact";
import { jobLink } from "../base/route";
import type { Job } from "../base/types";
import { Name } from "../ui/small";
import type { Contacts } from "./scenario_loader";
import type { Scenarios } from "./scenarios";
import { ScenarioStatus } from "./status";
import type { ContactSearch } from "./use_search";

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
            {props.contacts && <ScenarioStatus job={job} contacts={props.contacts} />}
        </div>
    );
}

/** Goes through the scenarios: by contacts, by a slider, by itself. */
export function Scrub(props: {
    scenarios: Scenarios;
    isInReport: boolean;
    place: number;
    move: (place: number) => void;
    search: ContactSearch;
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
                ‹ previous contact
            </button>
            <button type="button" onClick={() => search.start(1)} title="n">
                next contact ›
            </button>
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
