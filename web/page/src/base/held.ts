/** The answers that a report holds, as client/document/embedded_viewer.cpp writes them. */
import { type Answer, ApiError } from "./api";

/** One answer: gzip in Base64. The text is read when it is needed. */
export interface HeldBlock {
    base64: () => string;
    cut: boolean;
}

async function unpack(base64: string): Promise<ArrayBuffer> {
    const text = atob(base64);
    const packed = new Uint8Array(text.length);
    for (let i = 0; i < text.length; ++i) {
        packed[i] = text.charCodeAt(i);
    }
    const bytes = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
    return new Response(bytes).arrayBuffer();
}

export class HeldAnswers {
    /** Each block has the path of the request that it answers. */
    constructor(private readonly blocks: ReadonlyMap<string, HeldBlock>) {}

    /** Returns the answers that a document holds in inert elements; null if it holds none. */
    static of(root: ParentNode): HeldAnswers | null {
        const found = Array.from(root.querySelectorAll<HTMLTemplateElement>("template[data-path]"));
        const blocks = found.map((one): [string, HeldBlock] => [
            one.dataset.path ?? "",
            { base64: () => one.content.textContent ?? "", cut: one.dataset.cut === "true" },
        ]);
        return blocks.length === 0 ? null : new HeldAnswers(new Map(blocks));
    }

    /** The scenarios that are held, the worst first. */
    get scenarios(): number[] {
        return [...this.blocks.keys()].flatMap((path) => {
            const found = /^jobs\/[^/]+\/scenarios\/(\d+)$/.exec(path);
            return found ? [Number(found[1])] : [];
        });
    }

    async answer(path: string): Promise<Answer> {
        const block = this.blocks.get(path);
        if (!block) {
            throw new ApiError(404, "this report holds its worst scenarios only");
        }
        return { bytes: await unpack(block.base64()), cut: block.cut };
    }
}
