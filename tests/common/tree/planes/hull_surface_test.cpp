// Tests that the surface of a hull stays closed and convex.
#include "common/tree/planes/hull_surface.hpp"

#include "tests/support/rounds.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace cd::tests {

namespace {

/// Returns the numbers of all facets, from neighbour to neighbour.
std::set<std::uint32_t> facets_of(const HullSurface& surface) {
    std::vector<std::uint32_t> open{surface.added().empty() ? 0 : surface.added().front()};
    std::set<std::uint32_t> found(open.begin(), open.end());
    while (!open.empty()) {
        const std::uint32_t facet = open.back();
        open.pop_back();
        for (const std::uint32_t next : surface.facet(facet).neighbours) {
            if (found.insert(next).second) {
                open.push_back(next);
            }
        }
    }
    return found;
}

/// Expects that each edge joins two facets, and that no corner is above a facet.
void expect_convex(const HullSurface& surface) {
    const auto facets = facets_of(surface);
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> edges;
    for (const std::uint32_t number : facets) {
        const HullFacet& facet = surface.facet(number);
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_TRUE(
                edges.insert({{facet.corners[k], facet.corners[(k + 1) % 3]}, number}).second);
        }
        for (std::uint32_t corner = 0; corner < surface.corner_count(); ++corner) {
            EXPECT_LE(facet.height(surface.corner(corner)), 1e-12);
        }
    }
    for (const auto& [edge, number] : edges) {
        const HullFacet& facet = surface.facet(number);
        const auto k = std::ranges::find(facet.corners, edge.first) - facet.corners.begin();
        const auto other = edges.find({edge.second, edge.first});
        ASSERT_NE(other, edges.end());
        EXPECT_EQ(facet.neighbours[static_cast<std::size_t>(k)], other->second);
    }
}

HullSurface unit_tetrahedron() {
    HullSurface surface;
    EXPECT_TRUE(surface.start({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, -1)}, 2));
    return surface;
}

std::uint32_t facet_below(const HullSurface& surface, const Vec3& at) {
    const auto facets = facets_of(surface);
    return *std::ranges::max_element(
        facets, {}, [&](std::uint32_t facet) { return surface.facet(facet).height(at); });
}

TEST(HullSurface, StaysClosedAndConvex) {
    for (SeededRandom random : seeds(10)) {
        HullSurface surface = unit_tetrahedron();
        expect_convex(surface);
        for (int i = 0; i < 60; ++i) {
            const Vec3 at = 3 * random_point(random, 1).normalized();
            const std::uint32_t below = facet_below(surface, at);
            if (!(surface.facet(below).height(at) > 1e-6)) {
                continue;
            }
            ASSERT_TRUE(surface.add(at, below));
            for (const std::uint32_t removed : surface.removed()) {
                EXPECT_GT(surface.facet(removed).height(at), 0);
            }
        }
        expect_convex(surface);
        EXPECT_GT(facets_of(surface).size(), 60u);
    }
}

TEST(HullSurface, RefusesACornerThatMakesNoCone) {
    HullSurface surface = unit_tetrahedron();
    // The first facet has the edge from corner 0 to 1.
    EXPECT_FALSE(surface.add(Vec3(0.5, 0, 0), 0));
    // All facets but the first see this corner.
    EXPECT_FALSE(surface.add(Vec3(-1, -1, -5), 0));
    expect_convex(surface);
    EXPECT_EQ(facets_of(surface), (std::set<std::uint32_t>{0, 1, 2, 3}));
    EXPECT_EQ(surface.corner_count(), 4u);
    EXPECT_TRUE(surface.removed().empty());
    EXPECT_TRUE(surface.add(Vec3(0.2, 0.2, 1), 0));
    expect_convex(surface);
    EXPECT_EQ(facets_of(surface).size(), 6u);
}

TEST(HullSurface, NeedsVolume) {
    HullSurface surface;
    EXPECT_FALSE(surface.start({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(0, 0, -1)}, 2));
}

} // namespace

} // namespace cd::tests
