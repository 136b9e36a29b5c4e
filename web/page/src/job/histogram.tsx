import { useMemo } from "preact/hooks";
import { asksShots, countNoun, type Job } from "../base/types";
import { compact, counted, grouped } from "../base/words";
import { Panel } from "../ui/small";
import type { Results } from "./results";

interface Bin {
    first: number;
    last: number;
    count: number;
}

/** Counts scenarios by pairs: bin i > 0 holds 2^(i-1) to 2^i - 1 pairs. Zero pairs are left out. */
export function binsOf(counts: Uint32Array): Bin[] {
    const bins: Bin[] = [];
    for (const count of counts) {
        if (count === 0) {
            continue;
        }
        const bin = 31 - Math.clz32(count);
        while (bins.length <= bin) {
            const first = 2 ** bins.length;
            bins.push({ first, last: 2 * first - 1, count: 0 });
        }
        bins[bin].count += 1;
    }
    return bins;
}

interface Bar {
    /** What the bar is about, such as "8 to 15 pairs". */
    about: string;
    /** The text below the left end. */
    foot: string;
    count: number;
}

/** Bars of numbers of scenarios, their height logarithmic. */
export function Bars({ bars, label }: { bars: Bar[]; label: string }) {
    const [width, height, foot] = [480, 150, 18];
    const highest = Math.log1p(Math.max(...bars.map((bar) => bar.count)));
    const step = width / bars.length;
    return (
        <svg class="histogram" viewBox={`0 0 ${width} ${height + foot}`} role="img" aria-label={label}>
            {bars.map((bar, i) => {
                const tall = (Math.log1p(bar.count) / highest) * (height - 14);
                return (
                    <g key={bar.about}>
                        <title>{`${bar.about}: ${counted(bar.count, "scenario")}`}</title>
                        <rect class="hit" x={i * step} y={0} width={step} height={height} />
                        <rect class="bar" x={i * step + 1} y={height - tall} width={step - 2} height={tall} />
                        {bar.count > 0 && (
                            <text x={(i + 0.5) * step} y={height - tall - 3}>
                                {compact(bar.count)}
                            </text>
                        )}
                        {(i % 2 === 0 || bars.length < 12) && (
                            <text x={(i + 0.5) * step} y={height + 13}>
                                {bar.foot}
                            </text>
                        )}
                    </g>
                );
            })}
            <line x1={0} x2={width} y1={height} y2={height} />
        </svg>
    );
}

/** How many pairs scenarios have: near pairs those that are near, both axes logarithmic. */
export function Histogram({ job, results }: { job: Job; results: Results }) {
    const bins = useMemo(() => (results.counts ? binsOf(results.counts) : []), [results]);
    if (bins.length === 0) {
        return null;
    }
    const [noun, place] = [countNoun(job), asksShots(job) ? "bundle" : "scenario"];
    return (
        <Panel
            title={`${noun}s a ${place}`}
            note={`${place}s in contact${job.clearance === null ? "" : " or near"}, both axes logarithmic${results.isExact ? "" : ", of the sample"}`}
        >
            <Bars
                label={`histogram of ${noun}s a ${place}`}
                bars={bins.map((bin) => ({
                    about: `${grouped(bin.first)} to ${grouped(bin.last)} ${noun}s`,
                    foot: compact(bin.first),
                    count: bin.count,
                }))}
            />
        </Panel>
    );
}
