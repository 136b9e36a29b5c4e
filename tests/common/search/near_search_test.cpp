// Proves that a search with a clearance neither misses nor invents a near pair: on random,
// degenerate and nearly touching meshes it finds what an exact test of all pairs finds.

#include "common/geometry/aabb.hpp"
#include "common/search/contact_search.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/touching_bodies.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace cd::tests {

namespace {

/// Tests every pair of triangles, without the stages in floats.
std::vector<ContactPair>
pairs_within(const Mesh& a, const Mesh& b, const PosePair& poses, double clearance) {
    TrianglePairTest contacts(poses, PairStage::Double);
    TriangleDistance distance(poses, DistanceStage::Double);
    std::vector<ContactPair> pairs;
    for (std::uint32_t i = 0; i < a.triangles().size(); ++i) {
        for (std::uint32_t j = 0; j < b.triangles().size(); ++j) {
            PairClass kind = contacts.classify(a.corners(i), b.corners(j));
            if (kind == PairClass::Separate &&
                distance.is_within(a.corners(i), b.corners(j), clearance)) {
                kind = PairClass::Near;
            }
            if (kind != PairClass::Separate) {
                pairs.push_back({i, j, kind});
            }
        }
    }
    return pairs;
}

std::uint64_t near_in(const std::vector<ContactPair>& pairs) {
    return static_cast<std::uint64_t>(
        std::ranges::count(pairs, PairClass::Near, &ContactPair::kind));
}

/// Compares the search of two trees with the expected pairs.
void expect_pairs(const ObbTree& a,
                  const ObbTree& b,
                  const PosePair& poses,
                  double clearance,
                  const std::vector<ContactPair>& expected) {
    const auto search = make_search(a.view(), b.view(), poses, {}, {.clearance = clearance});
    search->collect(a.view(), b.view());
    FoundContacts& found = search->contacts();
    found.sort();
    EXPECT_TRUE(found.pairs() == expected);
    EXPECT_EQ(found.near_count(), near_in(expected));
    EXPECT_EQ(found.count(), expected.size() - near_in(expected));
    // The pose before may lead a search for any pair, so it is asked twice.
    for (int round = 0; round < 2; ++round) {
        search->restart(poses);
        const Nearness nearness = search->any_near(a.view(), b.view());
        EXPECT_EQ(nearness != Nearness::Far, !expected.empty());
        EXPECT_EQ(search->any(a.view(), b.view()), near_in(expected) < expected.size());
        EXPECT_FALSE(nearness == Nearness::Contact && near_in(expected) == expected.size());
    }
}

/// Compares all answers of searches with the exact test of all pairs; returns the number of near
/// pairs.
std::uint64_t
expect_agreement(const Mesh& a, const Mesh& b, const PosePair& poses, double clearance) {
    const std::vector<ContactPair> expected = pairs_within(a, b, poses, clearance);
    const BuildOptions variants[] = {{}, {.leaf_triangles_max = 1}, {.boxes = BoxKind::Aabb}};
    for (const BuildOptions& options : variants) {
        expect_pairs(make_tree(a, options), make_tree(b, options), poses, clearance, expected);
    }
    return near_in(expected);
}

PosePair random_poses(std::mt19937_64& random, double reach) {
    const auto one = [&] {
        return random() % 2 == 0 ? make_pose(random, reach) : make_matrix_pose(random, reach);
    };
    Pose a = one();
    Pose b = one();
    return {a, b};
}

TEST(NearSearch, AgreesWithAllPairsOnRandomSoups) {
    std::uint64_t near = 0;
    for (SeededRandom random : seeds(40)) {
        const Mesh a = make_triangle_soup(random, 30);
        const Mesh b = make_triangle_soup(random, 30, 0.2);
        const double clearance = std::pow(10, uniform(random, -3, 0.3));
        near += expect_agreement(a, b, random_poses(random, 1.5), clearance);
    }
    EXPECT_GT(near, 500u);
}

TEST(NearSearch, AgreesWithAllPairsOnDegenerateSoups) {
    std::uint64_t near = 0;
    for (SeededRandom random : seeds(10)) {
        const Mesh a = make_degenerate_soup(random, 30);
        const Mesh b = make_degenerate_soup(random, 30);
        near += expect_agreement(a, b, {Pose{}, translation_pose(1, 0, 0)}, 1);
        near += expect_agreement(a, b, random_poses(random, 1.0), 0.3);
    }
    EXPECT_GT(near, 1000u);
}

// The faces are exactly 0.25 apart, so that all pairs of facing triangles are ties.
TEST(NearSearch, AGapThatEqualsTheClearanceIsNear) {
    const Mesh box = make_gridded_box(Vec3(1, 1, 1), 4);
    const PosePair poses{Pose{}, translation_pose(1.25, 0, 0)};
    EXPECT_GE(expect_agreement(box, box, poses, 0.25), 32u);
    EXPECT_EQ(expect_agreement(box, box, poses, std::nextafter(0.25, 0.0)), 0u);
    EXPECT_EQ(expect_agreement(box, box, {Pose{}, translation_pose(1, 0, 0)}, 0), 0u);
}

TEST(NearSearch, AnotherClearanceHoldsFromTheNextRestart) {
    const ObbTree box = make_tree(make_gridded_box(Vec3(1, 1, 1), 4));
    const PosePair poses{Pose{}, translation_pose(1.25, 0, 0)};
    for (const TreeView& view : forms_of(box)) {
        const auto search = make_search(view, view, poses, {}, {.clearance = 0});
        for (const double clearance : {0.0, 0.25, std::nextafter(0.25, 0.0), 1.0, 0.125}) {
            search->set_clearance(clearance);
            search->restart(poses);
            const bool is_near = search->any_near(view, view) != Nearness::Far;
            EXPECT_EQ(is_near, clearance >= 0.25) << clearance;
            search->collect(view, view);
            EXPECT_EQ(search->contacts().near_count() > 0, clearance >= 0.25) << clearance;
        }
    }
}

TEST(NearSearch, AMatrixScalesDistances) {
    const Mesh sphere = make_sphere(2);
    for (const double scale : {0.5, 3.0}) {
        const Mat3 matrix = scale * Mat3::Identity();
        const PosePair poses{Pose::from_matrix(matrix, Vec3(0, 0, 0)),
                             Pose::from_matrix(matrix, Vec3(2.5 * scale, 0, 0))};
        EXPECT_GT(expect_agreement(sphere, sphere, poses, 0.51 * scale), 0u);
        EXPECT_EQ(expect_agreement(sphere, sphere, poses, 0.49 * scale), 0u);
    }
    Mat3 skewed = Mat3::Identity();
    skewed(0, 0) = 0.25;
    const PosePair poses{Pose::from_matrix(skewed, Vec3(0, 0, 0)),
                         Pose::from_matrix(skewed, Vec3(0.7, 0, 0))};
    EXPECT_GT(expect_agreement(sphere, sphere, poses, 0.21), 0u);
}

TEST(NearSearch, BodiesThatNearlyTouchAreNearInEveryCategory) {
    for (std::size_t category = 0; category < touching_categories; ++category) {
        SCOPED_TRACE(touching_category(category));
        for (SeededRandom random : seeds(1)) {
            const TouchingBodies bodies = make_touching(category, random);
            for (const double share : {0.0, 1e-9, 1e-2}) {
                const double size = bounding_box(bodies.a.vertices()).diagonal();
                const ObbTree a = make_tree(bodies.a);
                const ObbTree b = make_tree(bodies.b);
                expect_pairs(a,
                             b,
                             bodies.poses,
                             share * size,
                             pairs_within(bodies.a, bodies.b, bodies.poses, share * size));
            }
        }
    }
}

} // namespace

} // namespace cd::tests
