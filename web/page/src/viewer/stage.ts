import {
    type Camera,
    Color,
    DirectionalLight,
    HemisphereLight,
    type Object3D,
    PerspectiveCamera,
    Plane,
    Scene,
    SRGBColorSpace,
    Vector2,
    Vector3,
    WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { Vec3 } from "../base/types";
import type { Ray } from "./pick";

const fitMargin = 1.08;
const startDirection = new Vector3(0.75, -1, 0.6).normalize();

function lit(): Scene {
    const scene = new Scene();
    scene.add(new HemisphereLight(0xffffff, 0x9aa0a6, 1.9));
    return scene;
}

/**
 * The canvas with its camera. Layers are drawn in their order; a layer may forget the depths of those
 * before it. Draws a frame when something changed, and only then.
 */
export class Stage {
    frames = 0;
    private readonly renderer: WebGLRenderer;
    private readonly camera = new PerspectiveCamera(35, 1, 0.01, 1000);
    private readonly controls: OrbitControls;
    private readonly lamp = new DirectionalLight(0xffffff, 2.3);
    private layers: { scene: Scene; forgetsDepth: boolean }[] = [];
    private readonly watcher: ResizeObserver;
    private isWaiting = false;
    private isPlacing = false;
    private radius = 1;

    /** Throws if the browser has no WebGL 2. `moved` hears of each change of the camera by hand. */
    constructor(
        private readonly canvas: HTMLCanvasElement,
        private readonly moved: () => void,
        private readonly drawn: () => void,
    ) {
        this.renderer = new WebGLRenderer({ canvas, antialias: true });
        this.renderer.outputColorSpace = SRGBColorSpace;
        this.renderer.autoClear = false;
        this.renderer.localClippingEnabled = true;
        this.camera.up.set(0, 0, 1);
        this.controls = new OrbitControls(this.camera, canvas);
        this.controls.enableDamping = false;
        this.controls.zoomToCursor = true;
        this.controls.addEventListener("change", this.change);
        canvas.addEventListener("webglcontextrestored", this.draw);
        this.watcher = new ResizeObserver(() => this.resize());
        this.watcher.observe(canvas);
        this.resize();
    }

    private readonly change = () => {
        this.draw();
        if (!this.isPlacing) {
            this.moved();
        }
    };

    /** Draws in the next frame. */
    readonly draw = () => {
        if (!this.isWaiting) {
            this.isWaiting = true;
            requestAnimationFrame(() => {
                this.isWaiting = false;
                this.render();
                this.drawn();
            });
        }
    };

    private resize(): void {
        const [width, height] = [this.canvas.clientWidth, this.canvas.clientHeight];
        if (width > 0 && height > 0) {
            this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
            this.renderer.setSize(width, height, false);
            this.camera.aspect = width / height;
            this.camera.updateProjectionMatrix();
            this.draw();
        }
    }

    setBackground(colour: string): void {
        this.renderer.setClearColor(new Color(colour));
        this.draw();
    }

    /** Gives the layers from back to front. */
    setLayers(layers: { objects: Object3D[]; forgetsDepth: boolean }[]): void {
        this.layers = layers.map(({ objects, forgetsDepth }) => {
            const scene = lit();
            scene.add(...objects);
            return { scene, forgetsDepth };
        });
        this.draw();
    }

    private render(): void {
        const distance = this.camera.position.distanceTo(this.controls.target);
        const reach = this.camera.position.length() + this.radius;
        this.camera.near = Math.max(distance / 500, (reach - 2 * this.radius) / 2, reach / 1e5);
        this.camera.near = Math.min(this.camera.near, distance / 2);
        this.camera.far = 2 * reach;
        this.camera.updateProjectionMatrix();
        this.lamp.position.copy(this.camera.position);
        this.lamp.target.position.copy(this.controls.target);
        this.renderer.clear();
        for (const { scene, forgetsDepth } of this.layers) {
            if (forgetsDepth) {
                this.renderer.clearDepth();
            }
            scene.add(this.lamp, this.lamp.target);
            this.renderer.render(scene, this.camera);
        }
        this.frames += 1;
    }

    /** Looks at `centre` from where all `points` are in view; keeps the direction unless `fresh`. */
    fit(centre: Vec3, points: readonly Vec3[], fresh: boolean): void {
        const target = new Vector3(...centre);
        const back = fresh
            ? startDirection.clone()
            : this.camera.position.clone().sub(this.controls.target).normalize();
        const right = new Vector3().crossVectors(this.camera.up, back).normalize();
        const up = new Vector3().crossVectors(back, right);
        const tall = Math.tan((this.camera.fov * Math.PI) / 360);
        const wide = tall * this.camera.aspect;
        let distance = 1e-9;
        for (const point of points) {
            const from = new Vector3(...point).sub(target);
            const aside = Math.max(Math.abs(from.dot(right)) / wide, Math.abs(from.dot(up)) / tall);
            distance = Math.max(distance, aside + from.dot(back));
        }
        this.look(target.clone().addScaledVector(back, fitMargin * distance), target);
    }

    /** Whether the camera looks in the first direction. */
    get isAtStart(): boolean {
        const from = this.camera.position.clone().sub(this.controls.target).normalize();
        return from.distanceTo(startDirection) < 1e-6;
    }

    private look(eye: Vector3, target: Vector3): void {
        this.isPlacing = true;
        this.controls.target.copy(target);
        this.camera.position.copy(eye);
        this.controls.update();
        this.isPlacing = false;
        this.draw();
    }

    /** Turns about the target, in radians: to the right and upwards. */
    turn(right: number, up: number): void {
        const target = this.controls.target;
        const from = this.camera.position.clone().sub(target);
        const distance = from.length();
        const azimuth = Math.atan2(from.y, from.x) + right;
        const polar = Math.min(Math.PI - 0.01, Math.max(0.01, Math.acos(from.z / distance) - up));
        const flat = distance * Math.sin(polar);
        from.set(flat * Math.cos(azimuth), flat * Math.sin(azimuth), distance * Math.cos(polar));
        this.look(from.add(target), target.clone());
        this.moved();
    }

    /** Comes nearer to the target, to this share of the distance. */
    approach(share: number): void {
        const target = this.controls.target;
        const from = this.camera.position.clone().sub(target).multiplyScalar(share);
        this.look(from.add(target), target.clone());
        this.moved();
    }

    /** Moves eye and target aside, in shares of their distance: to the right and upwards. */
    move(right: number, up: number): void {
        const target = this.controls.target;
        const distance = this.camera.position.distanceTo(target);
        this.camera.updateMatrix();
        const by = new Vector3()
            .addScaledVector(new Vector3().setFromMatrixColumn(this.camera.matrix, 0), right * distance)
            .addScaledVector(new Vector3().setFromMatrixColumn(this.camera.matrix, 1), up * distance);
        this.look(this.camera.position.clone().add(by), target.clone().add(by));
        this.moved();
    }

    /** The radius of all that may be drawn, about the origin. */
    setRadius(radius: number): void {
        this.radius = radius;
    }

    /** Eye and target, six numbers. */
    get view(): number[] {
        return [...this.camera.position.toArray(), ...this.controls.target.toArray()];
    }

    set view(numbers: readonly number[]) {
        this.look(new Vector3().fromArray(numbers, 0), new Vector3().fromArray(numbers, 3));
    }

    /** Returns the ray under a point of the canvas, in pixels from its upper left corner. */
    rayAt(x: number, y: number): Ray {
        const at = new Vector2((2 * x) / this.canvas.clientWidth - 1, 1 - (2 * y) / this.canvas.clientHeight);
        const camera: Camera = this.camera;
        camera.updateMatrixWorld();
        const through = new Vector3(at.x, at.y, 0.5).unproject(camera);
        const direction = through.sub(this.camera.position).normalize();
        return { origin: this.camera.position.toArray() as Vec3, direction: direction.toArray() as Vec3 };
    }

    /** Returns where a point is drawn on the canvas, in pixels. */
    pixelOf(point: Vec3): [number, number] {
        this.camera.updateMatrixWorld();
        const at = new Vector3(...point).project(this.camera);
        return [((at.x + 1) / 2) * this.canvas.clientWidth, ((1 - at.y) / 2) * this.canvas.clientHeight];
    }

    private picture(): Promise<Blob | null> {
        this.render(); // The buffer is kept until this task ends.
        return new Promise((resolve) => this.canvas.toBlob(resolve, "image/png"));
    }

    /** Saves the picture as a file. */
    async save(name: string): Promise<void> {
        const blob = await this.picture();
        if (blob) {
            const link = document.createElement("a");
            link.href = URL.createObjectURL(blob);
            link.download = `${name}.png`.replaceAll(/[^\w.-]+/g, "_");
            link.click();
            setTimeout(() => URL.revokeObjectURL(link.href), 1000);
        }
    }

    dispose(): void {
        this.watcher.disconnect();
        this.controls.dispose();
        this.canvas.removeEventListener("webglcontextrestored", this.draw);
        this.renderer.dispose();
        this.renderer.forceContextLoss();
    }
}

/** Returns the plane that hides what lies beyond `at` along an axis. */
export function clipPlane(axis: "x" | "y" | "z", at: number): Plane {
    const normal = new Vector3(axis === "x" ? -1 : 0, axis === "y" ? -1 : 0, axis === "z" ? -1 : 0);
    return new Plane(normal, at);
}
