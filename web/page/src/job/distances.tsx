import { useMemo } from "preact/hooks";
import { nameOf } from "../base/classes";
import { scenarioLink } from "../base/route";
import type { Job } from "../base/types";
import { grouped, short } from "../base/words";
import { ClassMark, Panel } from "../ui/small";
import { Table } from "../ui/table";
import { Bars } from "./histogram";
import type { Results } from "./results";

const shownMax = 10;
const binsMax = 20;

/** Returns the elements of least distance, the nearest first. */
export function nearestOf(results: Results, count = shownMax): number[] {
    const nearest: number[] = [];
    (results.distances ?? new Float64Array()).forEach((distance, i) => {
        const last = nearest.length === count ? results.distanceAt(nearest[count - 1]) : null;
        if (Number.isNaN(distance) || (last !== null && distance >= last)) {
            return;
        }
        const place = nearest.findIndex((one) => distance < (results.distanceAt(one) ?? Infinity));
        nearest.splice(place < 0 ? nearest.length : place, 0, i);
        nearest.length = Math.min(nearest.length, count);
    });
    return nearest;
}

export interface DistanceBin {
    from: number;
    to: number;
    count: number;
}

/** Counts scenarios by distance, in bins of equal width from 0 to the greatest distance. */
export function distanceBinsOf(distances: Float64Array): DistanceBin[] {
    const known = distances.filter((distance) => !Number.isNaN(distance));
    const most = known.reduce((all, distance) => Math.max(all, distance), 0);
    if (known.length === 0 || most === 0) {
        return known.length === 0 ? [] : [{ from: 0, to: 0, count: known.length }];
    }
    const bins = Array.from({ length: binsMax }, (_, i) => ({
        from: (i / binsMax) * most,
        to: ((i + 1) / binsMax) * most,
        count: 0,
    }));
    known.forEach((distance) => {
        bins[Math.min(binsMax - 1, Math.floor((distance / most) * binsMax))].count += 1;
    });
    return bins;
}

/** How far the bodies are apart: the least distances, and how many scenarios have which. */
export function Distances({ job, results }: { job: Job; results: Results }) {
    const nearest = useMemo(() => nearestOf(results), [results]);
    const bins = useMemo(() => distanceBinsOf(results.distances ?? new Float64Array()), [results]);
    const sample = results.isExact ? "" : ", of the sample";
    return (
        <>
            <Panel title="least distances" note={`between the bodies' surfaces, in ${job.unit}${sample}`}>
                <Table
                    caption="least distances"
                    rows={nearest}
                    rowKey={(one) => String(one)}
                    empty="no scenario has a distance"
                    columns={[
                        {
                            key: "scenario",
                            title: "scenario",
                            cell: (one) => (
                                <a href={scenarioLink(job.job, results.scenarioAt(one))}>
                                    #{grouped(results.scenarioAt(one))}
                                </a>
                            ),
                            value: (one) => results.scenarioAt(one),
                            isNumber: true,
                        },
                        {
                            key: "class",
                            title: "class",
                            cell: (one) => (
                                <>
                                    <ClassMark kind={results.classes[one]} /> {nameOf(results.classes[one])}
                                </>
                            ),
                            value: (one) => results.classes[one],
                        },
                        {
                            key: "distance",
                            title: `distance [${job.unit}]`,
                            cell: (one) => short(results.distanceAt(one) ?? Number.NaN, 6),
                            value: (one) => results.distanceAt(one) ?? Infinity,
                            isNumber: true,
                        },
                    ]}
                />
            </Panel>
            {bins.length > 0 && (
                <Panel title="distances" note={`scenarios by distance in ${job.unit}; heights are logarithmic${sample}`}>
                    <Bars
                        label="histogram of distances"
                        bars={bins.map((bin) => ({
                            about: `${short(bin.from)} to ${short(bin.to)} ${job.unit}`,
                            foot: short(bin.from, 2),
                            count: bin.count,
                        }))}
                    />
                </Panel>
            )}
        </>
    );
}
