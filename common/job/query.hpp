// What a job asks of every scenario.
#pragma once

#include "common/tree/ignored_range.hpp"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace cd {

/// How much is computed and sent back, ascending.
enum class Level : std::uint8_t {
    Any = 0,      ///< In contact or not.
    Count = 1,    ///< The class, and how many pairs.
    Pairs = 2,    ///< Each pair with its class.
    Contacts = 3, ///< And the shared points.
};

[[nodiscard]] std::string_view to_text(Level level);
[[nodiscard]] std::optional<Level> level_from_text(std::string_view text);

struct Query {
    Level level = Level::Pairs;
    /// Above 0: boxes whose diameters sum to no more are left undecided, in the job's units. No
    /// contact is missed: a scenario is separate only where that is proven.
    double tolerance = 0;
    std::uint64_t limit_pairs = 0; ///< Of a scenario, the first so many are kept; 0 keeps all.
    std::vector<IgnoredRange> ignored;
    /// From level count on: the job says in how many scenarios each triangle was in contact.
    bool maps = false;
};

} // namespace cd
