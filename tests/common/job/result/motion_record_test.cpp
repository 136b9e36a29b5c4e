// Proves that the result of a motion has one record: it is restored exactly, its bytes are the
// golden ones, and records that no search gives are refused.

#include "common/job/result/result.hpp"
#include "tests/common/job/result/settled_records.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <limits>
#include <random>

namespace cd::tests {

namespace {

using testing::HasSubstr;

constexpr CellRun free_run(std::uint32_t first, std::uint32_t count) {
    return {CellState::Free, first, count};
}

constexpr CellRun open_run(std::uint32_t first,
                           std::uint32_t count,
                           std::uint32_t event_first = 1,
                           std::uint32_t event_last = 0) {
    return {CellState::Open, first, count, event_first, event_last};
}

ScenarioResult of_motion(ScenarioClass kind) {
    ScenarioResult result;
    result.index = 12345;
    result.body_a = 3;
    result.body_b = 9;
    result.question = Question::Motion;
    result.level = Level::Any;
    result.kind = kind;
    if (kind != ScenarioClass::Failed) {
        result.motion.emplace().depth = 4;
    }
    return result;
}

/// Free throughout.
ScenarioResult passing() {
    ScenarioResult result = of_motion(ScenarioClass::Separate);
    result.motion->runs = {free_run(0, 16)};
    result.motion->t0 = 16;
    result.motion->t1 = 16;
    return result;
}

/// In contact from a quarter of the time on.
ScenarioResult hitting() {
    ScenarioResult result = of_motion(ScenarioClass::Cross);
    result.level = Level::Pairs;
    result.pair_count = 2;
    result.pairs = {{1, 2, PairClass::Touch}, {1, 3, PairClass::Proper}};
    result.motion->end = MotionEnd::Contact;
    result.motion->runs = {free_run(0, 3), open_run(3, 1, 4, 4)};
    result.motion->t0 = 3;
    result.motion->t1 = 4;
    return result;
}

/// Nearer than the clearance from the begin on.
ScenarioResult starting() {
    ScenarioResult result = of_motion(ScenarioClass::Near);
    result.has_clearance = true;
    result.motion->end = MotionEnd::Start;
    return result;
}

/// Leaves a contact.
ScenarioResult leaving() {
    ScenarioResult result = of_motion(ScenarioClass::Contact);
    result.motion->until = Until::Free;
    result.motion->runs = {open_run(0, 6, 0, 5), free_run(6, 2)};
    result.motion->t0 = 5;
    result.motion->t1 = 6;
    return result;
}

/// Comes too near to tell.
ScenarioResult undecided() {
    ScenarioResult result = of_motion(ScenarioClass::Undecided);
    result.distance_bound = 0.25;
    result.motion->until = Until::End;
    result.motion->runs = {free_run(0, 7), open_run(7, 2), free_run(9, 7)};
    result.motion->t0 = 16;
    result.motion->t1 = 16;
    return result;
}

/// Ended early.
ScenarioResult unfinished() {
    ScenarioResult result = of_motion(ScenarioClass::Undecided);
    result.distance_bound = std::numeric_limits<double>::infinity();
    result.motion->end = MotionEnd::Limit;
    result.motion->runs = {free_run(0, 5)};
    result.motion->t0 = 5;
    result.motion->t1 = 5;
    return result;
}

ScenarioResult failed() {
    ScenarioResult result = of_motion(ScenarioClass::Failed);
    result.failure = "three workers were lost with it";
    return result;
}

std::vector<ScenarioResult> examples() {
    return {passing(), hitting(), starting(), leaving(), undecided(), unfinished(), failed()};
}

std::string refusal_of(const Bytes& bytes) {
    const auto decoded = decode_result(bytes);
    EXPECT_TRUE(decoded || decoded.error().code == ErrorCode::BadFrame);
    return decoded ? "taken" : decoded.error().detail;
}

/// Returns why the record of a changed result is refused, or "taken".
std::string refusal(ScenarioResult result, const std::function<void(ScenarioResult&)>& change) {
    change(result);
    return refusal_of(encode_result(result));
}

} // namespace

TEST(MotionRecord, ComesBackToTheSameResult) {
    for (const ScenarioResult& result : examples()) {
        const Bytes bytes = encode_result(result);
        const auto decoded = decode_result(bytes);
        ASSERT_TRUE(decoded) << decoded.error().detail;
        const ScenarioResult& again = decoded.value();
        EXPECT_EQ(again.question, Question::Motion);
        EXPECT_EQ(again.kind, result.kind);
        EXPECT_EQ(again.motion, result.motion);
        EXPECT_EQ(again.has_clearance, result.has_clearance);
        EXPECT_EQ(again.distance_bound, result.distance_bound);
        EXPECT_EQ(again.pairs, result.pairs);
        EXPECT_EQ(encode_result(again), bytes);
    }
}

TEST(MotionRecord, ASettledResultHasTheRecordThatItsEncodingGives) {
    expect_settled_records(examples());
}

TEST(MotionRecord, TellsAtWhichInstantItsAnswerHolds) {
    EXPECT_EQ(passing().motion->event(), std::nullopt);
    EXPECT_EQ(hitting().motion->event(), 4u);
    EXPECT_EQ(starting().motion->event(), 0u);
    EXPECT_EQ(leaving().motion->event(), 5u);
    EXPECT_EQ(undecided().motion->event(), std::nullopt);
}

TEST(MotionRecord, RefusesRunsThatNoSearchFinds) {
    const std::string none = "runs that are none";
    const auto with_runs = [&](std::vector<CellRun> runs) {
        return refusal(undecided(), [&](ScenarioResult& r) { r.motion->runs = std::move(runs); });
    };
    EXPECT_EQ(with_runs({free_run(0, 7), open_run(7, 2), free_run(9, 7)}), "taken");
    EXPECT_THAT(with_runs({free_run(1, 15)}), HasSubstr(none)) << "not from the begin";
    EXPECT_THAT(with_runs({free_run(0, 7), open_run(8, 8)}), HasSubstr(none)) << "a gap";
    EXPECT_THAT(with_runs({free_run(0, 7), open_run(6, 10)}), HasSubstr(none)) << "an overlap";
    EXPECT_THAT(with_runs({free_run(0, 7), free_run(7, 9)}), HasSubstr(none)) << "of one state";
    EXPECT_THAT(with_runs({free_run(0, 7), open_run(7, 0), free_run(7, 9)}), HasSubstr(none));
    EXPECT_THAT(with_runs({free_run(0, 7), open_run(7, 10)}), HasSubstr(none)) << "too long";
    EXPECT_THAT(with_runs({open_run(0, 16, 3, 17)}), HasSubstr(none)) << "an event outside";
    EXPECT_THAT(with_runs({open_run(0, 16, 7, 6)}), HasSubstr(none)) << "two ways to have none";
    EXPECT_THAT(with_runs({}), HasSubstr("no runs"));
    CellRun eventful = free_run(0, 16);
    eventful.event_first = eventful.event_last = 3;
    EXPECT_THAT(with_runs({eventful}), HasSubstr(none)) << "an event of a free run";
    EXPECT_THAT(refusal(undecided(), [](ScenarioResult& r) { r.motion->depth = 20; }),
                HasSubstr(none));
}

TEST(MotionRecord, RefusesAnEndThatTheRunsDoNotGive) {
    const std::string misfit = "an end that does not fit the runs";
    for (const ScenarioResult& result :
         {passing(), hitting(), leaving(), undecided(), unfinished()}) {
        const MotionOutcome right = *result.motion;
        for (int end = 0; end < 4; ++end) {
            if (static_cast<MotionEnd>(end) != right.end) {
                EXPECT_THAT(refusal(result,
                                    [&](ScenarioResult& r) {
                                        r.motion->end = static_cast<MotionEnd>(end);
                                    }),
                            HasSubstr(misfit));
            }
        }
        EXPECT_THAT(refusal(result, [](ScenarioResult& r) { ++r.motion->t0; }), HasSubstr(misfit));
        EXPECT_THAT(refusal(result, [](ScenarioResult& r) { --r.motion->t1; }), HasSubstr(misfit));
    }
    EXPECT_THAT(refusal(starting(), [](ScenarioResult& r) { r.motion->t1 = 1; }),
                HasSubstr("no runs"));
    // A search for the first contact ends there, and one for the way out with its first free part.
    EXPECT_THAT(
        refusal(hitting(), [](ScenarioResult& r) { r.motion->runs.push_back(free_run(4, 12)); }),
        HasSubstr(misfit));
    EXPECT_THAT(
        refusal(leaving(), [](ScenarioResult& r) { r.motion->runs.push_back(open_run(8, 8)); }),
        HasSubstr(misfit));
}

TEST(MotionRecord, RefusesAClassThatTheMotionDoesNotGive) {
    const std::string misfit = "a motion that does not fit the class";
    const auto as = [](const ScenarioResult& result, ScenarioClass kind) {
        return refusal(result, [&](ScenarioResult& r) { r.kind = kind; });
    };
    EXPECT_EQ(as(passing(), ScenarioClass::Inside), "taken");
    EXPECT_THAT(as(passing(), ScenarioClass::Contact), HasSubstr(misfit));
    EXPECT_THAT(as(leaving(), ScenarioClass::Separate), HasSubstr(misfit));
    EXPECT_THAT(as(leaving(), ScenarioClass::Inside), HasSubstr(misfit));
    EXPECT_EQ(as(starting(), ScenarioClass::Inside), "taken") << "near at the begin, and inside";
    EXPECT_THAT(refusal(undecided(),
                        [](ScenarioResult& r) {
                            r.kind = ScenarioClass::Separate;
                            r.distance_bound = 0;
                        }),
                HasSubstr(misfit));
    EXPECT_THAT(refusal(passing(),
                        [](ScenarioResult& r) {
                            r.kind = ScenarioClass::Undecided;
                            r.distance_bound = 1;
                        }),
                HasSubstr(misfit));
    EXPECT_THAT(refusal(passing(), [](ScenarioResult& r) { r.level = Level::Count; }),
                HasSubstr("another level"));
}

TEST(MotionRecord, NoBytesBreakTheDecoder) {
    std::mt19937_64 random(3);
    for (const ScenarioResult& result : examples()) {
        const Bytes bytes = encode_result(result);
        for (std::size_t length = 0; length < bytes.size(); ++length) {
            EXPECT_NE(refusal_of(Bytes(bytes.begin(), bytes.begin() + static_cast<long>(length))),
                      "taken");
        }
        for (int round = 0; round < 2000; ++round) {
            Bytes damaged = bytes;
            damaged[random() % damaged.size()] ^= std::byte(1u << random() % 8);
            if (const auto decoded = decode_result(damaged)) {
                EXPECT_EQ(encode_result(decoded.value()), damaged);
            }
        }
    }
}

} // namespace cd::tests
