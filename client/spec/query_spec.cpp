#include "client/spec/query_spec.hpp"

namespace cd {

namespace {

constexpr std::string_view distance_word = asked_levels.back();

/// Below level pairs, results list no pairs that a limit could cut; at level any, a search finds no
/// triangles that maps could count.
std::optional<QueryConflict> conflict_with_level(const Query& query) {
    if (query.limit_pairs != 0 && query.level < Level::Pairs) {
        return QueryConflict{"limit_pairs",
                             "limit_pairs cuts the lists of level pairs and above; set one of "
                             "these levels, or leave out limit_pairs"};
    }
    if (query.maps && query.level == Level::Any) {
        return QueryConflict{"maps",
                             "maps need level count, pairs or contacts, since level any finds no "
                             "triangles; set another level, or leave out maps"};
    }
    return std::nullopt;
}

std::optional<QueryConflict> conflict_of_shots(const Query& query) {
    if (query.level != Level::Count && query.level != Level::Pairs) {
        return QueryConflict{"level",
                             "lines of [shots] are asked at level count or pairs; set one of "
                             "these"};
    }
    if (query.clearance) {
        return QueryConflict{"clearance",
                             "a line of [shots] hits a triangle or does not, however near it is; "
                             "leave out clearance, or write [b] and [poses] instead of [shots]"};
    }
    if (query.up_to) {
        return QueryConflict{"up_to",
                             "up_to belongs to level distance, which lines of [shots] do not have; "
                             "leave out up_to"};
    }
    return conflict_with_level(query);
}

std::optional<QueryConflict> conflict_of_motion(const Query& query) {
    if (query.question != Question::Motion ||
        (query.level != Level::Any && query.level != Level::Pairs)) {
        return QueryConflict{"level",
                             "motions of [motion] are asked at level any or pairs; set one of "
                             "these"};
    }
    if (query.up_to) {
        return QueryConflict{"up_to",
                             "up_to belongs to level distance, which motions do not have; leave "
                             "out up_to"};
    }
    if (query.maps) {
        return QueryConflict{"maps",
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
                                           "up_to belongs to level distance; set that level, or "
                                           "leave out up_to"}
                           : conflict_with_level(query);
    }
    if (query.clearance) {
        return QueryConflict{"clearance",
                             "level distance tells how far apart the bodies are, whatever is near; "
                             "leave out clearance, or write up_to, beyond which none is told"};
    }
    if (query.limit_pairs != 0) {
        return QueryConflict{"limit_pairs",
                             "level distance lists no pairs; leave out limit_pairs, or set another "
                             "level"};
    }
    if (query.maps) {
        return QueryConflict{"maps",
                             "level distance finds no contacts that maps could count; leave out "
                             "maps, or set another level"};
    }
    return std::nullopt;
}

} // namespace cd
