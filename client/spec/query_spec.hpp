// What users write to ask a question.
#pragma once

#include "common/job/query.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace cd {

/// The words of the key `level`: the names of the levels, then that of the distance, which is a
/// question of its own at level any.
inline constexpr std::array<std::string_view, 5> asked_levels{
    "any", "count", "pairs", "contacts", "distance"};

/// The words of the key `until` of [motion], in the order of `Until`.
inline constexpr std::array<std::string_view, 3> until_words{"contact", "free", "end"};

[[nodiscard]] constexpr std::string_view to_text(Until until) {
    return until_words[static_cast<std::size_t>(until)];
}

/// Returns the word for what a query asks.
[[nodiscard]] std::string_view asked_level(const Query& query);

/// Sets the level and the question that `word` stands for. The question of shots stays, and with
/// the word of the distance it has a level that `conflict_in` refuses; so does the distance of a
/// query with a motion. Returns false if it is none of `asked_levels`.
[[nodiscard]] bool set_asked_level(std::string_view word, Query& query);

/// A key of [query] that does not go together with the level, or with another table.
struct QueryConflict {
    std::string_view key;
    std::string_view other;  ///< The other key, or the table: level, [shots], [motion] or
                             ///< [bodies].
    std::string_view reason; ///< Also says what to do.
};

/// Returns the first key that the query may not have: clearance, limit_pairs and maps of a
/// distance, another level than count and pairs and a clearance of shots, another level than any
/// and pairs and maps of motions, up_to of anything but a distance, limit_pairs below level pairs,
/// and maps at level any.
[[nodiscard]] std::optional<QueryConflict> conflict_in(const Query& query);

/// Returns the first key that the query of a scene may not have: the distance without up_to, and
/// maps.
[[nodiscard]] std::optional<QueryConflict> conflict_in_scene(const Query& query);

/// Returns the sum of a clearance and a chord, rounded up.
[[nodiscard]] double with_chord(double clearance, double chord);

/// Returns the query with a clearance that covers the chord of curves as well, if there is one.
[[nodiscard]] Query covering(Query query, const std::optional<double>& chord);

} // namespace cd
