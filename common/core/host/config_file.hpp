// Reads the flat TOML files with which users set options.
#pragma once

#include "common/core/result.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

/// A key of a configuration file: the name of an option, without its dashes.
struct ConfigEntry {
    std::string key;
    std::vector<std::string> values; ///< One for text, a number or a truth value; those of a list.
    std::uint32_t line = 0;          ///< Line of the key, from 1.
};

/// Parses `key = value` lines, sorted by key in the result. A value is text, a finite number, true
/// or false, or a list of these. Errors: BadInput that begins with `place` and the line's number:
/// "FILE:3: ..." for the place "FILE:".
[[nodiscard]] Result<std::vector<ConfigEntry>> parse_config(std::string_view text,
                                                            const std::string& place);

} // namespace cd
