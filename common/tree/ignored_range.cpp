#include "common/tree/ignored_range.hpp"

#include <algorithm>

namespace cd {

bool is_ignored(std::span<const IgnoredRange> ignored, std::uint32_t a, std::uint32_t b) {
    return std::any_of(ignored.begin(), ignored.end(), [&](const IgnoredRange& range) {
        return a >= range.a_begin && a < range.a_end && b >= range.b_begin && b < range.b_end;
    });
}

} // namespace cd
