/** The classes of scenarios: number, letter, colour, and which is worse (docs/formats.md). */
export const classNames = [
    "separate",
    "touch",
    "cross",
    "inside",
    "contact",
    "undecided",
    "failed",
    "near",
] as const;
export type ClassName = (typeof classNames)[number];

export const untested = 255;

/** The class of scenarios whose bodies are only near. */
export const near = 7;

/** The classes in the order in which counts of them are shown. */
export const shownOrder: readonly number[] = [0, near, 1, 2, 3, 4, 5, 6];

/**
 * How bad each class is; of several scenarios in one place the worst is shown. The order is separate,
 * undecided, near, touch, contact, cross, inside, failed.
 */
const severities = [1, 4, 6, 7, 5, 2, 8, 3];

export function severity(kind: number): number {
    return kind === untested ? 0 : severities[kind];
}

export function isContact(kind: number): boolean {
    return kind >= 1 && kind <= 4;
}

/** Whether a class is one of bodies in contact or near. */
export function isHit(kind: number): boolean {
    return isContact(kind) || kind === near;
}

export function nameOf(kind: number): string {
    return kind === untested ? "not tested yet" : classNames[kind];
}

export function numberOf(name: string | null): number {
    const found = classNames.indexOf(name as ClassName);
    return found < 0 ? untested : found;
}

export function letterOf(kind: number): string {
    return kind === untested ? "-" : "STXICUFN"[kind];
}

export type Rgb = readonly [number, number, number];

const colours: readonly Rgb[] = [
    [92, 168, 128],
    [232, 188, 38],
    [206, 58, 50],
    [146, 36, 92],
    [214, 82, 54],
    [132, 112, 186],
    [60, 64, 70],
    [240, 140, 40],
];
const untestedColour: Rgb = [150, 155, 160];

export function colourOf(kind: number): Rgb {
    return kind === untested ? untestedColour : colours[kind];
}

export function cssColour(kind: number): string {
    const [r, g, b] = colourOf(kind);
    return `rgb(${r} ${g} ${b})`;
}

/** A bar's height, 0 to 1, so that classes differ without their colours, too. */
export function heightOf(kind: number): number {
    return kind === untested ? 0.12 : [0.3, 0.6, 1, 0.9, 0.8, 0.5, 0.7, 0.45][kind];
}
