/** Gets scenarios one at a time; while one is under way only the last wish is remembered. */
import { ApiError, getArray, getJson, isAbort, pause } from "../base/api";
import type { Scenario } from "../base/types";
import { Hits } from "./hits";
import type { Model } from "./model";

export interface Contacts {
    scenario: Scenario;
    /** Rows of triangle of A, triangle of B, class of the pair. */
    pairs: Uint32Array;
    /** Rows of pair, x, y, z in the world. */
    points: Float64Array;
    /** What the lines of B hit; null in a job without lines. */
    hits: Hits | null;
    /** Whether the server left out pairs or points beyond its limit. */
    isCut: boolean;
    /** In a job of a scene the two bodies; null if they are not drawn, or in other jobs. */
    model: Model | null;
}

export class ScenarioLoader {
    private wanted: number | null = null;
    private isLoading = false;
    private readonly stop = new AbortController();

    constructor(
        private readonly job: string,
        private readonly hasLines: boolean,
        private readonly modelOf: (scenario: Scenario) => Promise<Model | null>,
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
        const scenario = await getJson<Scenario>(path, this.stop.signal);
        const [contacts, model] = await Promise.all([this.loadContacts(path, scenario), this.modelOf(scenario)]);
        return { ...contacts, model };
    }

    private async loadContacts(path: string, scenario: Scenario): Promise<Omit<Contacts, "model">> {
        const signal = this.stop.signal;
        if (scenario.class === null || scenario.exact_pairs === 0) {
            const pairs = new Uint32Array();
            const hits = this.hasLines ? new Hits(pairs, new Float64Array()) : null;
            return { scenario, pairs, points: new Float64Array(), hits, isCut: false };
        }
        const pairs = await getArray(`${path}/pairs`, signal);
        const rows = pairs.values as Uint32Array;
        if (this.hasLines) {
            const found = await getArray(`${path}/hits`, signal);
            const hits = new Hits(rows, found.values as Float64Array);
            return { scenario, pairs: rows, points: new Float64Array(), hits, isCut: pairs.cut };
        }
        const points = await getArray(`${path}/points`, signal);
        return {
            scenario,
            pairs: rows,
            points: points.values as Float64Array,
            hits: null,
            isCut: pairs.cut || points.cut,
        };
    }
}
