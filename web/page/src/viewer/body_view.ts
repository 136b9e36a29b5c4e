import {
    BufferAttribute,
    BufferGeometry,
    DataTexture,
    DoubleSide,
    Group,
    LessEqualDepth,
    Matrix4,
    Mesh as DrawnMesh,
    MeshLambertMaterial,
    NearestFilter,
    type Plane,
    RGBAFormat,
    Sphere,
    SRGBColorSpace,
    Vector3,
} from "three";
import type { Rgb } from "../base/classes";
import { cornersOf, type Mesh } from "../base/mesh";
import { apply } from "../base/pose";
import type { Pose, Vec3 } from "../base/types";
import { heatTable } from "./heat";

const ghostOpacity = 0.28;

export function makeMaterial(colour: Rgb): MeshLambertMaterial {
    const material = new MeshLambertMaterial({ flatShading: true, side: DoubleSide });
    material.color.setRGB(colour[0] / 255, colour[1] / 255, colour[2] / 255, SRGBColorSpace);
    return material;
}

/** Lets a material take its colour from a table by the attribute `heat`, a byte a corner. */
function addHeat(material: MeshLambertMaterial, table: DataTexture, isOn: { value: boolean }): void {
    material.onBeforeCompile = (shader) => {
        shader.uniforms.heatTable = { value: table };
        shader.uniforms.showsHeat = isOn;
        shader.vertexShader = shader.vertexShader
            .replace("#include <common>", "#include <common>\nattribute float heat;\nvarying float vHeat;")
            .replace("#include <begin_vertex>", "#include <begin_vertex>\nvHeat = heat;");
        shader.fragmentShader = shader.fragmentShader
            .replace(
                "#include <common>",
                "#include <common>\nuniform sampler2D heatTable;\nuniform bool showsHeat;\nvarying float vHeat;",
            )
            .replace(
                "#include <color_fragment>",
                `#include <color_fragment>
                if (showsHeat) {
                    float at = (floor(vHeat * 255.0 + 0.5) + 0.5) / 256.0;
                    diffuseColor.rgb = texture2D(heatTable, vec2(at, 0.5)).rgb;
                }`,
            );
    };
}

/**
 * A body: its triangles around its own box's centre, drawn solid, or as a ghost in two passes: depth
 * alone, then colour without depth, so that its nearest layer is blended once.
 */
export class BodyView {
    readonly corners: Float32Array;
    readonly solid: DrawnMesh;
    readonly ghost = new Group();
    readonly radius: number;
    private readonly geometry = new BufferGeometry();
    private readonly materials: MeshLambertMaterial[];
    private readonly showsHeat = { value: false };
    private readonly table: DataTexture;

    constructor(
        readonly mesh: Mesh,
        colour: Rgb,
    ) {
        this.corners = cornersOf(mesh);
        this.radius = Math.hypot(...mesh.max.map((high, axis) => high - mesh.min[axis])) / 2;
        this.geometry.setAttribute("position", new BufferAttribute(this.corners, 3));
        this.setHeat(new Uint8Array(this.corners.length / 3));
        this.geometry.boundingSphere = new Sphere(new Vector3(), this.radius);
        this.table = new DataTexture(heatTable(colour), 256, 1, RGBAFormat);
        this.table.colorSpace = SRGBColorSpace;
        this.table.minFilter = NearestFilter;
        this.table.magFilter = NearestFilter;
        this.table.needsUpdate = true;

        // Contact triangles lie in the bodies' surfaces, and are drawn in front of them.
        const solid = makeMaterial(colour);
        const depth = makeMaterial(colour);
        const veil = makeMaterial(colour);
        for (const material of [solid, depth, veil]) {
            material.polygonOffset = true;
            material.polygonOffsetFactor = 1;
            material.polygonOffsetUnits = 1;
            addHeat(material, this.table, this.showsHeat);
        }
        depth.colorWrite = false;
        veil.polygonOffset = false;
        veil.transparent = true;
        veil.opacity = ghostOpacity;
        veil.depthWrite = false;
        veil.depthFunc = LessEqualDepth;
        this.materials = [solid, depth, veil];
        this.solid = this.make(solid, 0);
        this.ghost.add(this.make(depth, 1), this.make(veil, 2));
    }

    private make(material: MeshLambertMaterial, order: number): DrawnMesh {
        const drawn = new DrawnMesh(this.geometry, material);
        drawn.matrixAutoUpdate = false;
        drawn.renderOrder = order;
        return drawn;
    }

    get triangles(): number {
        return this.corners.length / 9;
    }

    setHeat(bytes: Uint8Array): void {
        this.geometry.setAttribute("heat", new BufferAttribute(bytes, 1, true));
    }

    showHeat(isOn: boolean): void {
        this.showsHeat.value = isOn;
    }

    showAs(form: "solid" | "ghost"): void {
        this.solid.visible = form === "solid";
        this.ghost.visible = form === "ghost";
    }

    clip(planes: Plane[]): void {
        for (const material of this.materials) {
            material.clippingPlanes = planes;
        }
    }

    /** Places the body; `origin` is the point of A's frame around which all is drawn. */
    place(pose: Pose, origin: Vec3): Matrix4 {
        const centre = apply(pose, this.mesh.centre);
        const matrix = new Matrix4().set(
            ...([pose[0], pose[1], pose[2], centre[0] - origin[0]] as const),
            ...([pose[4], pose[5], pose[6], centre[1] - origin[1]] as const),
            ...([pose[8], pose[9], pose[10], centre[2] - origin[2]] as const),
            ...([0, 0, 0, 1] as const),
        );
        for (const drawn of [this.solid, ...this.ghost.children]) {
            drawn.matrix.copy(matrix);
            drawn.matrixWorldNeedsUpdate = true;
        }
        return matrix;
    }

    /** Returns the corners of the body's box, where `matrix` places it. */
    boxCorners(matrix: Matrix4): Vec3[] {
        const half = this.mesh.max.map((high, axis) => high - this.mesh.centre[axis]);
        const signs = [-1, 1];
        return signs.flatMap((x) =>
            signs.flatMap((y) =>
                signs.map(
                    (z) =>
                        new Vector3(x * half[0], y * half[1], z * half[2])
                            .applyMatrix4(matrix)
                            .toArray() as Vec3,
                ),
            ),
        );
    }

    dispose(): void {
        this.geometry.dispose();
        this.table.dispose();
        this.materials.forEach((material) => material.dispose());
    }
}
