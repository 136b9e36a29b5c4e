// Tables, printed for people or for programs.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace cd {

/// The format of a column's numbers for people. Programs get raw values.
enum class CellKind : std::uint8_t {
    Text,
    Count,
    Size,    ///< Bytes: "1.4 MiB".
    Seconds, ///< "12.3 s"
    Rate,    ///< Per second: "58.4 k/s"
    Share,   ///< A fraction of 1: "42 %"
};

struct Column {
    std::string key; ///< Name for programs: `bytes_sent`.
    std::string title;
    CellKind kind = CellKind::Text;
    bool only_wide = false; ///< Printed only with -o wide, csv or json.
};

/// A list is printed with blanks between its numbers; in JSON it is an array.
using Cell = std::variant<std::string, std::uint64_t, double, std::vector<std::uint32_t>>;

/// Each row has a cell for each column; the first column has the row's name.
struct Table {
    std::vector<Column> columns;
    std::vector<std::vector<Cell>> rows;
};

[[nodiscard]] std::string cell_text(const Cell& cell, CellKind kind);

/// The table as aligned columns under their titles, each line after `indent`.
[[nodiscard]] std::string table_text(const Table& table, bool wide, const std::string& indent = "");
/// The table as CSV with a line of keys; fields are quoted as in RFC 4180.
[[nodiscard]] std::string table_csv(const Table& table);
/// The table as a JSON array of objects.
[[nodiscard]] std::string table_json(const Table& table);
/// The cells of the first column, one per line.
[[nodiscard]] std::string table_names(const Table& table);

/// The table in the named form: text, wide, csv, json or name.
[[nodiscard]] std::string format_table(const Table& table, const std::string& form);

} // namespace cd
