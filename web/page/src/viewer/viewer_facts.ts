import { useEffect, useRef } from "preact/hooks";
import { tellFacts } from "../base/facts";
import type { Vec3 } from "../base/types";
import { eventOf, intervalsOf, startOf } from "../motion/motion";
import type { Others } from "../scene/use_scene";
import type { StepBodies } from "../scene/step_bodies";
import type { Model } from "./model";
import type { Contacts } from "./scenario_loader";
import type { Drawing } from "./use_viewer";
import type { ViewState } from "./view_state";

/** Publishes what the viewer shows, and where, so that tests can ask and point at it. */
export function useViewerFacts(values: {
    model: Model | null;
    contacts: Contacts | null;
    state: ViewState;
    drawing: Drawing;
    scenario: number;
    canvas: { current: HTMLCanvasElement | null };
    step: StepBodies | null;
    others: Others;
}): void {
    const now = useRef(values);
    now.current = values;
    useEffect(
        () =>
            tellFacts("viewer", () => {
                const { model, contacts, state, drawing, scenario, canvas, step, others } = now.current;
                const viewer = drawing.viewer;
                const box = canvas.current?.getBoundingClientRect();
                const onPage = ([x, y]: [number, number]) => [x + (box?.left ?? 0), y + (box?.top ?? 0)];
                const points = contacts?.points ?? new Float64Array();
                const rows = Array.from({ length: Math.min(8, points.length / 4) }, (_, i) =>
                    Array.from(points.subarray(4 * i + 1, 4 * i + 4)),
                );
                return {
                    ready: viewer?.isShowing(state) === true && drawing.drawn.current === scenario,
                    scenario: contacts?.scenario.index,
                    class: contacts?.scenario.class,
                    verified: contacts?.scenario.verified,
                    mode: state.mode,
                    ghost: state.ghost,
                    throughWalls: state.throughWalls,
                    clip: state.clip,
                    camera: viewer?.view,
                    parts: [state.partA, state.partB],
                    pick: state.pick,
                    trianglesDrawn: viewer?.bodies.map((body) => body.triangles) ?? [0, 0],
                    highlighted: viewer?.highlighted ?? [[], []],
                    gaps: viewer?.gaps ?? 0,
                    lines: viewer?.lines ?? [0, 0],
                    motion: contacts?.scenario.motion && {
                        tau: state.tau ?? startOf(contacts.scenario.motion),
                        event: eventOf(contacts.scenario.motion),
                        intervals: intervalsOf(contacts.scenario.motion),
                        ...viewer?.motion,
                    },
                    scene: contacts?.scenario.bodies && {
                        step: contacts.scenario.step,
                        time: contacts.scenario.time,
                        bodies: contacts.scenario.bodies,
                        stepRead: step?.step ?? null,
                        others: viewer?.others.group.visible ? viewer.others.bodies.length : 0,
                        form: others.form,
                        filter: state.filter,
                        centres: (viewer?.others.centres ?? []).map((one) => ({
                            ...one,
                            pixel: onPage(viewer?.pixelOf(one.centre) ?? [0, 0]),
                        })),
                    },
                    hits: (viewer?.hitPixels(64) ?? []).map((one) => ({ ...one, pixel: onPage(one.pixel) })),
                    shaChecked: model?.meshes.map((mesh) => mesh.checked),
                    meshMilliseconds: model?.milliseconds,
                    firstFrameMilliseconds: drawing.firstFrame.current,
                    frames: viewer?.stage.frames,
                    pointPixels: viewer ? rows.map((row) => onPage(viewer.pixelOfWorld(row as Vec3))) : [],
                };
            }),
        [],
    );
}
