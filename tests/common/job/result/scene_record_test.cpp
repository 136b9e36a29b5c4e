// Proves that records of a scene keep their step, that their digest does not depend on their index,
// and that the digest of a scene is over its head and the results that tell something.

#include "common/job/result/merge.hpp"
#include "common/job/result/result.hpp"
#include "tests/common/job/result/settled_records.hpp"
#include "tests/support/rounds.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cd::tests {

namespace {

using testing::HasSubstr;

ScenarioResult at_step(std::uint64_t step, ScenarioClass kind) {
    ScenarioResult result;
    result.index = 77;
    result.body_a = 2;
    result.body_b = 9;
    result.level = Level::Pairs;
    result.kind = kind;
    result.step = step;
    return result;
}

ScenarioResult touching(std::uint64_t step) {
    ScenarioResult result = at_step(step, ScenarioClass::Touch);
    result.pair_count = 1;
    result.pairs = {{3, 4, PairClass::Touch}};
    return result;
}

ScenarioResult near(std::uint64_t step) {
    ScenarioResult result = at_step(step, ScenarioClass::Near);
    result.has_clearance = true;
    result.near_count = 1;
    result.pairs = {{3, 4, PairClass::Near}};
    return result;
}

ScenarioResult apart(std::uint64_t step) {
    ScenarioResult result = at_step(step, ScenarioClass::Separate);
    result.question = Question::Distance;
    result.level = Level::Any;
    result.nearest = NearestWitness{0.5, 1, 2, 0, Vec3(0, 0, 0), Vec3(0, 0, 0), Vec3(0.5, 0, 0)};
    return result;
}

ScenarioResult failed(std::uint64_t step) {
    ScenarioResult result = at_step(step, ScenarioClass::Failed);
    result.failure = "stopped";
    return result;
}

std::vector<ScenarioResult> examples() {
    return {at_step(0, ScenarioClass::Separate),
            touching(0),
            touching(UINT64_MAX),
            near(5),
            apart(6),
            failed(7)};
}

Sha256 head_of(std::uint8_t number) {
    Sha256 head;
    head.bytes[0] = std::byte{number};
    return head;
}

/// Merges results in order, with the indices 0, 1, ...
std::optional<Sha256> digest_of_scene(std::vector<ScenarioResult> results, std::uint8_t head = 1) {
    ResultMerger merger(results.size(), SceneHead{head_of(head)});
    for (std::size_t i = 0; i < results.size(); ++i) {
        results[i].index = i;
        EXPECT_EQ(merger.add(results[i]), ResultMerger::Outcome::Added);
    }
    return merger.digest();
}

} // namespace

TEST(SceneRecord, KeepsItsStep) {
    for (const ScenarioResult& result : examples()) {
        const Bytes record = encode_result(result);
        const auto decoded = decode_result(record);
        ASSERT_TRUE(decoded) << decoded.error().detail;
        EXPECT_EQ(decoded.value().step, result.step);
        EXPECT_EQ(decoded.value().has_clearance, result.has_clearance);
        EXPECT_EQ(encode_result(decoded.value()), record);
        EXPECT_EQ(std::to_integer<int>(record[0]), 3);
    }
}

TEST(SceneRecord, ASettledResultHasTheRecordThatItsEncodingGives) {
    expect_settled_records(examples());
}

TEST(SceneRecord, OfTwoBodiesStaysAsItWas) {
    ScenarioResult result = touching(0);
    result.step.reset();
    const Bytes record = encode_result(result);
    EXPECT_EQ(std::to_integer<int>(record[0]), 2);
    EXPECT_FALSE(decode_result(record).value().step);
}

TEST(SceneRecord, RefusesAStepOutsideAScene) {
    constexpr std::size_t flags = 20;
    constexpr std::size_t step = 29;
    Bytes record = encode_result(near(5));
    record[flags] &= ~std::byte{4};
    EXPECT_THAT(decode_result(record).error().detail, HasSubstr("step outside a scene"));
    record[step] = std::byte{0};
    EXPECT_TRUE(decode_result(record));
    record[flags] = std::byte{8};
    EXPECT_FALSE(decode_result(record));
    // Contacts of two bodies without a clearance have version 2.
    Bytes plain = encode_result(touching(0));
    plain[flags] &= ~std::byte{4};
    EXPECT_THAT(decode_result(plain).error().detail, HasSubstr("version 3 without need"));
}

TEST(SceneRecord, SurvivesDamage) {
    for (SeededRandom random : seeds(300)) {
        const auto all = examples();
        Bytes record = encode_result(all[random() % all.size()]);
        record[random() % record.size()] = static_cast<std::byte>(random());
        record.resize(record.size() - random() % 2);
        const auto decoded = decode_result(record);
        if (decoded) {
            EXPECT_EQ(encode_result(decoded.value()), record);
        }
    }
}

TEST(SceneRecord, DigestIsThatOfIndexZero) {
    for (ScenarioResult result : examples()) {
        const Sha256 digest = digest_of(result);
        result.index = 0;
        EXPECT_EQ(digest, digest_of(result));
        EXPECT_EQ(digest, sha256(encode_result(result)));
        result.step = *result.step + 1;
        EXPECT_NE(digest, digest_of(result));
    }
    ScenarioResult of_two = touching(0);
    of_two.step.reset();
    const Sha256 digest = digest_of(of_two);
    of_two.index = 0;
    EXPECT_NE(digest, digest_of(of_two));
}

TEST(SceneDigest, DoesNotDependOnPairsThatAreSeparate) {
    const auto digest = digest_of_scene({touching(0), touching(3), near(4)});
    EXPECT_EQ(digest,
              digest_of_scene({at_step(0, ScenarioClass::Separate),
                               touching(0),
                               at_step(2, ScenarioClass::Separate),
                               touching(3),
                               near(4)}));
    EXPECT_NE(digest, digest_of_scene({touching(0), touching(3)}));
    EXPECT_NE(digest, digest_of_scene({touching(3), touching(0), near(4)}));
    EXPECT_NE(digest, digest_of_scene({touching(0), touching(3), near(4)}, 2));
    EXPECT_NE(digest, digest_of_scene({touching(0), touching(3), near(4), apart(4)}));
    EXPECT_NE(digest, digest_of_scene({touching(0), touching(3), near(4), failed(4)}));
}

TEST(SceneDigest, OfNothingIsThatOfTheHead) {
    EXPECT_EQ(digest_of_scene({}), sha256(head_of(1).bytes));
    EXPECT_EQ(digest_of_scene({at_step(0, ScenarioClass::Separate)}), digest_of_scene({}));
}

TEST(SceneDigest, ForgetsAWithdrawnResult) {
    ResultMerger merger(2, SceneHead{head_of(1)});
    ScenarioResult wrong = touching(0);
    wrong.index = 0;
    EXPECT_EQ(merger.add(wrong), ResultMerger::Outcome::Added);
    merger.remove(0, facts_of(wrong));
    ScenarioResult right = at_step(0, ScenarioClass::Separate);
    right.index = 0;
    EXPECT_EQ(merger.add(right), ResultMerger::Outcome::Added);
    ScenarioResult last = touching(1);
    last.index = 1;
    EXPECT_EQ(merger.add(last), ResultMerger::Outcome::Added);
    EXPECT_EQ(merger.digest(), digest_of_scene({right, last}));
}

} // namespace cd::tests
