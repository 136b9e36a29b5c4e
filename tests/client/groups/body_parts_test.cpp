// Proves which triangles make up the parts of a body, and how parts are named.
#include "client/groups/body_parts.hpp"

#include "common/core/limits/client.hpp"
#include "tests/support/parts.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace cd::tests {

namespace {

/// Makes `count` boxes side by side, that have no point in common.
Mesh boxes(int count) {
    std::vector<Mesh> meshes;
    for (int i = 0; i < count; ++i) {
        meshes.push_back(translated(make_box({1, 1, 1}), {2.0 * i, 0, 0}));
    }
    return join(meshes);
}

} // namespace

TEST(BodyParts, AreThePartsOfTheMesh) {
    const BodyParts parts(with_parts(make_box({1, 1, 1}), {{"left", 0, 6}, {"right", 6, 12}}));
    ASSERT_EQ(parts.count(), 2u);
    EXPECT_TRUE(parts.has_lasting_names());
    EXPECT_EQ(parts.name(parts.part_of(5)), "left");
    EXPECT_EQ(parts.name(parts.part_of(6)), "right");
}

TEST(BodyParts, PartsOfOneNameAreOnePart) {
    const BodyParts parts(
        with_parts(make_box({1, 1, 1}), {{"wheel", 0, 2}, {"door", 2, 6}, {"wheel", 6, 12}}));
    ASSERT_EQ(parts.count(), 2u);
    EXPECT_EQ(parts.part_of(0), parts.part_of(11));
    EXPECT_NE(parts.part_of(0), parts.part_of(3));
}

TEST(BodyParts, TrianglesOfNoPartAreAPart) {
    const BodyParts parts(with_parts(make_box({1, 1, 1}), {{"left", 0, 2}, {"right", 4, 8}}));
    ASSERT_EQ(parts.count(), 3u);
    for (const std::uint32_t triangle : {2u, 3u, 8u, 11u}) {
        EXPECT_EQ(parts.name(parts.part_of(triangle)), "others");
    }
}

TEST(BodyParts, AMeshOfOnePieceIsOnePart) {
    const BodyParts nameless(make_box({1, 1, 1}));
    ASSERT_EQ(nameless.count(), 1u);
    EXPECT_EQ(nameless.name(0), "whole");
    EXPECT_TRUE(nameless.has_lasting_names());
    const BodyParts named(with_parts(make_box({1, 1, 1}), {{"hull", 0, 12}}));
    ASSERT_EQ(named.count(), 1u);
    EXPECT_EQ(named.name(0), "hull");
}

TEST(BodyParts, PiecesAreNumberedFromTheLargest) {
    const Mesh mesh = join({make_box({1, 1, 1}),
                            translated(make_sphere(2), {5, 0, 0}),
                            make_soup({{9, 0, 0}, {9, 1, 0}, {9, 0, 1}})});
    const BodyParts parts(mesh);
    ASSERT_EQ(parts.count(), 3u);
    EXPECT_FALSE(parts.has_lasting_names());
    EXPECT_EQ(parts.name(parts.part_of(12)), "piece 1") << "the sphere";
    EXPECT_EQ(parts.name(parts.part_of(0)), "piece 2") << "the box";
    EXPECT_EQ(parts.name(parts.part_of(mesh.triangles().size() - 1)), "piece 3");
}

TEST(BodyParts, PiecesAreNoPartsWhereOnlyNamedPartsCount) {
    const BodyParts parts(boxes(3), PartKind::Named);
    EXPECT_EQ(parts.count(), 1u);
    EXPECT_EQ(parts.name(parts.part_of(13)), "whole");
    EXPECT_TRUE(parts.has_lasting_names());
}

TEST(BodyParts, UnsharedCornersConnectByTheirCoordinates) {
    EXPECT_EQ(BodyParts(unshared(boxes(2))).count(), 2u);
}

TEST(BodyParts, PiecesBeyondTheLimitAreOthers) {
    const BodyParts parts(boxes(static_cast<int>(limits::pieces_max) + 5));
    ASSERT_EQ(parts.count(), limits::pieces_max + 1);
    EXPECT_EQ(parts.name(limits::pieces_max - 1), "piece 1000");
    EXPECT_EQ(parts.name(limits::pieces_max), "others");
    EXPECT_EQ(parts.part_of(12 * (limits::pieces_max + 4)), limits::pieces_max);
}

TEST(BodyParts, RunsGiveEachTriangleItsPart) {
    const std::vector<Mesh> meshes{
        boxes(3),
        unshared(boxes(2)),
        make_box({1, 1, 1}),
        with_parts(make_box({1, 1, 1}), {{"wheel", 0, 2}, {"door", 2, 6}, {"wheel", 8, 12}})};
    for (const Mesh& mesh : meshes) {
        const BodyParts parts(mesh);
        const NamedParts runs = parts.by_runs();
        ASSERT_EQ(runs.names.size(), parts.count());
        for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
            const std::uint32_t part = runs.runs.runs()[runs.runs.run_of(i)].part;
            EXPECT_EQ(runs.names[part], parts.name(parts.part_of(i)));
        }
    }
    EXPECT_EQ(BodyParts(boxes(3)).by_runs().runs.runs().size(), 3u);
}

TEST(BodyParts, ABundleOfLinesIsOnePart) {
    const Mesh lines = make_mesh({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 0)},
                                 {{0, 1, 1}, {2, 3, 3}});
    const BodyParts parts(with_parts(lines, {{"lines", 0, 2}}));
    ASSERT_EQ(parts.count(), 1u);
    EXPECT_EQ(parts.name(0), "lines");
    EXPECT_TRUE(parts.has_lasting_names());
}

} // namespace cd::tests
