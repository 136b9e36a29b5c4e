import {
    BufferAttribute,
    BufferGeometry,
    DoubleSide,
    Group,
    LineSegments,
    LineBasicMaterial,
    type Matrix4,
    Mesh as DrawnMesh,
    MeshBasicMaterial,
} from "three";
import { edgesOf } from "./contacts_view";
import type { Pick } from "./view_state";

/** The picked triangle, drawn above all else. */
export class PickMark {
    readonly group = new Group();
    private readonly face = new MeshBasicMaterial({
        color: 0x1f8fff,
        side: DoubleSide,
        transparent: true,
        opacity: 0.55,
    });
    private readonly edge = new LineBasicMaterial({ color: 0x0a4f9e });

    private clear(): void {
        for (const child of [...this.group.children]) {
            (child as DrawnMesh).geometry.dispose();
            child.removeFromParent();
        }
    }

    show(corners: Float32Array | null, pick: Pick | null, matrices: readonly [Matrix4, Matrix4]): void {
        this.clear();
        if (!corners || !pick || 9 * pick.triangle >= corners.length) {
            return;
        }
        const chosen = corners.slice(9 * pick.triangle, 9 * pick.triangle + 9);
        const geometry = (positions: Float32Array) =>
            new BufferGeometry().setAttribute("position", new BufferAttribute(positions, 3));
        const drawn = [
            new DrawnMesh(geometry(chosen), this.face),
            new LineSegments(geometry(edgesOf(chosen)), this.edge),
        ];
        for (const one of drawn) {
            one.matrixAutoUpdate = false;
            one.matrix.copy(matrices[pick.body]);
            one.frustumCulled = false;
            this.group.add(one);
        }
    }

    dispose(): void {
        this.clear();
        this.face.dispose();
        this.edge.dispose();
    }
}
