#include "common/job/query.hpp"

#include "common/core/check.hpp"

#include <cstddef>

namespace cd {

std::string_view to_text(Level level) {
    const auto number = static_cast<std::size_t>(level);
    CD_CHECK(number < level_names.size());
    return level_names[number];
}

std::optional<Level> level_from_text(std::string_view text) {
    for (std::size_t i = 0; i < level_names.size(); ++i) {
        if (level_names[i] == text) {
            return static_cast<Level>(i);
        }
    }
    return std::nullopt;
}

} // namespace cd
