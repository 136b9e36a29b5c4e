import { Box3, Matrix4, Sphere, Vector3 } from "three";
import type { Rgb } from "../base/classes";
import { apply, inverse, relativePose } from "../base/pose";
import { styleColour } from "../base/theme";
import type { Pose, Vec3 } from "../base/types";
import { hasContactsAt, isNearEvent, pathOf, shownPose, shownPoses, shownTime } from "../motion/motion";
import { PathView } from "../motion/path_view";
import { BodyView } from "./body_view";
import { ContactsView, type Highlight, highlightsOf, proper } from "./contacts_view";
import { heatBytes } from "./heat";
import type { HitKind, Hits } from "./hits";
import type { Model } from "./model";
import type { Ray } from "./pick";
import { PickMark } from "./pick_mark";
import { ballOf, boxAround, hiddenBy, pickAmong } from "./picking";
import type { Contacts } from "./scenario_loader";
import { type OtherBody, OthersView } from "../scene/others_view";
import { ShotsView } from "./shots_view";
import { clipPlane, Stage } from "./stage";
import { isSameView, type Pick, type ViewState } from "./view_state";

const grey: Rgb = [186, 190, 196];
const blue: Rgb = [100, 138, 186];
const linePixels = 8; // How near to a hit a click picks its line.
const identity: Pose = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0];

function bodiesOf({ meshes }: Model): [BodyView, BodyView] {
    return [new BodyView(meshes[0], grey), new BodyView(meshes[1], blue)];
}

function shotsOf({ meshes, closed }: Model): ShotsView | null {
    return closed ? new ShotsView(meshes[1]) : null;
}

/**
 * Both bodies and their contacts, drawn in A's frame about the centre of A's box; of a scene also the other
 * bodies of the step. Poses are composed in double; what the graphics card gets is single precision.
 */
export class Viewer {
    readonly stage: Stage;
    bodies: [BodyView, BodyView];
    /** How many lines between nearest points are drawn. */
    gaps = 0;
    readonly others = new OthersView();
    private readonly contactsView = new ContactsView();
    private shotsView: ShotsView | null;
    private readonly pathView = new PathView();
    private readonly mark = new PickMark();
    private matrices: [Matrix4, Matrix4] = [new Matrix4(), new Matrix4()];
    private highlights: [Highlight, Highlight] = [new Map(), new Map()];
    private contacts: Contacts | null = null;
    private state: ViewState | null = null;
    private fitted: Sphere | null = null; // What the view was fitted to.
    private isOtherPair = false;
    private radius = 1; // Of the ball about the origin that holds both bodies.
    private freshAt = -1; // The scenario that, opened anew, would be seen as it is.

    constructor(
        private readonly canvas: HTMLCanvasElement,
        private model: Model,
        moved: () => void,
        drawn: () => void,
    ) {
        this.stage = new Stage(canvas, moved, drawn);
        this.bodies = bodiesOf(model);
        this.shotsView = shotsOf(model);
        this.refreshTheme();
    }

    /** Draws two other bodies from the next scenario on, which is fitted into the view. */
    use(model: Model): void {
        if (model === this.model) {
            return;
        }
        [...this.bodies, this.shotsView].forEach((view) => view?.dispose());
        this.model = model;
        this.bodies = bodiesOf(model);
        this.shotsView = shotsOf(model);
        this.others.bodies = [];
        [this.fitted, this.isOtherPair] = [null, true];
    }

    /** Draws these bodies beside the pair, at the time that is shown. */
    showOthers(others: readonly OtherBody[]): void {
        this.others.bodies = others;
        this.placeOthers();
        this.stage.draw();
    }

    private placeOthers(): void {
        if (this.contacts && this.state) {
            const { scenario } = this.contacts;
            const toA = inverse(shownPoses(scenario, this.state.tau).pose_a);
            this.others.place(toA, this.origin, shownTime(scenario, this.state.tau));
        }
        this.stage.setRadius(Math.max(this.radius, this.others.reach));
    }

    /** Returns the number of the faint body at a pixel at which no triangle of the pair is; null if there is none. */
    otherAt(x: number, y: number): number | null {
        const isFree = this.others.group.visible && this.pickAt(x, y, false) === null;
        const ray = this.stage.rayAt(x, y);
        return isFree ? this.others.bodyAt(ray, hiddenBy(this.state?.clip, this.origin, ray)) : null;
    }

    refreshTheme(): void {
        this.stage.setBackground(styleColour("--stage", this.canvas));
    }

    show(contacts: Contacts, state: ViewState): void {
        this.contacts = contacts;
        this.placeBodies(contacts, state);
        this.showPath(contacts);
        this.radius = this.reachOfB() + this.bodies[1].radius + this.bodies[0].radius;
        this.refreshContacts(state);
        this.state = state;
        this.placeOthers();
        this.applyState(state);
        if (this.isOtherPair || (!state.camera && !this.isInView())) {
            this.fit(this.fitted === null);
        }
        this.isOtherPair = false;
    }

    private placeBodies({ scenario }: Contacts, state: ViewState): void {
        this.matrices = [
            this.bodies[0].place(identity, this.origin),
            this.bodies[1].place(shownPose(scenario, state.tau), this.origin),
        ];
    }

    private showPath({ scenario }: Contacts): void {
        this.pathView.show(scenario.motion ? pathOf(scenario.motion) : [], this.origin, isNearEvent(scenario));
    }

    /** How far from A's centre B's centre is, or comes on its path at most. */
    private reachOfB(): number {
        const away = Math.hypot(...this.bodies[1].mesh.centre);
        const onPath = this.pathView.points.map((point) => Math.hypot(...point) + away);
        return Math.max(this.centreOfB().length(), ...onPath);
    }

    /** The point of A's frame about which all is drawn. */
    private get origin(): Vec3 {
        return this.model.meshes[0].centre;
    }

    private centreOfB(): Vector3 {
        return new Vector3().setFromMatrixPosition(this.matrices[1]);
    }

    private isShown(state: ViewState, a: number, b: number): boolean {
        const [partsA, partsB] = this.model.parts;
        return partsA.isOf(a, state.partA) && partsB.isOf(b, state.partB);
    }

    private refreshContacts(state: ViewState): void {
        if (!this.contacts) {
            return;
        }
        const { pairs, points, scenario } = this.contacts;
        if (this.contacts.hits && this.shotsView) {
            this.refreshHits(this.contacts, this.contacts.hits, this.shotsView, state);
            return;
        }
        const areOfTime = hasContactsAt(scenario, state.tau);
        const isShown = (a: number, b: number) => areOfTime && this.isShown(state, a, b);
        this.highlights = highlightsOf(pairs, isShown);
        const corners = [this.bodies[0].corners, this.bodies[1].corners] as const;
        this.contactsView.show(corners, this.highlights, this.matrices);
        this.gaps = this.contactsView.addPoints(points, inverse(scenario.pose_a), this.origin, (pair) =>
            isShown(pairs[3 * pair], pairs[3 * pair + 1]) ? pairs[3 * pair + 2] : null,
        );
    }

    /** Shows lines and hits; of the highlighted triangles only the places matter, they are not drawn. */
    private refreshHits({ scenario }: Contacts, hits: Hits, view: ShotsView, state: ViewState): void {
        const shown = hits
            .shown(state.onlyFirst)
            .filter((hit) => this.isShown(state, hits.triangleOf(hit), hits.lineOf(hit)));
        this.highlights = [new Map(shown.map((hit) => [hits.triangleOf(hit), proper])), new Map()];
        const pose = relativePose(scenario);
        view.show(hits, shown, (point) => apply(pose, point).map((value, i) => value - this.origin[i]) as Vec3);
    }

    /** Shows `state`; only its camera is left alone, which `view` sets. */
    setState(state: ViewState): void {
        const old = this.state;
        this.state = state;
        if (old && isSameView(old, state)) {
            return;
        }
        if (old && old.tau !== state.tau && this.contacts) {
            this.placeBodies(this.contacts, state);
            this.placeOthers();
            this.refreshContacts(state);
        }
        if (old && (old.partA !== state.partA || old.partB !== state.partB || old.onlyFirst !== state.onlyFirst)) {
            this.refreshContacts(state);
        }
        this.applyState(state);
    }

    private applyState(state: ViewState): void {
        const [a, b] = this.bodies;
        a.showAs(state.ghost === "a" ? "ghost" : "solid");
        b.showAs(state.ghost === "b" ? "ghost" : "solid");
        this.bodies.forEach((body) => body.showHeat(state.mode === "heat"));
        const axis = state.clip ? "xyz".indexOf(state.clip.axis) : 0;
        const planes = state.clip ? [clipPlane(state.clip.axis, state.clip.at - this.origin[axis])] : [];
        this.bodies.forEach((body) => body.clip(planes));
        this.contactsView.clip(planes);
        this.contactsView.group.visible = state.mode === "contacts";
        this.contactsView.lines.visible = state.lines;
        this.others.clip(planes);
        this.others.group.visible = state.others;
        this.pathView.clip(planes);
        this.pathView.group.visible = state.lines;
        if (this.shotsView) {
            this.shotsView.clip(planes);
            this.shotsView.group.visible = state.mode === "contacts" && state.lines;
        }
        this.mark.show(state.pick && this.bodies[state.pick.body].corners, state.pick, this.matrices);
        this.arrange(state);
    }

    isShowing(state: ViewState): boolean {
        return this.state === state;
    }

    /** Solid bodies, contacts, ghost, faint bodies; contacts through walls come last, without the others' depths. */
    private arrange(state: ViewState): void {
        const [a, b] = this.bodies;
        const solid = { objects: [a.solid, b.solid], forgetsDepth: false };
        const contacts = {
            objects: [this.contactsView.group, this.pathView.group, ...(this.shotsView ? [this.shotsView.group] : [])],
            forgetsDepth: state.throughWalls,
        };
        const ghost = { objects: [a.ghost, b.ghost], forgetsDepth: false };
        const others = { objects: [this.others.group], forgetsDepth: false };
        const mark = { objects: [this.mark.group], forgetsDepth: true };
        this.stage.setLayers(
            state.throughWalls ? [solid, ghost, others, contacts, mark] : [solid, contacts, ghost, others, mark],
        );
    }

    /** Gives each body's counts by triangle for the heat map; `most` is the largest of all. */
    setHeat(counts: readonly Float64Array[], most: number): void {
        counts.forEach((one, i) => this.bodies[i].setHeat(heatBytes(one, most)));
        this.stage.draw();
    }

    /** Returns the ball about both bodies, in the coordinates of the stage. */
    private ballAround(): Sphere {
        const ball = new Sphere(new Vector3(), this.bodies[0].radius);
        this.pathView.points.forEach((point) => ball.expandByPoint(new Vector3(...point)));
        return this.shotsView ? ball : ball.union(new Sphere(this.centreOfB(), this.bodies[1].radius));
    }

    private isInView(): boolean {
        const [ball, fitted] = [this.ballAround(), this.fitted];
        return fitted !== null && fitted.center.distanceTo(ball.center) + ball.radius <= fitted.radius * 1.001;
    }

    /** Looks at both bodies; from the first direction if `fresh`. */
    fit(fresh: boolean): void {
        this.fitted = this.ballAround();
        const seen = this.shotsView ? this.bodies.slice(0, 1) : this.bodies; // Lines begin far away.
        const corners = [...seen.flatMap((body, i) => body.boxCorners(this.matrices[i])), ...this.pathView.points];
        const box = new Box3().setFromPoints(corners.map((corner) => new Vector3(...corner)));
        this.stage.fit(box.getCenter(new Vector3()).toArray() as Vec3, corners, fresh);
        this.freshAt = this.stage.isAtStart ? (this.contacts?.scenario.index ?? -1) : -1;
    }

    /** Looks at the triangles of A in contact; at all if there are none. */
    goToContact(): void {
        if (this.highlights[0].size === 0) {
            this.fit(false);
            return;
        }
        const { centre, radius } = ballOf(this.bodies[0].corners, [...this.highlights[0].keys()]);
        const least = Math.min(this.bodies[0].radius, this.bodies[1].radius) / 12;
        this.stage.fit(centre.toArray() as Vec3, boxAround(centre, Math.max(radius, least)), false);
    }

    /** The camera in A's frame: eye and target, six numbers. */
    get view(): number[] {
        return this.stage.view.map((value, i) => value + this.origin[i % 3]);
    }

    /** The camera; null if this scenario, opened anew, would be seen so. */
    get ownView(): number[] | null {
        return this.contacts?.scenario.index === this.freshAt ? null : this.view;
    }

    set view(numbers: readonly number[]) {
        this.stage.view = numbers.map((value, i) => value - this.origin[i % 3]);
    }

    /** As `pickAt`, in the middle of the picture. */
    pickMiddle(prefersGhost: boolean): Pick | null {
        return this.pickAt(this.canvas.clientWidth / 2, this.canvas.clientHeight / 2, prefersGhost);
    }

    /**
     * Returns the triangle at a pixel: a contact that shows through walls, else the nearest of a solid
     * body, else of the ghost. With `prefersGhost` the ghost comes first.
     */
    pickAt(x: number, y: number, prefersGhost: boolean): Pick | null {
        const line = this.lineAt(x, y);
        if (line !== null) {
            return { body: 1, triangle: line };
        }
        const ray = this.stage.rayAt(x, y);
        const ghosts = [0, 1].filter((body) => this.bodies[body].ghost.visible);
        const solids = [0, 1].filter((body) => this.bodies[body].solid.visible);
        if (prefersGhost) {
            return this.pickAmong(ray, ghosts) ?? this.pickAmong(ray, solids);
        }
        const isContact = this.state?.throughWalls && this.state.mode === "contacts";
        return (
            (isContact ? this.pickAmong(ray, [0, 1], true) : null) ??
            this.pickAmong(ray, solids) ??
            this.pickAmong(ray, ghosts)
        );
    }

    /** Returns the line whose hit is drawn at a pixel; null if there is none. */
    private lineAt(x: number, y: number): number | null {
        const hits = this.contacts?.hits;
        if (!hits || !this.shotsView?.group.visible) {
            return null;
        }
        let least = linePixels;
        let found: number | null = null;
        for (const { hit, at } of this.shotsView.points) {
            const [px, py] = this.stage.pixelOf(at);
            const away = Math.hypot(px - x, py - y);
            if (away < least) {
                [least, found] = [away, hits.lineOf(hit)];
            }
        }
        return found;
    }

    private pickAmong(ray: Ray, bodies: readonly number[], onlyContacts = false): Pick | null {
        const targets = bodies.map((body) => ({
            body: body as 0 | 1,
            corners: this.bodies[body].corners,
            matrix: this.matrices[body],
            triangles: onlyContacts ? [...this.highlights[body].keys()] : null,
        }));
        return pickAmong(ray, targets, hiddenBy(this.state?.clip, this.origin, ray));
    }

    /** How many lines are drawn, and how many of them hit something. */
    get lines(): [number, number] {
        return this.shotsView?.lines ?? [0, 0];
    }

    /** Returns line, kind and pixel of the first hits that are drawn. */
    hitPixels(count: number): { line: number; kind: HitKind; pixel: [number, number] }[] {
        const hits = this.contacts?.hits;
        return (hits ? (this.shotsView?.points.slice(0, count) ?? []) : []).map(({ hit, at }) => ({
            line: hits?.lineOf(hit) ?? -1,
            kind: hits?.kindOf(hit) ?? "grazes",
            pixel: this.stage.pixelOf(at),
        }));
    }

    /** How many pieces of a path are drawn, and where B's centre is in A's frame. */
    get motion(): { pieces: number; centre: number[] } {
        const centre = this.centreOfB().toArray();
        return { pieces: this.pathView.group.children.length, centre: centre.map((value, i) => value + this.origin[i]) };
    }

    /** The triangles that are highlighted, of A and of B, in rising order. */
    get highlighted(): [number[], number[]] {
        return this.highlights.map((one) => [...one.keys()].sort((a, b) => a - b)) as [number[], number[]];
    }

    /** Returns where a point of A's frame is drawn, in pixels. */
    pixelOf(point: Vec3): [number, number] {
        return this.stage.pixelOf(point.map((value, i) => value - this.origin[i]) as Vec3);
    }

    /** Returns where a point of the world is drawn, in pixels. */
    pixelOfWorld(point: Vec3): [number, number] {
        const scenario = this.contacts?.scenario;
        return this.pixelOf(scenario ? apply(inverse(scenario.pose_a), point) : point);
    }

    dispose(): void {
        this.bodies.forEach((body) => body.dispose());
        this.contactsView.dispose();
        this.shotsView?.dispose();
        this.pathView.dispose();
        this.others.dispose();
        this.mark.dispose();
        this.stage.dispose();
    }
}
