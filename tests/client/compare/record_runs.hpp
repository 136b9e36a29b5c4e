// Files of records that tests make.
#pragma once

#include "common/job/result/record_file.hpp"
#include "common/shots/line_hit.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

namespace cd::tests {

/// Makes a result of level pairs, of a class that fits the pairs.
[[nodiscard]] inline ScenarioResult result_with(std::uint64_t index,
                                                std::vector<ContactPair> pairs) {
    ScenarioResult result;
    result.index = index;
    result.kind = pairs.empty() ? ScenarioClass::Separate : ScenarioClass::Touch;
    for (const ContactPair& pair : pairs) {
        result.kind = pair.kind == PairClass::Proper ? ScenarioClass::Cross : result.kind;
    }
    result.pair_count = pairs.size();
    result.pairs = std::move(pairs);
    return result;
}

/// Makes a result of a query with a clearance, whose pairs are all near.
[[nodiscard]] inline ScenarioResult near_with(std::uint64_t index, std::vector<ContactPair> pairs) {
    ScenarioResult result;
    result.index = index;
    result.has_clearance = true;
    result.kind = pairs.empty() ? ScenarioClass::Separate : ScenarioClass::Near;
    for (ContactPair& pair : pairs) {
        pair.kind = PairClass::Near;
    }
    result.near_count = pairs.size();
    result.pairs = std::move(pairs);
    return result;
}

/// Makes a result of the question of the distance; without a number there is no distance.
[[nodiscard]] inline ScenarioResult apart(std::uint64_t index, std::optional<double> distance) {
    ScenarioResult result;
    result.index = index;
    result.question = Question::Distance;
    result.level = Level::Any;
    if (distance) {
        result.nearest = NearestWitness{*distance, 0, 0, 0, {0, 0, 0}, {0, 0, 0}, {1, 0, 0}};
    }
    return result;
}

/// A hit of a line of B with a triangle of A.
struct HitAt {
    std::uint32_t triangle = 0;
    std::uint32_t line = 0;
    double depth = 0;
};

/// Makes a result of shot lines whose hits all enter; they ascend by triangle.
[[nodiscard]] inline ScenarioResult hits_at(const std::vector<HitAt>& hits) {
    ScenarioResult result;
    result.question = Question::Shots;
    result.kind = hits.empty() ? ScenarioClass::Separate : ScenarioClass::Contact;
    result.pair_count = hits.size();
    for (const HitAt& hit : hits) {
        result.pairs.push_back({hit.triangle, hit.line, PairClass::Touch});
        result.hits.push_back({hit.depth, hit_flag::crosses | hit_flag::front, 0});
    }
    return result;
}

[[nodiscard]] inline ScenarioResult failed(std::uint64_t index) {
    ScenarioResult result;
    result.index = index;
    result.kind = ScenarioClass::Failed;
    result.failure = "cancelled";
    return result;
}

/// Writes the results, in ascending order, and opens the file.
[[nodiscard]] inline RecordFile write_records(const std::filesystem::path& path,
                                              const std::vector<ScenarioResult>& results) {
    auto writer = RecordWriter::create(path);
    EXPECT_TRUE(writer);
    for (const ScenarioResult& result : results) {
        writer.value().add(result.index, encode_result(result));
        if (writer.value().is_full()) {
            EXPECT_TRUE(writer.value().flush());
        }
    }
    EXPECT_TRUE(writer.value().finish());
    auto file = RecordFile::open(path);
    EXPECT_TRUE(file) << file.error().detail;
    return std::move(file.value());
}

} // namespace cd::tests
