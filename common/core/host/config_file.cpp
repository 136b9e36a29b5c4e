#include "common/core/host/config_file.hpp"

#include "common/core/errors.hpp"

#include <toml++/toml.h>

#include <array>
#include <charconv>
#include <cmath>
#include <optional>

namespace cd {

namespace {

Error config_error(const std::string& place,
                   const toml::source_region& where,
                   const std::string& what) {
    return bad_input(place + std::to_string(where.begin.line) + ": " + what);
}

/// Returns the text of a value that an option may have; nothing for a table, a date or infinity.
std::optional<std::string> option_text(const toml::node& value) {
    if (const auto* text = value.as_string()) {
        return text->get();
    }
    if (const auto* number = value.as_integer()) {
        return std::to_string(number->get());
    }
    if (const auto* number = value.as_floating_point(); number && std::isfinite(number->get())) {
        std::array<char, 32> text{};
        return std::string(text.data(), std::to_chars(text.begin(), text.end(), number->get()).ptr);
    }
    if (const auto* truth = value.as_boolean()) {
        return truth->get() ? "true" : "false";
    }
    return std::nullopt;
}

Result<std::vector<std::string>>
option_texts(const std::string& key, const toml::node& value, const std::string& place) {
    std::vector<std::string> texts;
    const auto add = [&](const toml::node& node) -> Status {
        auto text = option_text(node);
        if (!text) {
            return config_error(place,
                                node.source(),
                                "'" + key +
                                    "' is neither text, a number, nor true or false, nor a list of "
                                    "these");
        }
        texts.push_back(*std::move(text));
        return Done{};
    };
    if (const toml::array* const list = value.as_array()) {
        for (const toml::node& node : *list) {
            CD_TRY(add(node));
        }
    } else {
        CD_TRY(add(value));
    }
    return texts;
}

} // namespace

Result<std::vector<ConfigEntry>> parse_config(std::string_view text, const std::string& place) {
    toml::table table;
    try {
        table = toml::parse(text);
    } catch (const toml::parse_error& error) {
        return config_error(place, error.source(), std::string(error.description()));
    }
    std::vector<ConfigEntry> entries;
    for (const auto& [key, value] : table) {
        ConfigEntry entry;
        entry.key = std::string(key.str());
        entry.line = key.source().begin.line;
        entry.values = CD_TRY(option_texts(entry.key, value, place));
        entries.push_back(std::move(entry));
    }
    return entries;
}

} // namespace cd
