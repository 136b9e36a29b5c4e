import { numberOf } from "../base/classes";
import { countNoun, type Job, type Scenario } from "../base/types";
import { counted, grouped, short } from "../base/words";
import { isNearEvent, motionText } from "../motion/motion";
import { ClassMark, Name, Notice } from "../ui/small";
import type { Model } from "./model";
import type { Contacts } from "./scenario_loader";

/** Whether what is drawn is what was tested, as bars that nobody overlooks. */
export function Trust({ model, contacts }: { model: Model | null; contacts: Contacts | null }) {
    const damaged = model?.meshes.filter((mesh) => mesh.checked === false) ?? [];
    const unchecked = model?.meshes.some((mesh) => mesh.checked === null) ?? false;
    const scenario = contacts?.scenario;
    return (
        <>
            {damaged.length > 0 && (
                <Notice kind="bad">
                    not the tested geometry: the bytes of {counted(damaged.length, "mesh").replace("meshs", "meshes")} do
                    not have the SHA-256 of the run ({damaged.map((mesh) => mesh.sha256.slice(0, 16)).join(", ")})
                </Notice>
            )}
            {damaged.length === 0 && unchecked && (
                <Notice kind="warn">
                    the geometry is not checked: this browser computes SHA-256 on 127.0.0.1 or over TLS only
                </Notice>
            )}
            {scenario?.verified === false && (
                <Notice kind="bad">
                    this scenario, run again, gives another record than the stored one: {scenario.verify_note}
                </Notice>
            )}
            {scenario && scenario.draw_note !== "" && <Notice kind="warn">nothing is drawn: {scenario.draw_note}</Notice>}
            {scenario && scenario.failure !== "" && (
                <Notice kind="bad">
                    failed: <Name text={scenario.failure} />
                </Notice>
            )}
        </>
    );
}

/** How far the bodies, or their nearest near triangles, are apart; empty where that is not known. */
export function distanceText(job: Pick<Job, "unit" | "up_to">, scenario: Scenario): string {
    const length = (value: number) => `${short(value, 6)} ${job.unit} apart`;
    if (typeof scenario.distance === "number") {
        return `the bodies are ${length(scenario.distance)}`;
    }
    if (scenario.distance === null) {
        return scenario.class === "separate" && typeof job.up_to === "number" ? `more than ${length(job.up_to)}` : "";
    }
    return scenario.least_distance === null ? "" : `nearest triangles ${length(scenario.least_distance)}`;
}

/** The scenario's class, count, and what restricts them. */
export function ScenarioStatus({ job, contacts }: { job: Job; contacts: Contacts }) {
    const { scenario } = contacts;
    const kind = numberOf(scenario.class);
    const count = scenario.class !== null && scenario.count > 0 ? counted(scenario.count, countNoun(job)) : "";
    const nearCount = scenario.near_count > 0 ? counted(scenario.near_count, "near pair") : "";
    const said = [
        distanceText(job, scenario),
        scenario.motion ? motionText(scenario.motion, isNearEvent(scenario)) : "",
        job.first_hits ? "the first hit of each line" : "",
        kind === 3 ? "one body is inside the other: g changes the ghost" : "",
        scenario.id !== null ? `id ${scenario.id}` : "",
        scenario.time !== null ? `t ${short(scenario.time, 6)}` : "",
        contacts.isCut ? `drawn: the first ${grouped(contacts.pairs.length / 3)} ${countNoun(job)}s` : "",
        scenario.cut ? `list of ${countNoun(job)}s cut at ${grouped(scenario.listed)}` : "",
        scenario.surfaces_only ? "surfaces only: a body is open" : "",
        scenario.insides_skipped ? "containment not tested: triangles are ignored" : "",
        scenario.distance_bound !== null && scenario.distance_bound > 0
            ? `at most ${short(scenario.distance_bound)} ${job.unit} apart`
            : "",
    ].filter((text) => text !== "");
    return (
        <span class="scenario-status">
            <span>
                <ClassMark kind={kind} />
                <b>{scenario.class ?? "no result yet"}</b>
                {count && `, ${count}`}
                {nearCount && `, ${nearCount}`}
            </span>
            {scenario.verified === true && (
                <span class="verified" title="run again, the record has the same bytes">
                    ✓ verified
                </span>
            )}
            {scenario.verified === null && (
                <span class="note" title={scenario.verify_note}>
                    not verified{scenario.verify_note && `: ${scenario.verify_note}`}
                </span>
            )}
            {said.length > 0 && <span class="note">{said.join(" · ")}</span>}
        </span>
    );
}
