import type { RefObject } from "preact";
import { useRef } from "preact/hooks";
import { asksShots, bodyNames, countNoun, firstPair, isScene, type Job, pairOf } from "../base/types";
import { fileName, grouped } from "../base/words";
import { Name } from "../ui/small";
import type { Contacts } from "./scenario_loader";
import { trianglesOf } from "./model";
import type { Pick } from "./view_state";
import type { Viewer } from "./viewer";

const dragPixels = 4;

interface PictureProps {
    job: Job;
    scenario: number;
    contacts: Contacts | null;
    canvas: RefObject<HTMLCanvasElement | null>;
    viewer: Viewer | null;
    /** Whether the meshes are still being read. */
    waits: boolean;
    /** The element around the viewer in a report. */
    root: HTMLElement | undefined;
    pick: (found: Pick | null) => void;
    /** Hears of a click on a faint body. */
    pickOther: (body: number) => void;
}

/** The drawing, in which a click or Enter picks a triangle. */
export function Picture({ job, scenario, contacts, canvas, viewer, waits, root, pick, pickOther }: PictureProps) {
    const pair = contacts ? pairOf(contacts.scenario) : firstPair;
    const names = isScene(job)
        ? bodyNames(job, pair)
        : [fileName(job.bodies[0].file), asksShots(job) ? job.bodies[1].name : fileName(job.bodies[1].file)];
    const down = useRef<[number, number]>([0, 0]);
    const click = (event: MouseEvent) => {
        const moved = Math.hypot(event.clientX - down.current[0], event.clientY - down.current[1]);
        if (viewer && moved < dragPixels) {
            const other = viewer.otherAt(event.offsetX, event.offsetY);
            pick(viewer.pickAt(event.offsetX, event.offsetY, event.shiftKey));
            if (other !== null) {
                pickOther(other);
            }
        }
    };
    // The wheel moves a report on, unless the viewer was clicked before.
    const leaveWheel = (event: WheelEvent) => {
        if (root && (root.getRootNode() as ShadowRoot).activeElement !== canvas.current) {
            event.stopPropagation();
        }
    };
    return (
        <div class="stage" onWheelCapture={leaveWheel}>
            <canvas
                ref={canvas}
                tabIndex={0}
                role="img"
                aria-label={`scenario ${scenario}: ${contacts?.scenario.class ?? ""}, ${contacts?.scenario.count ?? 0} ${countNoun(job)}s${contacts?.scenario.near_count ? `, ${contacts.scenario.near_count} near` : ""}`}
                onKeyDown={(event) => {
                    if (event.key === "Enter") {
                        pick(viewer?.pickMiddle(event.shiftKey) ?? null);
                    }
                }}
                onPointerDown={(event) => {
                    down.current = [event.clientX, event.clientY];
                }}
                onClick={click}
            />
            <span class="cross-hair" aria-hidden="true" />
            {waits && <p class="wait over">reading {contacts || !isScene(job) ? `${grouped(trianglesOf(job, pair))} triangles` : "the scenario"}…</p>}
            <div class="corner">
                <span class="swatch a" /> A <Name text={names[0]} /> <span class="swatch b" /> B <Name text={names[1]} />
                <span class="note">drawn in single precision</span>
            </div>
        </div>
    );
}
