// The question that a job answers for every scenario.
#pragma once

#include "common/motion/motion_outcome.hpp"
#include "common/tree/ignored_range.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace cd {

/// The detail of a job's results, in ascending order. The numbers are part of the wire format and
/// of stored results.
enum class Level : std::uint8_t {
    Any = 0,      ///< Whether the bodies are in contact.
    Count = 1,    ///< The class and the number of pairs.
    Pairs = 2,    ///< Each pair with its class.
    Contacts = 3, ///< Each pair with its class and its shared points.
};

/// The names of all levels, in their order.
inline constexpr std::array<std::string_view, 4> level_names{"any", "count", "pairs", "contacts"};
[[nodiscard]] std::string_view to_text(Level level);
[[nodiscard]] std::optional<Level> level_from_text(std::string_view text);

/// What a job asks of every scenario. The numbers are part of the wire format and of stored
/// results.
enum class Question : std::uint8_t {
    Contacts = 0, ///< Which triangles touch, or are near, in the detail of the level.
    Distance = 1, ///< How far the bodies are from each other, at level any.
    Motion = 2,   ///< When bodies that move are free of each other, at levels any and pairs.
    Shots = 3,    ///< Where the lines of body B meet A, at levels count and pairs.
};

/// What a job asks of every motion.
struct MotionQuery {
    /// How far the bodies may move against each other in a cell of time that stays open, in the
    /// job's unit; positive and finite.
    double resolution = 0;
    Until until = Until::Contact;

    friend bool operator==(const MotionQuery&, const MotionQuery&) = default;
};

struct Query {
    Level level = Level::Pairs;
    std::uint64_t limit_pairs =
        0; ///< A result lists at most this many pairs, the first in sorted order; 0: all.
    std::vector<IgnoredRange> ignored; ///< In order (`are_in_order`).
    /// At `level count` and above: whether the job counts, for each triangle, the scenarios in
    /// which the triangle is in contact or near. With Question::Shots it counts the crossings.
    bool maps = false;
    /// Also finds pairs that share no point but are at most this far from each other, in the world
    /// and in the job's unit (`is_clearance`).
    std::optional<double> clearance = std::nullopt;
    Question question = Question::Contacts;
    /// Bodies that are farther apart than this, in the world, get no distance (`is_clearance`);
    /// only with Question::Distance.
    std::optional<double> up_to = std::nullopt;
    /// Of each line, only the first hit that crosses counts; only with Question::Shots.
    bool first_hits = false;
    /// With Question::Motion, and only then.
    std::optional<MotionQuery> motion = std::nullopt;
};

/// Whether a number may be a query's clearance: it is finite and at least 0.
[[nodiscard]] inline bool is_clearance(double value) {
    return std::isfinite(value) && value >= 0;
}

/// Returns what no job may ask in this query: a question that does not exist, a clearance or an
/// up_to that is no length, an up_to of contacts, a distance with a level above any, a clearance,
/// maps or limit_pairs, motions at another level than any and pairs, with maps or without a
/// resolution, shots at another level than count and pairs or with a clearance, first hits or a
/// resolution of another question, or ignored ranges that are not in order. Null if there is
/// nothing. All that read a query from bytes that others wrote call this.
[[nodiscard]] const char* query_problem(const Query& query);

} // namespace cd
