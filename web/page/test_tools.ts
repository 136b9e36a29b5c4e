/** What the tests of the page's parts check with. */
let failures = 0;

export function same(name: string, found: unknown, expected: unknown): void {
    const [one, other] = [JSON.stringify(found), JSON.stringify(expected)];
    if (one !== other) {
        failures += 1;
        console.log(`FAILED ${name}: ${one} is not ${other}`);
    }
}

export function refuses(name: string, action: () => unknown): void {
    try {
        action();
    } catch {
        return;
    }
    failures += 1;
    console.log(`FAILED ${name}: was accepted`);
}

/** Throws if a check has failed. */
export function finish(): void {
    if (failures > 0) {
        throw new Error(`${failures} failed`);
    }
    console.log("all of the page's parts do what they say");
}
