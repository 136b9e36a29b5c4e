/** How links name a part of a body: `body/part`. In names, `\` stands before each of `/ * ? [ \`. */

/** What a part's name is read with. */
export interface PartNames {
    /** The names of the two bodies in their job. */
    bodies: readonly [string, string];
    /** Whether A has a part with this name. */
    hasA: (part: string) => boolean;
}

function escaped(name: string): string {
    return name.replaceAll(/[\\/*?[]/g, "\\$&");
}

function plain(text: string): string {
    return text.replaceAll(/\\(.)/gs, "$1");
}

/** Returns the body that a word names; by its name, or else by its letter. */
function bodyOf(word: string, bodies: readonly [string, string]): number {
    const named = bodies.indexOf(word);
    return named >= 0 ? named : ["a", "b"].indexOf(word);
}

export function writePart(body: 0 | 1, part: string, bodies: readonly [string, string]): string {
    const isNamed = bodies[body] !== "" && bodies[0] !== bodies[1];
    return `${isNamed ? escaped(bodies[body]) : "ab"[body]}/${escaped(part)}`;
}

/**
 * Splits `body/part`, as the groups of a scene have it, where one of `bodies` ends; null if none does. Nothing is
 * escaped there.
 */
export function splitPart(text: string, bodies: ReadonlySet<string>): { body: string; part: string } | null {
    for (let at = text.indexOf("/"); at >= 0; at = text.indexOf("/", at + 1)) {
        if (bodies.has(text.slice(0, at))) {
            return { body: text.slice(0, at), part: text.slice(at + 1) };
        }
    }
    return null;
}

/** Reads a part; without a body it is one of A if A has it. */
export function readPart(text: string, names: PartNames): { body: 0 | 1; part: string } {
    const found = /^((?:\\.|[^\\/])*)\/(.*)$/s.exec(text);
    const body = found ? bodyOf(plain(found[1]), names.bodies) : -1;
    if (found && body >= 0) {
        return { body: body as 0 | 1, part: plain(found[2]) };
    }
    const part = plain(text);
    return { body: names.hasA(part) ? 0 : 1, part };
}
