import { cssColour, near } from "../base/classes";
import { asksDistance, asksShots, type Job } from "../base/types";
import { grouped, percent } from "../base/words";
import { viridisAt } from "./heat";
import type { Heat } from "./model";

const steps = 48;

function ticksOf(most: number): number[] {
    const ticks = [1];
    for (let tick = 10; tick < most / 2; tick *= 10) {
        ticks.push(tick);
    }
    return most > 1 ? [...ticks, most] : ticks;
}

/** What makes a triangle count in the heat map. */
function stateOf(job: Job): string {
    return job.clearance === null ? "in contact" : "in contact or near";
}

/** The colours of the heat map with counts and shares. */
export function HeatLegend({ heat, job }: { heat: Heat; job: Job }) {
    if (heat.most === 0) {
        return <p class="note">no triangle was {asksShots(job) ? "crossed" : stateOf(job)}</p>;
    }
    const [width, height] = [264, 10];
    const position = (count: number) => (heat.most <= 1 ? 0 : (Math.log(count) / Math.log(heat.most)) * width);
    const ticks = ticksOf(heat.most);
    return (
        <figure class="legend">
            <svg viewBox={`0 0 ${width} 42`} role="img" aria-label="colours of the heat map">
                {Array.from({ length: steps }, (_, i) => {
                    const [r, g, b] = viridisAt(i / (steps - 1));
                    return (
                        <rect
                            key={i}
                            x={(i * width) / steps}
                            y={0}
                            width={width / steps + 0.5}
                            height={height}
                            fill={`rgb(${r},${g},${b})`}
                        />
                    );
                })}
                {ticks.map((tick, i) => (
                    <g key={tick}>
                        <line x1={position(tick)} x2={position(tick)} y1={height} y2={height + 3} />
                        <text
                            x={position(tick)}
                            y={height + 14}
                            class={i === 0 ? "begin" : i === ticks.length - 1 ? "end" : ""}
                        >
                            {grouped(tick)}
                        </text>
                        <text
                            x={position(tick)}
                            y={height + 27}
                            class={i === 0 ? "begin" : i === ticks.length - 1 ? "end" : ""}
                        >
                            {asksShots(job) ? "" : percent(tick / Math.max(1, job.done))}
                        </text>
                    </g>
                ))}
            </svg>
            <figcaption class="note">
                {asksShots(job) ? "how often lines cross a triangle" : `scenarios in which a triangle is ${stateOf(job)}`},
                logarithmic
                {job.map_pairs > 0 && `, of the first ${grouped(job.map_pairs)} pairs`}; plain: never
            </figcaption>
        </figure>
    );
}

/** What orange triangles are; empty in a job that has none. */
export function nearMeaning(job: Job): string {
    return asksDistance(job)
        ? "the nearest triangles: the line joins their nearest points"
        : job.clearance === null
          ? ""
          : "near: the line joins the nearest points";
}

/** The colours of triangles and lines; unless `near` is empty also those of near pairs. */
export function ContactLegend({ near: meaning }: { near: string }) {
    return (
        <ul class="legend plain">
            <li>
                <svg viewBox="0 0 14 12" aria-hidden="true">
                    <path d="M1 11 7 1l6 10z" fill={cssColour(2)} />
                </svg>
                proper: goes through the other
            </li>
            <li>
                <svg viewBox="0 0 14 12" aria-hidden="true">
                    <path d="M1 11 7 1l6 10z" fill={cssColour(1)} class="outlined" />
                </svg>
                touch or coplanar: outlined
            </li>
            <li>
                <svg viewBox="0 0 14 12" aria-hidden="true">
                    <path d="M1 9 11 4" class="thick" />
                    <circle cx={12} cy={4} r={2} />
                </svg>
                what they share
            </li>
            {meaning && (
                <li>
                    <svg viewBox="0 0 14 12" aria-hidden="true">
                        <path d="M1 11 7 1l6 10z" fill={cssColour(near)} class="outlined" />
                    </svg>
                    {meaning}
                </li>
            )}
        </ul>
    );
}
