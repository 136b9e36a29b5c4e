// Proves that a search reused from pose to pose finds what a new one finds, and stops allocating
// once it has enough memory.

#include "common/search/wide_search.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <new>
#include <random>

namespace {

/// Allocations of this thread, counted by the replaced operators.
thread_local std::size_t allocations = 0;

} // namespace

// Not inlined: the compiler would report a mismatch with the library's operators.
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    ++allocations;
    return std::malloc(size != 0 ? size : 1);
}
[[gnu::noinline]] void* operator new(std::size_t size) {
    if (void* const memory = operator new(size, std::nothrow)) {
        return memory;
    }
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
    std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace cd::tests {

namespace {

/// Makes poses under which most pairs of unit spheres are in contact and some are apart.
std::vector<PosePair> poses_around(std::mt19937_64& random, std::size_t count) {
    std::vector<PosePair> poses;
    for (std::size_t i = 0; i < count; ++i) {
        poses.push_back({Pose{}, make_pose(random, 2)});
    }
    return poses;
}

std::vector<ContactPair> sorted_pairs(WideSearch& search, const ObbTree& a, const ObbTree& b) {
    search.collect(a.view(), b.view());
    search.contacts().sort();
    return search.contacts().pairs();
}

} // namespace

TEST(SearchMemory, ASearchThatGoesOnFindsWhatANewOneFinds) {
    std::mt19937_64 random(1);
    const ObbTree a = make_tree(make_sphere(3));
    const ObbTree b = make_tree(make_sphere(4));
    for (const bool keep_corners : {false, true}) {
        const SearchOptions options{.keep_corners = keep_corners};
        WideSearch kept(PosePair{}, {}, options);
        WideSearch kept_any(PosePair{});
        std::size_t in_contact = 0;
        for (const PosePair& poses : poses_around(random, 60)) {
            kept.restart(poses);
            WideSearch fresh(poses, {}, options);
            const auto expected = sorted_pairs(fresh, a, b);
            ASSERT_EQ(sorted_pairs(kept, a, b), expected);
            ASSERT_EQ(kept.contacts().count(), fresh.contacts().count());
            ASSERT_EQ(kept.contacts().has_proper(), fresh.contacts().has_proper());
            ASSERT_EQ(kept.report().statistics.box_tests, fresh.report().statistics.box_tests);
            ASSERT_EQ(kept.report().statistics.triangle_tests,
                      fresh.report().statistics.triangle_tests);
            ASSERT_EQ(kept.contacts().corners().size(), keep_corners ? expected.size() : 0u);
            kept_any.restart(poses);
            ASSERT_EQ(kept_any.any(a.view(), b.view()), !expected.empty());
            in_contact += expected.empty() ? 0 : 1;
        }
        EXPECT_GT(in_contact, 20u);
        EXPECT_LT(in_contact, 60u);
    }
}

TEST(SearchMemory, NothingIsAllocatedOnceThereIsEnough) {
    std::mt19937_64 random(2);
    const ObbTree a = make_tree(make_sphere(3));
    const ObbTree b = make_tree(make_sphere(4));
    const std::vector<PosePair> all = poses_around(random, 40);
    WideSearch any(PosePair{});
    WideSearch count(PosePair{}, {}, {.keep_pairs = false});
    WideSearch pairs(PosePair{});
    WideSearch with_corners(PosePair{}, {}, {.keep_corners = true});
    std::size_t found = 0;
    const auto run_all = [&] {
        for (const PosePair& poses : all) {
            any.restart(poses);
            found += any.any(a.view(), b.view()) ? 1 : 0;
            for (WideSearch* const search : {&count, &pairs, &with_corners}) {
                search->restart(poses);
                search->collect(a.view(), b.view());
                search->contacts().sort();
                found += search->contacts().count();
            }
        }
    };
    run_all();
    const std::size_t before = allocations;
    EXPECT_GT(before, 0u) << "allocations are not counted";
    run_all();
    EXPECT_EQ(allocations, before);
    EXPECT_GT(found, 1000u);
}

} // namespace cd::tests
