/** The colours of what is known of a motion's times. */
import { colourOf, near, type Rgb } from "../base/classes";
import type { Knowledge } from "./motion";

const grey: Rgb = [150, 155, 160];
const pale: Rgb = [214, 216, 219];
const [cross, undecided] = [2, 5];

/** Free is grey, open violet, the event red, or orange if it is that the bodies are near. */
export function knowledgeColour(kind: Knowledge, isNear: boolean): Rgb {
    return {
        free: grey,
        open: colourOf(undecided),
        event: colourOf(isNear ? near : cross),
        unknown: pale,
    }[kind];
}

export function knowledgeCss(kind: Knowledge, isNear: boolean): string {
    const [r, g, b] = knowledgeColour(kind, isNear);
    return `rgb(${r} ${g} ${b})`;
}
