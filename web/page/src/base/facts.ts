/** What the page shows, as plain values: tests and people ask `cdcluster.facts()` in the console. */
type Facts = Record<string, unknown>;
type Teller = () => Facts;

const tellers = new Map<string, Teller>();
const errors: string[] = [];

/** Adds facts until the returned function is called. */
export function tellFacts(name: string, teller: Teller): () => void {
    tellers.set(name, teller);
    return () => {
        if (tellers.get(name) === teller) {
            tellers.delete(name);
        }
    };
}

declare global {
    interface Window {
        cdcluster: { facts: Teller };
    }
}

export function publishFacts(): void {
    addEventListener("error", (event) => errors.push(event.message));
    addEventListener("unhandledrejection", (event) => errors.push(String(event.reason)));
    document.addEventListener("securitypolicyviolation", (event) =>
        errors.push(`policy: ${event.violatedDirective} ${event.blockedURI}`),
    );
    window.cdcluster = {
        facts: () =>
            Object.assign({ ready: false, errors: [...errors] }, ...[...tellers.values()].map((f) => f())),
    };
}
