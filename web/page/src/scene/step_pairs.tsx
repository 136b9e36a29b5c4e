import { useMemo } from "preact/hooks";
import { severity } from "../base/classes";
import { type Body, bodyNames, type Job } from "../base/types";
import { counted, grouped } from "../base/words";
import { ClassMark, Name } from "../ui/small";
import { drawnTrianglesMax, othersMax, type StepBodies } from "./step_bodies";
import type { Others } from "./use_scene";

const shownMax = 100;

/** Returns the places of a step's scenarios whose bodies' names hold a text, the worst first. */
export function pairsOfStep(
    { rows, classes }: Pick<StepBodies, "rows" | "classes">,
    bodies: readonly Pick<Body, "name">[],
    text: string,
): number[] {
    const wanted = text.toLowerCase();
    const isWanted = (body: number) => bodies[body].name.toLowerCase().includes(wanted);
    return Array.from({ length: rows.length / 3 }, (_, i) => i)
        .filter((i) => isWanted(rows[3 * i + 1]) || isWanted(rows[3 * i + 2]))
        .sort((a, b) => severity(classes[b]) - severity(classes[a]) || a - b);
}

export function othersText({ form, count, boxes, error }: Others, isCut: boolean): string {
    const cut = isCut ? " Bodies of the step's last scenarios are left out." : "";
    const bodies = count === 1 ? "1 other body" : `${grouped(count)} other bodies`;
    if (error) {
        return `The other bodies are not drawn: ${error}`;
    }
    if (form === "boxes") {
        return `${bodies}: boxes only, above ${othersMax} bodies or ${grouped(drawnTrianglesMax)} triangles.${cut}`;
    }
    const left = boxes > 0 ? ` Of ${grouped(boxes)} this report has no mesh, so boxes are drawn.` : "";
    return `${bodies} near another at this step, faint.${left}${cut}`;
}

/** The scenarios of the step; a click opens one. */
export function StepPairs(props: {
    job: Job;
    step: StepBodies;
    scenario: number;
    others: Others;
    /** Which bodies are listed: those whose names hold this text. */
    text: string;
    setText: (text: string) => void;
    /** The scenarios of a report; others cannot be opened there. Left out: all can. */
    held?: readonly number[] | undefined;
    open: (scenario: number) => void;
}) {
    const { job, step } = props;
    const found = useMemo(() => pairsOfStep(step, job.bodies, props.text), [step, props.text]);
    const title = "pairs of bodies at this step";
    return (
        <section aria-label={title}>
            <h2>{title}</h2>
            <input
                type="search"
                aria-label="pairs of this body"
                placeholder="a body's name"
                value={props.text}
                onInput={(event) => props.setText(event.currentTarget.value)}
            />
            <ul class="pairs">
                {found.slice(0, shownMax).map((i) => {
                    const [a, b] = bodyNames(job, [step.rows[3 * i + 1], step.rows[3 * i + 2]]);
                    const scenario = step.first + i;
                    return (
                        <li key={i}>
                            <button
                                type="button"
                                aria-pressed={scenario === props.scenario}
                                disabled={props.held?.includes(scenario) === false}
                                onClick={() => props.open(scenario)}
                            >
                                <span>
                                    <ClassMark kind={step.classes[i]} /> <Name text={a} /> <i>×</i> <Name text={b} />
                                </span>
                                <b>#{grouped(scenario)}</b>
                            </button>
                        </li>
                    );
                })}
            </ul>
            {found.length > shownMax && <p class="note">and {counted(found.length - shownMax, "pair")} more</p>}
            <p class="note">{othersText(props.others, step.isCut)}</p>
        </section>
    );
}
