import { useEffect, useRef } from "preact/hooks";

export const keyTable: readonly (readonly [string, string])[] = [
    ["n, p", "next and previous scenario in contact"],
    ["← →", "previous and next scenario"],
    ["space", "play, stop"],
    ["h", "heat map, contacts"],
    ["g", "ghost: A, B, none"],
    ["x", "contacts through walls"],
    ["l", "segments and points"],
    ["s", "section plane"],
    ["[ ]", "move the section plane"],
    ["f", "fit all into view"],
    ["c", "go to the contact"],
    ["shift ← → ↑ ↓", "turn"],
    ["+ −", "nearer, farther"],
    ["drag, wheel", "turn, zoom; with the right button or two fingers: move"],
    ["click", "pick a triangle; with shift: of the ghost"],
    ["?", "these keys"],
];

/** The list of keys as a dialog. */
export function KeyHelp({ close }: { close: () => void }) {
    const dialog = useRef<HTMLDialogElement>(null);
    useEffect(() => dialog.current?.showModal(), []);
    return (
        <dialog ref={dialog} class="keys" onClose={close} onClick={() => dialog.current?.close()}>
            <h2>Keys of the viewer</h2>
            <table>
                <tbody>
                    {keyTable.map(([key, what]) => (
                        <tr key={key}>
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

/** Whether a key belongs to the element that has the focus rather than to the screen. */
export function isTyping(event: KeyboardEvent): boolean {
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
