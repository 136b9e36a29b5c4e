import type { Job } from "../base/types";
import { counted, fileName, grouped } from "../base/words";
import { Name } from "../ui/small";

const filesMax = 5;

/** What the bodies of a scene are, in one card: there may be thousands. */
export function SceneCard({ job }: { job: Job }) {
    const { bodies } = job;
    const meshes = new Map(bodies.map((body) => [body.sha256, body]));
    const triangles = bodies.reduce((sum, body) => sum + body.triangles, 0);
    const fixed = bodies.filter((body) => body.fixed).length;
    const files = [...new Set([...meshes.values()].map((body) => fileName(body.file)))];
    return (
        <div class="card">
            <b class="letter">{bodies.length > 99 ? "n" : bodies.length}</b>
            <div>
                <span>
                    {grouped(bodies.length)} bodies of {meshes.size === 1 ? "1 mesh" : `${grouped(meshes.size)} meshes`}
                </span>
                <div class="note">
                    {counted(triangles, "triangle")} in all, {fixed === 0 ? "none" : grouped(fixed)} fixed
                </div>
                <div class="note">
                    <Name text={files.slice(0, filesMax).join(", ")} />
                    {files.length > filesMax && ` and ${grouped(files.length - filesMax)} more`}
                </div>
            </div>
        </div>
    );
}

/** The rows about meshes in how a scene ran: one for each mesh, with how many bodies have it. */
export function meshRows(job: Job, most: number): [string, string][] {
    const counts = new Map<string, number>();
    job.bodies.forEach(({ sha256 }) => counts.set(sha256, (counts.get(sha256) ?? 0) + 1));
    const files = new Map(job.bodies.map((body) => [body.sha256, body.file]));
    const rows = [...counts].map(([sha256, count]): [string, string] => [
        count === 1 ? "mesh of 1 body" : `mesh of ${grouped(count)} bodies`,
        `${sha256}, ${files.get(sha256) ?? ""}`,
    ]);
    const left = rows.length - most;
    return left > 0 ? [...rows.slice(0, most), ["meshes", `and ${grouped(left)} more`]] : rows;
}
