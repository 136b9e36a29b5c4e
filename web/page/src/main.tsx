import { render } from "preact";
import { useEffect, useState } from "preact/hooks";
import "./app.css";
import { getJson, messageOf, takeKey } from "./base/api";
import { publishFacts, tellFacts } from "./base/facts";
import { forgetNotes, jobLink, noteLink, parseRoute, type Route } from "./base/route";
import { startTheme } from "./base/theme";
import type { Source } from "./base/types";
import { ClusterScreen } from "./screens/cluster";
import { JobScreen } from "./screens/job";
import { JobsScreen } from "./screens/jobs";
import { ViewerScreen } from "./screens/viewer";
import { Shell } from "./ui/shell";
import { Notice } from "./ui/small";

function homeOf(source: Source): string {
    return source.job === null ? "#/cluster" : jobLink(source.job);
}

/** The screen that the address names, below the bar. */
function Screens({ source }: { source: Source }) {
    const [route, setRoute] = useState(() => parseRoute(location.hash));
    useEffect(() => {
        const follow = () => {
            forgetNotes();
            takeKey();
            setRoute(parseRoute(location.hash));
        };
        addEventListener("hashchange", follow);
        return () => removeEventListener("hashchange", follow);
    }, []);
    useEffect(() => tellFacts("route", () => ({ screen: route.screen, link: location.hash })), [route]);
    const isHome = location.hash.replace(/^#\/?/, "") === "";
    useEffect(() => {
        if (isHome) {
            noteLink(homeOf(source));
            setRoute(parseRoute(location.hash));
        }
    }, [isHome]);
    return (
        <Shell source={source} screen={route.screen}>
            {route.screen === "none" && !isHome ? (
                <Notice kind="warn">
                    this address names nothing here; <a href={homeOf(source)}>go to the start</a>
                </Notice>
            ) : (
                <Screen source={source} route={route} />
            )}
        </Shell>
    );
}

function Screen({ source, route }: { source: Source; route: Route }) {
    switch (route.screen) {
        case "cluster":
            return <ClusterScreen />;
        case "jobs":
            return <JobsScreen />;
        case "job":
            return <JobScreen key={route.job} source={source} id={route.job} />;
        case "viewer":
            return <ViewerScreen key={route.job} source={source} route={route} />;
        default:
            return null;
    }
}

function Page() {
    const [source, setSource] = useState<Source | null>(null);
    const [error, setError] = useState("");
    useEffect(() => {
        getJson<Source>("source").then(setSource, (reason) => setError(messageOf(reason)));
    }, []);
    if (!source) {
        return error ? <Notice kind="bad">{error}</Notice> : null;
    }
    return <Screens source={source} />;
}

publishFacts();
startTheme();
takeKey();
const root = document.getElementById("page");
if (root) {
    render(<Page />, root);
}
