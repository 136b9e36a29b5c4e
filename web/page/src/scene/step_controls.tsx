import { useEffect, useState } from "preact/hooks";
import { counted, short } from "../base/words";
import { Name } from "../ui/small";
import { rangeText, type SceneFilter } from "./filter";
import type { Steps } from "./steps";

/** Goes through the steps of a scene: one by one, by a slider, by its number. */
export function StepControls(props: {
    steps: Steps;
    /** The step that is shown. */
    step: number;
    stepTo: (step: number, by: 1 | -1) => void;
}) {
    const { steps, step, stepTo } = props;
    const [wanted, setWanted] = useState(step);
    useEffect(() => setWanted(step), [step]);
    const choose = (text: string) => {
        const to = Math.round(Number(text)) || 0;
        setWanted(to);
        stepTo(to, to < step ? -1 : 1);
    };
    return (
        <div class="scrub steps" role="group" aria-label="steps">
            <button type="button" disabled={step <= 0} onClick={() => stepTo(step - 1, -1)} title=",">
                ‹ previous step
            </button>
            <button type="button" disabled={step >= steps.count - 1} onClick={() => stepTo(step + 1, 1)} title=".">
                next step ›
            </button>
            <label class="number">
                step{" "}
                <input
                    type="number"
                    aria-label="step"
                    min={0}
                    max={steps.count - 1}
                    value={wanted}
                    onChange={(event) => choose(event.currentTarget.value)}
                />
            </label>
            <input
                type="range"
                aria-label={`step, 0 to ${steps.count - 1}`}
                min={0}
                max={steps.count - 1}
                value={wanted}
                onInput={(event) => choose(event.currentTarget.value)}
            />
            <span class="note">
                t {short(steps.timeOf(step), 6)}, {counted(steps.count, "step")}
            </span>
        </div>
    );
}

/** Says which scenarios next and previous find, and drops that. */
export function FilterNote({ filter, drop }: { filter: SceneFilter; drop: () => void }) {
    return (
        <p class="note scene-filter">
            next and previous: only {filter.body ? <Name text={filter.body} /> : "scenarios"}
            {filter.steps && ` in steps ${rangeText(filter.steps)}`};{" "}
            <button type="button" class="link" onClick={drop}>
                all
            </button>
        </p>
    );
}
