#include "web/status/table.hpp"

#include "common/core/words.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace cd {

namespace {

std::string bytes_text(double bytes) {
    constexpr std::array<const char*, 5> units{"B", "KiB", "MiB", "GiB", "TiB"};
    std::size_t unit = 0;
    while (bytes >= 1000 && unit + 1 < units.size()) {
        bytes /= 1024;
        ++unit;
    }
    return fixed_text(bytes, unit == 0 ? 0 : 1) + " " + units[unit];
}

double number_of(const Cell& cell) {
    if (const auto* count = std::get_if<std::uint64_t>(&cell)) {
        return static_cast<double>(*count);
    }
    const auto* value = std::get_if<double>(&cell);
    return value == nullptr ? 0 : *value;
}

/// Returns a cell's value for programs, without units or digit groups.
std::string raw_text(const Cell& cell) {
    if (const auto* list = std::get_if<std::vector<std::uint32_t>>(&cell)) {
        return fmt::format("{}", fmt::join(*list, " "));
    }
    if (const auto* value = std::get_if<double>(&cell)) {
        return exact_text(*value);
    }
    if (const auto* number = std::get_if<std::int64_t>(&cell)) {
        return std::to_string(*number);
    }
    const auto* count = std::get_if<std::uint64_t>(&cell);
    return count != nullptr ? std::to_string(*count) : std::get<std::string>(cell);
}

/// Returns how many terminal columns a UTF-8 text takes: one for each code point.
std::size_t width_of(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
    }));
}

/// Replaces control characters, which could take control of the terminal.
std::string printable(std::string text) {
    std::replace_if(
        text.begin(),
        text.end(),
        [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; },
        '?');
    return text;
}

std::string padded(const std::string& text, std::size_t width, bool to_the_left) {
    const std::string space(width - std::min(width, width_of(text)), ' ');
    return to_the_left ? text + space : space + text;
}

std::string table_csv(const Table& table) {
    std::string text;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        text += (c == 0 ? "" : ",") + csv_field(table.columns[c].key);
    }
    text += "\n";
    for (const auto& row : table.rows) {
        for (std::size_t c = 0; c < row.size(); ++c) {
            text += (c == 0 ? "" : ",") + csv_field(raw_text(row[c]));
        }
        text += "\n";
    }
    return text;
}

std::string table_names(const Table& table) {
    std::string text;
    for (const auto& row : table.rows) {
        text += raw_text(row.front()) + "\n";
    }
    return text;
}

} // namespace

std::string cell_text(const Cell& cell, CellKind kind) {
    if (const auto* text = std::get_if<std::string>(&cell)) {
        return printable(*text);
    }
    switch (kind) {
    case CellKind::Text:
        return raw_text(cell);
    case CellKind::Count:
        return grouped(static_cast<std::uint64_t>(number_of(cell)));
    case CellKind::Size:
        return bytes_text(number_of(cell));
    case CellKind::Seconds:
        return fixed_text(number_of(cell), number_of(cell) < 100 ? 2 : 0) + " s";
    case CellKind::Rate:
        return rate_text(number_of(cell)) + "/s";
    case CellKind::Share:
        return fixed_text(100 * number_of(cell), 0) + " %";
    }
    return raw_text(cell);
}

std::string table_text(const Table& table, bool wide, const std::string& indent) {
    std::vector<std::string> lines(table.rows.size() + 1, indent);
    bool first = true;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        const Column& column = table.columns[c];
        if (column.only_wide && !wide) {
            continue;
        }
        std::vector<std::string> cells{column.title};
        for (const auto& row : table.rows) {
            cells.push_back(cell_text(row[c], column.kind));
        }
        std::size_t width = 0;
        for (const std::string& cell : cells) {
            width = std::max(width, width_of(cell));
        }
        for (std::size_t i = 0; i < lines.size(); ++i) {
            lines[i] +=
                (first ? "" : "  ") + padded(cells[i], width, column.kind == CellKind::Text);
        }
        first = false;
    }
    std::string text;
    for (std::string& line : lines) {
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

nlohmann::ordered_json table_json(const Table& table) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const auto& row : table.rows) {
        nlohmann::ordered_json object;
        for (std::size_t c = 0; c < row.size(); ++c) {
            std::visit([&](const auto& value) { object[table.columns[c].key] = value; }, row[c]);
        }
        list.push_back(std::move(object));
    }
    return list;
}

std::string json_text(const nlohmann::ordered_json& json, int indent) {
    return json.dump(indent, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string format_table(const Table& table, const std::string& form) {
    return form == "json"   ? json_text(table_json(table))
           : form == "csv"  ? table_csv(table)
           : form == "name" ? table_names(table)
                            : table_text(table, form == "wide");
}

} // namespace cd
