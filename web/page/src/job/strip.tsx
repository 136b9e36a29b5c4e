import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import { cssColour, heightOf, nameOf, untested } from "../base/classes";
import { tellFacts } from "../base/facts";
import { goTo, scenarioLink } from "../base/route";
import { asksShots, type Job, type Source } from "../base/types";
import { counted, grouped, short } from "../base/words";
import { useReloaded, useTheme } from "../ui/hooks";
import { Notice, Panel } from "../ui/small";
import type { JobView } from "./job_view";
import { canBeExact, exactMax, loadResults, type Results } from "./results";
import { writeFilter } from "../scene/filter";
import { styleColour } from "../base/theme";

const binsMax = 1024;

type Range = readonly [number, number];

/** Returns the scenarios that a view shows, of a job that may have fewer; `all` without a window. */
function windowWithin(window: Range | null, total: number, all: Range): Range {
    return window && window[0] < total ? [window[0], Math.min(total, window[1])] : all;
}

function noteOf(source: Source, results: Results, chosenOf: number): string {
    if (chosenOf > 0) {
        return `${grouped(results.classes.length)} of a sample of ${grouped(chosenOf)}`;
    }
    const exact = `windows of at most ${grouped(exactMax(source))} are exact`;
    return results.isSample ? `a sample of ${grouped(results.classes.length)}; ${exact}` : "";
}

/** How many bars show something, for tests. */
function shownOf(results: Results, worst: Int32Array): number {
    return worst.reduce((sum, element) => sum + (element >= 0 && results.classes[element] !== untested ? 1 : 0), 0);
}

/** Returns the worst element of each bin of scenarios [first, end); -1 where there is none. */
export function worstInBins(results: Results, first: number, end: number): Int32Array {
    const count = Math.min(binsMax, end - first);
    const worst = new Int32Array(count).fill(-1);
    for (let i = 0; i < results.classes.length; ++i) {
        const scenario = results.scenarioAt(i);
        if (scenario < first || scenario >= end) {
            continue;
        }
        const bin = Math.floor(((scenario - first) * count) / (end - first));
        if (worst[bin] < 0 || results.isWorse(i, worst[bin])) {
            worst[bin] = i;
        }
    }
    return worst;
}

interface Marks {
    /** The bin of the mark; -1 if there is none. */
    bin: number;
    /** The two ends of a drag, as shares of the width. */
    drag: readonly [number, number] | null;
}

function drawStrip(canvas: HTMLCanvasElement, results: Results, worst: Int32Array, { bin, drag }: Marks) {
    const width = Math.round(canvas.clientWidth * devicePixelRatio);
    const height = Math.round(canvas.clientHeight * devicePixelRatio);
    const context = canvas.getContext("2d");
    if (!context || width === 0) {
        return;
    }
    canvas.width = width;
    canvas.height = height;
    const edges = (one: number) => [one, one + 1].map((edge) => Math.round((edge * width) / worst.length));
    worst.forEach((element, one) => {
        if (element < 0) {
            return;
        }
        const kind = results.classes[element];
        const [left, right] = edges(one);
        const tall = height * heightOf(kind);
        const gap = right - left > 4 * devicePixelRatio ? devicePixelRatio : 0;
        context.fillStyle = cssColour(kind);
        context.fillRect(left, height - tall, Math.max(1, right - left - gap), tall);
    });
    context.fillStyle = styleColour("--accent");
    if (bin >= 0) {
        const [left, right] = edges(bin);
        context.fillRect(left, 0, Math.max(2 * devicePixelRatio, right - left), 3 * devicePixelRatio);
    }
    if (drag) {
        const [left, right] = [Math.min(...drag) * width, Math.max(...drag) * width];
        context.globalAlpha = 0.25;
        context.fillRect(left, 0, right - left, height);
    }
}

/**
 * Returns the window of half or twice as many scenarios about `mark`, which keeps its place in it. It
 * stays within [0, total).
 */
export function zoomed([first, end]: Range, mark: number, isNearer: boolean, total: number): Range {
    const size = Math.max(1, Math.min(total, isNearer ? Math.ceil((end - first) / 2) : 2 * (end - first)));
    const place = (mark - first) / (end - first);
    const from = Math.min(total - size, Math.max(0, Math.floor(mark) - Math.floor(place * size)));
    return [from, from + size];
}

/** Returns the window of the same size that holds `mark`, half a window further on. */
export function panned([first, end]: Range, mark: number, total: number): Range {
    const size = end - first;
    const from = Math.min(total - size, Math.max(0, Math.round(mark - size / 2)));
    return mark >= first && mark < end ? [first, end] : [from, from + size];
}

/** The classes of a window, exact where the source gives so many; else those of the whole job. */
function useWindow(source: Source, job: Job, whole: Results, [first, end]: Range): { results: Results; error: string } {
    const isAsked = whole.isSample && canBeExact(source, first, end);
    const exact = useReloaded(isAsked ? `${first} ${end}` : null, whole, (signal) =>
        loadResults(source, job, first, end, signal),
    );
    return { results: exact.value ?? whole, error: exact.error };
}

/** Scenarios in order as bars. A drag zooms, and so do keys; a click opens a bar's worst scenario. */
export function Strip(props: {
    source: Source;
    job: Job;
    results: Results;
    /** The scenarios that are shown at first; all if left out. */
    range?: Range;
    /** Of how many scenarios, a sample, those of `results` were chosen; 0: of all. */
    chosenOf?: number;
    view: JobView;
    change: (part: Partial<JobView>) => void;
}) {
    const { source, job } = props;
    const total = job.scenarios;
    const canvas = useRef<HTMLCanvasElement>(null);
    const [drag, setDrag] = useState<[number, number] | null>(null);
    const [mark, setMark] = useState(-1); // A scenario; -1: none.
    const [size, setSize] = useState(0);
    const theme = useTheme();
    const all: Range = props.range ?? [0, total];
    const range: Range = windowWithin(props.view.window, total, all);
    const [first, end] = range;
    const { results, error } = useWindow(source, job, props.results, range);
    const worst = useMemo(() => worstInBins(results, first, end), [results, first, end]);
    const bins = worst.length;
    const binOf = (scenario: number) => Math.floor(((scenario - first) * bins) / (end - first));
    const bin = mark >= first && mark < end ? binOf(mark) : -1;
    const firstOf = (one: number) => first + Math.ceil((one * (end - first)) / bins);
    useEffect(() => {
        const element = canvas.current;
        if (!element) {
            return;
        }
        const watcher = new ResizeObserver(() => setSize(element.clientWidth));
        watcher.observe(element);
        return () => watcher.disconnect();
    }, []);
    useEffect(() => {
        if (canvas.current) {
            drawStrip(canvas.current, results, worst, { bin, drag });
        }
    }, [results, worst, bin, drag, size, theme]);
    useEffect(
        () => tellFacts("strip", () => ({ strip: { first, end, mark, isExact: results.isExact, shown: shownOf(results, worst) } })),
        [results, worst, mark],
    );

    const show = ([from, to]: Range) => props.change({ window: from === all[0] && to === all[1] ? null : [from, to] });
    const share = (event: PointerEvent) => {
        const box = (event.currentTarget as HTMLElement).getBoundingClientRect();
        return Math.min(1, Math.max(0, (event.clientX - box.left) / box.width));
    };
    const scenarioUnder = (position: number) => firstOf(Math.min(bins - 1, Math.floor(position * bins)));
    const open = (one: number) => {
        if (worst[one] >= 0) {
            goTo(scenarioLink(job.job, results.scenarioAt(worst[one]), writeFilter(props.view.filter)));
        }
    };
    const release = () => {
        if (!drag) {
            return;
        }
        const [low, high] = [Math.min(...drag), Math.max(...drag)];
        setDrag(null);
        if (high - low < 0.005) {
            open(Math.min(bins - 1, Math.floor(low * bins)));
            return;
        }
        const from = Math.floor(first + low * (end - first));
        show([from, Math.max(from + 1, Math.ceil(first + high * (end - first)))]);
        setMark(-1);
    };
    const moveMark = (by: number) => {
        const to = bin < 0 ? (by > 0 ? first : end - 1) : by > 0 ? firstOf(bin + 1) : firstOf(bin) - 1;
        const inside = Math.min(total - 1, Math.max(0, to));
        setMark(inside);
        show(panned(range, inside, total));
    };
    const zoom = (isNearer: boolean) => show(zoomed(range, bin < 0 ? (first + end) / 2 : mark, isNearer, total));
    const keys: Record<string, () => void> = {
        ArrowRight: () => moveMark(1),
        ArrowLeft: () => moveMark(-1),
        "+": () => zoom(true),
        "-": () => zoom(false),
        Enter: () => open(bin),
        Escape: () => show(all),
    };
    const press = (event: KeyboardEvent) => {
        const action = event.ctrlKey || event.altKey || event.metaKey ? undefined : keys[event.key];
        if (action) {
            action();
            event.preventDefault();
        }
    };
    const element = bin >= 0 ? worst[bin] : -1;
    const distance = element >= 0 ? results.distanceAt(element) : null;
    const apart = distance === null ? "" : `, ${short(distance, 6)} ${job.unit} apart`;
    const hits = element >= 0 && asksShots(job) ? `, ${counted(results.countAt(element), "hit")}` : "";
    const said =
        element >= 0
            ? `#${results.scenarioAt(element)} ${nameOf(results.classes[element])}${apart}${hits}, the ${hits ? "most" : "worst"} of this bin`
            : "drag to zoom, click to open";
    return (
        <Panel
            title="scenarios in order"
            wide
            note={noteOf(source, results, props.chosenOf ?? 0)}
        >
            {error && <Notice kind="bad">{error}</Notice>}
            <canvas
                ref={canvas}
                class="strip"
                tabIndex={0}
                role="application"
                aria-label={`scenarios ${first} to ${end - 1}: arrows move, plus and minus zoom, Enter opens, Escape shows all. ${said}`}
                onPointerDown={(event) => {
                    event.currentTarget.setPointerCapture(event.pointerId);
                    setDrag([share(event), share(event)]);
                }}
                onPointerMove={(event) => {
                    setMark(scenarioUnder(share(event)));
                    setDrag(drag && [drag[0], share(event)]);
                }}
                onPointerUp={release}
                onPointerCancel={() => setDrag(null)}
                onPointerLeave={() => drag || setMark(-1)}
                onKeyDown={press}
            />
            <div class="x-axis">
                <span>#{grouped(first)}</span>
                <span class="readout">{said}</span>
                <span>
                    {props.view.window && (
                        <button type="button" class="quiet" onClick={() => show(all)}>
                            show all
                        </button>
                    )}{" "}
                    #{grouped(end - 1)}
                </span>
            </div>
        </Panel>
    );
}
