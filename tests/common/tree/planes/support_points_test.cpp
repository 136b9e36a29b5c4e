// Proves that support points span the vertices below each node within eps.
#include "common/tree/planes/support_points.hpp"

#include "common/tree/planes/simplex.hpp"
#include "tests/support/brink_boxes.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace cd::tests {

namespace {

Vec3 any_direction(std::mt19937_64& random) {
    return make_pose(random, 1).translation().normalized();
}

/// Returns the points of a set, less the centre.
std::vector<Vec3> points_of(const WideView& tree, const SupportSet& set) {
    const SupportView& support = tree.support;
    const Vec3 center(support.center[0], support.center[1], support.center[2]);
    std::vector<Vec3> points;
    for (std::uint32_t i = 0; i < set.count; ++i) {
        const float* at = support.columns.data() + 3 * std::size_t{set.first} + i;
        const std::size_t n = padded(set.count);
        points.push_back(set.is_chosen ? Vec3(at[0], at[n], at[2 * n])
                                       : Vec3(tree.triangles.vertex(set.first + i) - center));
    }
    return points;
}

void add_vertices(const WideView& tree, std::uint32_t node, std::vector<Vec3>& to) {
    const WideNode& now = tree.nodes[node];
    if (!now.is_leaf) {
        for (std::uint32_t child = now.first; child < now.first + now.count; ++child) {
            add_vertices(tree, child, to);
        }
        return;
    }
    for (auto i = tree.triangles.vertex_begin[now.first];
         i < tree.triangles.vertex_begin[now.first + 1];
         ++i) {
        to.push_back(tree.triangles.vertex(i));
    }
}

double reach_of(const std::vector<Vec3>& points, const Vec3& direction) {
    double most = -std::numeric_limits<double>::infinity();
    for (const Vec3& point : points) {
        most = std::max(most, direction.dot(point));
    }
    return most;
}

void expect_spanned(const WideView& tree, std::mt19937_64& random) {
    const SupportView& support = tree.support;
    const Vec3 center(support.center[0], support.center[1], support.center[2]);
    ASSERT_EQ(support.sets.size(), tree.nodes.size());
    const double rounding = 0x1p-23 * support.radius;
    for (std::uint32_t node = 0; node < tree.nodes.size(); ++node) {
        const SupportSet& set = support.sets[node];
        ASSERT_GT(set.count, 0);
        ASSERT_LE(set.count, set.is_chosen ? support_points_max : support_vertices_max);
        const std::vector<Vec3> points = points_of(tree, set);
        std::vector<Vec3> vertices;
        add_vertices(tree, node, vertices);
        for (Vec3& vertex : vertices) {
            vertex -= center;
            EXPECT_LE(vertex.norm(), support.radius);
        }
        for (int i = 0; i < 20; ++i) {
            const Vec3 direction = any_direction(random);
            EXPECT_LE(reach_of(vertices, direction),
                      reach_of(points, direction) + static_cast<double>(set.eps) + rounding);
        }
    }
}

TEST(SupportPoints, SpanEachNodeWithinEps) {
    std::mt19937_64 random(3);
    const std::vector<Vec3> offsets{{0, 0, 0}, {1000, -2000, 3000}};
    for (const Vec3& offset : offsets) {
        for (const Mesh& mesh : {make_sphere(5),
                                 make_gridded_box(Vec3(1, 0.5, 0.25), 24),
                                 make_torus(1, 0.3, 80, 40),
                                 make_triangle_soup(random, 3000, 0.1)}) {
            std::vector<Vec3> vertices;
            for (const Vec3& vertex : mesh.vertices()) {
                vertices.emplace_back(vertex + offset);
            }
            ObbTree tree = make_tree(
                make_mesh(std::move(vertices), {mesh.triangles().begin(), mesh.triangles().end()}));
            tree.prepare_planes();
            expect_spanned(tree.view().wide, random);
        }
    }
}

TEST(SupportPoints, AreEqualForAnyNumberOfThreads) {
    const ObbTree tree = make_tree(make_torus(1, 0.3, 120, 60));
    const SupportPoints alone(tree.view().wide);
    ThreadPool pool(3);
    const SupportPoints together(tree.view().wide, &pool);
    EXPECT_TRUE(same_bytes(alone.view().sets, together.view().sets));
    EXPECT_TRUE(same_bytes(alone.view().columns, together.view().columns));
    EXPECT_EQ(alone.view().radius, together.view().radius);
    EXPECT_TRUE(alone.view().sets[0].is_chosen);
}

TEST(NearestOfSimplex, IsNoFartherThanAnyCombination) {
    for (SeededRandom random : seeds(2000)) {
        std::array<Vec3, 4> corners;
        const bool is_flat = random() % 3 == 0;
        for (Vec3& corner : corners) {
            corner = Vec3(uniform(random, -1, 1),
                          uniform(random, -1, 1),
                          is_flat ? 0.25 : uniform(random, -1, 1));
        }
        if (random() % 5 == 0) {
            corners[1] = corners[0];
        }
        const std::size_t count = 1 + random() % 4;
        const NearestOfSimplex nearest = nearest_of_simplex(corners, count);
        double sum = 0;
        Vec3 point = Vec3::Zero();
        for (std::size_t i = 0; i < 4; ++i) {
            EXPECT_GE(nearest.weights[i], 0);
            sum += nearest.weights[i];
            point += nearest.weights[i] * corners[i];
        }
        EXPECT_NEAR(sum, 1, 0x1p-48);
        EXPECT_LE((point - nearest.point).norm(), 1e-15);
        for (int i = 0; i < 200; ++i) {
            std::array<double, 4> weights{};
            double whole = 0;
            for (std::size_t k = 0; k < count; ++k) {
                weights[k] = std::pow(uniform(random, 0, 1), 3);
                whole += weights[k];
            }
            Vec3 other = Vec3::Zero();
            for (std::size_t k = 0; k < count; ++k) {
                other += weights[k] / whole * corners[k];
            }
            EXPECT_LE(nearest.point.norm(), other.norm() + 1e-9);
        }
    }
}

} // namespace

} // namespace cd::tests
