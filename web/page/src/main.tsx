import { render } from "preact";
import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import "./app.css";
import { answerFrom, getJson, getText, messageOf, takeKey } from "./base/api";
import { publishFacts, tellFacts } from "./base/facts";
import { HeldAnswers } from "./base/held";
import { forgetNotes, jobLink, noteLink, parseRoute, readRoute, type Route, scenarioLink } from "./base/route";
import { startTheme } from "./base/theme";
import type { Source } from "./base/types";
import { ClusterScreen } from "./screens/cluster";
import { JobScreen } from "./screens/job";
import { JobsScreen } from "./screens/jobs";
import { type Report, ViewerScreen } from "./screens/viewer";
import { Shell } from "./ui/shell";
import { Notice } from "./ui/small";

function homeOf(source: Source): string {
    return source.job === null ? "#/cluster" : jobLink(source.job);
}

/** What the address names, and a function that reads it again. */
function useRoute(): [Route, () => void] {
    const [route, setRoute] = useState(readRoute);
    const read = () => setRoute(readRoute());
    const first = useRef(location.hash);
    useEffect(() => {
        if (location.hash !== first.current) {
            read(); // It changed before anything listened.
        }
        const follow = () => {
            forgetNotes();
            takeKey();
            read();
        };
        addEventListener("hashchange", follow);
        return () => removeEventListener("hashchange", follow);
    }, []);
    return [route, read];
}

/** The screen that the address names, below the bar. */
function Screens({ source }: { source: Source }) {
    const [route, readAgain] = useRoute();
    useEffect(() => tellFacts("route", () => ({ screen: route.screen, link: location.hash })), [route]);
    const isHome = location.hash.replace(/^#\/?/, "") === "";
    useEffect(() => {
        if (isHome) {
            noteLink(homeOf(source));
            readAgain();
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
            return <JobScreen key={route.job} source={source} route={route} />;
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

/** The viewer alone; it begins with the worst scenario. */
function ReportViewer({ source, report }: { source: Source; report: Report }) {
    const [route] = useRoute();
    const first = useMemo(() => parseRoute(scenarioLink(source.job ?? "", report.scenarios[0])), []);
    return <ViewerScreen source={source} route={route.screen === "viewer" ? route : first} report={report} />;
}

/** Shows the viewer of a report in place of the words in `host`. Neither's style sheet is the other's. */
async function startInReport(host: HTMLElement, held: HeldAnswers): Promise<void> {
    answerFrom((path) => held.answer(path));
    const source = await getJson<Source>("source");
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(await getText("app.css"));
    const shadow = host.attachShadow({ mode: "open" });
    shadow.adoptedStyleSheets = [sheet];
    const root = shadow.appendChild(document.createElement("div"));
    render(<ReportViewer source={source} report={{ scenarios: held.scenarios, root }} />, root);
}

publishFacts();
const root = document.getElementById("page");
const held = HeldAnswers.of(document);
if (root && held) {
    void startInReport(root, held);
} else if (root) {
    startTheme();
    takeKey();
    render(<Page />, root);
}
