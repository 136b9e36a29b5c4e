/** Light and dark: as the system says, or as the switch was set here. */
export type Theme = "system" | "light" | "dark";

const storageName = "cdcluster.theme";
const listeners = new Set<() => void>();

export function currentTheme(): Theme {
    const said = document.documentElement.dataset.theme;
    return said === "light" || said === "dark" ? said : "system";
}

export function isDark(): boolean {
    const theme = currentTheme();
    return theme === "system" ? matchMedia("(prefers-color-scheme: dark)").matches : theme === "dark";
}

export function setTheme(theme: Theme): void {
    if (theme === "system") {
        delete document.documentElement.dataset.theme;
    } else {
        document.documentElement.dataset.theme = theme;
    }
    try {
        localStorage.setItem(storageName, theme);
    } catch {
        // The choice then lasts as long as this tab.
    }
    listeners.forEach((listener) => listener());
}

export function startTheme(): void {
    try {
        const stored = localStorage.getItem(storageName);
        if (stored === "light" || stored === "dark") {
            document.documentElement.dataset.theme = stored;
        }
    } catch {
        // No storage: the system's theme.
    }
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () =>
        listeners.forEach((listener) => listener()),
    );
}

/** Calls `listener` when light and dark change, until the returned function is called. */
export function onTheme(listener: () => void): () => void {
    listeners.add(listener);
    return () => listeners.delete(listener);
}

/** Returns a colour of the style sheet, such as `--ink`, as an element sees it. */
export function styleColour(name: string, element: Element = document.documentElement): string {
    return getComputedStyle(element).getPropertyValue(name).trim();
}
