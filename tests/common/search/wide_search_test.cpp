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

} // namespace

} // namespace cd::tests
