/** The meshes of a scene's bodies, each read once however many bodies have it. */
import { getMesh, type Mesh } from "../base/mesh";

interface Wanted {
    sha256: string;
    triangles: number;
}

export class MeshStore {
    private readonly kept = new Map<string, { mesh: Promise<Mesh>; triangles: number }>();

    /** Of the meshes that were asked for last, keeps those that have at most so many triangles together. */
    constructor(
        private readonly trianglesMax: number,
        private readonly read: (sha256: string) => Promise<Mesh> = getMesh,
    ) {}

    get({ sha256, triangles }: Wanted): Promise<Mesh> {
        const mesh = this.kept.get(sha256)?.mesh ?? this.read(sha256);
        this.kept.delete(sha256); // So that it stands last, as the one used last.
        this.kept.set(sha256, { mesh, triangles });
        mesh.catch(() => this.kept.delete(sha256));
        this.drop(sha256);
        return mesh;
    }

    private drop(used: string): void {
        let sum = [...this.kept.values()].reduce((all, one) => all + one.triangles, 0);
        for (const [sha256, { triangles }] of this.kept) {
            if (sum <= this.trianglesMax || sha256 === used) {
                return;
            }
            this.kept.delete(sha256);
            sum -= triangles;
        }
    }
}
