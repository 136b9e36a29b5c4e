// Proves that a search neither misses nor invents a contact: on random, degenerate and
// touching meshes, with either kind of pose on both bodies, it finds what brute force finds.

#include "common/search/contact_search.hpp"

#include "common/search/brute_force.hpp"
#include "tests/support/brink_boxes.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>

namespace cd::tests {

namespace {

/// Compares all answers of a search with brute force; returns the number of pairs.
std::size_t expect_agreement(const Mesh& a, const Mesh& b, const PosePair& poses) {
    const std::vector<ContactPair> expected = contact_pairs_brute_force(a, b, poses);
    const BuildOptions variants[] = {
        {}, {.leaf_triangles_max = 1}, {.boxes = BoxKind::Aabb}, {.rule = SplitRule::Bare}};
    for (const BuildOptions& options : variants) {
        const ObbTree tree_a = make_tree(a, options);
        const ObbTree tree_b = make_tree(b, options);
        EXPECT_EQ(contact_pairs(tree_a, tree_b, poses), expected);
        const auto search = make_search(tree_a.view(), tree_b.view(), poses);
        EXPECT_EQ(search->any(tree_a.view(), tree_b.view()), !expected.empty());
        EXPECT_TRUE(search->contacts().pairs().empty());
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

TEST(ContactSearch, AgreesWithBruteForceOnRandomSoups) {
    constexpr std::uint64_t rounds = 60;
    std::uint64_t rounds_with_contact = 0;
    for (SeededRandom random : seeds(rounds)) {
        const Mesh a = make_triangle_soup(random, 40);
        const Mesh b = make_triangle_soup(random, 50, 0.2);
        rounds_with_contact += expect_agreement(a, b, random_poses(random, 1.5)) != 0 ? 1u : 0u;
    }
    // Both outcomes must occur, or agreement proves little.
    EXPECT_GT(rounds_with_contact, rounds / 5);
    EXPECT_LT(rounds_with_contact, rounds * 19 / 20);
}

TEST(ContactSearch, AgreesWithBruteForceOnDegenerateSoups) {
    std::size_t contacts = 0;
    for (SeededRandom random : seeds(20)) {
        const Mesh a = make_degenerate_soup(random, 40);
        const Mesh b = make_degenerate_soup(random, 40);
        contacts += expect_agreement(a, b, {Pose{}, translation_pose(1, 0, 0)});
        contacts += expect_agreement(a, b, random_poses(random, 1.0));
        contacts += expect_agreement(a, a, PosePair{});
    }
    EXPECT_GT(contacts, 0u);
}

TEST(ContactSearch, AgreesWithBruteForceOnSpheresThatTouchOrCross) {
    const Mesh sphere = make_sphere(2);
    EXPECT_GT(expect_agreement(sphere, sphere, PosePair{}), 0u);
    EXPECT_GT(expect_agreement(sphere, sphere, {Pose{}, translation_pose(2, 0, 0)}), 0u);
    EXPECT_GT(expect_agreement(sphere, sphere, {Pose{}, translation_pose(1.5, 0.3, 0)}), 0u);
    EXPECT_EQ(expect_agreement(sphere, sphere, {Pose{}, translation_pose(2.0001, 0, 0)}), 0u);
}

TEST(ContactSearch, FindsEveryContactOfGriddedBoxesFaceToFace) {
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
    const Pose upper = with_translation(lower, lower.translation() + up);
    return expect_agreement(box, box, {lower, upper});
}

// FCL in float loses three of four touching pairs of two stacked boxes in its box tests alone.
TEST(ContactSearch, LosesNoTouchingPairOfStackedBoxes) {
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
    for (SeededRandom random : seeds(2)) {
        const double reach = random.seed % 2 == 0 ? 1.0 : 1e7;
        contacts +=
            expect_agreement_of_stacked_boxes(Vec3(0.1, 0.3, 0.7), 4, make_pose(random, reach));
        contacts += expect_agreement_of_stacked_boxes(
            Vec3(0.1, 0.3, 0.7), 4, make_matrix_pose(random, reach));
    }
    EXPECT_GT(contacts, 0u);
}

TEST(ContactSearch, AgreesWithBruteForceUnderMatricesThatAreNotQuiteRigid) {
    std::size_t contacts = 0;
    for (SeededRandom random : seeds(8)) {
        const Mesh box = make_gridded_box(Vec3(1, 1, 1), 3);
        contacts += expect_agreement(box, box, {any_pose(random, 1e-5), any_pose(random, 1e-5)});
        // A stretch along z near the tolerated maximum: the bodies are 1e-6 apart, or 1e-6 deep.
        const double stretch = 1 + 4.9e-6;
        const Mat3 longer = Vec3(1, 1, stretch).asDiagonal();
        const double up = 0.5 * (1 + stretch) + (random.seed % 2 == 0 ? 1e-6 : -1e-6);
        const std::size_t pairs =
            expect_agreement(box, box, {Pose{}, Pose::from_matrix(longer, Vec3(0, 0, up))});
        EXPECT_EQ(pairs == 0, random.seed % 2 == 0);
    }
    EXPECT_GT(contacts, 0u);
}

TEST(ContactSearch, AgreesWithBruteForceOnHugeTinyAndFarMeshes) {
    std::mt19937_64 random(7);
    const Mesh soup = make_triangle_soup(random, 30);
    for (const double scale : {1e-320, 1e-200, 1e-30, 1e30, 0x1p400}) {
        SCOPED_TRACE(testing::Message() << "scale " << scale);
        const Mesh mesh = scaled(soup, scale);
        EXPECT_GT(expect_agreement(mesh, mesh, PosePair{}), 0u);
        expect_agreement(mesh, mesh, random_poses(random, 0.5 * scale));
    }
    const Mesh far = translated(soup, Vec3(1e7, -1e7, 1e6));
    EXPECT_GT(expect_agreement(far, far, {Pose{}, translation_pose(0.25, 0, 0)}), 0u);
    expect_agreement(far, soup, {Pose{}, translation_pose(1e7, -1e7, 1e6)});
}

TEST(ContactSearch, PassesOverIgnoredRanges) {
    const Mesh sphere = make_sphere(2);
    const ObbTree tree = make_tree(sphere);
    const auto last = static_cast<std::uint32_t>(sphere.triangles().size());
    const std::vector<IgnoredRange> ignored = {{0, 40, 0, last}, {50, 60, 10, 70}};
    const std::vector<IgnoredRange> all = {{0, last, 0, last}};
    std::vector<ContactPair> expected = contact_pairs_brute_force(sphere, sphere, PosePair{});
    std::erase_if(expected, [&](const ContactPair& pair) {
        return pair.a < 40 || (pair.a >= 50 && pair.a < 60 && pair.b >= 10 && pair.b < 70);
    });

    for (const TreeView& view : forms_of(tree)) {
        const auto search = make_search(view, view, PosePair{}, ignored);
        search->collect(view, view);
        search->contacts().sort();
        EXPECT_EQ(search->contacts().pairs(), expected);

        const auto nothing = make_search(view, view, PosePair{}, all);
        EXPECT_FALSE(nothing->any(view, view));
        EXPECT_EQ(nothing->report().statistics.triangle_tests, 0u);
    }
}

TEST(ContactSearch, KeepsTheCornersOfEachPairBesideItIfAsked) {
    std::mt19937_64 random(8);
    const Mesh a = make_triangle_soup(random, 80);
    const Mesh b = make_triangle_soup(random, 80);
    const ObbTree tree_a = make_tree(a);
    const ObbTree tree_b = make_tree(b);
    const auto search =
        make_search(tree_a.view(), tree_b.view(), PosePair{}, {}, {.keep_corners = true});
    search->collect(tree_a.view(), tree_b.view());
    FoundContacts& found = search->contacts();
    found.sort();
    ASSERT_FALSE(found.pairs().empty());
    ASSERT_EQ(found.corners().size(), found.pairs().size());
    EXPECT_TRUE(std::is_sorted(found.pairs().begin(), found.pairs().end()));
    for (std::size_t i = 0; i < found.pairs().size(); ++i) {
        EXPECT_EQ(found.corners()[i].a, a.corners(found.pairs()[i].a));
        EXPECT_EQ(found.corners()[i].b, b.corners(found.pairs()[i].b));
    }
}

TEST(ContactSearch, KeepsTheFirstPairsOfManyAndCountsAll) {
    constexpr std::uint32_t triangles = 400; // All triangles touch in one point.
    const ObbTree tree =
        make_tree(make_mesh({Vec3(1, 2, 3)}, std::vector<Triangle>(triangles, {0, 0, 0})));

    const auto search = make_search(tree.view(), tree.view(), PosePair{}, {}, {.pairs_max = 450});
    search->collect(tree.view(), tree.view());
    FoundContacts& found = search->contacts();
    EXPECT_EQ(found.count(), std::uint64_t{triangles} * triangles);
    EXPECT_LT(found.pairs().size(), 70'000u); // All pairs: 160,000.
    found.sort();

    ASSERT_EQ(found.pairs().size(), 450u);
    for (std::uint32_t i = 0; i < 450; ++i) {
        EXPECT_EQ(found.pairs()[i], (ContactPair{i / triangles, i % triangles, PairClass::Touch}));
    }
}

TEST(ContactSearch, GathersOverSeveralCallsAndCounts) {
    const ObbTree tree = make_tree(make_sphere(1));
    for (const TreeView& view : forms_of(tree)) {
        const auto search = make_search(view, view, PosePair{});
        search->collect(view, view);
        const std::size_t once = search->contacts().pairs().size();
        const QueryStatistics first = search->report().statistics;
        search->collect(view, view);
        const QueryStatistics both = search->report().statistics;
        EXPECT_EQ(search->contacts().pairs().size(), 2 * once);
        EXPECT_EQ(both.box_tests, 2 * first.box_tests);
        EXPECT_EQ(both.triangle_tests, 2 * first.triangle_tests);
        EXPECT_GE(first.triangle_tests, once);
    }
}

TEST(ContactSearch, EndsSoonAfterItIsToldToStop) {
    const ObbTree sphere = make_tree(make_sphere(4));
    for (const TreeView& view : forms_of(sphere)) {
        const auto search_until = [&](std::uint64_t checks_max) {
            std::uint64_t checks = 0;
            SearchOptions options;
            options.stop = [&] { return ++checks > checks_max; };
            const auto search = make_search(view, view, PosePair{}, {}, options);
            search->collect(view, view);
            search->collect(view, view); // A stopped search adds nothing.
            EXPECT_EQ(search->report().is_stopped, checks > checks_max);
            return search->report().statistics;
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
}

TEST(ContactSearch, ASearchForAnyContactStopsToo) {
    // Two nested shells that are near each other everywhere.
    const ObbTree outer = make_tree(make_sphere(4));
    const PosePair poses{Pose::from_matrix(1.001 * Mat3::Identity(), Vec3::Zero()), Pose{}};
    for (const TreeView& view : forms_of(outer)) {
        std::uint64_t checks = 0;
        SearchOptions options;
        options.stop = [&] { return ++checks == 2; };
        const auto search = make_search(view, view, poses, {}, options);
        EXPECT_FALSE(search->any(view, view));
        EXPECT_TRUE(search->report().is_stopped);
        EXPECT_EQ(checks, 2u);
    }
}

TEST(ContactSearch, SeparateBodiesCostNoMoreThanTheirRoots) {
    const ObbTree tree = make_tree(make_sphere(3));
    const PosePair poses{Pose{}, translation_pose(10, 0, 0)};
    const auto search = make_search(tree.view(), tree.view(), poses);
    EXPECT_FALSE(search->any(tree.view(), tree.view()));
    const QueryStatistics statistics = search->report().statistics;
    EXPECT_LE(statistics.box_tests, 2 * wide_children_max);
    EXPECT_EQ(statistics.triangle_tests, 0u);
}

TEST(ContactSearch, EndsOnTreesAsDeepAsTheBareRuleMakesThem) {
    const Mesh fan = make_staircase(2000);
    const Mesh needle =
        make_mesh({Vec3(15, 5e-4, -1), Vec3(15, 5e-4, 1), Vec3(15, 6e-4, 1)}, {{0, 1, 2}});
    const ObbTree deep = make_tree(fan, {.rule = SplitRule::Bare, .leaf_triangles_max = 1});
    ASSERT_GT(deep.depth(), 500u);
    EXPECT_EQ(contact_pairs(deep, make_tree(needle), PosePair{}),
              contact_pairs_brute_force(fan, needle, PosePair{}));
}

} // namespace

} // namespace cd::tests
