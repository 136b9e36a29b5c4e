#include "client/spec/toml_fields.hpp"

#include "client/spec/toml_text.hpp"
#include "common/core/errors.hpp"

#include <algorithm>
#include <cmath>

namespace cd {

namespace {

std::string quoted_key(std::string_view key) {
    return "\"" + std::string(key) + "\"";
}

std::optional<double> finite_number(const toml::node& node) {
    if (!node.is_number()) {
        return std::nullopt;
    }
    const std::optional<double> value = node.value<double>();
    return value && std::isfinite(*value) ? value : std::nullopt;
}

/// Writes a value of numbers, texts, arrays and tables in one line.
std::string inline_text(const toml::node& node) {
    if (const toml::table* const table = node.as_table()) {
        std::string text;
        for (const auto& [key, value] : *table) {
            text +=
                (text.empty() ? "" : ", ") + std::string(key.str()) + " = " + inline_text(value);
        }
        return "{ " + text + " }";
    }
    if (const toml::array* const array = node.as_array()) {
        return toml_list(*array, inline_text);
    }
    if (const auto text = node.value_exact<std::string>()) {
        return toml_quoted(*text);
    }
    return toml_number(finite_number(node).value_or(0));
}

} // namespace

Error error_at(const std::string& file, const toml::source_region& where, const std::string& what) {
    return bad_input(file + ":" + std::to_string(where.begin.line) + ": " + what);
}

KeyLines lines_of(const toml::table& document, std::initializer_list<std::string_view> of) {
    KeyLines lines;
    for (const auto& [name, node] : document) {
        lines.emplace("[" + std::string(name.str()) + "]", node.source().begin.line);
        const toml::table* const table = node.as_table();
        if (table == nullptr || std::ranges::find(of, name.str()) == of.end()) {
            continue;
        }
        for (const auto& [key, value] : *table) {
            lines.emplace(key.str(), value.source().begin.line);
        }
    }
    return lines;
}

TomlFields::TomlFields(const toml::table& table,
                       std::string file,
                       std::string name,
                       std::initializer_list<std::string_view> known)
    : table_(table), file_(std::move(file)), name_(std::move(name)) {
    const std::span<const std::string_view> words(known.begin(), known.size());
    // Finds the unknown key on the earliest line; a table does not keep the order of the file.
    const toml::key* unknown = nullptr;
    for (const auto& [key, value] : table_) {
        const bool is_known = std::ranges::find(words, key.str()) != words.end();
        if (!is_known && (!unknown || key.source().begin < unknown->source().begin)) {
            unknown = &key;
        }
    }
    if (unknown != nullptr) {
        throw Refusal{error_at(file_,
                               unknown->source(),
                               name_ + " has no key " + quoted_key(unknown->str()) +
                                   suggestion(unknown->str(), words))};
    }
}

std::optional<std::string> TomlFields::text(std::string_view key) const {
    if (!has(key)) {
        return std::nullopt;
    }
    auto value = table_.get(key)->value_exact<std::string>();
    if (!value) {
        wrong_type(key, "text in quotes");
    }
    return value;
}

std::optional<std::string> TomlFields::word(std::string_view key,
                                            std::span<const std::string_view> words) const {
    auto value = text(key);
    if (value && std::ranges::find(words, *value) == words.end()) {
        refuse(key,
               std::string(key) + " " + quoted_key(*value) + " is not known" +
                   suggestion(*value, words));
    }
    return value;
}

bool TomlFields::says(std::string_view key, std::string_view text) const {
    return has(key) && table_.get(key)->value_exact<std::string>() == text;
}

std::optional<double> TomlFields::number(std::string_view key) const {
    const auto value = has(key) ? finite_number(*table_.get(key)) : std::nullopt;
    if (has(key) && !value) {
        wrong_type(key, "a finite number");
    }
    return value;
}

std::optional<std::uint64_t>
TomlFields::integer(std::string_view key, std::uint64_t min, std::uint64_t max) const {
    if (!has(key)) {
        return std::nullopt;
    }
    const auto value = table_.get(key)->value_exact<std::int64_t>();
    if (!value) {
        wrong_type(key, "a whole number");
    }
    if (*value < 0 || static_cast<std::uint64_t>(*value) < min ||
        static_cast<std::uint64_t>(*value) > max) {
        refuse(key,
               std::string(key) + " = " + std::to_string(*value) + " is not between " +
                   std::to_string(min) + " and " + std::to_string(max));
    }
    return static_cast<std::uint64_t>(*value);
}

std::optional<bool> TomlFields::boolean(std::string_view key) const {
    const auto value = has(key) ? table_.get(key)->value_exact<bool>() : std::nullopt;
    if (has(key) && !value) {
        wrong_type(key, "true or false");
    }
    return value;
}

const toml::table* TomlFields::table(std::string_view key) const {
    const toml::table* value = has(key) ? table_.get(key)->as_table() : nullptr;
    if (has(key) && value == nullptr) {
        wrong_type(key, "a table");
    }
    return value;
}

const toml::array* TomlFields::array(std::string_view key) const {
    const toml::array* value = has(key) ? table_.get(key)->as_array() : nullptr;
    if (has(key) && value == nullptr) {
        wrong_type(key, "an array");
    }
    return value;
}

std::string TomlFields::line_of(std::string_view key) const {
    return std::string(key) + " = " + inline_text(*table_.get(key));
}

std::optional<std::vector<double>>
TomlFields::numbers(std::string_view key, std::size_t count, std::string_view shape) const {
    const toml::array* values = array(key);
    if (values == nullptr) {
        return std::nullopt;
    }
    std::vector<double> numbers;
    for (const toml::node& node : *values) {
        if (const auto value = finite_number(node)) {
            numbers.push_back(*value);
        }
    }
    if (numbers.size() != count || values->size() != count) {
        wrong_type(key, shape);
    }
    return numbers;
}

void TomlFields::refuse(std::string_view key, const std::string& what) const {
    throw Refusal{error_at(
        file_, has(key) ? table_.get(key)->source() : table_.source(), name_ + ": " + what)};
}

void TomlFields::refuse(const toml::node& node, const std::string& what) const {
    throw Refusal{error_at(file_, node.source(), name_ + ": " + what)};
}

void TomlFields::wrong_type(std::string_view key, std::string_view wanted) const {
    refuse(key, quoted_key(key) + " has to be " + std::string(wanted));
}

} // namespace cd
