// Proves that runs of triangles give each triangle the part that its mesh names.
#include "common/geometry/part_runs.hpp"

#include "common/core/limits/engine.hpp"
#include "tests/support/parts.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace cd::tests {

namespace {

/// Finds the name of a triangle's part among all parts of a mesh.
std::string slow_name(const Mesh& mesh, std::uint32_t triangle) {
    for (const Part& part : mesh.parts()) {
        if (part.triangles_begin <= triangle && triangle < part.triangles_end) {
            return part.name;
        }
    }
    return "others";
}

bool are_runs(std::vector<PartRun> runs) {
    return static_cast<bool>(PartRuns::create(std::move(runs)));
}

} // namespace

TEST(PartRuns, GiveEachTriangleThePartThatItsMeshNames) {
    const Mesh sphere = make_sphere(2);
    const auto triangles = static_cast<std::uint32_t>(sphere.triangles().size());
    for (SeededRandom random : seeds(200)) {
        std::vector<Part> parts{{"a", 0, 0}, {"b", 0, 0}}; // Parts may be empty.
        for (auto begin = static_cast<std::uint32_t>(random() % 3); begin < triangles;) {
            const auto end = std::min<std::uint64_t>(triangles, begin + random() % 60);
            const std::string name(1, "abcdef"[random() % 6]);
            parts.push_back({name, begin, static_cast<std::uint32_t>(end)});
            begin = static_cast<std::uint32_t>(end + random() % 2);
        }
        const Mesh mesh = with_parts(sphere, parts);
        const NamedParts named = named_parts(mesh);
        PartCursor cursor(named.runs);
        for (int i = 0; i < 300; ++i) {
            const auto triangle = static_cast<std::uint32_t>(random() % triangles);
            ASSERT_EQ(named.names.at(cursor.part_of(triangle)), slow_name(mesh, triangle));
        }
        EXPECT_LE(named.runs.count(), named.names.size());
        EXPECT_EQ(std::set(named.names.begin(), named.names.end()).size(), named.names.size())
            << "parts of equal names are one";
        const auto again = PartRuns::create(named.runs.runs());
        ASSERT_TRUE(again);
        EXPECT_EQ(again.value().runs(), named.runs.runs());
    }
}

TEST(PartRuns, AMeshWithAtMostOnePartIsOnePart) {
    EXPECT_EQ(named_parts(make_box({1, 1, 1})).names, std::vector<std::string>{"whole"});
    const NamedParts hull = named_parts(with_parts(make_box({1, 1, 1}), {{"hull", 3, 6}}));
    EXPECT_EQ(hull.names, std::vector<std::string>{"hull"});
    EXPECT_EQ(hull.runs.runs(), std::vector<PartRun>{PartRun{}});
}

TEST(PartRuns, RefuseRunsThatDoNotAscendFromTheFirstTriangle) {
    EXPECT_TRUE(are_runs({{0, 0}}));
    EXPECT_TRUE(are_runs({{0, 7}, {5, 0}, {6, 7}}));
    EXPECT_FALSE(are_runs({}));
    EXPECT_FALSE(are_runs({{1, 0}}));
    EXPECT_FALSE(are_runs({{0, 0}, {0, 1}}));
    EXPECT_FALSE(are_runs({{0, 0}, {5, 1}, {4, 0}}));
    EXPECT_FALSE(are_runs({{0, limits::parts_max + 1}}));
}

} // namespace cd::tests
