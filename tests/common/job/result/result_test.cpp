// Proves that a result has one record: it is restored exactly, its bytes and digest are the golden
// ones, and bytes that no result produces are refused.

#include "common/job/result/result.hpp"

#include "common/job/result/merge.hpp"
#include "tests/common/job/result/settled_records.hpp"
#include "tests/support/distance_results.hpp"
#include "tests/support/near_results.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <random>
#include <set>

namespace cd::tests {

namespace {

ScenarioResult make_pairs_result() {
    ScenarioResult result;
    result.index = 12345;
    result.level = Level::Pairs;
    result.kind = ScenarioClass::Cross;
    result.pair_count = 9;
    result.pairs = {
        {1, 70000, PairClass::Proper}, {1, 70001, PairClass::Touch}, {2, 3, PairClass::Coplanar}};
    return result;
}

ScenarioResult make_contacts_result() {
    ScenarioResult result = make_pairs_result();
    result.level = Level::Contacts;
    result.surfaces_only = true;
    result.pair_count = 3;
    result.point_origins = {Vec3(1, 2, 3), Vec3(-0.0, 0.1, 1e300), Vec3(4, 5, 6)};
    result.point_offsets = {0, 2, 3, 6};
    result.points = {Vec3(0, 0, 0),
                     Vec3(0.5, -0.0, 1),
                     Vec3(1, 1, 1),
                     Vec3(1, 0, 0),
                     Vec3(0, 1, 0),
                     Vec3(0, 0, 5e-324)};
    return result;
}

ScenarioResult make_failed_result() {
    ScenarioResult result;
    result.index = 7;
    result.kind = ScenarioClass::Failed;
    result.failure = "three workers were lost with it";
    return result;
}

ScenarioResult make_undecided_result() {
    ScenarioResult result;
    result.index = 8;
    result.level = Level::Count;
    result.kind = ScenarioClass::Undecided;
    result.distance_bound = 0.375;
    return result;
}

ScenarioResult make_skipped_result() {
    ScenarioResult result = make_pairs_result();
    result.insides_skipped = true;
    return result;
}

std::vector<ScenarioResult> examples() {
    ScenarioResult separate;
    separate.level = Level::Any;
    ScenarioResult inside;
    inside.level = Level::Count;
    inside.kind = ScenarioClass::Inside;
    inside.body_a = 3;
    inside.body_b = 9;
    return {separate,
            inside,
            make_pairs_result(),
            make_contacts_result(),
            make_failed_result(),
            make_undecided_result(),
            make_skipped_result()};
}

/// Returns the record of `result` with one byte replaced.
Bytes patched(const ScenarioResult& result, std::size_t place, std::uint8_t value) {
    Bytes bytes = encode_result(result);
    bytes.at(place) = std::byte{value};
    return bytes;
}

constexpr std::size_t level_place = 17;
constexpr std::size_t class_place = 18;
constexpr std::size_t flags_place = 19;
constexpr std::size_t count_place = 20;
constexpr std::size_t pairs_place = 28;

} // namespace

TEST(Result, RecordsComeBackToTheSameBytes) {
    for (const ScenarioResult& result : examples()) {
        const Bytes bytes = encode_result(result);
        const auto decoded = decode_result(bytes);
        ASSERT_TRUE(decoded) << decoded.error().detail;
        EXPECT_EQ(encode_result(decoded.value()), bytes);
        EXPECT_EQ(decoded.value().index, result.index);
        EXPECT_EQ(decoded.value().body_b, result.body_b);
        EXPECT_EQ(decoded.value().kind, result.kind);
        EXPECT_EQ(decoded.value().pairs, result.pairs);
        EXPECT_EQ(decoded.value().points, result.points);
        EXPECT_EQ(decoded.value().point_offsets, result.point_offsets);
        EXPECT_EQ(decoded.value().surfaces_only, result.surfaces_only);
        EXPECT_EQ(decoded.value().insides_skipped, result.insides_skipped);
        EXPECT_EQ(decoded.value().is_cut(), result.is_cut());
        EXPECT_EQ(decoded.value().failure, result.failure);
        EXPECT_EQ(decoded.value().distance_bound, result.distance_bound);
        if (bytes.size() > unhashed_record_bytes_max) {
            EXPECT_EQ(digest_of(result), sha256(bytes));
        }
    }
}

TEST(Result, ASettledResultHasTheRecordThatItsEncodingGives) {
    expect_settled_records(examples());
}

TEST(Result, ADecodedResultHasNothingOfTheOneBefore) {
    std::vector<ScenarioResult> all = examples();
    for (const auto& others : {distance_results(), near_results(Level::Contacts)}) {
        all.insert(all.end(), others.begin(), others.end());
    }
    for (const ScenarioResult& before : all) {
        for (const ScenarioResult& result : all) {
            ScenarioResult used = before;
            const Bytes bytes = encode_result(result);
            ASSERT_TRUE(decode_result(bytes, used));
            EXPECT_EQ(encode_result(used), bytes);
            EXPECT_EQ(facts_of(used), facts_of(result));
            EXPECT_EQ(used.failure, result.failure);
            EXPECT_EQ(used.distance_bound, result.distance_bound);
            EXPECT_EQ(used.pairs, result.pairs);
            EXPECT_EQ(used.points, result.points);
            EXPECT_EQ(used.hits.size() + used.near_distances.size(),
                      result.hits.size() + result.near_distances.size());
            EXPECT_FALSE(used.motion);
        }
    }
}

TEST(Result, ShortRecordsOfZerosHaveDifferentDigests) {
    std::set<Sha256> digests;
    for (std::size_t bytes = 0; bytes <= unhashed_record_bytes_max + 1; ++bytes) {
        EXPECT_TRUE(digests.insert(digest_of_record(Bytes(bytes))).second) << bytes;
    }
    EXPECT_EQ(digest_of_record(Bytes(31)).bytes.back(), std::byte{31});
    EXPECT_EQ(digest_of_record(Bytes(32)), sha256(Bytes(32)));
}

TEST(Result, DigestsAreTheGoldenOnes) {
    // These stand for all stored results: another value means another version of the record.
    EXPECT_EQ(to_hex(digest_of(examples()[0])),
              "020000000000000000000000000100000000000000000000000000000000001c");
    EXPECT_EQ(to_hex(digest_of(examples()[1])),
              "020000000000000000030000000900000001030000000000000000000000001c");
    EXPECT_EQ(to_short_hex(digest_of(make_pairs_result())), "855e617e4e16bd3d");
    EXPECT_EQ(to_short_hex(digest_of(make_contacts_result())), "1933a741a3e0eaec");
    EXPECT_EQ(to_short_hex(digest_of(make_failed_result())), "be359f83769d1593");
    EXPECT_EQ(to_short_hex(digest_of(make_undecided_result())), "b8b4ab3e613ccfac");
}

TEST(Result, ZeroAndNanHaveOnePattern) {
    ScenarioResult negative = make_contacts_result();
    ScenarioResult positive = negative;
    positive.point_origins[1].x() = 0.0;
    positive.points[1].y() = 0.0;
    EXPECT_EQ(encode_result(negative), encode_result(positive));

    negative.points[0].x() = -std::numeric_limits<double>::quiet_NaN();
    positive.points[0].x() = std::nan("123");
    EXPECT_EQ(encode_result(negative), encode_result(positive));
    EXPECT_TRUE(decode_result(encode_result(negative)));

    Bytes bytes = encode_result(make_contacts_result());
    bytes.back() = std::byte{0x80}; // The last coordinate becomes a negative denormal.
    EXPECT_TRUE(decode_result(bytes));
    bytes[bytes.size() - 8] = std::byte{0}; // The last coordinate becomes minus zero.
    EXPECT_FALSE(decode_result(bytes));
}

TEST(Result, CostsFewBytesWithoutContacts) {
    EXPECT_EQ(encode_result(examples()[0]).size(), 28u);
}

TEST(Result, RefusesEveryTruncation) {
    for (const ScenarioResult& result : examples()) {
        Bytes bytes = encode_result(result);
        for (std::size_t size = 0; size < bytes.size(); ++size) {
            ASSERT_FALSE(decode_result(std::span(bytes).first(size))) << size;
        }
        bytes.push_back(std::byte{0});
        ASSERT_FALSE(decode_result(bytes));
    }
}

TEST(Result, RefusesFieldsOutOfRange) {
    const ScenarioResult result = make_pairs_result();
    EXPECT_FALSE(decode_result(patched(result, 0, 1)));
    EXPECT_FALSE(decode_result(patched(result, level_place, 4)));
    EXPECT_FALSE(decode_result(patched(result, class_place, 7)));
    EXPECT_TRUE(decode_result(patched(result, flags_place, 2))) << "insides skipped";
    EXPECT_FALSE(decode_result(patched(result, flags_place, 3))) << "and a body is open";
    EXPECT_FALSE(decode_result(patched(result, flags_place, 4)));
    EXPECT_FALSE(decode_result(patched(result, pairs_place + 3, 0xff))) << "4 billion pairs";
    EXPECT_FALSE(decode_result(patched(result, encode_result(result).size() - 1, 0)));
    EXPECT_FALSE(decode_result(patched(result, encode_result(result).size() - 1, 4)));
}

TEST(Result, RefusesFieldsThatContradictEachOther) {
    const ScenarioResult result = make_pairs_result();
    const auto with_class = [&](ScenarioClass kind) {
        return patched(result, class_place, static_cast<std::uint8_t>(kind));
    };
    EXPECT_FALSE(decode_result(with_class(ScenarioClass::Separate)));
    EXPECT_FALSE(decode_result(with_class(ScenarioClass::Inside)));
    EXPECT_FALSE(decode_result(with_class(ScenarioClass::Contact)));
    EXPECT_FALSE(decode_result(with_class(ScenarioClass::Touch))) << "a pair is proper";
    EXPECT_FALSE(decode_result(patched(result, count_place, 2))) << "fewer than are listed";

    ScenarioResult any;
    any.level = Level::Any;
    any.kind = ScenarioClass::Contact;
    EXPECT_TRUE(decode_result(encode_result(any)));
    any.kind = ScenarioClass::Inside;
    EXPECT_TRUE(decode_result(encode_result(any)));
    any.kind = ScenarioClass::Cross;
    EXPECT_FALSE(decode_result(encode_result(any)));
    any.kind = ScenarioClass::Contact;
    any.pair_count = 1;
    EXPECT_FALSE(decode_result(encode_result(any)));
}

TEST(Result, ABoundIsADistanceOfBodiesNotInContact) {
    ScenarioResult result = make_undecided_result();
    const auto with_bound = [&](double bound) {
        result.distance_bound = bound;
        return decode_result(encode_result(result));
    };
    EXPECT_TRUE(with_bound(0));
    EXPECT_TRUE(with_bound(std::numeric_limits<double>::infinity()));
    EXPECT_FALSE(with_bound(-0.5));
    EXPECT_FALSE(with_bound(std::nan("")));
    EXPECT_EQ(encode_result(with_bound(-0.0).value()), encode_result(with_bound(0.0).value()));
    Bytes bytes = encode_result(result);
    bytes.back() = std::byte{0x80}; // Minus zero.
    EXPECT_FALSE(decode_result(bytes));

    // Pairs may be proven although undecided boxes are left.
    result = make_pairs_result();
    result.kind = ScenarioClass::Undecided;
    EXPECT_TRUE(with_bound(0));
    EXPECT_FALSE(with_bound(0.5));
}

TEST(Result, RefusesPairsOutOfOrder) {
    ScenarioResult result = make_pairs_result();
    std::swap(result.pairs[0], result.pairs[1]);
    EXPECT_FALSE(decode_result(encode_result(result)));
    result.pairs[0] = result.pairs[1];
    EXPECT_FALSE(decode_result(encode_result(result)));
}

TEST(Result, SurvivesDamage) {
    std::mt19937_64 random(11);
    const Bytes bytes = encode_result(make_contacts_result());
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

TEST(Result, ARecordOverTheLimitIsAFailureThatSaysSo) {
    ScenarioResult result;
    result.index = 7;
    result.kind = ScenarioClass::Cross;
    for (std::uint32_t i = 0; i < 1000; ++i) {
        result.pairs.push_back({i, i, PairClass::Proper});
    }
    result.pair_count = result.pairs.size();
    const std::uint64_t size = encode_result(result).size();

    ScenarioResult failed = result;
    fail_above_limit(failed, size + 64);
    EXPECT_EQ(failed.kind, ScenarioClass::Cross);
    fail_above_limit(failed, size - 1);
    EXPECT_EQ(failed.kind, ScenarioClass::Failed);
    EXPECT_EQ(failed.index, 7u);
    EXPECT_NE(failed.failure.find("1000 pairs"), std::string::npos);
    EXPECT_TRUE(decode_result(encode_result(failed)));
}

} // namespace cd::tests
