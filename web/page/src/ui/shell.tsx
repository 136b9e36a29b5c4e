import type { ComponentChildren } from "preact";
import { useState } from "preact/hooks";
import { currentTheme, setTheme, type Theme } from "../base/theme";
import type { Source } from "../base/types";
import { fileName } from "../base/words";
import { Name } from "./small";

const nextTheme: Record<Theme, Theme> = { system: "light", light: "dark", dark: "system" };

function ThemeSwitch() {
    const [theme, show] = useState(currentTheme());
    const turn = () => {
        setTheme(nextTheme[theme]);
        show(nextTheme[theme]);
    };
    const signs: Record<Theme, string> = { system: "◐", light: "○", dark: "●" };
    return (
        <button type="button" class="quiet" onClick={turn} title="light, dark, or as the system says">
            {signs[theme]} {theme}
        </button>
    );
}

/** The bar above every screen. */
export function Shell(props: { source: Source; screen: string; children: ComponentChildren }) {
    const { source, screen } = props;
    const isCluster = source.job === null;
    const tab = (name: string, title: string, isHere: boolean) => (
        <a href={`#/${name}`} {...(isHere ? { "aria-current": "page" as const } : {})}>
            {title}
        </a>
    );
    return (
        <>
            <header class="bar">
                <a class="brand" href="#/">
                    <img src="icon.svg" alt="" width={20} height={20} />
                    cdcluster
                </a>
                <nav aria-label="screens">
                    {isCluster && tab("cluster", "cluster", screen === "cluster")}
                    {isCluster && tab("jobs", "jobs", screen === "jobs")}
                    {source.job !== null && tab(`jobs/${source.job}`, "job", screen === "job")}
                </nav>
                <span class="where" title={`${source.program} ${source.name}`}>
                    {source.kind === "folder" ? "folder " : "master "}
                    <Name text={source.kind === "folder" ? fileName(source.name) : source.name} />
                    {source.tls && " · TLS"}
                </span>
                <ThemeSwitch />
            </header>
            <main>{props.children}</main>
        </>
    );
}
