import type { ComponentChildren } from "preact";
import { useState } from "preact/hooks";

/** A column: what a cell shows, and the value by which its rows are sorted. */
export interface Column<Row> {
    key: string;
    title: string;
    cell: (row: Row) => ComponentChildren;
    value: (row: Row) => number | string;
    isNumber?: boolean;
}

interface TableProps<Row> {
    caption: string;
    columns: Column<Row>[];
    rows: Row[];
    rowKey: (row: Row) => string;
    /** The order before somebody chooses a column. */
    order?: (a: Row, b: Row) => number;
    rowClass?: (row: Row) => string;
    empty: string;
}

function compare(a: number | string, b: number | string): number {
    return typeof a === "number" && typeof b === "number"
        ? a - b
        : String(a).localeCompare(String(b), "en", { numeric: true });
}

/** A table that each column's heading sorts. */
export function Table<Row>(props: TableProps<Row>) {
    const [sorted, setSorted] = useState<{ key: string; down: boolean } | null>(null);
    const column = props.columns.find((one) => one.key === sorted?.key);
    const rows = [...props.rows];
    if (column && sorted) {
        rows.sort((a, b) => (sorted.down ? -1 : 1) * compare(column.value(a), column.value(b)));
    } else if (props.order) {
        rows.sort(props.order);
    }
    const choose = (one: Column<Row>) => {
        const first = one.isNumber === true; // Large numbers are asked for first.
        if (sorted?.key !== one.key) {
            setSorted({ key: one.key, down: first });
        } else {
            setSorted(sorted.down === first ? { key: one.key, down: !first } : null);
        }
    };
    const direction = (one: Column<Row>) =>
        sorted?.key !== one.key ? "none" : sorted.down ? "descending" : "ascending";
    return (
        <div class="table" tabIndex={0} role="region" aria-label={props.caption}>
            <table>
                <caption>{props.caption}</caption>
                <thead>
                    <tr>
                        {props.columns.map((one) => (
                            <th
                                key={one.key}
                                scope="col"
                                class={one.isNumber ? "number" : ""}
                                aria-sort={direction(one)}
                            >
                                <button type="button" onClick={() => choose(one)}>
                                    {one.title}
                                </button>
                            </th>
                        ))}
                    </tr>
                </thead>
                <tbody>
                    {rows.length === 0 && (
                        <tr>
                            <td class="empty" colSpan={props.columns.length}>
                                {props.empty}
                            </td>
                        </tr>
                    )}
                    {rows.map((row) => (
                        <tr key={props.rowKey(row)} class={props.rowClass?.(row) ?? ""}>
                            {props.columns.map((one) => (
                                <td key={one.key} class={one.isNumber ? "number" : ""}>
                                    {one.cell(row)}
                                </td>
                            ))}
                        </tr>
                    ))}
                </tbody>
            </table>
        </div>
    );
}
