/** A mesh as it was tested: the canonical bytes that its SHA-256 names. */
import { getBytes, messageOf } from "./api";
import type { Vec3 } from "./types";

export interface Mesh {
    sha256: string;
    /** Whether the bytes have the hash by which they were asked; null if the browser cannot tell. */
    checked: boolean | null;
    bytes: number;
    vertices: Float32Array | Float64Array;
    triangles: Uint32Array;
    min: Vec3;
    max: Vec3;
    centre: Vec3;
}

const magic = [0x00, 0x43, 0x44, 0x4d, 0x45, 0x53, 0x48, 0x31]; // "\0CDMESH1"
const headerBytes = 29;

async function hasHash(bytes: ArrayBuffer, sha256: string): Promise<boolean | null> {
    if (!globalThis.crypto?.subtle) {
        return null; // Browsers offer it on loopback and over TLS only.
    }
    const hash = new Uint8Array(await crypto.subtle.digest("SHA-256", bytes));
    return Array.from(hash, (byte) => byte.toString(16).padStart(2, "0")).join("") === sha256;
}

function boundsOf(vertices: Float32Array | Float64Array): [Vec3, Vec3] {
    const min: Vec3 = [Infinity, Infinity, Infinity];
    const max: Vec3 = [-Infinity, -Infinity, -Infinity];
    for (let i = 0; i < vertices.length; i += 3) {
        for (let axis = 0; axis < 3; ++axis) {
            const value = vertices[i + axis];
            min[axis] = value < min[axis] ? value : min[axis];
            max[axis] = value > max[axis] ? value : max[axis];
        }
    }
    return vertices.length === 0
        ? [
              [0, 0, 0],
              [0, 0, 0],
          ]
        : [min, max];
}

/** Parses canonical bytes (common/geometry/mesh.cpp). Throws if they are no mesh. */
export function parseMesh(bytes: ArrayBuffer, sha256: string, checked: boolean | null): Mesh {
    const view = new DataView(bytes);
    if (bytes.byteLength < headerBytes || magic.some((byte, i) => view.getUint8(i) !== byte)) {
        throw new Error("the server's mesh is not in canonical form");
    }
    const isDouble = view.getUint8(8) === 1;
    const vertexCount = Number(view.getBigUint64(9, true));
    const triangleCount = Number(view.getBigUint64(17, true));
    const verticesEnd = headerBytes + vertexCount * 3 * (isDouble ? 8 : 4);
    const trianglesEnd = verticesEnd + triangleCount * 12;
    if (trianglesEnd > bytes.byteLength) {
        throw new Error("the server's mesh is cut short");
    }
    const coordinates = bytes.slice(headerBytes, verticesEnd);
    const vertices = isDouble ? new Float64Array(coordinates) : new Float32Array(coordinates);
    const triangles = new Uint32Array(bytes.slice(verticesEnd, trianglesEnd));
    const [min, max] = boundsOf(vertices);
    return {
        sha256,
        checked,
        bytes: bytes.byteLength,
        vertices,
        triangles,
        min,
        max,
        centre: [0, 1, 2].map((axis) => (min[axis] + max[axis]) / 2) as Vec3,
    };
}

/** Gets a mesh and checks its hash. A damaged mesh that can still be read has `checked` false. */
export async function getMesh(sha256: string, signal?: AbortSignal): Promise<Mesh> {
    const bytes = await getBytes(`meshes/${sha256}`, signal);
    const checked = await hasHash(bytes, sha256);
    try {
        return parseMesh(bytes, sha256, checked);
    } catch (error) {
        throw checked === false ? new Error(`not the tested geometry: ${messageOf(error)}`) : error;
    }
}

/**
 * Returns nine floats a triangle, so that position i / 3 in them is triangle i / 9. The box's centre
 * is subtracted in double.
 */
export function cornersOf(mesh: Mesh): Float32Array {
    const { vertices, triangles, centre } = mesh;
    const [cx, cy, cz] = centre;
    const corners = new Float32Array(3 * triangles.length);
    for (let i = 0; i < triangles.length; ++i) {
        const vertex = 3 * triangles[i];
        corners[3 * i] = vertices[vertex] - cx;
        corners[3 * i + 1] = vertices[vertex + 1] - cy;
        corners[3 * i + 2] = vertices[vertex + 2] - cz;
    }
    return corners;
}
