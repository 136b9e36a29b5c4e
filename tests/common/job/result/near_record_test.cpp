// Proves that a result of a query with a clearance has one record: it is restored exactly, its
// bytes and digest are the golden ones, and records that no search gives are refused.

#include "common/core/files/disk_file.hpp"
#include "common/job/result/merge.hpp"
#include "common/job/result/packed_records.hpp"
#include "common/job/result/result.hpp"
#include "common/job/result/result_sense.hpp"
#include "tests/common/job/result/settled_records.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

namespace cd::tests {

namespace {

using testing::HasSubstr;

ScenarioResult with_clearance(Level level, ScenarioClass kind) {
    ScenarioResult result;
    result.index = 12345;
    result.body_a = 3;
    result.body_b = 9;
    result.level = level;
    result.kind = kind;
    result.has_clearance = true;
    return result;
}

ScenarioResult near_at_level_any() {
    return with_clearance(Level::Any, ScenarioClass::Near);
}

ScenarioResult inside_at_level_count() {
    ScenarioResult result = with_clearance(Level::Count, ScenarioClass::Inside);
    result.near_count = 1u << 20;
    return result;
}

ScenarioResult cross_at_level_pairs() {
    ScenarioResult result = with_clearance(Level::Pairs, ScenarioClass::Cross);
    result.pair_count = 9;
    result.near_count = 4;
    result.pairs = {{1, 70000, PairClass::Near},
                    {1, 70001, PairClass::Proper},
                    {2, 3, PairClass::Near},
                    {2, 4, PairClass::Touch}};
    return result;
}

ScenarioResult touch_at_level_contacts() {
    ScenarioResult result = with_clearance(Level::Contacts, ScenarioClass::Touch);
    result.pair_count = 1;
    result.near_count = 2;
    result.pairs = {{1, 1, PairClass::Near}, {1, 2, PairClass::Touch}, {5, 0, PairClass::Near}};
    result.point_origins = {Vec3(1, 2, 3), Vec3(-0.0, 0.1, 1e300), Vec3(4, 5, 6)};
    result.point_offsets = {0, 2, 5, 7};
    for (int i = 0; i < 7; ++i) {
        result.points.emplace_back(i, 0.5, -i);
    }
    result.near_distances = {0.0625, 5e-324};
    return result;
}

ScenarioResult failed_with_clearance() {
    ScenarioResult result = with_clearance(Level::Pairs, ScenarioClass::Failed);
    result.failure = "three workers were lost with it";
    return result;
}

std::vector<ScenarioResult> examples() {
    std::vector<ScenarioResult> examples{near_at_level_any(),
                                         inside_at_level_count(),
                                         cross_at_level_pairs(),
                                         touch_at_level_contacts(),
                                         failed_with_clearance()};
    for (const Level level : {Level::Any, Level::Count, Level::Pairs, Level::Contacts}) {
        examples.push_back(with_clearance(level, ScenarioClass::Separate));
        if (level == Level::Contacts) {
            examples.back().point_offsets = {0};
        }
    }
    return examples;
}

/// Returns why the record of a changed result is refused, or "taken".
std::string refusal(ScenarioResult result, const std::function<void(ScenarioResult&)>& change) {
    change(result);
    const auto decoded = decode_result(encode_result(result));
    EXPECT_TRUE(decoded || decoded.error().code == ErrorCode::BadFrame);
    return decoded ? "taken" : decoded.error().detail;
}

std::string refusal_of_byte(const ScenarioResult& result, std::size_t place, std::uint8_t value) {
    Bytes bytes = encode_result(result);
    bytes.at(place) = std::byte{value};
    const auto decoded = decode_result(bytes);
    return decoded ? "taken" : decoded.error().detail;
}

constexpr std::size_t question_place = 1;
constexpr std::size_t class_place = 19;
constexpr std::size_t step_place = 29;
constexpr std::size_t more_flags_place = 37;

Bytes with_length(const Bytes& record) {
    ByteWriter out;
    out.put(static_cast<std::uint32_t>(record.size()));
    put_bytes(out, record);
    return out.take();
}

} // namespace

TEST(NearRecord, ComesBackToTheSameResultAtEachLevel) {
    for (const ScenarioResult& result : examples()) {
        const Bytes bytes = encode_result(result);
        const auto decoded = decode_result(bytes);
        ASSERT_TRUE(decoded) << decoded.error().detail;
        const ScenarioResult& again = decoded.value();
        EXPECT_EQ(encode_result(again), bytes);
        EXPECT_TRUE(again.has_clearance);
        EXPECT_EQ(again.index, result.index);
        EXPECT_EQ(again.body_a, result.body_a);
        EXPECT_EQ(again.body_b, result.body_b);
        EXPECT_EQ(again.level, result.level);
        EXPECT_EQ(again.kind, result.kind);
        EXPECT_EQ(again.pair_count, result.pair_count);
        EXPECT_EQ(again.near_count, result.near_count);
        EXPECT_EQ(again.pairs, result.pairs);
        EXPECT_EQ(again.points, result.points);
        EXPECT_EQ(again.point_offsets, result.point_offsets);
        EXPECT_EQ(again.near_distances, result.near_distances);
        EXPECT_EQ(again.failure, result.failure);
        EXPECT_EQ(again.is_cut(), result.is_cut());
    }
}

TEST(NearRecord, ASettledResultHasTheRecordThatItsEncodingGives) {
    expect_settled_records(examples());
}

TEST(NearRecord, DigestsAreTheGoldenOnes) {
    // These stand for all stored results: another value means another version of the record.
    EXPECT_EQ(to_short_hex(digest_of(near_at_level_any())), "0341ff9eadf2307b");
    EXPECT_EQ(to_short_hex(digest_of(inside_at_level_count())), "e1f67b4ba8051b43");
    EXPECT_EQ(to_short_hex(digest_of(cross_at_level_pairs())), "98c638f7de29870a");
    EXPECT_EQ(to_short_hex(digest_of(touch_at_level_contacts())), "89f2abcc4d7f1835");
    EXPECT_EQ(to_short_hex(digest_of(failed_with_clearance())), "03ed5ca5cc441ef9");
}

TEST(NearRecord, AClearanceIsPartOfTheRecordAlthoughNothingIsNear) {
    ScenarioResult separate = with_clearance(Level::Count, ScenarioClass::Separate);
    EXPECT_EQ(encode_result(separate).size(), 46u);
    const Sha256 digest = digest_of(separate);
    separate.has_clearance = false;
    EXPECT_NE(digest_of(separate), digest);
}

TEST(NearRecord, RefusesEveryTruncation) {
    for (const ScenarioResult& result : examples()) {
        Bytes bytes = encode_result(result);
        for (std::size_t size = 0; size < bytes.size(); ++size) {
            ASSERT_FALSE(decode_result(std::span(bytes).first(size))) << size;
        }
        bytes.push_back(std::byte{0});
        ASSERT_FALSE(decode_result(bytes));
    }
}

TEST(NearRecord, RefusesFieldsOutOfRange) {
    const ScenarioResult result = cross_at_level_pairs();
    EXPECT_THAT(refusal_of_byte(result, 0, 4), HasSubstr("version"));
    EXPECT_THAT(refusal_of_byte(result, question_place, 4), HasSubstr("question"));
    EXPECT_THAT(refusal_of_byte(result, class_place, 8), HasSubstr("unknown level, class"));
    EXPECT_THAT(refusal_of_byte(result, step_place, 1), HasSubstr("step outside a scene"));
    EXPECT_THAT(refusal_of_byte(result, more_flags_place, 0), HasSubstr("version 3 without need"));
    EXPECT_THAT(refusal_of_byte(result, more_flags_place, 3), HasSubstr("unknown flag"));
    EXPECT_THAT(refusal_of_byte(result, encode_result(result).size() - 1, 5),
                HasSubstr("class of a pair"));
}

TEST(NearRecord, RefusesNearPairsWithoutAClearance) {
    EXPECT_THAT(refusal(cross_at_level_pairs(), [](auto& r) { r.has_clearance = false; }),
                HasSubstr("class of a pair"));
    EXPECT_THAT(refusal(near_at_level_any(), [](auto& r) { r.has_clearance = false; }),
                HasSubstr("near pairs"));
}

TEST(NearRecord, RefusesNumbersThatDoNotFitTheClass) {
    const auto near = with_clearance(Level::Count, ScenarioClass::Near);
    EXPECT_EQ(refusal(near, [](auto& r) { r.near_count = 1; }), "taken");
    EXPECT_THAT(refusal(near, [](auto&) {}), HasSubstr("near pairs")) << "near by no pair";
    EXPECT_THAT(refusal(near, [](auto& r) { r.near_count = r.pair_count = 1; }),
                HasSubstr("does not fit the class"))
        << "near with a contact";
    EXPECT_THAT(refusal(near_at_level_any(), [](auto& r) { r.near_count = 1; }),
                HasSubstr("near pairs"))
        << "a number at level any";
    for (const ScenarioClass kind : {ScenarioClass::Separate, ScenarioClass::Failed}) {
        EXPECT_THAT(refusal(with_clearance(Level::Count, kind), [](auto& r) { r.near_count = 1; }),
                    HasSubstr("near pairs"));
    }
}

TEST(NearRecord, RefusesListsThatDoNotFitTheNumbers) {
    const ScenarioResult result = cross_at_level_pairs();
    EXPECT_EQ(refusal(result, [](auto& r) { r.near_count = 2; }), "taken");
    EXPECT_THAT(refusal(result, [](auto& r) { r.near_count = 1; }), HasSubstr("near pairs"));
    EXPECT_EQ(refusal(result, [](auto& r) { r.pair_count = 2; }), "taken");
    EXPECT_THAT(refusal(result, [](auto& r) { r.pair_count = 1; }), HasSubstr("near pairs"));
}

TEST(NearRecord, ANearPairHasTwoPointsAndADistance) {
    const ScenarioResult result = touch_at_level_contacts();
    EXPECT_THAT(refusal(result,
                        [](auto& r) {
                            r.point_offsets = {0, 1, 5, 7};
                        }),
                HasSubstr("number of points"));
    EXPECT_THAT(refusal(result,
                        [](auto& r) {
                            r.point_offsets = {0, 3, 5, 7};
                        }),
                HasSubstr("number of points"));
    EXPECT_FALSE(decode_result(encode_result(result)).value().near_distances.empty());
    EXPECT_THAT(refusal(result, [](auto& r) { r.near_distances.pop_back(); }),
                HasSubstr("distances cut short"));
    EXPECT_THAT(refusal(result, [](auto& r) { r.near_distances.push_back(1); }),
                HasSubstr("left over"));
    const auto with_distance = [&](double distance) {
        return refusal(result, [&](auto& r) { r.near_distances.back() = distance; });
    };
    EXPECT_EQ(with_distance(0), "taken") << "less than half the least number rounds to 0";
    EXPECT_EQ(with_distance(-0.0), "taken") << "is written as 0";
    for (const double none :
         {-1.0, std::nan(""), std::numeric_limits<double>::infinity(), -5e-324}) {
        EXPECT_THAT(with_distance(none), HasSubstr("a distance that is none")) << none;
    }
    Bytes bytes = encode_result(touch_at_level_contacts());
    bytes[bytes.size() - 8] = std::byte{0};
    bytes[bytes.size() - 1] = std::byte{0x80};
    EXPECT_FALSE(decode_result(bytes)) << "minus zero";
}

TEST(NearRecord, SurvivesDamage) {
    std::mt19937_64 random(11);
    const Bytes bytes = encode_result(touch_at_level_contacts());
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

TEST(NearRecord, IsCutWhereTheListLacksAPairOfEitherKind) {
    ScenarioResult result = cross_at_level_pairs();
    result.pair_count = result.near_count = 2;
    EXPECT_FALSE(result.is_cut());
    EXPECT_EQ(listed_near_pairs(result), 2u);
    result.near_count = 3;
    EXPECT_TRUE(result.is_cut());
    result.pair_count = 3;
    result.near_count = 2;
    EXPECT_TRUE(result.is_cut());
}

TEST(NearRecord, OverTheLimitIsAFailureThatCountsBothKinds) {
    ScenarioResult result = with_clearance(Level::Contacts, ScenarioClass::Near);
    result.point_offsets.push_back(0);
    for (std::uint32_t i = 0; i < 1000; ++i) {
        result.pairs.push_back({i, i, PairClass::Near});
        result.point_origins.emplace_back(0, 0, 0);
        result.points.resize(result.points.size() + 2, Vec3(1, 2, 3));
        result.point_offsets.push_back(2 * i + 2);
        result.near_distances.push_back(1);
    }
    result.near_count = result.pairs.size();
    const std::uint64_t size = encode_result(result).size();

    ScenarioResult failed = result;
    fail_above_limit(failed, size + 4000); // Offsets count more than the numbers in the record.
    EXPECT_EQ(failed.kind, ScenarioClass::Near);
    fail_above_limit(failed, size - 1);
    EXPECT_EQ(failed.kind, ScenarioClass::Failed);
    EXPECT_TRUE(failed.has_clearance);
    EXPECT_THAT(failed.failure, HasSubstr("1000 pairs"));
    const auto again = decode_result(encode_result(failed));
    ASSERT_TRUE(again);
    EXPECT_TRUE(again.value().has_clearance);
}

TEST(NearRecord, PairsArePackedInColumns) {
    ScenarioResult result = with_clearance(Level::Pairs, ScenarioClass::Near);
    for (std::uint32_t i = 0; i < 3000; ++i) {
        result.pairs.push_back({i / 3, 70'000 - 5 * i, PairClass::Near});
    }
    std::ranges::sort(result.pairs);
    result.near_count = result.pairs.size();
    const Bytes record = encode_result(result);
    EXPECT_EQ(bytes_before_pairs(record), 50u);
    const Bytes packed = pack_records(with_length(record));
    EXPECT_LT(packed.size(), result.pairs.size());
    EXPECT_EQ(unpack_records(packed, 1u << 20).value(), with_length(record));
}

TEST(NearRecord, RecordsWithoutPairsArePackedWhole) {
    for (const ScenarioResult& result : examples()) {
        const Bytes record = encode_result(result);
        EXPECT_EQ(bytes_before_pairs(record).has_value(), !result.pairs.empty());
        EXPECT_EQ(unpack_records(pack_records(with_length(record)), 1u << 20).value(),
                  with_length(record));
    }
}

TEST(NearRecord, TheMergerCountsNearApartAndForgetsWhatIsRemoved) {
    ResultMerger merger(examples().size());
    std::uint64_t index = 0;
    for (ScenarioResult result : examples()) {
        result.index = index++;
        EXPECT_EQ(merger.add(result), ResultMerger::Outcome::Added);
    }
    EXPECT_EQ(merger.summary().near, 1u);
    EXPECT_EQ(merger.summary().near_pairs, (1u << 20) + 4 + 2);
    EXPECT_EQ(merger.summary().pairs, 9u + 1);
    EXPECT_EQ(merger.summary().cut, 1u);
    EXPECT_TRUE(merger.summary().is_complete());

    merger.remove(0, facts_of(near_at_level_any()));
    merger.remove(2, facts_of(cross_at_level_pairs()));
    EXPECT_EQ(merger.summary().near, 0u);
    EXPECT_EQ(merger.summary().near_pairs, (1u << 20) + 2);
    EXPECT_EQ(merger.summary().pairs, 1u);
    EXPECT_EQ(merger.summary().cut, 0u);
    EXPECT_EQ(merger.summary().merged(), examples().size() - 2);
}

} // namespace cd::tests
