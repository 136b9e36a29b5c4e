#include "common/job/result/result_sense.hpp"

#include "common/core/errors.hpp"

#include <algorithm>
#include <string>

namespace cd {

namespace {

Error bad(const char* what) {
    return {ErrorCode::BadFrame, std::string("result record: ") + what};
}

/// Checks that the numbers of near pairs fit the class and the pairs.
Status check_near(const ScenarioResult& result) {
    const bool is_near = result.kind == ScenarioClass::Near;
    const bool may_count = result.level != Level::Any && result.kind != ScenarioClass::Separate &&
                           result.kind != ScenarioClass::Undecided &&
                           result.kind != ScenarioClass::Failed;
    const std::uint64_t listed = result.has_clearance ? listed_near_pairs(result) : 0;
    if ((is_near && !result.has_clearance) || (result.near_count > 0 && !may_count) ||
        (is_near && result.near_count == 0 && result.level != Level::Any) ||
        listed > result.near_count || result.pairs.size() - listed > result.pair_count) {
        return bad("a number of near pairs that does not fit the class");
    }
    return Done{};
}

/// Checks that a distance fits level and class.
Status check_distance(const ScenarioResult& result) {
    if (result.question != Question::Distance) {
        return Done{};
    }
    const bool may_have_distance =
        result.kind == ScenarioClass::Separate || result.kind == ScenarioClass::Inside;
    const bool has_none =
        result.kind == ScenarioClass::Contact || result.kind == ScenarioClass::Failed;
    if (result.level != Level::Any || !(may_have_distance || (has_none && !result.nearest))) {
        return bad("a distance that does not fit the level or class");
    }
    return Done{};
}

/// Checks that class and outcome of a motion fit.
Status check_motion(const ScenarioResult& result) {
    if (result.question != Question::Motion) {
        return Done{};
    }
    if (result.level != Level::Any && result.level != Level::Pairs) {
        return bad("a motion at another level than any and pairs");
    }
    if (result.kind == ScenarioClass::Failed) {
        return Done{};
    }
    const MotionOutcome& motion = result.motion.value();
    const bool has_event = motion.event().has_value();
    const bool is_free = !has_event && !motion.has_open_run() && motion.end != MotionEnd::Limit;
    bool fits = has_event;
    if (result.kind == ScenarioClass::Separate) {
        fits = is_free;
    } else if (result.kind == ScenarioClass::Undecided) {
        fits = !has_event && !is_free && result.pair_count == 0;
    } else if (result.kind == ScenarioClass::Inside) {
        fits = is_free || (has_event && result.has_clearance);
    }
    return fits ? Status(Done{}) : bad("a motion that does not fit the class");
}

/// Checks a record of hits: some make a contact, and none are more than are counted.
Status check_shots(const ScenarioResult& result) {
    const bool is_level = result.level == Level::Count || result.level == Level::Pairs;
    const bool is_class = result.kind == ScenarioClass::Contact
                              ? result.pair_count > 0
                              : result.pair_count == 0 && (result.kind == ScenarioClass::Separate ||
                                                           result.kind == ScenarioClass::Failed);
    if (!is_level || !is_class || result.pairs.size() > result.pair_count || result.surfaces_only ||
        result.insides_skipped) {
        return bad("hits that do not fit the level or class");
    }
    return Done{};
}

} // namespace

std::uint64_t listed_near_pairs(const ScenarioResult& result) {
    return static_cast<std::uint64_t>(
        std::ranges::count(result.pairs, PairClass::Near, &ContactPair::kind));
}

Status check_sense(const ScenarioResult& result) {
    if (result.question == Question::Shots) {
        return check_shots(result);
    }
    const bool is_any = result.level == Level::Any;
    const bool in_contact =
        result.kind == ScenarioClass::Touch || result.kind == ScenarioClass::Cross;
    if (is_any ? in_contact : result.kind == ScenarioClass::Contact) {
        return bad("a class that its level does not know");
    }
    const bool may_count = in_contact || result.kind == ScenarioClass::Undecided;
    if ((result.pair_count > 0 && (is_any || !may_count)) ||
        (result.pair_count == 0 && in_contact)) {
        return bad("a number of pairs that does not fit the class");
    }
    CD_TRY(check_near(result));
    CD_TRY(check_distance(result));
    CD_TRY(check_motion(result));
    if (result.pair_count > 0 && result.distance_bound > 0) {
        return bad("a distance between bodies in contact");
    }
    const bool is_wrong_touch = result.kind == ScenarioClass::Touch &&
                                std::ranges::any_of(result.pairs, [](const auto& pair) {
                                    return pair.kind == PairClass::Proper;
                                });
    return is_wrong_touch ? bad("a touch with a proper pair") : Status(Done{});
}

} // namespace cd
