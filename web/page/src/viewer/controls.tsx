import { useState } from "preact/hooks";
import { copyText } from "../ui/small";
import type { ClipAxis, Ghost, Mode, ViewState } from "./view_state";

interface RadioProps<T extends string> {
    title: string;
    name: string;
    value: T;
    all: readonly (readonly [T, string])[];
    choose: (value: T) => void;
}

function Radio<T extends string>(props: RadioProps<T>) {
    return (
        <fieldset class="radio">
            <legend>{props.title}</legend>
            {props.all.map(([value, text]) => (
                <label key={value}>
                    <input
                        type="radio"
                        name={props.name}
                        checked={props.value === value}
                        onChange={() => props.choose(value)}
                    />
                    <span>{text}</span>
                </label>
            ))}
        </fieldset>
    );
}

function Check(props: { text: string; isOn: boolean; turn: (isOn: boolean) => void }) {
    return (
        <label class="check">
            <input type="checkbox" checked={props.isOn} onChange={(event) => props.turn(event.currentTarget.checked)} />
            {props.text}
        </label>
    );
}

/** The section plane's bounds along each axis, in A's frame. */
export type Bounds = Record<ClipAxis, [number, number]>;

function SectionPlane(props: { state: ViewState; bounds: Bounds; change: (part: Partial<ViewState>) => void }) {
    const { clip } = props.state;
    const [low, high] = props.bounds[clip?.axis ?? "x"];
    const middle = (axis: ClipAxis) => (props.bounds[axis][0] + props.bounds[axis][1]) / 2;
    return (
        <div class="section-plane">
            <Check
                text="section"
                isOn={clip !== null}
                turn={(isOn) => props.change({ clip: isOn ? { axis: "x", at: middle("x") } : null })}
            />
            {clip && (
                <>
                    <select
                        aria-label="axis of the section plane"
                        value={clip.axis}
                        onChange={(event) => {
                            const axis = event.currentTarget.value as ClipAxis;
                            props.change({ clip: { axis, at: middle(axis) } });
                        }}
                    >
                        {["x", "y", "z"].map((axis) => (
                            <option key={axis}>{axis}</option>
                        ))}
                    </select>
                    <input
                        type="range"
                        aria-label="place of the section plane"
                        min={low}
                        max={high}
                        step={(high - low) / 500 || 1}
                        value={clip.at}
                        onInput={(event) =>
                            props.change({ clip: { axis: clip.axis, at: Number(event.currentTarget.value) } })
                        }
                    />
                    <output>{Number(clip.at.toPrecision(4))}</output>
                </>
            )}
        </div>
    );
}

export function ViewControls(props: {
    state: ViewState;
    bounds: Bounds;
    hasMap: boolean;
    /** Whether a scene's other bodies can be shown. */
    hasOthers: boolean;
    /** Whether B is a bundle of lines, whether the job has hits beyond their first ones, and what `l` hides. */
    lines: { areDrawn: boolean; hasAllHits: boolean; name: string };
    change: (part: Partial<ViewState>) => void;
    fit: () => void;
    goToContact: () => void;
}) {
    const { state, change } = props;
    const modes: (readonly [Mode, string])[] = [["contacts", "contacts"]];
    if (props.hasMap) {
        modes.push(["heat", "heat map"]);
    }
    const ghosts: (readonly [Ghost, string])[] = [
        ["a", "A"],
        ["b", "B"],
        ["none", "none"],
    ];
    return (
        <section class="view-controls" aria-label="view">
            <Radio title="show" name="mode" value={state.mode} all={modes} choose={(mode) => change({ mode })} />
            <Radio title="ghost" name="ghost" value={state.ghost} all={ghosts} choose={(ghost) => change({ ghost })} />
            <Check text="through walls" isOn={state.throughWalls} turn={(throughWalls) => change({ throughWalls })} />
            {props.lines.hasAllHits && (
                <Check text="first hits only" isOn={state.onlyFirst} turn={(onlyFirst) => change({ onlyFirst })} />
            )}
            <Check text={props.lines.name} isOn={state.lines} turn={(lines) => change({ lines })} />
            {props.hasOthers && <Check text="other bodies" isOn={state.others} turn={(others) => change({ others })} />}
            <SectionPlane state={state} bounds={props.bounds} change={change} />
            <div class="buttons">
                <button type="button" onClick={props.fit} title="f">
                    fit
                </button>
                <button type="button" onClick={props.goToContact} title="c">
                    go to the {props.lines.areDrawn ? "hits" : "contact"}
                </button>
            </div>
        </section>
    );
}

/** Copies the address of all that is seen. */
export function CopyLink({ address }: { address: () => string }) {
    const [said, say] = useState("");
    return (
        <button type="button" onClick={() => copyText(address(), say)}>
            {said || "copy link"}
        </button>
    );
}
