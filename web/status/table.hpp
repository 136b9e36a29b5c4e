// Tables, printed for people or for programs.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace cd {

/// How a column's numbers are printed for people. Programs get raw values.
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

/// A cell's value. A list is printed with blanks between its numbers; in JSON it is an array.
using Cell =
    std::variant<std::string, std::uint64_t, std::int64_t, double, std::vector<std::uint32_t>>;

/// Each row has a cell for each column; the first column has the row's name.
struct Table {
    std::vector<Column> columns;
    std::vector<std::vector<Cell>> rows;
};

/// Builds a table with a row for each object of a list, column by column.
template <class Row>
class TableOf {
  public:
    explicit TableOf(std::span<const Row> objects) : objects_(objects) {
        table_.rows.resize(objects.size());
    }

    /// Adds a column. `cell_of` is a function of an object, or a pointer to a member.
    template <class CellOf>
    void add(const char* key, const char* title, CellKind kind, const CellOf& cell_of) {
        table_.columns.push_back({key, title, kind});
        for (std::size_t i = 0; i < objects_.size(); ++i) {
            table_.rows[i].push_back(cell(std::invoke(cell_of, objects_[i])));
        }
    }
    /// Adds a column that is printed only with -o wide, csv or json.
    template <class CellOf>
    void add_wide(const char* key, const char* title, CellKind kind, const CellOf& cell_of) {
        add(key, title, kind, cell_of);
        table_.columns.back().only_wide = true;
    }

    [[nodiscard]] Table take() { return std::move(table_); }

  private:
    template <class Value>
    static Cell cell(const Value& value) {
        if constexpr (std::is_integral_v<Value> && std::is_signed_v<Value>) {
            return std::int64_t{value};
        } else if constexpr (std::is_integral_v<Value>) {
            return std::uint64_t{value};
        } else {
            return value;
        }
    }

    std::span<const Row> objects_;
    Table table_;
};

[[nodiscard]] std::string cell_text(const Cell& cell, CellKind kind);

/// Returns the table as aligned columns under their titles, each line after `indent`.
[[nodiscard]] std::string table_text(const Table& table, bool wide, const std::string& indent = "");
/// Converts the table to a JSON array of objects.
[[nodiscard]] nlohmann::ordered_json table_json(const Table& table);

/// Returns a JSON document as text with a newline, on one line if `indent` is -1. Invalid UTF-8,
/// which names from foreign files may contain, is replaced.
[[nodiscard]] std::string json_text(const nlohmann::ordered_json& json, int indent = 2);

/// Returns the table in the form `form`: text; wide; csv, with a line of keys and fields quoted as
/// in RFC 4180; json; or name, the cells of the first column, one per line.
[[nodiscard]] std::string format_table(const Table& table, const std::string& form);

} // namespace cd
