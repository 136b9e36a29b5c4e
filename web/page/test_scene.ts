/** Tests of what the page computes of scenes of many bodies. */
import { classNames } from "./src/base/classes";
import type { Pose, Vec3 } from "./src/base/types";
import { splitPart } from "./src/base/part_name";
import { sceneParts } from "./src/job/groups";
import { Results } from "./src/job/results";
import { bodyNumber, noFilter, readFilter, readRange, writeFilter } from "./src/scene/filter";
import { MeshStore } from "./src/scene/meshes";
import { boxCornersOf } from "./src/scene/others_view";
import { sceneEpisodesOf } from "./src/scene/scene_episodes";
import { SceneRows, sumsByBody, topBodies } from "./src/scene/scene_rows";
import { bestRow, drawnTrianglesMax, formOf, movingPosesOf, othersMax, othersOf, posesOf } from "./src/scene/step_bodies";
import { othersText, pairsOfStep } from "./src/scene/step_pairs";
import { Steps } from "./src/scene/steps";
import { isNearEvent } from "./src/motion/motion";
import { same } from "./test_tools";

const kind = (name: (typeof classNames)[number]) => classNames.indexOf(name);

// Steps: the second and the last have no scenarios.
const steps = new Steps([0, 3, 3, 5], [0, 0.5, 1, 1.5], 5);
same("a step's scenarios", steps.rangeOf(0), [0, 3]);
same("a step without scenarios", steps.rangeOf(1), [3, 3]);
same("the last step", steps.rangeOf(3), [5, 5]);
same("some steps", steps.rangeOf(1, 2), [3, 5]);
same("the next step with scenarios", [steps.nearest(1, 1), steps.nearest(1, -1)], [2, 0]);
same("beyond the last step", [steps.nearest(9, 1), steps.nearest(-4, -1)], [2, 0]);
same("no step has scenarios", new Steps([0, 0], [0, 1], 0).nearest(0, 1), -1);
same("steps that exist", steps.within([2, 99]), [2, 3]);

// Filters in links.
const filter = { body: "car.3", steps: [4, 9] as const };
same("a link holds the filter", readFilter(new URLSearchParams(writeFilter(filter))), filter);
same("a plain link", writeFilter(noFilter), {});
same("one step", readRange("7"), [7, 7]);
same("ranges that mean nothing", [readRange("9-3"), readRange("x"), readRange(null), readRange("1-2-3")], [null, null, null, null]);
const named = [{ name: "car.0" }, { name: "car.1" }, { name: "0" }];
same("a body by its name", bodyNumber(named, "car.1"), 1);
same("a body by its number", bodyNumber(named, "1"), 1);
same("a name is meant before a number", bodyNumber(named, "0"), 2);
same("no such body", [bodyNumber(named, "3"), bodyNumber(named, "car"), bodyNumber(named, "-1")], [-1, -1, -1]);

// One step: bodies 0, 2 and 5 in two scenarios.
const rows = [4, 0, 2, 4, 2, 5];
const poseAt = (x: number): Pose => [1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, 0];
const poses = posesOf(rows, [...poseAt(1), ...poseAt(2), ...poseAt(2), ...poseAt(3)]);
same("each body has one pose", [...poses.keys()], [0, 2, 5]);
same("the pose of the body", poses.get(5)?.(0.5), poseAt(3));
const key = (x: number) => [1, 0, 0, 0, x, 0, 0];
const moving = movingPosesOf(rows, [...key(1), ...key(2), ...key(5), ...key(2), ...key(2), ...key(3), ...key(2), ...key(9)]);
same("a body moves with the step", [0, 0.25, 1].map((tau) => moving.get(0)?.(tau)[3]), [1, 2, 5]);
same("each body moves as its first scenario says", [2, 5].map((body) => moving.get(body)?.(0.5)[3]), [2, 6]);
const turned = [0, 0, 0, 2, 0, 0, 0]; // Half a turn about z, with another length.
const turning = movingPosesOf([0, 0, 1], [...key(0), ...key(0), ...turned, ...key(0)]).get(0)?.(0.5) ?? [];
const [w, z] = [0.5, 1];
same("a body turns as a motion of a pair does", turning[0], 1 - (2 / (w * w + z * z)) * z * z);
same("the other bodies", othersOf({ poses }, [2, 5]), [0]);
same("the same pair", bestRow(rows, [2, 5], -1), 1);
same("else of the body that is wanted", bestRow(rows, [0, 1], 5), 1);
same("else the first", bestRow(rows, [0, 1], 7), 0);
const small = { triangles: 10 };
const some = Array.from({ length: othersMax + 3 }, () => small);
const numbers = some.map((_, i) => i);
same("nothing else is there", formOf(some, [0, 1], []), "none");
same("as many as meshes are drawn of", formOf(some, [0, 1], numbers.slice(2, othersMax + 2)), "meshes");
same("one too many", formOf(some, [0, 1], numbers.slice(2)), "boxes");
same("too many triangles", formOf([small, small, { triangles: drawnTrianglesMax }], [0, 1], [2]), "boxes");
const stepPairs = { rows, classes: [kind("separate"), kind("cross")] };
const letters = ["a", "b", "car", "d", "e", "wall"].map((name) => ({ name }));
same("the worst pair comes first", pairsOfStep(stepPairs, letters, ""), [1, 0]);
same("pairs of a body", [pairsOfStep(stepPairs, letters, "WAL"), pairsOfStep(stepPairs, letters, "b")], [[1], []]);
const shown = { form: "meshes", count: 3, boxes: 0, error: "" } as const;
same("what is said of the others", othersText(shown, false), "3 other bodies near another at this step, faint.");
same("a report without a mesh", othersText({ ...shown, boxes: 2 }, false).endsWith("Of 2 this report has no mesh, so boxes are drawn."), true);

// The groups of a scene name parts with their bodies.
const bodiesOfGroups = new Set(["car.0", "hall/door", "wall"]);
same("a body and its part", splitPart("car.0/wheel/left", bodiesOfGroups), { body: "car.0", part: "wheel/left" });
same("a body with a slash", splitPart("hall/door/leaf", bodiesOfGroups), { body: "hall/door", part: "leaf" });
same("no body of the scene", splitPart("lorry/wheel", bodiesOfGroups), null);
same("the link of a group", sceneParts(bodiesOfGroups, { a: "car.0/wheel", b: "hall/door/le*f" }), { part: "car.0/wheel", with: "hall\\/door/le\\*f" });

// A box from 1 to 3 along x, moved by 10.
const corners = boxCornersOf({ pose: poseAt(10), low: [1, 0, 0], size: [2, 1, 1] });
same("corners of a box", [corners[0], corners[1], corners[7]], [[11, 0, 0], [13, 0, 0], [13, 1, 1]] satisfies Vec3[]);

// All scenarios of a scene: body 1 is in contact with 0 at steps 0, 1 and 3, body 2 is near 1 at step 1.
const places = [0, 0, 1, 1, 0, 1, 1, 1, 2, 2, 0, 1, 3, 0, 1];
const kinds = Uint8Array.from([kind("cross"), kind("touch"), kind("near"), kind("separate"), kind("cross")]);
const results = new Results(0, 5, kinds, new Uint32Array([4, 9, 2, 0, 6]));
const all = new SceneRows(results, places, 5);
same("all rows are there", all.areAll, true);
same("scenarios of a body", all.chosen(2, null), [2]);
same("scenarios of some steps", all.chosen(-1, [1, 2]), [1, 2, 3]);
same("of a body and some steps", all.chosen(0, [2, 3]), [3, 4]);
const chosen = all.resultsOf([1, 4]);
same("chosen results", [chosen.scenarioAt(1), chosen.classes[1], chosen.countAt(1)], [4, kind("cross"), 6]);
same("chosen results are no sample", [chosen.isSample, chosen.isExact], [false, false]);
const sums = sumsByBody(all, 4);
same("sums of a body", sums[1], { body: 1, scenarios: 5, contacts: 3, near: 1, worst: 4 });
same("a body that is never there", sums[3], { body: 3, scenarios: 0, contacts: 0, near: 0, worst: -1 });
const names = ["car.0", "car.1", "wall", "Wall.2"];
same("bodies in most contacts, then near", topBodies(sums, names, "", 2).map(({ body }) => body), [1, 0]);
same("bodies by name", topBodies(sums, names, "WALL", 9).map(({ body }) => body), [2, 3]);
const free = { bodies: [{ fixed: false }, { fixed: false }, { fixed: false }], steps: 4 };
const episodes = sceneEpisodesOf(all, free, 9);
same("episodes of pairs", episodes.listed.map(({ pair, first, last }) => [pair, first, last]), [[[0, 1], 0, 1], [[1, 2], 1, 1], [[0, 1], 3, 3]]);
same("the worst of an episode", episodes.listed[0].worst, 0);
same("more episodes than are listed", [sceneEpisodesOf(all, free, 1).count, sceneEpisodesOf(all, free, 1).listed.length], [3, 1]);
const rest = new SceneRows(new Results(0, 1, kinds.slice(0, 1), null), [0, 0, 1], 1);
const fixed = sceneEpisodesOf(rest, { bodies: [{ fixed: true }, { fixed: true }], steps: 4 }, 9);
same("fixed bodies touch at all steps", [fixed.listed[0].first, fixed.listed[0].last], [0, 3]);

// A sample of two of four scenarios, of which all results are known.
const sampled = new SceneRows(new Results(0, 4, kinds.slice(0, 4), null), [0, 0, 1, 1, 1, 2], 4);
same("a sample of rows", [sampled.areAll, sampled.elementOf(1), sampled.classOf(1)], [false, 2, kind("near")]);

// Meshes are read once, and the oldest are dropped.
const asked: string[] = [];
const store = new MeshStore(25, (sha256) => {
    asked.push(sha256);
    return new Promise(() => undefined);
});
for (const sha256 of ["a", "b", "a", "c", "b"]) {
    void store.get({ sha256, triangles: 10 });
}
same("a mesh is read once while it is kept", asked, ["a", "b", "c", "b"]);

// The event of a motion with a clearance, also where one body is inside the other.
same("near events", (["near", "inside", "cross", null] as const).map((one) => isNearEvent({ class: one })), [true, true, false, false]);
