/** The scenarios that can be shown, in rising order: all of a job, or the chosen ones. */
export class Scenarios {
    private readonly chosen: readonly number[] | null;

    constructor(
        private readonly total: number,
        chosen?: readonly number[],
    ) {
        this.chosen = chosen ? [...chosen].sort((a, b) => a - b) : null;
    }

    get count(): number {
        return this.chosen?.length ?? this.total;
    }

    /** Returns the scenario at a place, 0 to count - 1; beyond these, the first or the last. */
    at(place: number): number {
        const inside = Math.min(this.count - 1, Math.max(0, place));
        return this.chosen ? this.chosen[inside] : inside;
    }

    /** Returns the place of the nearest scenario. */
    placeOf(scenario: number): number {
        if (!this.chosen) {
            return Math.min(this.total - 1, Math.max(0, scenario));
        }
        const distances = this.chosen.map((one) => Math.abs(one - scenario));
        return distances.indexOf(Math.min(...distances));
    }
}
