/** Numbers and sizes as text. */
const thin = "\u202f";

/** A whole number in groups of three digits: 48 212. */
export function grouped(value: number): string {
    const sign = value < 0 ? "-" : "";
    return sign + String(Math.round(Math.abs(value))).replace(/\B(?=(\d{3})+$)/g, thin);
}

/** At most `digits` significant digits, without zeros at the end. */
export function short(value: number, digits = 4): string {
    if (!Number.isFinite(value)) {
        return value > 0 ? "infinite" : "-";
    }
    return String(Number(value.toPrecision(digits)));
}

export function percent(share: number): string {
    if (!Number.isFinite(share)) {
        return "-";
    }
    return `${share > 0 && share < 0.001 ? "<" + thin + "0.1" : short(100 * share, 3)}${thin}%`;
}

function scaled(value: number, step: number, units: string[]): string {
    let index = 0;
    while (Math.abs(value) >= step && index + 1 < units.length) {
        value /= step;
        index += 1;
    }
    const text = index === 0 ? String(Math.round(value)) : value.toPrecision(3);
    return units[index] === "" ? text : text + thin + units[index];
}

export function bytes(value: number): string {
    return scaled(value, 1024, ["B", "KiB", "MiB", "GiB", "TiB"]);
}

/** Bytes a second, in decimal units as network cards count. */
export function wireRate(value: number): string {
    return `${scaled(value, 1000, ["B", "kB", "MB", "GB"])}/s`;
}

/** A part of a whole, in the whole's unit unless the part is tiny: 1.8 of 4.0 GiB. */
export function bytesOf(part: number, whole: number): string {
    if (part < 0.01 * whole) {
        return `${bytes(part)} of ${bytes(whole)}`;
    }
    const [number, unit] = bytes(whole).split(thin);
    return `${(part / (whole / Number(number))).toPrecision(2)} of ${number}${thin}${unit}`;
}

export function rate(value: number): string {
    return `${scaled(value, 1000, ["", "k", "M", "G"])}/s`;
}

export function compact(value: number): string {
    return scaled(value, 1000, ["", "k", "M", "G"]);
}

export function duration(seconds: number): string {
    if (!Number.isFinite(seconds)) {
        return "-";
    }
    if (seconds < 10) {
        return `${short(seconds, 2)}${thin}s`;
    }
    const whole = Math.round(seconds);
    const pad = (value: number) => String(value).padStart(2, "0");
    if (whole < 3600) {
        return `${Math.floor(whole / 60)}:${pad(whole % 60)}`;
    }
    if (whole < 86400) {
        return `${Math.floor(whole / 3600)}${thin}h ${pad(Math.floor((whole % 3600) / 60))}`;
    }
    return `${Math.floor(whole / 86400)}${thin}d ${Math.floor((whole % 86400) / 3600)}${thin}h`;
}

export function counted(count: number, noun: string): string {
    return `${grouped(count)} ${noun}${count === 1 ? "" : "s"}`;
}

/** A word of a command line, quoted for a POSIX shell where that is needed. */
export function shellWord(word: string): string {
    return /^[\w./:@%+=,-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`;
}

/** The last component of a path. */
export function fileName(path: string): string {
    return path.split("/").pop() || path;
}
