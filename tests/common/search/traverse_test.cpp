// Proves that the traversal neither misses nor invents a contact: on random, degenerate and
// touching meshes, with either kind of pose on both bodies, it finds what brute force finds.

#include "common/search/traverse.hpp"

#include "common/core/host/thread_pool.hpp"
#include "common/search/brute_force.hpp"
#include "common/tree/build/build.hpp"
#include "tests/common/tree/exact_box.hpp"
#include "tests/support/brink_boxes.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace cd::tests {

namespace {

ObbTree build(const Mesh& mesh, const BuildOptions& options = {}) {
    ThreadPool pool(1);
    return build_tree(share(Mesh(mesh)), options, pool);
}

/// Compares all answers of the traversal with brute force; returns the number of pairs.
std::size_t expect_agreement(const Mesh& a, const Mesh& b, const PosePair& poses) {
    const std::vector<ContactPair> expected = contact_pairs_brute_force(a, b, poses);
    const BuildOptions variants[] = {
        {}, {.leaf_triangles_max = 1}, {.boxes = BoxKind::Aabb}, {.rule = SplitRule::Bare}};
    for (const BuildOptions& options : variants) {
        const ObbTree tree_a = build(a, options);
        const ObbTree tree_b = build(b, options);
        EXPECT_EQ(contact_pairs(tree_a, tree_b, poses), expected);
        ContactSearch search(poses, {});
        EXPECT_EQ(search.any(tree_a.view(), tree_b.view()), !expected.empty());
        EXPECT_TRUE(search.pairs().empty());
    }
    return expected.size();
}

PosePair random_poses(std::mt19937_64& random, double reach) {
    const auto one = [&] {
        return random() % 2 == 0 ? make_pose(random, reach) : make_matrix_pose(random, reach);
    };
    Pose a = one();
    Pose b = one();
    return {a, b};
}

TEST(Traverse, AgreesWithBruteForceOnRandomSoups) {
    constexpr std::uint64_t rounds = 60;
    std::uint64_t rounds_with_contact = 0;
    for (std::uint64_t seed = 0; seed < rounds; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        std::mt19937_64 random(seed);
        const Mesh a = make_triangle_soup(random, 40);
        const Mesh b = make_triangle_soup(random, 50, 0.2);
        rounds_with_contact += expect_agreement(a, b, random_poses(random, 1.5)) != 0 ? 1u : 0u;
    }
    // Both outcomes must occur, or agreement proves little.
    EXPECT_GT(rounds_with_contact, rounds / 5);
    EXPECT_LT(rounds_with_contact, rounds * 19 / 20);
}

TEST(Traverse, AgreesWithBruteForceOnDegenerateSoups) {
    std::size_t contacts = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        std::mt19937_64 random(seed);
        const Mesh a = make_degenerate_soup(random, 40);
        const Mesh b = make_degenerate_soup(random, 40);
        contacts += expect_agreement(a, b, {Pose{}, translation_pose(1, 0, 0)});
        contacts += expect_agreement(a, b, random_poses(random, 1.0));
        contacts += expect_agreement(a, a, PosePair{});
    }
    EXPECT_GT(contacts, 0u);
}

TEST(Traverse, AgreesWithBruteForceOnSpheresThatTouchOrCross) {
    const Mesh sphere = make_sphere(2);
    EXPECT_GT(expect_agreement(sphere, sphere, PosePair{}), 0u);
    EXPECT_GT(expect_agreement(sphere, sphere, {Pose{}, translation_pose(2, 0, 0)}), 0u);
    EXPECT_GT(expect_agreement(sphere, sphere, {Pose{}, translation_pose(1.5, 0.3, 0)}), 0u);
    EXPECT_EQ(expect_agreement(sphere, sphere, {Pose{}, translation_pose(2.0001, 0, 0)}), 0u);
}

TEST(Traverse, FindsEveryContactOfGriddedBoxesFaceToFace) {
    const Mesh box = make_gridded_box(Vec3(1, 1, 1), 4);
    const std::size_t aligned = expect_agreement(box, box, {Pose{}, translation_pose(1, 0, 0)});
    EXPECT_GE(aligned, 32u);
    EXPECT_GT(expect_agreement(box, box, {Pose{}, translation_pose(1, 1, 0)}), 0u);
    EXPECT_GT(expect_agreement(box, box, {Pose{}, translation_pose(1, 1, 1)}), 0u);
    EXPECT_EQ(expect_agreement(box, box, {Pose{}, translation_pose(0x1.000002p0, 0, 0)}), 0u);
    // Both bodies turn by one 3-4-5 angle: nothing is axis-aligned, everything touches.
    const Quaternion turn{2, 0, 0, 1};
    const PosePair turned{Pose::from_quaternion(turn, Vec3(5, 0, 0)),
                          Pose::from_quaternion(turn, Vec3(5, 0, 1))};
    EXPECT_EQ(expect_agreement(box, box, turned), aligned);
}

/// Compares the pairs of two stacked boxes with coinciding grids under these poses of the lower
/// box; the upper one rests on it.
std::size_t expect_agreement_of_stacked_boxes(const Vec3& size, int cells, const Pose& lower) {
    const Mesh box = make_gridded_box(size, cells);
    const Vec3 up = lower.rotation() * Vec3(0, 0, size.z());
    const Pose upper = lower.kind() == Pose::Kind::Matrix
                           ? Pose::from_matrix(lower.matrix(), lower.translation() + up)
                           : Pose::from_quaternion(lower.quaternion(), lower.translation() + up);
    return expect_agreement(box, box, {lower, upper});
}

// FCL in float loses three of four touching pairs of two stacked boxes in its box tests alone.
TEST(Traverse, LosesNoTouchingPairOfStackedBoxes) {
    // Under exact poses all adjacent facing triangles touch.
    const Vec3 dyadic(1, 2, 0.5);
    const std::size_t exact = expect_agreement_of_stacked_boxes(dyadic, 4, Pose{});
    EXPECT_GE(exact, 2u * 2u * 16u);
    for (const Vec3& offset : {Vec3(1e6, -3e6, 12345), Vec3(1e7, 1e7, 1e7), Vec3(0.125, 0, -7)}) {
        EXPECT_EQ(expect_agreement_of_stacked_boxes(
                      dyadic, 4, Pose::from_matrix(Mat3::Identity(), offset)),
                  exact);
        // A right angle, as a quaternion far from norm 1.
        EXPECT_EQ(expect_agreement_of_stacked_boxes(
                      dyadic, 4, Pose::from_quaternion({1, 0, 0, 1}, offset)),
                  exact);
    }
    // Rounded poses and decimal sizes: some pairs touch, depending on roundings.
    std::size_t contacts = 0;
    for (std::uint64_t seed = 0; seed < 2; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        std::mt19937_64 random(seed);
        const double reach = seed % 2 == 0 ? 1.0 : 1e7;
        contacts +=
            expect_agreement_of_stacked_boxes(Vec3(0.1, 0.3, 0.7), 4, make_pose(random, reach));
        contacts += expect_agreement_of_stacked_boxes(
            Vec3(0.1, 0.3, 0.7), 4, make_matrix_pose(random, reach));
    }
    EXPECT_GT(contacts, 0u);
}

TEST(Traverse, AgreesWithBruteForceUnderMatricesThatAreNotQuiteRigid) {
    std::size_t contacts = 0;
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        std::mt19937_64 random(seed);
        const Mesh box = make_gridded_box(Vec3(1, 1, 1), 3);
        contacts += expect_agreement(box, box, {any_pose(random, 1e-5), any_pose(random, 1e-5)});
        // A stretch along z near the tolerated maximum: the bodies are 1e-6 apart, or 1e-6 deep.
        const double stretch = 1 + 4.9e-6;
        const Mat3 longer = Vec3(1, 1, stretch).asDiagonal();
        const double up = 0.5 * (1 + stretch) + (seed % 2 == 0 ? 1e-6 : -1e-6);
        const std::size_t pairs =
            expect_agreement(box, box, {Pose{}, Pose::from_matrix(longer, Vec3(0, 0, up))});
        EXPECT_EQ(pairs == 0, seed % 2 == 0);
    }
    EXPECT_GT(contacts, 0u);
}

/// Returns the least squared distance of two vertices of the meshes in the world.
Rational squared_vertex_distance(const Mesh& a, const Mesh& b, const PosePair& poses) {
    const auto world = [](const Mesh& mesh, const Pose& pose) {
        std::vector<ExactVec> places;
        for (const Vec3& vertex : mesh.vertices()) {
            places.push_back(exact_rotation(pose) * exact(vertex) + exact(pose.translation()));
        }
        return places;
    };
    const std::vector<ExactVec> of_b = world(b, poses.b);
    std::optional<Rational> least;
    for (const ExactVec& x : world(a, poses.a)) {
        for (const ExactVec& y : of_b) {
            const ExactVec between = x + scaled(Rational(-1), y);
            const Rational square = dot(between, between);
            least = least ? std::min(*least, square) : square;
        }
    }
    return *least;
}

TEST(Traverse, TheDistanceThatATolerancePromisesIsTrueInTheWorld) {
    std::size_t undecided = 0;
    std::size_t decided = 0;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        std::mt19937_64 random(seed);
        const double offset = seed % 2 == 0 ? 1.0 : 1e6;
        // Two small soups, whose boxes overlap or just do not, far from the poses' origins.
        const Vec3 place = random_point(random, offset);
        const Mesh a = translated(make_triangle_soup(random, 3), place);
        const Mesh b = translated(make_triangle_soup(random, 3), place);
        PosePair poses{any_pose(random, offset), any_pose(random, offset)};
        const Vec3 between = poses.a.apply(place) - poses.b.apply(place);
        poses.b =
            with_translation(poses.b, poses.b.translation() + between + random_point(random, 1.0));
        for (const double tolerance : {100.0, 4.0, 1.0}) {
            ContactSearch search(poses, {}, {.tolerance = tolerance});
            search.collect(build(a).view(), build(b).view());
            const auto distance = search.undecided_distance();
            if (!distance) {
                ++decided;
                continue;
            }
            ++undecided;
            ASSERT_TRUE(std::isfinite(*distance));
            ASSERT_LE(squared_vertex_distance(a, b, poses),
                      Rational(*distance) * Rational(*distance));
        }
    }
    EXPECT_GT(undecided, 40u);
    EXPECT_GT(decided, 10u);
}

TEST(Traverse, TheDistanceThatATolerancePromisesCountsHowPosesStretch) {
    // Two points with the smallest boxes: their distance is the bound, up to the boxes' margins.
    // A's pose lengthens vectors.
    const Mesh point = make_mesh({Vec3::Zero()}, {{0, 0, 0}});
    const double stretch = 1 + 1e-4;
    const Pose longer = Pose::from_matrix(stretch * Mat3::Identity(), Vec3::Zero());
    for (const double apart : {1e-40, 1e-30, 1e-25}) {
        const PosePair poses{longer, translation_pose(apart, apart, apart)};
        ContactSearch search(poses, {}, {.tolerance = 1e-6});
        search.collect(build(point).view(), build(point).view());
        if (const auto distance = search.undecided_distance()) {
            EXPECT_LE(squared_vertex_distance(point, point, poses),
                      Rational(*distance) * Rational(*distance));
        }
    }
    // Under poses that overflow, the bound is infinite, never NaN.
    const double big = 1.7e308;
    ContactSearch overflowing(
        {translation_pose(big, 0, 0), translation_pose(-big, 0, 0)}, {}, {.tolerance = 1e-6});
    overflowing.collect(build(point).view(), build(point).view());
    ASSERT_TRUE(overflowing.undecided_distance());
    EXPECT_EQ(*overflowing.undecided_distance(), std::numeric_limits<double>::infinity());
}

TEST(Traverse, AgreesWithBruteForceOnHugeTinyAndFarMeshes) {
    std::mt19937_64 random(7);
    const Mesh soup = make_triangle_soup(random, 30);
    for (const double scale : {1e-320, 1e-200, 1e-30, 1e30, 0x1p400}) {
        SCOPED_TRACE(testing::Message() << "scale " << scale);
        std::vector<Vec3> vertices = soup.vertices();
        for (Vec3& vertex : vertices) {
            vertex *= scale;
        }
        const Mesh mesh = make_mesh(vertices, soup.triangles());
        EXPECT_GT(expect_agreement(mesh, mesh, PosePair{}), 0u);
        expect_agreement(mesh, mesh, random_poses(random, 0.5 * scale));
    }
    const Mesh far = translated(soup, Vec3(1e7, -1e7, 1e6));
    EXPECT_GT(expect_agreement(far, far, {Pose{}, translation_pose(0.25, 0, 0)}), 0u);
    expect_agreement(far, soup, {Pose{}, translation_pose(1e7, -1e7, 1e6)});
}

TEST(Traverse, PassesOverIgnoredRanges) {
    const Mesh sphere = make_sphere(2);
    const ObbTree tree = build(sphere);
    const auto last = static_cast<std::uint32_t>(sphere.triangles().size());
    const std::vector<IgnoredRange> ignored = {{0, 40, 0, last}, {50, 60, 10, 70}};

    ContactSearch search(PosePair{}, ignored);
    search.collect(tree.view(), tree.view());
    search.sort();

    std::vector<ContactPair> expected = contact_pairs_brute_force(sphere, sphere, PosePair{});
    std::erase_if(expected, [&](const ContactPair& pair) {
        return pair.a < 40 || (pair.a >= 50 && pair.a < 60 && pair.b >= 10 && pair.b < 70);
    });
    EXPECT_EQ(search.pairs(), expected);

    const std::vector<IgnoredRange> all = {{0, last, 0, last}};
    ContactSearch nothing(PosePair{}, all);
    EXPECT_FALSE(nothing.any(tree.view(), tree.view()));
    EXPECT_EQ(nothing.statistics().triangle_tests, 0u);
}

TEST(Traverse, KeepsTheCornersOfEachPairBesideItIfAsked) {
    std::mt19937_64 random(8);
    const Mesh a = make_triangle_soup(random, 80);
    const Mesh b = make_triangle_soup(random, 80);
    ContactSearch search(PosePair{}, {}, {.keep_corners = true});
    search.collect(build(a).view(), build(b).view());
    search.sort();
    ASSERT_FALSE(search.pairs().empty());
    ASSERT_EQ(search.corners().size(), search.pairs().size());
    EXPECT_TRUE(std::is_sorted(search.pairs().begin(), search.pairs().end()));
    for (std::size_t i = 0; i < search.pairs().size(); ++i) {
        EXPECT_EQ(search.corners()[i].a, a.corners(search.pairs()[i].a));
        EXPECT_EQ(search.corners()[i].b, b.corners(search.pairs()[i].b));
    }
}

TEST(Traverse, KeepsTheFirstPairsOfManyAndCountsAll) {
    constexpr std::uint32_t triangles = 400; // All triangles touch in one point.
    MeshArrays arrays;
    arrays.vertices = {Vec3(1, 2, 3)};
    arrays.triangles.assign(triangles, {0, 0, 0});
    const ObbTree tree = build(Mesh::create(std::move(arrays)).value());

    ContactSearch search(PosePair{}, {}, {.pairs_max = 450});
    search.collect(tree.view(), tree.view());
    EXPECT_EQ(search.pair_count(), std::uint64_t{triangles} * triangles);
    EXPECT_LT(search.pairs().size(), 70'000u); // All pairs: 160,000.
    search.sort();

    ASSERT_EQ(search.pairs().size(), 450u);
    for (std::uint32_t i = 0; i < 450; ++i) {
        EXPECT_EQ(search.pairs()[i], (ContactPair{i / triangles, i % triangles, PairClass::Touch}));
    }
}

TEST(Traverse, GathersOverSeveralCallsAndCounts) {
    const Mesh sphere = make_sphere(1);
    const ObbTree tree = build(sphere);
    ContactSearch search(PosePair{}, {});
    search.collect(tree.view(), tree.view());
    const std::size_t once = search.pairs().size();
    const QueryStatistics first = search.statistics();
    search.collect(tree.view(), tree.view());
    EXPECT_EQ(search.pairs().size(), 2 * once);
    EXPECT_EQ(search.statistics().box_tests, 2 * first.box_tests);
    EXPECT_EQ(search.statistics().triangle_tests, 2 * first.triangle_tests);
    EXPECT_GE(first.triangle_tests, once);
}

TEST(Traverse, EndsSoonAfterItIsToldToStop) {
    const ObbTree sphere = build(make_sphere(4));
    const auto search_until = [&](std::uint64_t checks_max) {
        std::uint64_t checks = 0;
        SearchOptions options;
        options.stop = [&] { return ++checks > checks_max; };
        ContactSearch search(PosePair{}, {}, options);
        search.collect(sphere.view(), sphere.view());
        search.collect(sphere.view(), sphere.view()); // A stopped search adds nothing.
        EXPECT_EQ(search.is_stopped(), checks > checks_max);
        return search.statistics();
    };
    const QueryStatistics whole = search_until(std::numeric_limits<std::uint64_t>::max());
    const QueryStatistics at_once = search_until(0);
    const QueryStatistics later = search_until(5);
    EXPECT_GT(at_once.box_tests, 0u);
    EXPECT_GT(later.box_tests, 4 * at_once.box_tests);
    EXPECT_GT(whole.box_tests, 10 * at_once.box_tests);
    EXPECT_GT(whole.triangle_tests, later.triangle_tests);
    EXPECT_GT(later.triangle_tests, at_once.triangle_tests);
}

TEST(Traverse, ASearchForAnyContactStopsToo) {
    // Two nested shells that are near each other everywhere.
    const ObbTree outer = build(make_sphere(4));
    const PosePair poses{Pose::from_matrix(1.001 * Mat3::Identity(), Vec3::Zero()), Pose{}};
    std::uint64_t checks = 0;
    SearchOptions options;
    options.stop = [&] { return ++checks == 2; };
    ContactSearch search(poses, {}, options);
    EXPECT_FALSE(search.any(outer.view(), outer.view()));
    EXPECT_TRUE(search.is_stopped());
    EXPECT_EQ(checks, 2u);
}

TEST(Traverse, SeparateBodiesCostNoMoreThanTheirRoots) {
    const ObbTree tree = build(make_sphere(3));
    ContactSearch search({Pose{}, translation_pose(10, 0, 0)}, {});
    EXPECT_FALSE(search.any(tree.view(), tree.view()));
    EXPECT_LE(search.statistics().box_tests, 2 * wide_children_max);
    EXPECT_EQ(search.statistics().triangle_tests, 0u);
}

TEST(Traverse, EndsOnTreesAsDeepAsTheBareRuleMakesThem) {
    std::vector<Vec3> vertices = {Vec3::Zero()};
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i < 2000; ++i) {
        vertices.emplace_back(1.0 + 0.01 * i, 0, 0);
        vertices.emplace_back(1.0 + 0.01 * i, 1e-3, 0);
        triangles.push_back({0, 2 * i + 1, 2 * i + 2});
    }
    const Mesh fan = make_mesh(vertices, triangles);
    const Mesh needle =
        make_mesh({Vec3(15, 5e-4, -1), Vec3(15, 5e-4, 1), Vec3(15, 6e-4, 1)}, {{0, 1, 2}});
    const ObbTree deep = build(fan, {.rule = SplitRule::Bare, .leaf_triangles_max = 1});
    ASSERT_GT(deep.depth(), 500u);
    EXPECT_EQ(contact_pairs(deep, build(needle), PosePair{}),
              contact_pairs_brute_force(fan, needle, PosePair{}));
}

} // namespace

} // namespace cd::tests
