/** Tests of the page's parts that need no browser: `npm test`. */
import "./test_scene";
import { finish, refuses, same } from "./test_tools";
import { cssColour, isContact, isHit, letterOf, nameOf, numberOf, severity, shownOrder, untested } from "./src/base/classes";
import { HeldAnswers } from "./src/base/held";
import { type Mesh, parseMesh } from "./src/base/mesh";
import { parseNpy } from "./src/base/npy";
import { readPart, writePart } from "./src/base/part_name";
import { BodyParts } from "./src/base/parts";
import { apply, compose, coordinateOf, inverse, placementOf } from "./src/base/pose";
import { jobLink, parseRoute, scenarioLink } from "./src/base/route";
import type { Motion, Scenario, Vec3 } from "./src/base/types";
import { bytesOf, grouped, percent, shellWord } from "./src/base/words";
import { distanceBinsOf, nearestOf } from "./src/job/distances";
import { episodesOf } from "./src/job/episodes";
import { traceGlyph } from "./src/job/glyphs";
import { Grid, gridCells } from "./src/job/grid";
import { wilson } from "./src/job/groups";
import { binsOf } from "./src/job/histogram";
import { readJobView, startView, writeJobView } from "./src/job/job_view";
import { mostHitOf } from "./src/job/most_hits";
import { addRows, bestCoordinates } from "./src/job/poses";
import { Results } from "./src/job/results";
import { scenariosOfSlice, windowsOf } from "./src/job/slice";
import { panned, worstInBins, zoomed } from "./src/job/strip";
import { knowledgeCss } from "./src/motion/colours";
import { hasContactsAt, intervalsOf, knowledgeAt, motionText, pathOf, poseBetween, shownPose, timeText } from "./src/motion/motion";
import { highlightsOf, shapesOf } from "./src/viewer/contacts_view";
import { heatByte } from "./src/viewer/heat";
import { endsOf, Hits, passagesOf, pointAt, startsAndEndsOutside } from "./src/viewer/hits";
import { nearestTriangle } from "./src/viewer/pick";
import { Scenarios } from "./src/viewer/scenarios";
import { hasPairOf } from "./src/viewer/step";
import { distanceText } from "./src/viewer/status";
import { readState, startState, writeState } from "./src/viewer/view_state";

function npy(type: string, shape: string, data: ArrayBuffer): ArrayBuffer {
    const text = `{'descr': '${type}', 'fortran_order': False, 'shape': (${shape}), }`.padEnd(117) + "\n";
    const header = [0x93, ...Array.from("NUMPY", (c) => c.charCodeAt(0)), 1, 0, text.length, 0];
    const bytes = [...header, ...Array.from(text, (c) => c.charCodeAt(0)), ...new Uint8Array(data)];
    return new Uint8Array(bytes).buffer;
}

// Arrays.
same("u1", [...parseNpy(npy("|u1", "3,", new Uint8Array([1, 2, 255]).buffer)).values], [1, 2, 255]);
same("u8", [...parseNpy(npy("<u8", "1, 2", new BigUint64Array([7n, 9n]).buffer)).values], [7, 9]);
same("shape", parseNpy(npy("<f8", "2, 2", new Float64Array(4).buffer)).shape, [2, 2]);
refuses("an array cut short", () => parseNpy(npy("<u4", "3,", new Uint32Array(2).buffer)));
refuses("no array", () => parseNpy(new ArrayBuffer(20)));

// Meshes: one triangle.
function meshBytes(): ArrayBuffer {
    const bytes = new ArrayBuffer(29 + 36 + 12);
    const view = new DataView(bytes);
    [0, 0x43, 0x44, 0x4d, 0x45, 0x53, 0x48, 0x31, 0].forEach((byte, i) => view.setUint8(i, byte));
    view.setBigUint64(9, 3n, true);
    view.setBigUint64(17, 1n, true);
    [0, 0, 0, 2, 0, 0, 0, 4, 0].forEach((value, i) => view.setFloat32(29 + 4 * i, value, true));
    [0, 1, 2].forEach((value, i) => view.setUint32(65 + 4 * i, value, true));
    return bytes;
}
const mesh = parseMesh(meshBytes(), "", true);
same("box", [mesh.min, mesh.max, mesh.centre], [[0, 0, 0], [2, 4, 0], [1, 2, 0]]);
for (let length = 0; length < meshBytes().byteLength; ++length) {
    refuses(`a mesh of ${length} bytes`, () => parseMesh(meshBytes().slice(0, length), "", true));
}

// Parts: triangles 0 to 3 and 9 on are of piece 2, the others of piece 1.
const parts = new BodyParts(["piece 1", "piece 2"], new Uint32Array([0, 1, 4, 0, 9, 1]));
same("parts", [0, 3, 4, 8, 9, 50].map((one) => parts.nameOf(one)[6]), [..."221122"]);
same("places in parts", [0, 3, 4, 8, 9, 50].map((one) => parts.placeOf(one)), [0, 3, 0, 4, 4, 45]);
same("all parts", [parts.isOf(4, ""), parts.isOf(4, "piece 1"), parts.isOf(4, "piece 2")], [true, true, false]);

// Names of parts in links.
const van = { bodies: ["van", "post"] as const, hasA: (part: string) => part === "hood" || part === "a/b" };
const reads = (text: string) => Object.values(readPart(text, van));
same("a body's name", [reads("van/hood"), reads("post/top")], [[0, "hood"], [1, "top"]]);
same("a body's letter", [reads("a/hood"), reads("b/van/hood")], [[0, "hood"], [1, "van/hood"]]);
same("no body", [reads("hood"), reads("top"), reads("no/hood"), reads("a\\/b")], [[0, "hood"], [1, "top"], [1, "no/hood"], [0, "a/b"]]);
same("a body that is called b", Object.values(readPart("b/x", { ...van, bodies: ["b", "a"] })), [0, "x"]);
same("the body's name is written", writePart(1, "hood", van.bodies), "post/hood");
same("bodies of one name have letters", writePart(1, "hood", ["van", "van"]), "b/hood");
for (const part of ["a/b", "\\", "[*?]", "\\/", "", "x"]) {
    for (const body of [0, 1] as const) {
        const bodies = ["v/\\n", "p*"] as const;
        const text = writePart(body, part, bodies);
        same(`part ${text}`, readPart(text, { bodies, hasA: () => false }), { body, part });
    }
}
same("escapes", writePart(0, "a/b*?[\\", ["van", "post"]), "van/a\\/b\\*\\?\\[\\\\");

// Poses: a quarter turn about z, and a shift.
const turn = [0, -1, 0, 5, 1, 0, 0, 6, 0, 0, 1, 7];
same("apply", apply(turn, [1, 0, 0]), [5, 7, 7]);
same("inverse", apply(compose(inverse(turn), turn), [1, 2, 3]), [1, 2, 3]);
same("placement", [placementOf(turn).yaw, placementOf(turn).x], [90, 5]);

// Links.
const seen = {
    ...startState,
    mode: "heat" as const,
    ghost: "a" as const,
    throughWalls: false,
    lines: false,
    clip: { axis: "y" as const, at: -0.25 },
    camera: [1, 2, 3, 4, 5, 6.5],
    partA: "a/b, c&d=#?",
    partB: "\u202e<img>",
    pick: { body: 1 as const, triangle: 12 },
    seek: "near" as const,
    tau: 0.3125,
};
const link = scenarioLink("j-1", 7, writeState(seen, van.bodies));
const all = { ...van, hasA: () => true };
same("a link holds all that is seen", readState(parseRoute(link).query, all), seen);
same("a plain view has a plain link", scenarioLink("j-1", 7, writeState(startState, van.bodies)), "#/jobs/j-1/7");
const wrong = new URLSearchParams("mode=x&clip=w:1&cam=1,2&pick=c:1&ghost=q&seek=x&tau=2");
same("values that mean nothing are ignored", readState(wrong, all), startState);
same("a part that A lacks is one of B", readState(new URLSearchParams("part=post"), van).partB, "post");
same("of two parts the second is of B", readState(new URLSearchParams("part=x&with=x"), all).partB, "x");
same("no such screen", parseRoute("#/jobs/j-1/x").screen, "none");

// Links of a job's screen.
const filter = { body: "car.3", steps: [4, 9] as const };
const view = { x: "yaw", y: "x", at: { z: -0.5, roll: 1e-7 }, window: [3, 90] as const, filter };
same("a job's link holds all that is seen", readJobView(parseRoute(jobLink("j-1", writeJobView(view))).query), view);
same("a plain job has a plain link", jobLink("j-1", writeJobView(startView)), "#/jobs/j-1");
const odd = new URLSearchParams("at=z:,y,:1,x:1e999&from=9&to=3");
same("a job's values that mean nothing are ignored", readJobView(odd), startView);

// Results: scenarios 0 to 7.
const kinds = new Uint8Array([0, 1, 2, 0, 2, 2, 255, 3]);
const results = new Results(0, 8, kinds, new Uint32Array([0, 4, 9, 0, 1, 70, 0, 0]));
same("number of episodes", episodesOf(results).count, 3);
same("episodes", episodesOf(results).listed.map((one) => [one.first, one.last, one.worst]), [[1, 2, 2], [4, 5, 5], [7, 7, 7]]);
same("the worst of bins", [...worstInBins(results, 0, 8)], [0, 1, 2, 3, 4, 5, 6, 7]);
same("the worst of all", results.worst(), 7);
const order = [untested, 0, 5, 7, 1, 4, 2, 3, 6];
same("classes from best to worst", [...order].sort((a, b) => severity(a) - severity(b)), order);
same("severities differ", new Set(order.map(severity)).size, order.length);
const approach = new Results(0, 6, new Uint8Array([0, 7, 7, 2, 0, 7]), new Uint32Array([0, 3, 5, 1, 0, 2]));
same("episodes of near and contact", episodesOf(approach).listed.map((one) => [one.first, one.last, one.worst]), [[1, 3, 3], [5, 5, 5]]);
same("the worst near scenario", [approach.isWorse(2, 1), approach.isWorse(3, 2)], [true, true]);
same("near is no contact", [isContact(7), isHit(7), isHit(0), isHit(5)], [false, true, false, false]);
same("each class has a letter, a colour and a name", [letterOf(7), nameOf(7), numberOf("near"), new Set(order.map(cssColour)).size], ["N", "near", 7, 9]);
same("all classes are shown", [...shownOrder].sort(), [0, 1, 2, 3, 4, 5, 6, 7]);
same("a sample", new Results(0, 100, kinds, null).scenarioAt(3), 37);
const apart = new Results(0, 5, new Uint8Array([0, 0, 4, 3, 0]), null, null, Float64Array.of(0.5, 0.25, NaN, 0.125, 0.25));
same("the nearest scenarios", nearestOf(apart), [3, 1, 4, 0]);
same("the two nearest scenarios", nearestOf(apart, 2), [3, 1]);
same("of equal classes the nearer is worse", [apart.isWorse(1, 0), apart.isWorse(0, 1), apart.isWorse(4, 1)], [true, false, false]);
same("no distance", [apart.distanceAt(2), approach.distanceAt(0), nearestOf(approach).length], [null, null, 0]);
same("bins of distances", distanceBinsOf(apart.distances ?? new Float64Array()).flatMap((bin, i) => Array(bin.count).fill(i)), [5, 10, 10, 19]);
same("no bins without distances", distanceBinsOf(Float64Array.of(NaN)), []);
const told = (distance: number | null | undefined, least: number | null, up_to: number | null) =>
    distanceText({ unit: "m", up_to }, { class: "separate", distance, least_distance: least } as Scenario);
same("a distance is told", told(0.25, 0.25, null), "the bodies are 0.25 m apart");
same("a bound is told", told(null, null, 2), "more than 2 m apart");
same("the least distance of near pairs is told", told(undefined, 0.5, null), "nearest triangles 0.5 m apart");

// Line 4 enters and leaves part 0, leaves part 1 where it enters part 0 again, and grazes; line 7 crosses a plate.
const crossing = { enters: 3, leaves: 5, grazes: 16 };
const [rows, pairRows] = [
    [
        [5, 4, 2, crossing.leaves, 0],
        [0, 4, 1, crossing.enters, 0],
        [6, 4, 2, crossing.enters, 0],
        [1, 4, 3, crossing.leaves, 1],
        [2, 4, 3, crossing.enters, 0],
        [3, 4, 2.5, crossing.grazes, 0],
        [9, 7, 1.5, crossing.leaves, 0],
    ],
    (row: number[]) => [row[0], row[1], 3],
];
const lineHits = new Hits(
    Uint32Array.from(rows.flatMap(pairRows)),
    Float64Array.from(rows.flatMap((row) => row.slice(2))),
);
same("hits of a line by depth, rank, and leaving first", lineHits.ofLine(4), [1, 0, 2, 5, 4, 3]);
same("a line without hits", lineHits.ofLine(5), []);
same("kinds of hits", [1, 0, 5].map((hit) => lineHits.kindOf(hit)), ["enters", "leaves", "grazes"]);
same("first hits", [lineHits.shown(true), lineHits.shown(false).length], [[1, 6], 7]);
const partOfTriangle = (triangle: number) => (triangle < 3 ? 0 : triangle < 9 ? 1 : 2);
const isClosed = (part: number) => part === 0;
same(
    "crossings of closed parts are paired",
    passagesOf(lineHits, 4, partOfTriangle, isClosed).map(({ part, in: from, out }) => [part, from, out]),
    [[0, 1, 4], [1, 0, null], [1, 2, null], [0, 3, null]],
);
same("an open part has no way through it", passagesOf(lineHits, 7, partOfTriangle, isClosed), [{ part: 2, in: 6, out: null }]);
const bundle = { vertices: Float64Array.of(3, 0, 0, -1, 0, 0), triangles: Uint32Array.of(0, 1, 1) } as Mesh;
same("a point of a line", pointAt(endsOf(bundle, 0), 2.5), [0.5, 0, 0]);
const cube = { vertices: Float64Array.of(0, 0, 0, 1, 0, 0, 0, 1, 1), triangles: Uint32Array.of(0, 1, 2) } as Mesh;
const cubeParts = new BodyParts(["cube"], [0, 0]);
same(
    "ends in the box of a part",
    [[[-1, 0, 0], [2, 0, 0]], [[-1, 0, 0], [0.5, 0.5, 0.5]]].map((ends) => startsAndEndsOutside(ends as Vec3[], cube, cubeParts, 0)),
    [true, false],
);
const quarter = [0, -1, 0, 5, 1, 0, 0, 6, 0, 0, 1, 7];
same("lines from the left", [coordinateOf("azimuth", quarter), coordinateOf("elevation", quarter)], [90, 0]);
same("lines from the right", coordinateOf("azimuth", [0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0]), 270);
same("bundles with most hits", mostHitOf(new Results(0, 4, new Uint8Array(4), Uint32Array.of(2, 0, 9, 2))), [2, 0, 3]);
same("histogram", binsOf(new Uint32Array([0, 1, 2, 3, 4])).map((bin) => bin.count), [1, 2, 1]);

// A body's path, whose second key is negated to go the short way; the numbers are those of `pose_at` in C++.
const [keyFrom, keyTo] = [[1, 0, 0, 0, 1, 2, 3], [-0.5, 0.25, -0.5, -0.75, 4, -2, 3.5]];
const onPath = (tau: number) => poseBetween(keyFrom, keyTo, tau).map((value) => value.toFixed(14));
same("the pose at a time between two keys", onPath(0.3125), [
    ...[0.80097979179424372, -0.52663808940600121, 0.28475199020208208, 1.9375],
    ...[0.46540110226576853, 0.84690753214941827, 0.25719534598897736, 0.75],
    ...[-0.37660747091243113, -0.073484384568279243, 0.92345376607470908, 3.15625],
].map((value) => value.toFixed(14)));
same("the pose at the second key", onPath(1), [
    ...[-4 / 9, -8 / 9, 1 / 9, 4, 4 / 9, -1 / 9, 8 / 9, -2, -7 / 9, 4 / 9, 4 / 9, 3.5],
].map((value) => value.toFixed(14)));

// Motions: the bodies meet within the fourth leaf of eight, and again in the last one.
const rest = [1, 0, 0, 0, 0, 0, 0];
const slide: Motion = {
    ...{ end: "contact", until: "end", depth: 3, t0: 2, t1: 3, event: 3, bound: null },
    runs: [
        { state: "free", first: 0, count: 2, event_first: null, event_last: null },
        { state: "open", first: 2, count: 3, event_first: 3, event_last: 4 },
        { state: "free", first: 5, count: 1, event_first: null, event_last: null },
        { state: "open", first: 6, count: 1, event_first: null, event_last: null },
    ],
    from: { a: rest, b: [1, 0, 0, 0, 2, 0, 0] },
    to: { a: rest, b: [1, 0, 0, 0, -2, 0, 0] },
};
const slideIntervals = intervalsOf(slide);
same("the parts of a motion's time", slideIntervals.map(({ from, to, kind }) => [8 * from, 8 * to, kind]), [
    ...[[0, 2, "free"], [2, 3, "open"], [3, 4, "event"], [4, 5, "open"]],
    ...[[5, 6, "free"], [6, 7, "open"], [7, 8, "unknown"]],
]);
same("what is known of a time", [0, 2, 2.5, 3, 4, 4.5, 5.5, 7.5].map((one) => knowledgeAt(slideIntervals, one / 8)), [
    ...["free", "open", "open", "event", "event", "open", "free", "unknown"],
]);
const toContact: Motion = {
    ...slide,
    until: "contact",
    runs: [slide.runs[0], { state: "open", first: 2, count: 1, event_first: 3, event_last: 3 }],
};
same("an event at an instant", intervalsOf(toContact).map(({ from, to, kind }) => [8 * from, 8 * to, kind]), [
    ...[[0, 2, "free"], [2, 3, "open"], [3, 3, "event"], [3, 8, "unknown"]],
]);
same("the path of an instant is a point", pathOf(toContact).map(({ points, kind }) => [points.length, kind]), [
    ...[[17, "free"], [9, "open"], [1, "event"], [41, "unknown"]],
]);
same("the ends of a path", [pathOf(slide)[0].points[0], pathOf(slide)[6].points.at(-1)], [[2, 0, 0], [-2, 0, 0]]);
const away: Motion = { ...slide, end: "free", event: null, t0: 8, t1: 8, runs: [{ ...slide.runs[0], count: 8 }] };
const undecidedMotion: Motion = { ...away, runs: [{ ...slide.runs[3], first: 0, count: 8 }] };
const wayOut: Motion = { ...slide, until: "free", end: "free", t0: 4, t1: 5, event: 4 };
same("motions are told", [slide, away, undecidedMotion, wayOut].map((one) => motionText(one, false)), [
    "first in contact between 0.25 and 0.375 of the way",
    "free throughout",
    "not decided where open",
    "free from 0.625 of the way on",
]);
same("a bracket of near bodies", motionText({ ...slide, t0: 3 }, true), "near at 0.375 of the way");
same("contacts belong to the event", [0.375, 0.4].map((tau) => timeText(slide, false, tau)), [
    "at 0.375 of the way: in contact; the event, contacts are drawn",
    "at 0.4 of the way: in contact; contacts are drawn at the event only",
]);
same("no event", timeText(undecidedMotion, false, 0.5), "at 0.5 of the way: open: not decided; no contacts to draw");
const atBegin = { pose_a: turn, pose_b: turn };
same("contacts that are shown", [null, 0.375, 0.5].map((tau) => hasContactsAt({ ...atBegin, motion: slide }, tau)), [true, true, false]);
same("contacts without a motion", hasContactsAt(atBegin, 0.5), true);
same("a motion starts at its event", [null, 0, 1].map((tau) => shownPose({ ...atBegin, motion: slide }, tau)[3]), [0.5, 2, -2]);
const both3 = { ...slide, from: { ...slide.from, a: [1, 0, 0, 0, 0, 4, 0] }, to: { ...slide.to, a: [1, 0, 0, 0, 0, 8, 0] } };
same("both bodies move", shownPose({ ...atBegin, motion: both3 }, 0.5).filter((_, i) => i % 4 === 3), [0, -6, 0]);
same("what is known has a colour", new Set((["free", "open", "event", "unknown"] as const).map((kind) => knowledgeCss(kind, false))).size, 4);
same("open is undecided", knowledgeCss("open", true), cssColour(numberOf("undecided")));
same("events are red or orange", [false, true].map((isNear) => knowledgeCss("event", isNear)), [cssColour(2), cssColour(numberOf("near"))]);

// A grid of 2 x 4: y varies fastest.
const axis = (name: string, count: number) => ({ name, first: 0, last: count - 1, count });
const grid = new Grid([axis("x", 2), axis("y", 4)], "m");
same("numbers of a scenario", [grid.numberOf(0, 6), grid.numberOf(1, 6)], [1, 2]);
const cells = gridCells(grid, results, 0, 1, [0, 0]);
for (let scenario = 0; scenario < 8; ++scenario) {
    const [x, y] = [(grid.numberOf(0, scenario) + 0.5) / 2, (grid.numberOf(1, scenario) + 0.5) / 4];
    same(`the cell of scenario ${scenario}`, cells.at(x, y)?.scenario, scenario);
}

// Axes by value: a number has a short value that leads back to it.
const fine = new Grid([axis("x", 1), { name: "yaw", first: -1, last: 1, count: 30001 }], "m");
same("numbers by value", [0, 1, 7777, 15000, 30000].map((one) => fine.nearest(1, fine.brief(1, one))), [0, 1, 7777, 15000, 30000]);
same("a short value", new Grid([{ name: "z", first: 0, last: 1, count: 11 }], "m").brief(0, 3), 0.3);
same("values beyond an axis", [fine.nearest(1, -9), fine.nearest(1, 9), fine.nearest(0, 3)], [0, 30000, 0]);

// Slices of a grid of 200 x 300 x 400, in windows of 65,536.
const block = new Grid([axis("x", 200), axis("y", 300), axis("yaw", 400)], "m");
const scenariosAt = (x: number, y: number, fixed: number[]) => scenariosOfSlice(block, x, y, fixed) ?? new Float64Array();
same("the fastest axes are one window", windowsOf(scenariosAt(1, 2, [7, 0, 0]).subarray(0, 65536)), [{ first: 840000, count: 65536 }]);
same("a slice that lies apart", windowsOf(scenariosAt(0, 1, [0, 0, 5])), null);
const lines = scenariosAt(2, 0, [0, 8, 0]).subarray(0, 800);
same("lines far apart", windowsOf(lines), [{ first: 3200, count: 400 }, { first: 123200, count: 400 }]);
const slow = [scenariosAt(2, 1, [3, 0, 0]), scenariosAt(0, 2, [0, 299, 0]), scenariosAt(1, 1, [199, 0, 399])];
for (const [i, found] of slow.entries()) {
    const expected = Array.from({ length: 200 * 300 * 400 }, (_, scenario) => scenario).filter((scenario) =>
        [[0, 3], [1, 299], [0, 199]].every(([along, number], k) => k !== i || block.numberOf(along, scenario) === number) &&
        (i !== 2 || block.numberOf(2, scenario) === 399),
    );
    same(`slice ${i}`, found.length === expected.length && expected.every((scenario, k) => found[k] === scenario), true);
}
const sliced = new Results(0, 24_000_000, new Uint8Array([0, 2]), null, Float64Array.of(840000, 840001));
same("a slice's scenarios", [sliced.scenarioAt(1), sliced.isExact, sliced.isSample], [840001, false, false]);
same("a slice as cells", gridCells(block, sliced, 2, 1, [7, 0, 0]).at(1.5 / 400, 0)?.scenario, 840001);

// The strip's windows.
same("zoom about a mark", zoomed([0, 1000], 750, true, 1000), [375, 875]);
same("zoom out at an edge", zoomed([0, 100], 0, false, 1000), [0, 200]);
same("zoom out of all", zoomed([0, 1000], 10, false, 1000), [0, 1000]);
for (let mark = 400; mark < 500; ++mark) {
    const window = [0, 1, 2, 3, 4, 5, 6, 7].reduce((range) => zoomed(range, mark, true, 1000), [400, 500] as readonly [number, number]);
    same(`zoom down to ${mark}`, window, [mark, mark + 1]);
}
same("a mark beyond the edge", [panned([100, 200], 200, 1000), panned([100, 200], 150, 1000)], [[150, 250], [100, 200]]);

// Coordinates of poses: B in A's frame.
const both = [...turn, ...compose(turn, [1, 0, 0, 1, 0, 1, 0, 2, 0, 0, 1, 3])];
const coordinates = new Map([["x", new Float64Array(2)], ["distance", new Float64Array(2)]] as const);
addRows(coordinates, both, 24, 1);
addRows(coordinates, turn, 12, 0);
same("coordinates", [...(coordinates.get("x") ?? [])], [5, 1]);
same("distances", coordinates.get("distance")?.[1].toFixed(6), Math.sqrt(14).toFixed(6));
const spread = new Map([["x", Float64Array.of(0, 9)], ["z", Float64Array.of(1, 3)], ["yaw", Float64Array.of(0, 90)]] as const);
same("the coordinates that differ most", bestCoordinates(spread), ["x", "z"]);

// A sign for each class.
function strokesOf(kind: number): string {
    const strokes: string[] = [];
    const note = (name: string) => (...numbers: unknown[]) =>
        void strokes.push(`${name} ${numbers.map((one) => Number(one).toFixed(2))}`);
    traceGlyph({ moveTo: note("to"), lineTo: note("line"), arc: note("arc"), rect: note("rect") }, kind, 0, 0, 1);
    return strokes.join(";");
}
same("each class has its sign", new Set([0, 1, 2, 3, 4, 5, 6, 7, 255].map(strokesOf)).size, 9);

// Wilson's interval: 10 of 100 is 5.5 % to 17.4 %.
same("wilson", wilson(10, 100).map((share) => share.toFixed(3)), ["0.055", "0.174"]);

// Heat: the scale's ends, and never.
same("heat", [heatByte(0, 9), heatByte(1, 9), heatByte(9, 9), heatByte(1, 1)], [0, 1, 255, 255]);

// Contacts: the worst class of a triangle counts.
const pairs = new Uint32Array([4, 7, 1, 4, 8, 3, 5, 8, 2]);
same("highlights", highlightsOf(pairs, () => true).map((one) => [...one]), [[[4, 3], [5, 2]], [[7, 1], [8, 3]]]);
same("a part alone", highlightsOf(pairs, (a) => a === 5).map((one) => [...one]), [[[5, 2]], [[8, 2]]]);

// Near pairs: better than contacts; their two points are a gap, not a shared segment.
const mixed = new Uint32Array([4, 7, 4, 4, 8, 1, 5, 8, 4]);
same("near highlights", highlightsOf(mixed, () => true).map((one) => [...one]), [[[4, 1], [5, 4]], [[7, 4], [8, 1]]]);
const gapPoints = new Float64Array([0, 1, 1, 1, 0, 1, 1, 2, 1, 5, 5, 5, 2, 0, 0, 0, 2, 0, 0, 1]);
const shapesIn = (kindOf: (pair: number) => number | null) => shapesOf(gapPoints, (point) => point, kindOf);
same("gaps", shapesIn((pair) => mixed[3 * pair + 2]), { segments: [], points: [5, 5, 5], gaps: [1, 1, 1, 1, 1, 2, 0, 0, 0, 0, 0, 1] });
same("a gap that is not shown", shapesIn((pair) => (pair === 2 ? 4 : null)).gaps, [0, 0, 0, 0, 0, 1]);
same("shared segments", shapesIn(() => 3).segments.length, 12);
const wholeBody = [parts, parts] as const;
const soughtIn = (seek: "contact" | "near" | "either", one: Uint32Array) =>
    hasPairOf(one, { partA: "", partB: "piece 2", seek, bodies: [0, 1] }, wholeBody, [0, 1]);
same("pairs that are sought", (["contact", "near", "either"] as const).map((seek) => soughtIn(seek, new Uint32Array([9, 0, 4]))), [false, true, true]);
same("contacts that are sought", soughtIn("near", new Uint32Array([9, 0, 1])), false);
const ofScene = { partA: "", partB: "piece 2", seek: "contact", bodies: [3, 5] } as const;
const onSides = (of: [number, number]) => hasPairOf(new Uint32Array([0, 4, 1]), ofScene, wholeBody, of);
same("a part of a body that is A, B or neither", [onSides([5, 7]), onSides([3, 5]), onSides([3, 7])], [true, false, false]);

// Picks: parallel triangles at z = 1, 2, 3.
const corners = new Float32Array([1, 2, 3].flatMap((z) => [-1, -1, z, 3, -1, z, -1, 3, z]));
const ray = { origin: [0, 0, 5] as Vec3, direction: [0, 0, -1] as Vec3 };
same("the nearest triangle", nearestTriangle(corners, ray, () => false), { triangle: 2, distance: 2 });
same("behind a section", nearestTriangle(corners, ray, (distance) => distance < 2.5)?.triangle, 1);
same("beside all", nearestTriangle(corners, { ...ray, origin: [9, 9, 5] }, () => false), null);

// The scenarios of a job, and of a report.
const four = new Scenarios(4);
same("all places", [four.count, four.at(-1), four.at(2), four.at(9), four.placeOf(9)], [4, 0, 2, 3, 3]);
const worst = new Scenarios(100, [40, 7, 90]);
same("chosen places", [worst.count, worst.at(-1), worst.at(1), worst.at(9)], [3, 7, 40, 90]);
same("places of scenarios", [7, 40, 0, 60, 99].map((one) => worst.placeOf(one)), [0, 1, 0, 1, 2]);

// The answers in a report.
async function packed(text: string): Promise<string> {
    const stream = new Blob([text]).stream().pipeThrough(new CompressionStream("gzip"));
    return btoa(String.fromCharCode(...new Uint8Array(await new Response(stream).arrayBuffer())));
}
const words = await packed("words");
const heldBlock = (cut: boolean) => ({ base64: () => words, cut });
const held = new HeldAnswers(
    new Map([
        ["jobs/j-1/scenarios/7", heldBlock(false)],
        ["jobs/j-1/scenarios/7/pairs", heldBlock(true)],
        ["jobs/j-1/scenarios/3", heldBlock(false)],
    ]),
);
same("held scenarios", held.scenarios, [7, 3]);
const answered = await held.answer("jobs/j-1/scenarios/7/pairs");
same("a held answer", [new TextDecoder().decode(answered.bytes), answered.cut], ["words", true]);
const missing = await held.answer("jobs/j-1/scenarios/4").catch((error) => error.status);
same("what a report lacks", missing, 404);

// Words.
same("groups of digits", grouped(1234567), "1\u202f234\u202f567");
same("shares", [percent(0.061), percent(0), percent(0.00001)], ["6.1\u202f%", "0\u202f%", "<\u202f0.1\u202f%"]);
same("a part of a whole", bytesOf(1.8 * 2 ** 30, 4 * 2 ** 30), "1.8 of 4.00\u202fGiB");
same("a tiny part of a whole", bytesOf(2048, 2 ** 30), "2.00\u202fKiB of 1.00\u202fGiB");
same("a word for the shell", [shellWord("/tmp/out"), shellWord("it's here")], ["/tmp/out", "'it'\\''s here'"]);

finish();
