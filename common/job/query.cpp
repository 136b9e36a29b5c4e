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

namespace {

const char* problem_of_distance(const Query& query) {
    const bool asks_more =
        query.level != Level::Any || query.clearance || query.maps || query.limit_pairs != 0;
    return asks_more ? "a distance with a level, clearance, maps or limit_pairs" : nullptr;
}

const char* problem_of_motion(const Query& query) {
    if (!query.motion || !std::isfinite(query.motion->resolution) ||
        !(query.motion->resolution > 0) || query.motion->until > Until::End) {
        return "a motion without a resolution above 0";
    }
    const bool is_level = query.level == Level::Any || query.level == Level::Pairs;
    return is_level && !query.maps ? nullptr
                                   : "a motion with maps, or at another level than any and pairs";
}

const char* problem_of_shots(const Query& query) {
    const bool is_level = query.level == Level::Count || query.level == Level::Pairs;
    return is_level && !query.clearance
               ? nullptr
               : "shots with a clearance, or at another level than count and pairs";
}

} // namespace

const char* query_problem(const Query& query) {
    if (query.question > Question::Shots) {
        return "an unknown question";
    }
    if (query.clearance && !is_clearance(*query.clearance)) {
        return "a clearance that is negative or not finite";
    }
    if (query.up_to && !is_clearance(*query.up_to)) {
        return "an up_to that is negative or not finite";
    }
    if (!are_in_order(query.ignored)) {
        return "ignored parts whose bodies are not in order";
    }
    if (query.first_hits && query.question != Question::Shots) {
        return "first hits without the question of shots";
    }
    if (query.up_to && query.question != Question::Distance) {
        return "an up_to without the question of the distance";
    }
    if (query.motion && query.question != Question::Motion) {
        return "a resolution without the question of motions";
    }
    switch (query.question) {
    case Question::Contacts:
        return nullptr;
    case Question::Distance:
        return problem_of_distance(query);
    case Question::Motion:
        return problem_of_motion(query);
    case Question::Shots:
        return problem_of_shots(query);
    }
    return nullptr;
}

} // namespace cd
