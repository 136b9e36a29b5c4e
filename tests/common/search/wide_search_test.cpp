// Proves that wide and binary searches find the same for every query, on every SIMD target.
#include "common/search/wide_search.hpp"

#include "common/search/binary_search.hpp"
#include "tests/support/brink_boxes.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <initializer_list>

namespace cd::tests {

namespace {

/// Expects both searches to find the same; returns the number of contacts.
std::uint64_t expect_same(const ObbTree& a,
                          const ObbTree& b,
                          const PosePair& poses,
                          std::span<const IgnoredRange> ignored,
                          const SearchOptions& options) {
    WideSearch wide(poses, ignored, options);
    BinarySearch binary(poses, ignored, options);
    EXPECT_EQ(wide.any(a.view(), b.view()), binary.any(a.view(), b.view()));
    for (ContactSearch* const search : std::initializer_list<ContactSearch*>{&wide, &binary}) {
        search->collect(a.view(), b.view());
        search->contacts().sort();
    }
    const FoundContacts& left = wide.contacts();
    const FoundContacts& right = binary.contacts();
    EXPECT_EQ(left.count(), right.count());
    EXPECT_EQ(left.has_proper(), right.has_proper());
    EXPECT_EQ(left.pairs(), right.pairs());
    EXPECT_TRUE(std::ranges::equal(
        left.corners(), right.corners(), [](const PairCorners& x, const PairCorners& y) {
            return x.a == y.a && x.b == y.b;
        }));
    return left.count();
}

TEST(WideSearch, FindsWhatABinarySearchFinds) {
    const std::vector<IgnoredRange> some = {{0, 20, 0, 1000}, {30, 35, 5, 50}};
    const std::vector<IgnoredRange> none;
    std::uint64_t contacts = 0;
    for (SeededRandom random : seeds(25)) {
        const std::array<Mesh, 4> meshes = {make_sphere(2),
                                            make_degenerate_soup(random, 60),
                                            make_gridded_box(Vec3(1, 0.5, 0.25), 3),
                                            make_triangle_soup(random, 120, 0.1)};
        const ObbTree a = make_tree(meshes[random() % 4]);
        const ObbTree b = make_tree(meshes[random() % 4]);
        const PosePair poses{any_pose(random, 0.3), any_pose(random, 0.3)};
        on_every_target([&](SimdTarget) {
            for (const auto& ignored : {none, some}) {
                for (const SearchOptions& options :
                     {SearchOptions{},
                      SearchOptions{.keep_pairs = false},
                      SearchOptions{.only_touches = true},
                      SearchOptions{.pairs_max = 7},
                      SearchOptions{.pairs_max = 5, .keep_corners = true},
                      SearchOptions{.keep_corners = true, .first_stage = PairStage::Arbitrary}}) {
                    contacts += expect_same(a, b, poses, ignored, options);
                }
            }
        });
    }
    EXPECT_GT(contacts, 10'000u);
}

TEST(WideSearch, AnExpectedContactChangesNoAnswer) {
    const ObbTree sphere = make_tree(make_sphere(4));
    std::mt19937_64 random(6);
    WideSearch any(PosePair{});
    WideSearch all(PosePair{});
    std::uint64_t contacts = 0;
    for (std::uint64_t i = 0; i < 200; ++i) {
        const PosePair poses{Pose{}, make_pose(random, 3)};
        any.restart(poses);
        all.restart(poses);
        all.collect(sphere.view(), sphere.view());
        ASSERT_EQ(any.any(sphere.view(), sphere.view()), all.contacts().count() > 0);
        ASSERT_LE(any.report().statistics.triangle_tests, all.report().statistics.triangle_tests);
        contacts += all.contacts().count() > 0 ? 1 : 0;
    }
    EXPECT_GT(contacts, 20u);
    EXPECT_LT(contacts, 180u);
}

/// The next pose of a sweep: mostly near the last one, now and then far from it.
Pose next_pose(std::mt19937_64& random, const Pose& last) {
    if (random() % 20 == 0) {
        return make_pose(random, 1.5);
    }
    const Pose step = make_pose(random, 0.02);
    const Quaternion turn{1,
                          uniform(random, -0.02, 0.02),
                          uniform(random, -0.02, 0.02),
                          uniform(random, -0.02, 0.02)};
    return Pose::from_quaternion(turn * last.quaternion(),
                                 last.translation() + 0.01 * step.translation());
}

TEST(WideSearch, EarlierPosesChangeNoAnswer) {
    std::uint64_t contacts = 0;
    std::uint64_t poses_tried = 0;
    for (SeededRandom random : seeds(6)) {
        ObbTree torus = make_tree(make_torus(1, 0.3, 60, 30));
        ObbTree box = make_tree(make_gridded_box(Vec3(1, 0.5, 0.25), 12));
        for (const bool has_planes : {false, true}) {
            if (has_planes) {
                torus.prepare_planes();
                box.prepare_planes();
            }
            WideSearch any(PosePair{});
            WideSearch all(PosePair{});
            Pose pose = make_pose(random, 1.5);
            for (int i = 0; i < 300; ++i) {
                pose = next_pose(random, pose);
                // Other trees than those of the last pose come between, in no order.
                const bool is_swapped = random() % 30 == 0;
                const TreeView a = (is_swapped ? box : torus).view();
                const TreeView b = (is_swapped ? torus : box).view();
                const PosePair poses{Pose{}, pose};
                WideSearch fresh(poses);
                fresh.collect(a, b);
                any.restart(poses);
                all.restart(poses);
                all.collect(a, b);
                ASSERT_EQ(any.any(a, b), fresh.contacts().count() > 0);
                ASSERT_EQ(all.contacts().count(), fresh.contacts().count());
                contacts += fresh.contacts().count() > 0 ? 1 : 0;
                ++poses_tried;
            }
        }
    }
    EXPECT_GT(contacts, poses_tried / 10);
    EXPECT_LT(contacts, poses_tried * 9 / 10);
}

TEST(WideSearch, ContactsOfASweepAreFoundSooner) {
    std::mt19937_64 random(8);
    const ObbTree soup = make_tree(make_triangle_soup(random, 4000, 0.1));
    WideSearch kept(PosePair{});
    std::uint64_t with_memory = 0;
    std::uint64_t alone = 0;
    for (int i = 0; i < 50; ++i) {
        const PosePair poses{Pose{}, translation_pose(1.2 + 0.0005 * i, 0.1, 0.02)};
        WideSearch fresh(poses);
        kept.restart(poses);
        ASSERT_TRUE(fresh.any(soup.view(), soup.view()));
        ASSERT_TRUE(kept.any(soup.view(), soup.view()));
        alone += fresh.report().statistics.box_tests;
        with_memory += kept.report().statistics.box_tests;
    }
    EXPECT_LT(with_memory, alone * 3 / 4);
}

} // namespace

} // namespace cd::tests
