/** Small pieces that several screens show. */
import type { ComponentChildren } from "preact";
import { useState } from "preact/hooks";
import { cssColour, letterOf, nameOf } from "../base/classes";
import { grouped, percent } from "../base/words";

/** A name that a stranger chose: always text, and its writing direction ends with it. */
export function Name({ text }: { text: string }) {
    return (
        <bdi class="name" title={text.slice(0, 2000)}>
            {text === "" ? "(no name)" : text.length > 400 ? `${text.slice(0, 400)}…` : text}
        </bdi>
    );
}

/** A class of scenarios as a coloured letter. */
export function ClassMark({ kind }: { kind: number }) {
    return (
        <span
            class={`mark mark-${nameOf(kind).split(" ")[0]}`}
            style={{ background: cssColour(kind) }}
            aria-hidden="true"
        >
            {letterOf(kind)}
        </span>
    );
}

export function ClassCount(props: { kind: number; count: number; always?: boolean }) {
    if (props.count === 0 && !props.always) {
        return null;
    }
    return (
        <span class={`count ${props.count === 0 ? "zero" : ""}`}>
            <ClassMark kind={props.kind} />
            {nameOf(props.kind)} <b>{grouped(props.count)}</b>
        </span>
    );
}

export function Notice(props: { kind: "bad" | "warn" | "calm"; children: ComponentChildren }) {
    return (
        <div class={`notice ${props.kind}`} role={props.kind === "bad" ? "alert" : "status"}>
            {props.children}
        </div>
    );
}

export function Panel(props: {
    title: string;
    note?: ComponentChildren;
    children: ComponentChildren;
    wide?: boolean;
}) {
    return (
        <section class={`panel ${props.wide ? "wide" : ""}`} aria-label={props.title}>
            <header>
                <h2>{props.title}</h2>
                {props.note && <span class="note">{props.note}</span>}
            </header>
            {props.children}
        </section>
    );
}

export function Progress({ done, total }: { done: number; total: number }) {
    const share = total === 0 ? 0 : done / total;
    return (
        <span class="progress">
            <progress max={1} value={share} aria-label={`${grouped(done)} of ${grouped(total)}`} />
            <span>{percent(share)}</span>
        </span>
    );
}

/** A command that a click copies. */
export function Command({ text }: { text: string }) {
    const [said, setSaid] = useState("");
    return (
        <button type="button" class="command" title="copy" onClick={() => copyText(text, setSaid)}>
            <code>{text}</code>
            <span aria-live="polite">{said || "copy"}</span>
        </button>
    );
}

/** Copies text, and says for two seconds whether that worked. */
export function copyText(text: string, say: (word: string) => void): void {
    const tell = (word: string) => {
        say(word);
        setTimeout(() => say(""), 2000);
    };
    const copied = navigator.clipboard?.writeText(text) ?? Promise.reject(new Error());
    copied.then(
        () => tell("copied"),
        () => tell("the browser did not allow it"),
    );
}
