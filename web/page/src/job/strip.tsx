import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import { isAbort, messageOf } from "../base/api";
import { cssColour, heightOf, nameOf } from "../base/classes";
import { goTo, scenarioLink } from "../base/route";
import type { Job, Source } from "../base/types";
import { grouped } from "../base/words";
import { useTheme } from "../ui/hooks";
import { Notice, Panel } from "../ui/small";
import { canBeExact, loadResults, type Results } from "./results";
import { styleColour } from "../base/theme";

const bins = 1024;

/** Returns the worst element of each bin of scenarios [first, end); -1 where there is none. */
export function worstInBins(results: Results, first: number, end: number): Int32Array {
    const count = Math.min(bins, end - first);
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

function drawStrip(canvas: HTMLCanvasElement, results: Results, worst: Int32Array, marks: [number, number] | null) {
    const width = Math.round(canvas.clientWidth * devicePixelRatio);
    const height = Math.round(canvas.clientHeight * devicePixelRatio);
    const context = canvas.getContext("2d");
    if (!context || width === 0) {
        return;
    }
    canvas.width = width;
    canvas.height = height;
    worst.forEach((element, bin) => {
        if (element < 0) {
            return;
        }
        const kind = results.classes[element];
        const [left, right] = [bin, bin + 1].map((edge) => Math.round((edge * width) / worst.length));
        const tall = height * heightOf(kind);
        const gap = right - left > 4 * devicePixelRatio ? devicePixelRatio : 0;
        context.fillStyle = cssColour(kind);
        context.fillRect(left, height - tall, Math.max(1, right - left - gap), tall);
    });
    if (marks) {
        const [left, right] = [Math.min(...marks) * width, Math.max(...marks) * width];
        context.fillStyle = styleColour("--accent");
        context.globalAlpha = 0.25;
        context.fillRect(left, 0, right - left, height);
    }
}

/** Follows a drag over the strip; a click without a drag opens the bin's worst scenario. */
export function Strip(props: { source: Source; job: Job; results: Results }) {
    const { source, job } = props;
    const canvas = useRef<HTMLCanvasElement>(null);
    const [view, setView] = useState<[number, number]>([0, job.scenarios]);
    const [exact, setExact] = useState<Results | null>(null);
    const [error, setError] = useState("");
    const [drag, setDrag] = useState<[number, number] | null>(null);
    const [spot, setSpot] = useState(-1);
    const [size, setSize] = useState(0);
    const theme = useTheme();
    const [first, end] = view;
    const results = exact && exact.first === first && exact.end === end ? exact : props.results;
    const worst = useMemo(() => worstInBins(results, first, end), [results, first, end]);
    useEffect(() => {
        setExact(null);
        if (props.results.isExact || !canBeExact(source, first, end)) {
            return;
        }
        const stop = new AbortController();
        loadResults(source, job, first, end, stop.signal).then(
            setExact,
            (reason) => isAbort(reason) || setError(messageOf(reason)),
        );
        return () => stop.abort();
    }, [first, end, props.results.isExact]);
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
            drawStrip(canvas.current, results, worst, drag);
        }
    }, [results, first, end, drag, size, theme]);

    const share = (event: PointerEvent) => {
        const box = (event.currentTarget as HTMLElement).getBoundingClientRect();
        return Math.min(1, Math.max(0, (event.clientX - box.left) / box.width));
    };
    const binAt = (position: number) => Math.min(worst.length - 1, Math.floor(position * worst.length));
    const open = (bin: number) => {
        if (worst[bin] >= 0) {
            goTo(scenarioLink(job.job, results.scenarioAt(worst[bin])));
        }
    };
    const release = () => {
        if (!drag) {
            return;
        }
        const [low, high] = [Math.min(...drag), Math.max(...drag)];
        setDrag(null);
        if (high - low < 0.005) {
            open(binAt(low));
            return;
        }
        const from = Math.floor(first + low * (end - first));
        setView([from, Math.max(from + 1, Math.ceil(first + high * (end - first)))]);
        setSpot(-1);
    };
    const press = (event: KeyboardEvent) => {
        const step = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
        if (step !== 0) {
            setSpot(Math.min(worst.length - 1, Math.max(0, spot + step)));
            event.preventDefault();
        } else if (event.key === "Enter" && spot >= 0) {
            open(spot);
        } else if (event.key === "Escape") {
            setView([0, job.scenarios]);
        }
    };
    const element = spot >= 0 && spot < worst.length ? worst[spot] : -1;
    const isWhole = first === 0 && end === job.scenarios;
    const said =
        element >= 0
            ? `#${results.scenarioAt(element)} ${nameOf(results.classes[element])}, the worst of this bin`
            : "drag to zoom, click to open";
    return (
        <Panel
            title="scenarios in order"
            wide
            note={results.isExact ? "" : `a sample of ${grouped(results.classes.length)}; zoomed windows are exact`}
        >
            {error && <Notice kind="bad">{error}</Notice>}
            <canvas
                ref={canvas}
                class="strip"
                tabIndex={0}
                role="application"
                aria-label={`scenarios ${first} to ${end - 1}: arrows move, Enter opens, Escape shows all. ${said}`}
                onPointerDown={(event) => {
                    event.currentTarget.setPointerCapture(event.pointerId);
                    setDrag([share(event), share(event)]);
                }}
                onPointerMove={(event) => {
                    setSpot(binAt(share(event)));
                    setDrag(drag && [drag[0], share(event)]);
                }}
                onPointerUp={release}
                onPointerCancel={() => setDrag(null)}
                onPointerLeave={() => drag || setSpot(-1)}
                onKeyDown={press}
            />
            <div class="x-axis">
                <span>#{grouped(first)}</span>
                <span class="readout">{said}</span>
                <span>
                    {!isWhole && (
                        <button type="button" class="quiet" onClick={() => setView([0, job.scenarios])}>
                            show all
                        </button>
                    )}{" "}
                    #{grouped(end - 1)}
                </span>
            </div>
        </Panel>
    );
}
