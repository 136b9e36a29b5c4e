// Proves that a result of hits has one record: it is restored exactly, its bytes and digest are the
// golden ones, and records that no bundle of lines gives are refused.

#include "common/core/files/disk_file.hpp"
#include "common/job/result/merge.hpp"
#include "common/job/result/packed_records.hpp"
#include "common/job/result/result.hpp"
#include "common/shots/line_hit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>

namespace cd::tests {

namespace {

using testing::HasSubstr;

ScenarioResult shots(Level level, ScenarioClass kind) {
    ScenarioResult result;
    result.index = 12345;
    result.body_a = 3;
    result.body_b = 9;
    result.level = level;
    result.kind = kind;
    result.question = Question::Shots;
    return result;
}

ScenarioResult hits_at_level_pairs() {
    ScenarioResult result = shots(Level::Pairs, ScenarioClass::Contact);
    result.pair_count = 4;
    result.pairs = {
        {1, 70000, PairClass::Touch}, {1, 70001, PairClass::Touch}, {2, 3, PairClass::Touch}};
    result.hits = {{0.5, hit_flag::crosses | hit_flag::front, 0},
                   {1e-300, hit_flag::back | hit_flag::corner, 255},
                   {0, hit_flag::edge, 1}};
    return result;
}

ScenarioResult hits_at_level_count() {
    ScenarioResult result = shots(Level::Count, ScenarioClass::Contact);
    result.pair_count = 1u << 20;
    return result;
}

ScenarioResult failed_shots() {
    ScenarioResult result = shots(Level::Pairs, ScenarioClass::Failed);
    result.failure = "three workers were lost with it";
    return result;
}

std::vector<ScenarioResult> shots_examples() {
    return {hits_at_level_pairs(),
            hits_at_level_count(),
            failed_shots(),
            shots(Level::Pairs, ScenarioClass::Separate),
            shots(Level::Count, ScenarioClass::Separate)};
}

/// Returns why the record of a changed result is refused, or "taken".
std::string refusal_of(ScenarioResult result, const std::function<void(ScenarioResult&)>& change) {
    change(result);
    const auto decoded = decode_result(encode_result(result));
    EXPECT_TRUE(decoded || decoded.error().code == ErrorCode::BadFrame);
    return decoded ? "taken" : decoded.error().detail;
}

Bytes after_its_length(const Bytes& record) {
    ByteWriter out;
    out.put(static_cast<std::uint32_t>(record.size()));
    put_bytes(out, record);
    return out.take();
}

} // namespace

TEST(ShotsRecord, ComesBackToTheSameResult) {
    for (const ScenarioResult& result : shots_examples()) {
        const Bytes bytes = encode_result(result);
        const auto decoded = decode_result(bytes);
        ASSERT_TRUE(decoded) << decoded.error().detail;
        const ScenarioResult& again = decoded.value();
        EXPECT_EQ(encode_result(again), bytes);
        EXPECT_EQ(again.question, Question::Shots);
        EXPECT_FALSE(again.has_clearance);
        EXPECT_EQ(again.kind, result.kind);
        EXPECT_EQ(again.pair_count, result.pair_count);
        EXPECT_EQ(again.pairs, result.pairs);
        EXPECT_EQ(again.hits, result.hits);
        EXPECT_EQ(again.failure, result.failure);
        EXPECT_EQ(again.is_cut(), result.is_cut());
    }
}

TEST(ShotsRecord, HasItsBytesInOrder) {
    const ScenarioResult result = hits_at_level_pairs();
    const Bytes bytes = encode_result(result);
    // The head, the number of pairs, the pairs, and the hits.
    ASSERT_EQ(bytes.size(), 37u + 4 + 3 * 9 + 3 * 10);
    EXPECT_EQ(bytes[0], std::byte{3});
    EXPECT_EQ(bytes[1], std::byte{3});
    EXPECT_EQ(bytes[bytes.size() - 6], std::byte{3});
    EXPECT_EQ(bytes[bytes.size() - 5], std::byte{20});
    EXPECT_EQ(bytes[bytes.size() - 4], std::byte{8});
    EXPECT_EQ(bytes[bytes.size() - 2], std::byte{255});
    EXPECT_EQ(encode_result(hits_at_level_count()).size(), 37u);
}

TEST(ShotsRecord, DigestsAreTheGoldenOnes) {
    // These stand for all stored results: another value means another version of the record.
    EXPECT_EQ(to_short_hex(digest_of(hits_at_level_pairs())), "2b46e59d38571c42");
    EXPECT_EQ(to_short_hex(digest_of(hits_at_level_count())), "985e742c084a1521");
    EXPECT_EQ(to_short_hex(digest_of(failed_shots())), "9e411725a663be3a");
}

TEST(ShotsRecord, RefusesEveryTruncation) {
    for (const ScenarioResult& result : shots_examples()) {
        Bytes bytes = encode_result(result);
        for (std::size_t size = 0; size < bytes.size(); ++size) {
            ASSERT_FALSE(decode_result(std::span(bytes).first(size))) << size;
        }
        bytes.push_back(std::byte{0});
        ASSERT_FALSE(decode_result(bytes));
    }
}

TEST(ShotsRecord, RefusesHitsThatNoLineHas) {
    const auto with_flags = [](int flags) {
        return refusal_of(hits_at_level_pairs(),
                          [&](auto& r) { r.hits[1].flags = static_cast<std::uint8_t>(flags); });
    };
    EXPECT_EQ(with_flags(0), "taken");
    EXPECT_EQ(with_flags(hit_flag::crosses | hit_flag::back | hit_flag::edge), "taken");
    for (const int none : {hit_flag::front | hit_flag::back,
                           hit_flag::front | hit_flag::edge | hit_flag::corner,
                           int{hit_flag::crosses},
                           32}) {
        EXPECT_THAT(with_flags(none), HasSubstr("a hit that no line has")) << none;
    }
    const auto with_depth = [](double depth) {
        return refusal_of(hits_at_level_pairs(), [&](auto& r) { r.hits[1].depth = depth; });
    };
    EXPECT_EQ(with_depth(-0.0), "taken") << "is written as 0";
    for (const double none : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        EXPECT_THAT(with_depth(none), HasSubstr("a hit that no line has")) << none;
    }
    EXPECT_THAT(
        refusal_of(hits_at_level_pairs(), [](auto& r) { r.pairs[0].kind = PairClass::Coplanar; }),
        HasSubstr("class of a pair"));
}

TEST(ShotsRecord, RefusesNumbersThatDoNotFitLevelAndClass) {
    const char* const misfit = "hits that do not fit";
    EXPECT_THAT(refusal_of(hits_at_level_pairs(), [](auto& r) { r.pair_count = 2; }),
                HasSubstr(misfit));
    EXPECT_THAT(refusal_of(hits_at_level_count(), [](auto& r) { r.pair_count = 0; }),
                HasSubstr(misfit));
    EXPECT_THAT(refusal_of(hits_at_level_count(), [](auto& r) { r.level = Level::Any; }),
                HasSubstr(misfit));
    EXPECT_THAT(refusal_of(hits_at_level_count(), [](auto& r) { r.surfaces_only = true; }),
                HasSubstr(misfit));
    for (const ScenarioClass kind : {ScenarioClass::Separate,
                                     ScenarioClass::Touch,
                                     ScenarioClass::Cross,
                                     ScenarioClass::Inside,
                                     ScenarioClass::Undecided,
                                     ScenarioClass::Near}) {
        EXPECT_THAT(refusal_of(hits_at_level_count(), [&](auto& r) { r.kind = kind; }),
                    HasSubstr(misfit));
    }
    EXPECT_THAT(refusal_of(failed_shots(), [](auto& r) { r.pair_count = 1; }), HasSubstr(misfit));
}

TEST(ShotsRecord, SurvivesDamage) {
    std::mt19937_64 random(12);
    const Bytes bytes = encode_result(hits_at_level_pairs());
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

TEST(ShotsRecord, IsPackedAsItIs) {
    for (const ScenarioResult& result : shots_examples()) {
        const Bytes record = encode_result(result);
        EXPECT_EQ(bytes_before_pairs(record).has_value(), !result.pairs.empty());
        EXPECT_EQ(unpack_records(pack_records(after_its_length(record)), 1u << 20).value(),
                  after_its_length(record));
    }
}

TEST(ShotsRecord, OverTheLimitIsAFailure) {
    ScenarioResult result = shots(Level::Pairs, ScenarioClass::Contact);
    for (std::uint32_t i = 0; i < 1000; ++i) {
        result.pairs.push_back({i, i, PairClass::Touch});
        result.hits.push_back({1, hit_flag::front, 0});
    }
    result.pair_count = result.pairs.size();
    const std::uint64_t size = encode_result(result).size();
    ScenarioResult failed = result;
    fail_above_limit(failed, size + 64);
    EXPECT_EQ(failed.kind, ScenarioClass::Contact);
    fail_above_limit(failed, size - 1);
    EXPECT_EQ(failed.kind, ScenarioClass::Failed);
    EXPECT_THAT(failed.failure, HasSubstr("1000 pairs"));
    EXPECT_TRUE(decode_result(encode_result(failed)));
}

TEST(ShotsRecord, TheMergerCountsContacts) {
    ResultMerger merger(shots_examples().size());
    std::uint64_t index = 0;
    for (ScenarioResult result : shots_examples()) {
        result.index = index++;
        EXPECT_EQ(merger.add(result), ResultMerger::Outcome::Added);
    }
    EXPECT_EQ(merger.summary().contact, 2u);
    EXPECT_EQ(merger.summary().separate, 2u);
    EXPECT_EQ(merger.summary().pairs, (1u << 20) + 4u);
    EXPECT_EQ(merger.summary().cut, 1u);
    EXPECT_TRUE(merger.summary().is_complete());
}

} // namespace cd::tests
