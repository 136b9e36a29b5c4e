import { useEffect, useRef } from "preact/hooks";

type KeyTable = readonly (readonly [string, string])[];

const stepKeys: KeyTable = [
    ["n, p", "next and previous scenario in contact, or what else is chosen"],
    ["← →", "previous and next scenario"],
    ["esc", "end a search for the next contact"],
];

const sceneKeys: KeyTable = [[", .", "previous and next step, at best of the same two bodies"]];

const drawingKeys: KeyTable = [
    ["space", "play, stop"],
    ["h", "heat map, contacts"],
    ["g", "ghost: A, B, none"],
    ["x", "contacts through walls"],
    ["l", "segments and points, or the path of a motion"],
    ["s", "section plane"],
    ["[ ]", "move the section plane"],
    ["f", "fit all into view"],
    ["c", "go to the contact"],
    ["e", "in a motion: the time of the event"],
    ["shift ← → ↑ ↓", "turn"],
    ["shift W A S D", "move up, left, down, right"],
    ["+ −", "nearer, farther"],
    ["enter", "in the picture: pick the triangle in its middle; with shift: of the ghost"],
    ["drag, wheel", "turn, zoom; with the right button or two fingers: move"],
    ["click", "pick a triangle; with shift: of the ghost"],
];

/** The keys of the viewer; those that act on the drawing only where it draws. */
export function viewerKeys(draws: boolean, hasSteps: boolean): KeyTable {
    return [...stepKeys, ...(hasSteps ? sceneKeys : []), ...(draws ? drawingKeys : []), ["?", "these keys"]];
}

export const jobKeys: KeyTable = [
    ["tab", "from one part of the page to the next"],
    ["← → ↑ ↓", "in the pose space: the next place"],
    ["← →", "in the scenarios in order: the next bar; beyond the edge, further scenarios"],
    ["+ −", "there: half as many scenarios about the mark, or twice as many"],
    ["enter", "open the scenario at the mark"],
    ["esc", "all scenarios in order"],
    ["?", "these keys"],
];

/** A list of keys as a dialog. */
export function KeyHelp({ title, keys, close }: { title: string; keys: KeyTable; close: () => void }) {
    const dialog = useRef<HTMLDialogElement>(null);
    useEffect(() => dialog.current?.showModal(), []);
    return (
        <dialog ref={dialog} class="keys" onClose={close} onClick={() => dialog.current?.close()}>
            <h2>{title}</h2>
            <table>
                <tbody>
                    {keys.map(([key, what]) => (
                        <tr key={what}>
                            <th scope="row">
                                <kbd>{key}</kbd>
                            </th>
                            <td>{what}</td>
                        </tr>
                    ))}
                </tbody>
            </table>
            <button type="button">close</button>
        </dialog>
    );
}

/**
 * Calls the action of each pressed key, by its name; with shift, an arrow is `Shift+ArrowLeft`. Keys are
 * heard in `root`.
 */
export function useKeys(actions: Record<string, () => void>, root: EventTarget = document): void {
    const now = useRef(actions);
    now.current = actions;
    useEffect(() => {
        const press = (event: Event) => {
            if (!(event instanceof KeyboardEvent)) {
                return;
            }
            const isTurn = event.shiftKey && event.key.startsWith("Arrow");
            const action = now.current[isTurn ? `Shift+${event.key}` : event.key];
            if (action && !isTyping(event)) {
                action();
                event.preventDefault();
            }
        };
        root.addEventListener("keydown", press);
        return () => root.removeEventListener("keydown", press);
    }, [root]);
}

/** Whether a key belongs to the element that has the focus rather than to the screen. */
function isTyping(event: KeyboardEvent): boolean {
    const target = event.target;
    if (event.ctrlKey || event.altKey || event.metaKey) {
        return true;
    }
    if (target instanceof HTMLInputElement) {
        const isMoved = target.type === "range" || target.type === "radio";
        return target.type === "number" || (isMoved && event.key.startsWith("Arrow"));
    }
    const isPressed = target instanceof HTMLButtonElement && event.key === " ";
    const tree = target instanceof Element ? (target.getRootNode() as Document | ShadowRoot) : document;
    return isPressed || target instanceof HTMLSelectElement || tree.querySelector("dialog[open]") !== null;
}
