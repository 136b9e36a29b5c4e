/** Tests of the page's parts that need no browser: `npm test`. */
import { HeldAnswers } from "./src/base/held";
import { parseMesh, partOf } from "./src/base/mesh";
import { parseNpy } from "./src/base/npy";
import { apply, compose, inverse, placementOf } from "./src/base/pose";
import { parseRoute, scenarioLink } from "./src/base/route";
import type { Vec3 } from "./src/base/types";
import { bytesOf, grouped, percent, shellWord } from "./src/base/words";
import { episodesOf } from "./src/job/episodes";
import { Grid, gridCells } from "./src/job/grid";
import { wilson } from "./src/job/groups";
import { binsOf } from "./src/job/histogram";
import { Results } from "./src/job/results";
import { worstInBins } from "./src/job/strip";
import { highlightsOf } from "./src/viewer/contacts_view";
import { heatByte } from "./src/viewer/heat";
import { nearestTriangle } from "./src/viewer/pick";
import { Scenarios } from "./src/viewer/scenarios";
import { readState, startState, writeState } from "./src/viewer/view_state";

let failures = 0;

function same(name: string, found: unknown, expected: unknown): void {
    const [one, other] = [JSON.stringify(found), JSON.stringify(expected)];
    if (one !== other) {
        failures += 1;
        console.log(`FAILED ${name}: ${one} is not ${other}`);
    }
}

function refuses(name: string, action: () => unknown): void {
    try {
        action();
    } catch {
        return;
    }
    failures += 1;
    console.log(`FAILED ${name}: was accepted`);
}

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

// Meshes: one triangle, parts `p` and an empty name.
function meshBytes(): ArrayBuffer {
    const bytes = new ArrayBuffer(29 + 36 + 12 + 13 + 12);
    const view = new DataView(bytes);
    [0, 0x43, 0x44, 0x4d, 0x45, 0x53, 0x48, 0x31, 0].forEach((byte, i) => view.setUint8(i, byte));
    view.setBigUint64(9, 3n, true);
    view.setBigUint64(17, 1n, true);
    view.setUint32(25, 2, true);
    [0, 0, 0, 2, 0, 0, 0, 4, 0].forEach((value, i) => view.setFloat32(29 + 4 * i, value, true));
    [0, 1, 2].forEach((value, i) => view.setUint32(65 + 4 * i, value, true));
    view.setUint32(77, 1, true);
    view.setUint8(81, "p".charCodeAt(0));
    view.setUint32(86, 1, true);
    view.setUint32(94, 1, true);
    view.setUint32(98, 1, true);
    return bytes;
}
const mesh = parseMesh(meshBytes(), "", true);
same("box", [mesh.min, mesh.max, mesh.centre], [[0, 0, 0], [2, 4, 0], [1, 2, 0]]);
same("part", [partOf(mesh, 0)?.name, partOf(mesh, 1)?.name], ["p", undefined]);
for (let length = 0; length < meshBytes().byteLength; ++length) {
    refuses(`a mesh of ${length} bytes`, () => parseMesh(meshBytes().slice(0, length), "", true));
}

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
};
const link = scenarioLink("j-1", 7, writeState(seen));
same("a link holds all that is seen", readState(parseRoute(link).query, () => true), seen);
same("a plain view has a plain link", scenarioLink("j-1", 7, writeState(startState)), "#/jobs/j-1/7");
const wrong = new URLSearchParams("mode=x&clip=w:1&cam=1,2&pick=c:1&ghost=q");
same("values that mean nothing are ignored", readState(wrong, () => true), startState);
same("a part that A lacks is one of B", readState(new URLSearchParams("part=post"), () => false).partB, "post");
same("no such screen", parseRoute("#/jobs/j-1/x").screen, "none");

// Results: scenarios 0 to 7.
const kinds = new Uint8Array([0, 1, 2, 0, 2, 2, 255, 3]);
const results = new Results(0, 8, kinds, new Uint32Array([0, 4, 9, 0, 1, 70, 0, 0]));
same("episodes", episodesOf(results).map((one) => [one.first, one.last, one.worst]), [[1, 2, 2], [4, 5, 5], [7, 7, 7]]);
same("the worst of bins", [...worstInBins(results, 0, 8)], [0, 1, 2, 3, 4, 5, 6, 7]);
same("the worst of all", results.worst(), 5);
same("a sample", new Results(0, 100, kinds, null).scenarioAt(3), 37);
same("histogram", binsOf(new Uint32Array([0, 1, 2, 3, 4])).map((bin) => bin.count), [1, 2, 1]);

// A grid of 2 x 4: y varies fastest.
const axis = (name: string, count: number) => ({ name, first: 0, last: count - 1, count });
const grid = new Grid([axis("x", 2), axis("y", 4)], "m");
same("numbers of a scenario", [grid.numberOf(0, 6), grid.numberOf(1, 6)], [1, 2]);
const cells = gridCells(grid, results, 0, 1, [0, 0]);
for (let scenario = 0; scenario < 8; ++scenario) {
    const [x, y] = [(grid.numberOf(0, scenario) + 0.5) / 2, (grid.numberOf(1, scenario) + 0.5) / 4];
    same(`the cell of scenario ${scenario}`, cells.at(x, y)?.scenario, scenario);
}

// Wilson's interval: 10 of 100 is 5.5 % to 17.4 %.
same("wilson", wilson(10, 100).map((share) => share.toFixed(3)), ["0.055", "0.174"]);

// Heat: the scale's ends, and never.
same("heat", [heatByte(0, 9), heatByte(1, 9), heatByte(9, 9), heatByte(1, 1)], [0, 1, 255, 255]);

// Contacts: the worst class of a triangle counts.
const pairs = new Uint32Array([4, 7, 1, 4, 8, 3, 5, 8, 2]);
same("highlights", highlightsOf(pairs, () => true).map((one) => [...one]), [[[4, 3], [5, 2]], [[7, 1], [8, 3]]]);
same("a part alone", highlightsOf(pairs, (a) => a === 5).map((one) => [...one]), [[[5, 2]], [[8, 2]]]);

// Picks: parallel triangles at z = 1, 2, 3.
const corners = new Float32Array([1, 2, 3].flatMap((z) => [-1, -1, z, 3, -1, z, -1, 3, z]));
const ray = { origin: [0, 0, 5] as Vec3, direction: [0, 0, -1] as Vec3 };
same("the nearest triangle", nearestTriangle(corners, ray, () => false), { triangle: 2, distance: 2 });
same("behind a section", nearestTriangle(corners, ray, (distance) => distance < 2.5)?.triangle, 1);
same("beside all", nearestTriangle(corners, { ...ray, origin: [9, 9, 5] }, () => false), null);

// The scenarios of a job, and of a report.
const all = new Scenarios(4);
same("all places", [all.count, all.at(-1), all.at(2), all.at(9), all.placeOf(9)], [4, 0, 2, 3, 3]);
const worst = new Scenarios(100, [40, 7, 90]);
same("chosen places", [worst.count, worst.at(-1), worst.at(1), worst.at(9)], [3, 7, 40, 90]);
same("places of scenarios", [7, 40, 0, 60, 99].map((one) => worst.placeOf(one)), [0, 1, 0, 1, 2]);

// The answers in a report.
async function packed(text: string): Promise<string> {
    const stream = new Blob([text]).stream().pipeThrough(new CompressionStream("gzip"));
    return btoa(String.fromCharCode(...new Uint8Array(await new Response(stream).arrayBuffer())));
}
const words = await packed("words");
const block = (cut: boolean) => ({ base64: () => words, cut });
const held = new HeldAnswers(
    new Map([
        ["jobs/j-1/scenarios/7", block(false)],
        ["jobs/j-1/scenarios/7/pairs", block(true)],
        ["jobs/j-1/scenarios/3", block(false)],
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

if (failures > 0) {
    throw new Error(`${failures} failed`);
}
console.log("all of the page's parts do what they say");
