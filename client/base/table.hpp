// Lists of things, for people and for programs.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace cd {

/// How a column's numbers are shown to people. Programs get them as they are.
enum class CellKind : std::uint8_t {
    Text,
    Count,
    Size,    ///< In bytes: "1.4 MiB".
    Seconds, ///< "12.3 s"
    Rate,    ///< A second: "58.4 k/s"
    Share,   ///< Of one: "42 %"
};

struct Column {
    std::string key; ///< For programs: `bytes_sent`.
    std::string title;
    CellKind kind = CellKind::Text;
    bool only_wide = false;
};

/// A list is shown with blanks between its numbers; in JSON it is an array.
using Cell = std::variant<std::string, std::uint64_t, double, std::vector<std::uint32_t>>;

/// Each row has a cell for each column; the first column names the thing.
struct Table {
    std::vector<Column> columns;
    std::vector<std::vector<Cell>> rows;
};

[[nodiscard]] std::string cell_text(const Cell& cell, CellKind kind);

/// Aligned columns under their titles, each line behind `indent`.
[[nodiscard]] std::string table_text(const Table& table, bool wide, const std::string& indent = "");
/// With a line of keys; quoted where RFC 4180 asks for it.
[[nodiscard]] std::string table_csv(const Table& table);
/// An array of objects.
[[nodiscard]] std::string table_json(const Table& table);
/// The first column, a line each.
[[nodiscard]] std::string table_names(const Table& table);

/// By the name of the form: text, wide, csv, json or name.
[[nodiscard]] std::string format_table(const Table& table, const std::string& form);

} // namespace cd
