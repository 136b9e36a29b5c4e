// Proves that a result of a query for a distance has one record: it is restored exactly, its bytes
// and digest are the golden ones, and records that no search gives are refused.

#include "common/distance/nearest_points.hpp"
#include "common/job/result/merge.hpp"
#include "common/job/result/packed_records.hpp"
#include "common/job/result/result.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <random>

namespace cd::tests {

namespace {

using testing::HasSubstr;

ScenarioResult of_distance(ScenarioClass kind) {
    ScenarioResult result;
    result.index = 12345;
    result.body_a = 3;
    result.body_b = 9;
    result.question = Question::Distance;
    result.level = Level::Any;
    result.kind = kind;
    return result;
}

ScenarioResult apart() {
    ScenarioResult result = of_distance(ScenarioClass::Separate);
    result.nearest = NearestWitness{
        0.0625, 70000, 3, 41, Vec3(1, -2, 1e300), Vec3(-0.0, 0.1, 5e-324), Vec3(4, 5, 6)};
    return result;
}

ScenarioResult inside() {
    ScenarioResult result = of_distance(ScenarioClass::Inside);
    result.nearest = NearestWitness{2.5, 0, 1, 0, Vec3(1, 2, 3), Vec3(0, 0, 0), Vec3(0, 2.5, 0)};
    return result;
}

ScenarioResult beyond_up_to() {
    ScenarioResult result = of_distance(ScenarioClass::Separate);
    result.surfaces_only = true;
    return result;
}

ScenarioResult in_contact() {
    return of_distance(ScenarioClass::Contact);
}

ScenarioResult failed() {
    ScenarioResult result = of_distance(ScenarioClass::Failed);
    result.failure = "three workers were lost with it";
    return result;
}

std::vector<ScenarioResult> examples() {
    return {apart(), inside(), beyond_up_to(), in_contact(), failed()};
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

std::string refusal_of_byte(const ScenarioResult& result, std::size_t place, std::uint8_t value) {
    Bytes bytes = encode_result(result);
    bytes.at(place) = std::byte{value};
    return refusal_of(bytes);
}

/// Returns why the record is refused if a number is written over the bytes at `place`.
std::string refusal_of_number(const ScenarioResult& result, std::size_t place, double value) {
    Bytes bytes = encode_result(result);
    std::memcpy(bytes.data() + place, &value, sizeof value);
    return refusal_of(bytes);
}

constexpr std::size_t question_place = 1;
constexpr std::size_t level_place = 18;
constexpr std::size_t class_place = 19;
constexpr std::size_t count_place = 21;
constexpr std::size_t step_place = 29;
constexpr std::size_t has_distance_place = 37;
constexpr std::size_t distance_place = 38;
constexpr std::size_t feature_place = 54;
constexpr std::size_t origin_place = 55;

} // namespace

TEST(DistanceRecord, ComesBackToTheSameResult) {
    for (const ScenarioResult& result : examples()) {
        const Bytes bytes = encode_result(result);
        const auto decoded = decode_result(bytes);
        ASSERT_TRUE(decoded) << decoded.error().detail;
        const ScenarioResult& again = decoded.value();
        EXPECT_EQ(encode_result(again), bytes);
        EXPECT_EQ(again.question, Question::Distance);
        EXPECT_FALSE(again.has_clearance);
        EXPECT_EQ(again.index, result.index);
        EXPECT_EQ(again.body_a, result.body_a);
        EXPECT_EQ(again.body_b, result.body_b);
        EXPECT_EQ(again.level, result.level);
        EXPECT_EQ(again.kind, result.kind);
        EXPECT_EQ(again.surfaces_only, result.surfaces_only);
        EXPECT_EQ(again.nearest, result.nearest);
        EXPECT_EQ(again.failure, result.failure);
        EXPECT_FALSE(again.is_cut());
    }
}

TEST(DistanceRecord, BytesAreTheGoldenOnes) {
    const Bytes bytes = encode_result(apart());
    ASSERT_EQ(bytes.size(), 127u);
    EXPECT_EQ(encode_result(in_contact()).size(), 38u);
    const std::string begin("\3\1\x39\x30\0\0\0\0\0\0\3\0\0\0\x09\0\0\0\0\0\0"
                            "\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\1"
                            "\0\0\0\0\0\0\xb0\x3f\x70\x11\1\0\3\0\0\0\x29",
                            origin_place);
    EXPECT_EQ(std::memcmp(bytes.data(), begin.data(), begin.size()), 0);
}

TEST(DistanceRecord, DigestsAreTheGoldenOnes) {
    // These stand for all stored results: another value means another version of the record.
    EXPECT_EQ(to_short_hex(digest_of(apart())), "1be1fca3c93cd299");
    EXPECT_EQ(to_short_hex(digest_of(inside())), "86d8fb7a5a9ca9da");
    EXPECT_EQ(to_short_hex(digest_of(beyond_up_to())), "cd9b6df955867664");
    EXPECT_EQ(to_short_hex(digest_of(in_contact())), "70206eb001bf72ed");
    EXPECT_EQ(to_short_hex(digest_of(failed())), "d1eae39305f46f96");
}

TEST(DistanceRecord, TheQuestionIsPartOfTheRecordAlthoughThereIsNoDistance) {
    ScenarioResult contact = in_contact();
    const Sha256 digest = digest_of(contact);
    contact.question = Question::Contacts;
    EXPECT_NE(digest_of(contact), digest);
}

TEST(DistanceRecord, RefusesEveryTruncation) {
    for (const ScenarioResult& result : examples()) {
        Bytes bytes = encode_result(result);
        for (std::size_t size = 0; size < bytes.size(); ++size) {
            ASSERT_FALSE(decode_result(std::span(bytes).first(size))) << size;
        }
        bytes.push_back(std::byte{0});
        ASSERT_FALSE(decode_result(bytes));
    }
}

TEST(DistanceRecord, RefusesFieldsOutOfRange) {
    EXPECT_THAT(refusal_of_byte(apart(), 0, 4), HasSubstr("version"));
    EXPECT_THAT(refusal_of_byte(apart(), question_place, 4), HasSubstr("question"));
    EXPECT_THAT(refusal_of_byte(apart(), class_place, 8), HasSubstr("unknown level, class"));
    EXPECT_THAT(refusal_of_byte(apart(), step_place, 1), HasSubstr("step outside a scene"));
    EXPECT_THAT(refusal_of_byte(apart(), has_distance_place, 2), HasSubstr("flag of a distance"));
    EXPECT_THAT(refusal_of_byte(apart(), has_distance_place, 0), HasSubstr("left over"));
    EXPECT_THAT(refusal_of_byte(beyond_up_to(), has_distance_place, 1), HasSubstr("cut short"));
    EXPECT_EQ(refusal_of_byte(apart(), feature_place, feature::count - 1), "taken");
    EXPECT_THAT(refusal_of_byte(apart(), feature_place, feature::count),
                HasSubstr("a distance that is none"));
}

TEST(DistanceRecord, RefusesNumbersThatAreNoDistance) {
    for (const double distance : {0.0, 5e-324, 1.0, std::numeric_limits<double>::max()}) {
        EXPECT_EQ(refusal_of_number(apart(), distance_place, distance), "taken") << distance;
    }
    for (const double none : {-0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        EXPECT_THAT(refusal_of_number(apart(), distance_place, none),
                    HasSubstr("a distance that is none"))
            << none;
    }
}

TEST(DistanceRecord, RefusesPointsThatAreNotCanonical) {
    for (std::size_t number = 0; number < 9; ++number) {
        const std::size_t place = origin_place + number * sizeof(double);
        EXPECT_EQ(refusal_of_number(apart(), place, 7), "taken") << number;
        EXPECT_THAT(refusal_of_number(apart(), place, -0.0), HasSubstr("canonical form")) << number;
    }
}

TEST(DistanceRecord, RefusesADistanceThatDoesNotFitTheClass) {
    for (const ScenarioClass kind : {ScenarioClass::Contact,
                                     ScenarioClass::Touch,
                                     ScenarioClass::Cross,
                                     ScenarioClass::Undecided,
                                     ScenarioClass::Near}) {
        EXPECT_NE(refusal(apart(), [&](auto& r) { r.kind = kind; }), "taken") << to_text(kind);
    }
    for (const ScenarioClass kind : {ScenarioClass::Separate, ScenarioClass::Inside}) {
        EXPECT_EQ(refusal(in_contact(), [&](auto& r) { r.kind = kind; }), "taken");
    }
    for (const ScenarioClass kind : {ScenarioClass::Undecided, ScenarioClass::Near}) {
        EXPECT_NE(refusal(in_contact(), [&](auto& r) { r.kind = kind; }), "taken");
    }
}

TEST(DistanceRecord, IsOfLevelAnyAndHasNoPairs) {
    for (const std::uint8_t level : {1, 2, 3}) {
        EXPECT_THAT(refusal_of_byte(apart(), level_place, level),
                    HasSubstr("does not fit the level or class"));
    }
    EXPECT_THAT(refusal_of_byte(in_contact(), count_place, 1), HasSubstr("number of pairs"));
    EXPECT_THAT(refusal_of_byte(apart(), count_place, 1), HasSubstr("number of pairs"));
}

TEST(DistanceRecord, SurvivesDamage) {
    std::mt19937_64 random(12);
    const Bytes bytes = encode_result(apart());
    for (int round = 0; round < 50'000; ++round) {
        Bytes damaged = bytes;
        for (std::uint64_t flips = 1 + random() % 3; flips > 0; --flips) {
            damaged[random() % damaged.size()] ^= static_cast<std::byte>(1u << (random() % 8));
        }
        if (const auto decoded = decode_result(damaged)) {
            ASSERT_EQ(encode_result(decoded.value()), damaged);
        }
    }
}

TEST(DistanceRecord, OverTheLimitIsAFailureOfTheSameQuestion) {
    ScenarioResult result = apart();
    fail_above_limit(result, 1000);
    EXPECT_EQ(result.nearest, apart().nearest);
    fail_above_limit(result, 10);
    EXPECT_EQ(result.kind, ScenarioClass::Failed);
    EXPECT_EQ(result.question, Question::Distance);
    EXPECT_FALSE(result.nearest);
    const auto again = decode_result(encode_result(result));
    ASSERT_TRUE(again) << again.error().detail;
    EXPECT_EQ(again.value().question, Question::Distance);
}

TEST(DistanceRecord, IsPackedWhole) {
    ByteWriter out;
    for (const ScenarioResult& result : examples()) {
        EXPECT_FALSE(bytes_before_pairs(encode_result(result)));
        put_record(out, result);
    }
    const Bytes records = out.take();
    EXPECT_EQ(unpack_records(pack_records(records), 1u << 20).value(), records);
}

TEST(DistanceRecord, TheMergerCountsClassesAndNoPairs) {
    ResultMerger merger(examples().size());
    std::uint64_t index = 0;
    for (ScenarioResult result : examples()) {
        result.index = index++;
        EXPECT_EQ(merger.add(result), ResultMerger::Outcome::Added);
    }
    const Summary& summary = merger.summary();
    EXPECT_EQ(summary.separate, 2u);
    EXPECT_EQ(summary.inside, 1u);
    EXPECT_EQ(summary.contact, 1u);
    EXPECT_EQ(summary.failed, 1u);
    EXPECT_EQ(summary.surfaces_only, 1u);
    EXPECT_EQ(summary.pairs + summary.near_pairs + summary.cut, 0u);
}

} // namespace cd::tests
