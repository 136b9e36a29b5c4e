/** NumPy's format 1.0 (NEP 1): little-endian, C order. */
export type NpyValues = Uint8Array | Uint32Array | Float32Array | Float64Array;

export interface NpyArray {
    shape: number[];
    values: NpyValues;
}

function valuesOf(type: string, bytes: ArrayBuffer): NpyValues {
    switch (type) {
        case "|u1":
            return new Uint8Array(bytes);
        case "<u4":
            return new Uint32Array(bytes);
        case "<f4":
            return new Float32Array(bytes);
        case "<f8":
            return new Float64Array(bytes);
        case "<u8":
            return Float64Array.from(new BigUint64Array(bytes), Number);
        default:
            throw new Error(`an NPY array of type ${type}, which this page does not know`);
    }
}

/** Parses an NPY file. Integers of eight bytes become doubles: the server sends none above 2^53. */
export function parseNpy(file: ArrayBuffer): NpyArray {
    const bytes = new Uint8Array(file);
    if (bytes.length < 10 || bytes[0] !== 0x93 || bytes[1] !== 0x4e || bytes[6] !== 1) {
        throw new Error("not an NPY array of format 1.0");
    }
    const begin = 10 + bytes[8] + 256 * bytes[9];
    const header = new TextDecoder("latin1").decode(bytes.subarray(10, begin));
    const type = /'descr':\s*'([^']+)'/.exec(header)?.[1] ?? "";
    const shape = (/'shape':\s*\(([^)]*)\)/.exec(header)?.[1] ?? "")
        .split(",")
        .filter((text) => text.trim() !== "")
        .map(Number);
    if (/'fortran_order':\s*True/.test(header)) {
        throw new Error("an NPY array in Fortran order, which this page does not read");
    }
    const values = valuesOf(type, file.slice(begin));
    if (values.length !== shape.reduce((product, length) => product * length, 1)) {
        throw new Error("an NPY array that is cut short");
    }
    return { shape, values };
}
