import { useEffect, useRef, useState } from "preact/hooks";
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { styleColour } from "../base/theme";
import { useTheme } from "./hooks";

export interface Line {
    title: string;
    colour: string; // A custom property of the style sheet.
    values: number[];
    dash?: number[];
}

const chartHeight = 160; // Pixels.

interface ChartProps {
    title: string;
    times: number[]; // Unix seconds.
    lines: Line[];
    format: (value: number) => string;
}

function optionsOf(
    props: ChartProps,
    width: number,
    point: (index: number | null) => void,
): uPlot.Options {
    const axis = {
        stroke: styleColour("--muted"),
        grid: { stroke: styleColour("--line"), width: 1 },
        ticks: { stroke: styleColour("--line"), width: 1, size: 4 },
        font: "11px system-ui, sans-serif",
    };
    return {
        width,
        height: chartHeight,
        legend: { show: false },
        cursor: { drag: { x: false, y: false }, y: false },
        hooks: { setCursor: [(plot) => point(plot.cursor.idx ?? null)] },
        scales: { y: { range: (_, __, max) => [0, Math.max(1.1 * max, 4)] } },
        axes: [
            { ...axis, size: 28, space: 70, values: "{HH}:{mm}:{ss}" },
            { ...axis, size: 64, values: (_, ticks) => ticks.map((tick) => props.format(tick)) },
        ],
        series: [
            {},
            ...props.lines.map((line) => ({
                stroke: styleColour(line.colour),
                width: 1.5,
                ...(line.dash ? { dash: line.dash } : {}),
                points: { show: false },
            })),
        ],
    };
}

/** Lines over the last minutes; below them the values under the pointer, or the last ones. */
export function Chart(props: ChartProps) {
    const box = useRef<HTMLDivElement>(null);
    const plot = useRef<uPlot | null>(null);
    const [index, point] = useState<number | null>(null);
    const theme = useTheme();
    const data: uPlot.AlignedData = [props.times, ...props.lines.map((line) => line.values)];
    useEffect(() => {
        const element = box.current;
        if (!element) {
            return;
        }
        const made = new uPlot(optionsOf(props, element.clientWidth || 300, point), data, element);
        plot.current = made;
        const watcher = new ResizeObserver(() =>
            made.setSize({ width: element.clientWidth || 300, height: chartHeight }),
        );
        watcher.observe(element);
        return () => {
            watcher.disconnect();
            made.destroy();
            plot.current = null;
        };
    }, [theme]);
    useEffect(() => plot.current?.setData(data), [props.times, theme]);
    const at = index !== null && index < props.times.length ? index : props.times.length - 1;
    const valueOf = (line: Line) => props.format(line.values[at] ?? 0);
    const said = props.lines.map((line) => `${line.title} ${valueOf(line)}`).join(", ");
    return (
        <figure class="chart">
            <div ref={box} role="img" aria-label={`${props.title}: ${said}`} />
            <figcaption>
                {props.lines.map((line) => (
                    <span key={line.title}>
                        <svg viewBox="0 0 18 4" aria-hidden="true">
                            <line
                                x1={0}
                                x2={18}
                                y1={2}
                                y2={2}
                                stroke={`var(${line.colour})`}
                                stroke-width={2}
                                stroke-dasharray={line.dash?.join(" ") ?? "none"}
                            />
                        </svg>
                        {line.title} <b>{valueOf(line)}</b>
                    </span>
                ))}
                <span class="note">{index === null ? "now" : new Date(1000 * props.times[at]).toLocaleTimeString("en-GB")}</span>
            </figcaption>
        </figure>
    );
}
