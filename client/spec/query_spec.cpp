#include "client/spec/query_spec.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cd {

namespace {

constexpr std::string_view distance_word = asked_levels.back();

/// Below level pairs, results list no pairs that a limit could cut; at level any, a search finds no
/// triangles that maps could count.
std::optional<QueryConflict> conflict_with_level(const Query& query) {
    if (query.limit_pairs != 0 && query.level < Level::Pairs) {
        return QueryConflict{"limit_pairs",
                             "level",
                             "limit_pairs cuts the lists of level pairs and above; set one of "
                             "these levels, or leave out limit_pairs"};
    }
    if (query.maps && query.level == Level::Any) {
        return QueryConflict{"maps",
                             "level",
                             "maps need level count, pairs or contacts, since level any finds no "
                             "triangles; set another level, or leave out maps"};
    }
    return std::nullopt;
}

std::optional<QueryConflict> conflict_of_shots(const Query& query) {
    if (query.level != Level::Count && query.level != Level::Pairs) {
        return QueryConflict{"level",
                             "[shots]",
                             "lines of [shots] are asked at level count or pairs; set one of "
                             "these"};
    }
    if (query.clearance) {
        return QueryConflict{"clearance",
                             "[shots]",
                             "a line of [shots] hits a triangle or does not, however near it is; "
                             "leave out clearance, or write [b] and [poses] instead of [shots]"};
    }
    if (query.up_to) {
        return QueryConflict{"up_to",
                             "[shots]",
                             "up_to belongs to level distance, which lines of [shots] do not have; "
                             "leave out up_to"};
    }
    return conflict_with_level(query);
}

std::optional<QueryConflict> conflict_of_motion(const Query& query) {
    if (query.question != Question::Motion ||
        (query.level != Level::Any && query.level != Level::Pairs)) {
        return QueryConflict{"level",
                             "[motion]",
                             "motions of [motion] are asked at level any or pairs; set one of "
                             "these"};
    }
    if (query.up_to) {
        return QueryConflict{"up_to",
                             "[motion]",
                             "up_to belongs to level distance, which motions do not have; leave "
                             "out up_to"};
    }
    if (query.maps) {
        return QueryConflict{"maps",
                             "[motion]",
                             "a motion has the contacts of one instant alone, which maps do not "
                             "count; leave out maps, or leave out [motion]"};
    }
    return conflict_with_level(query);
}

} // namespace

std::string_view asked_level(const Query& query) {
    return query.question == Question::Distance ? distance_word : to_text(query.level);
}

bool set_asked_level(std::string_view word, Query& query) {
    const bool is_distance = word == distance_word;
    const auto level = is_distance ? std::optional(Level::Any) : level_from_text(word);
    if (!level) {
        return false;
    }
    query.level = *level;
    if (query.question != Question::Shots) {
        query.question = is_distance    ? Question::Distance
                         : query.motion ? Question::Motion
                                        : Question::Contacts;
    }
    return true;
}

std::optional<QueryConflict> conflict_in(const Query& query) {
    if (query.question == Question::Shots) {
        return conflict_of_shots(query);
    }
    if (query.motion) {
        return conflict_of_motion(query);
    }
    if (query.question != Question::Distance) {
        return query.up_to ? QueryConflict{"up_to",
                                           "level",
                                           "up_to belongs to level distance; set that level, or "
                                           "leave out up_to"}
                           : conflict_with_level(query);
    }
    if (query.clearance) {
        return QueryConflict{"clearance",
                             "level",
                             "level distance tells how far apart the bodies are, whatever is near; "
                             "leave out clearance, or write up_to, beyond which none is told"};
    }
    if (query.limit_pairs != 0) {
        return QueryConflict{"limit_pairs",
                             "level",
                             "level distance lists no pairs; leave out limit_pairs, or set another "
                             "level"};
    }
    if (query.maps) {
        return QueryConflict{"maps",
                             "level",
                             "level distance finds no contacts that maps could count; leave out "
                             "maps, or set another level"};
    }
    return std::nullopt;
}

std::optional<QueryConflict> conflict_in_scene(const Query& query) {
    if (query.question == Question::Distance && !query.up_to) {
        return QueryConflict{"level",
                             "[bodies]",
                             "with [bodies], level distance needs up_to: pairs of bodies that are "
                             "farther apart get no distance"};
    }
    if (query.maps && query.question == Question::Shots) {
        return QueryConflict{"maps",
                             "[bodies]",
                             "maps count the triangles of one body; with [bodies] leave out maps: "
                             "the parts that lines cross are in the summary"};
    }
    if (query.maps) {
        return QueryConflict{
            "maps",
            "[bodies]",
            "maps count the contacts of two bodies' triangles; with [bodies] leave "
            "out maps, and level pairs tells which parts are in contact"};
    }
    return std::nullopt;
}

double with_chord(double clearance, double chord) {
    const double sum = clearance + chord;
    const double larger = std::max(clearance, chord);
    // Exact: Dekker, A floating-point technique (1971), section 4.
    const bool is_below = sum - larger < std::min(clearance, chord);
    return is_below ? std::nextafter(sum, std::numeric_limits<double>::infinity()) : sum;
}

Query covering(Query query, const std::optional<double>& chord) {
    if (chord) {
        query.clearance = with_chord(query.clearance.value_or(0), *chord);
    }
    return query;
}

} // namespace cd
