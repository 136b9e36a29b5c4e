/** Gets scenarios one at a time; while one is under way only the last wish is remembered. */
import { ApiError, getArray, getJson, isAbort, pause } from "../base/api";
import type { Scenario } from "../base/types";

export interface Contacts {
    scenario: Scenario;
    /** Rows of triangle of A, triangle of B, class of the pair. */
    pairs: Uint32Array;
    /** Rows of pair, x, y, z in the world. */
    points: Float64Array;
    /** Whether the server left out pairs or points beyond its limit. */
    isCut: boolean;
}

export class ScenarioLoader {
    private wanted: number | null = null;
    private isLoading = false;
    private readonly stop = new AbortController();

    constructor(
        private readonly job: string,
        private readonly show: (contacts: Contacts) => void,
        private readonly fail: (scenario: number, error: unknown) => void,
    ) {}

    want(scenario: number): void {
        this.wanted = scenario;
        if (!this.isLoading) {
            void this.run();
        }
    }

    /** Ends all; nothing is shown afterwards. */
    close(): void {
        this.wanted = null;
        this.stop.abort();
    }

    private async run(): Promise<void> {
        this.isLoading = true;
        while (this.wanted !== null) {
            const scenario = this.wanted;
            try {
                const contacts = await this.load(scenario);
                this.wanted = this.wanted === scenario ? null : this.wanted;
                this.show(contacts);
            } catch (error) {
                if (isAbort(error) || this.stop.signal.aborted) {
                    break;
                }
                if (error instanceof ApiError && error.isBusy) {
                    await pause();
                } else {
                    this.wanted = this.wanted === scenario ? null : this.wanted;
                    this.fail(scenario, error);
                }
            }
        }
        this.isLoading = false;
    }

    private async load(number: number): Promise<Contacts> {
        const path = `jobs/${encodeURIComponent(this.job)}/scenarios/${number}`;
        const signal = this.stop.signal;
        const scenario = await getJson<Scenario>(path, signal);
        if (scenario.class === null || scenario.exact_pairs === 0) {
            return { scenario, pairs: new Uint32Array(), points: new Float64Array(), isCut: false };
        }
        const pairs = await getArray(`${path}/pairs`, signal);
        const points = await getArray(`${path}/points`, signal);
        return {
            scenario,
            pairs: pairs.values as Uint32Array,
            points: points.values as Float64Array,
            isCut: pairs.cut || points.cut,
        };
    }
}
