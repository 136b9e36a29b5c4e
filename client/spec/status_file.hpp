// The file of statuses, in which people say what they decided about groups of contacts.
#pragma once

#include "client/groups/part_pattern.hpp"
#include "common/core/result.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

/// A `[[clash]]` of the file: what was decided about the groups that the patterns match.
struct StatusRule {
    PartPattern a;
    PartPattern b;
    bool is_approved = false; ///< If false, the groups are only reviewed.
    std::string note;
    /// The decision holds while no scenario has more pairs of triangles.
    std::optional<std::uint64_t> pairs_max;
    std::string place; ///< "FILE:LINE: clash a, b", for messages.
};

/// Reads a file of statuses. Errors: NotFound, Io; BadInput naming file, line and key.
[[nodiscard]] Result<std::vector<StatusRule>> read_status_file(const std::filesystem::path& path);

/// Parses the text of a file of statuses; `file` is its name in messages. Errors: BadInput.
[[nodiscard]] Result<std::vector<StatusRule>> parse_statuses(std::string_view text,
                                                             const std::string& file);

} // namespace cd
