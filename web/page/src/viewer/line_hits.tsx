import { useMemo } from "preact/hooks";
import { hasDirections, type Job } from "../base/types";
import { grouped, short } from "../base/words";
import { Name } from "../ui/small";
import { endsOf, type Passage, passagesOf, startsAndEndsOutside } from "./hits";
import type { Model } from "./model";
import type { Contacts } from "./scenario_loader";
import { hitColour } from "./shots_view";

/** Returns the passages of a line, where the job lists the hits that they are made of. */
function passagesOn(job: Job, model: Model, contacts: Contacts, line: number): Passage[] {
    const { hits } = contacts;
    const parts = model.parts[0];
    const isWhole = !contacts.isCut && job.first_hits !== true;
    const ends = endsOf(model.meshes[1], line);
    const isPaired = (part: number) =>
        isWhole &&
        model.closed?.[part] === 1 &&
        (hasDirections(job) || startsAndEndsOutside(ends, model.meshes[0], parts, part));
    return hits ? passagesOf(hits, line, (triangle) => parts.partOf(triangle), isPaired) : [];
}

/** The picked line: its ways through parts in exact order, then the hits that only graze. */
export function LineHits(props: { line: number; job: Job; model: Model; contacts: Contacts; drop: () => void }) {
    const { line, job, model, contacts } = props;
    const exists = line < model.meshes[1].triangles.length / 3;
    const passages = useMemo(() => (exists ? passagesOn(job, model, contacts, line) : []), [line, model, contacts]);
    const { hits } = contacts;
    const grazed = (hits?.ofLine(line) ?? []).filter((hit) => hits?.kindOf(hit) === "grazes");
    const partOf = (hit: number) => model.parts[0].nameOf(hits?.triangleOf(hit) ?? 0);
    const depth = (hit: number | null) => (hits && hit !== null ? short(hits.depthOf(hit), 6) : "");
    const thickness = ({ in: from, out }: Passage) =>
        hits && out !== null ? short(hits.depthOf(out) - hits.depthOf(from), 6) : "";
    return (
        <section aria-label="picked line" aria-live="polite">
            <h2>
                line {grouped(line)}{" "}
                <button type="button" class="link" onClick={props.drop}>
                    drop
                </button>
            </h2>
            {!exists && <p>the bundle has no line {grouped(line)}</p>}
            {exists && passages.length + grazed.length === 0 && <p>it hits nothing</p>}
            {passages.length > 0 && (
                <table class="line-hits">
                    <caption class="note">from the line's start, in {job.unit}</caption>
                    <thead>
                        <tr>
                            <th scope="col">part</th>
                            <th scope="col">in</th>
                            <th scope="col">out</th>
                            <th scope="col">thickness</th>
                        </tr>
                    </thead>
                    <tbody>
                        {passages.map((passage) => (
                            <tr key={passage.in}>
                                <td>
                                    <Name text={partOf(passage.in)} />
                                </td>
                                <td>{depth(passage.in)}</td>
                                <td>{depth(passage.out)}</td>
                                <td>{thickness(passage)}</td>
                            </tr>
                        ))}
                    </tbody>
                </table>
            )}
            {grazed.map((hit) => (
                <p key={hit} class="note">
                    grazes <Name text={partOf(hit)} /> at {depth(hit)}
                </p>
            ))}
        </section>
    );
}

/** The colours of lines and hits. */
export function HitLegend() {
    const rows = [
        ["enters", "the line enters"],
        ["leaves", "the line leaves"],
        ["grazes", "the line only grazes the surface"],
    ] as const;
    return (
        <ul class="legend plain">
            {rows.map(([kind, meaning]) => (
                <li key={kind}>
                    <svg viewBox="0 0 14 12" aria-hidden="true">
                        <rect x={3} y={2} width={8} height={8} fill={hitColour(kind)} />
                    </svg>
                    {meaning}
                </li>
            ))}
            <li class="note">faint lines hit nothing; a click on a hit picks its line</li>
        </ul>
    );
}
