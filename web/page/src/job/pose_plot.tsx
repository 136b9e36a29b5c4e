import { useEffect, useRef, useState } from "preact/hooks";
import { styleColour } from "../base/theme";
import { useTheme } from "../ui/hooks";
import { axisText } from "./cells";
import type { PlotModel, Spot } from "./plot_model";

const arrows: Record<string, [number, number]> = {
    ArrowLeft: [-1, 0],
    ArrowRight: [1, 0],
    ArrowUp: [0, 1],
    ArrowDown: [0, -1],
};

function drawFrame(context: CanvasRenderingContext2D, spot: Spot, width: number, height: number) {
    const [x, y] = [spot.x * width, (1 - spot.y - spot.height) * height];
    context.lineWidth = 2 * devicePixelRatio;
    context.strokeStyle = styleColour("--ink");
    context.beginPath();
    if (spot.width > 0) {
        context.rect(x - 1, y - 1, Math.max(4, spot.width * width) + 2, Math.max(4, spot.height * height) + 2);
    } else {
        context.arc(x, y, 6 * devicePixelRatio, 0, 2 * Math.PI);
    }
    context.stroke();
}

/** Draws a plot of the pose space; a click, or Enter, opens the scenario under the mark. */
export function PosePlot(props: { model: PlotModel; open: (scenario: number) => void }) {
    const { model } = props;
    const canvas = useRef<HTMLCanvasElement>(null);
    const below = useRef<OffscreenCanvas | null>(null); // The plot without its mark.
    const [spot, setSpot] = useState<Spot | null>(null);
    const [size, setSize] = useState<[number, number]>([0, 0]);
    const theme = useTheme();
    useEffect(() => {
        const element = canvas.current;
        if (!element) {
            return;
        }
        const watcher = new ResizeObserver(() =>
            setSize([
                Math.round(element.clientWidth * devicePixelRatio),
                Math.round(element.clientHeight * devicePixelRatio),
            ]),
        );
        watcher.observe(element);
        return () => watcher.disconnect();
    }, []);
    useEffect(() => setSpot(null), [model.x.title, model.y.title]);
    useEffect(() => {
        const [width, height] = size;
        if (width > 0 && height > 0) {
            below.current = new OffscreenCanvas(width, height);
            const context = below.current.getContext("2d");
            if (context) {
                model.draw(context, width, height);
            }
        }
    }, [model, size, theme]);
    useEffect(() => {
        const context = canvas.current?.getContext("2d");
        const [width, height] = size;
        if (!canvas.current || !context || !below.current) {
            return;
        }
        canvas.current.width = width;
        canvas.current.height = height;
        context.drawImage(below.current, 0, 0);
        if (spot) {
            drawFrame(context, spot, width, height);
        }
    }, [model, spot, size, theme]);
    const find = (event: MouseEvent) => {
        const box = (event.currentTarget as HTMLElement).getBoundingClientRect();
        const x = (event.clientX - box.left) / box.width;
        const y = 1 - (event.clientY - box.top) / box.height;
        return model.at(x, y, box.width, box.height);
    };
    const press = (event: KeyboardEvent) => {
        const direction = arrows[event.key];
        if (direction) {
            setSpot(model.step(spot, ...direction));
            event.preventDefault();
        } else if (event.key === "Enter" && spot) {
            props.open(spot.scenario);
        }
    };
    const middle = (axis: PlotModel["x"]) => axisText(axis, (axis.first + axis.last) / 2);
    return (
        <div class="plot">
            <div class="y-axis" aria-hidden="true">
                <span>{axisText(model.y, model.y.last)}</span>
                <b>{model.y.title}</b>
                <span>{axisText(model.y, model.y.first)}</span>
            </div>
            <canvas
                ref={canvas}
                tabIndex={0}
                role="application"
                aria-label={`${model.x.title} against ${model.y.title}: arrows move, Enter opens. ${spot?.text ?? ""}`}
                onPointerMove={(event) => setSpot(find(event))}
                onPointerLeave={() => setSpot(null)}
                onClick={(event) => {
                    const found = find(event);
                    if (found) {
                        props.open(found.scenario);
                    }
                }}
                onKeyDown={press}
            />
            <div class="x-axis" aria-hidden="true">
                <span>{axisText(model.x, model.x.first)}</span>
                <span>
                    <b>{model.x.title}</b> {middle(model.x)}
                </span>
                <span>{axisText(model.x, model.x.last)}</span>
            </div>
            <p class="readout" aria-live="polite">
                {spot ? spot.text : "point at a place to read it; a click opens its worst scenario"}
            </p>
        </div>
    );
}
