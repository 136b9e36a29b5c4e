import type { Motion, Scenario } from "../base/types";
import { knowledgeCss } from "./colours";
import { eventOf, intervalsOf, isNearEvent, type Knowledge, startOf, tauOf, timeText } from "./motion";

const [width, height] = [1000, 14];
const leastWidth = 4; // Of an instant.
const leastStep = 2 ** -10; // Of the slider.

function TimeBar({ motion, isNear, tau }: { motion: Motion; isNear: boolean; tau: number }) {
    const brackets = [...new Set([motion.t0, motion.t1])].map((instant) => width * tauOf(motion, instant));
    const intervals = intervalsOf(motion);
    // The event is drawn above its neighbours, since it may be an instant.
    const ordered = [...intervals.filter((one) => one.kind !== "event"), ...intervals.filter((one) => one.kind === "event")];
    return (
        <svg viewBox={`0 -6 ${width} ${height + 12}`} preserveAspectRatio="none" aria-hidden="true">
            {ordered.map(({ from, to, kind }) => {
                const wide = Math.max(width * (to - from), kind === "event" ? leastWidth : 0);
                const left = Math.min(width * from, width - wide);
                return (
                    <rect
                        key={`${from} ${kind}`}
                        class={kind}
                        x={left}
                        y={0}
                        width={wide}
                        height={height}
                        fill={knowledgeCss(kind, isNear)}
                    />
                );
            })}
            {brackets.map((x) => (
                <line key={x} class="bracket" x1={x} x2={x} y1={-6} y2={height + 6} />
            ))}
            <line class="now" x1={width * tau} x2={width * tau} y1={-2} y2={height + 2} />
        </svg>
    );
}

function TimeLegend({ motion, isNear }: { motion: Motion; isNear: boolean }) {
    const meanings: Record<Knowledge, string> = {
        free: "free",
        open: "open",
        event: isNear ? "near" : "in contact",
        unknown: "not searched",
    };
    const kinds = new Set(intervalsOf(motion).map(({ kind }) => kind));
    return (
        <span class="time-legend note">
            {(Object.keys(meanings) as Knowledge[])
                .filter((kind) => kinds.has(kind))
                .map((kind) => (
                    <span key={kind}>
                        <i style={{ background: knowledgeCss(kind, isNear) }} /> {meanings[kind]}
                    </span>
                ))}
        </span>
    );
}

/** The time of a motion as a bar, with a slider that poses both bodies. */
export function TimeLine(props: {
    scenario: Scenario;
    motion: Motion;
    /** The time that is shown; null: that of the event. */
    tau: number | null;
    choose: (tau: number | null) => void;
}) {
    const { motion, choose } = props;
    const isNear = isNearEvent(props.scenario);
    const tau = props.tau ?? startOf(motion);
    const text = timeText(motion, isNear, tau);
    return (
        <section class="time-line" aria-label="time of the motion">
            <TimeBar motion={motion} isNear={isNear} tau={tau} />
            <div>
                <input
                    type="range"
                    aria-label="time"
                    aria-valuetext={text}
                    min={0}
                    max={1}
                    step={Math.max(leastStep, 2 ** -motion.depth)}
                    value={tau}
                    onInput={(event) => choose(Number(event.currentTarget.value))}
                />
                <button type="button" disabled={eventOf(motion) === null} onClick={() => choose(null)} title="e">
                    event
                </button>
            </div>
            <output>{text}</output>
            <TimeLegend motion={motion} isNear={isNear} />
        </section>
    );
}
