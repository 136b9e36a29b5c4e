// Proves that a mesh's topology is counted as defined: closed, open, doubled, degenerate, and
// joined by coordinates rather than by index.
#include "common/geometry/topology.hpp"

#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace cd::tests {

namespace {

Mesh without_triangle(const Mesh& mesh, std::size_t triangle) {
    std::vector<Triangle> triangles = mesh.triangles();
    triangles.erase(triangles.begin() + static_cast<std::ptrdiff_t>(triangle));
    return make_mesh(mesh.vertices(), std::move(triangles));
}

Mesh with_triangle(const Mesh& mesh, const Triangle& triangle) {
    std::vector<Triangle> triangles = mesh.triangles();
    triangles.push_back(triangle);
    return make_mesh(mesh.vertices(), std::move(triangles));
}

/// Counts with maps: slow and obvious.
Topology naive_topology(const Mesh& mesh) {
    using Place = std::array<double, 3>;
    std::map<Place, std::uint32_t> places;
    std::map<std::array<Place, 3>, std::uint64_t> triangles;
    std::map<std::pair<Place, Place>, std::vector<bool>> edges; // For each use, whether it ascends.
    Topology topology;
    for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
        std::array<Place, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 v = mesh.corners(i)[k];
            corners[k] = {v.x() + 0.0, v.y() + 0.0, v.z() + 0.0};
        }
        std::array<Place, 3> sorted = corners;
        std::sort(sorted.begin(), sorted.end());
        topology.duplicate += triangles[sorted]++ > 0 ? 1u : 0u;
        if (sorted[0] == sorted[1] || sorted[1] == sorted[2]) {
            continue;
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const Place& from = corners[k];
            const Place& to = corners[(k + 1) % 3];
            edges[std::minmax(from, to)].push_back(from < to);
        }
    }
    for (const auto& [edge, uses] : edges) {
        topology.boundary_edges += uses.size() == 1 ? 1u : 0u;
        topology.non_manifold_edges += uses.size() > 2 ? 1u : 0u;
        topology.inconsistent_edges += uses.size() == 2 && uses[0] == uses[1] ? 1u : 0u;
    }
    return topology;
}

/// Expects equal counts of both; a mesh's order of triangles does not change them.
void expect_same_counts(const Topology& a, const Topology& b) {
    EXPECT_EQ(a.duplicate, b.duplicate);
    EXPECT_EQ(a.boundary_edges, b.boundary_edges);
    EXPECT_EQ(a.non_manifold_edges, b.non_manifold_edges);
    EXPECT_EQ(a.inconsistent_edges, b.inconsistent_edges);
}

} // namespace

TEST(Topology, CountsWhatMapsCount) {
    std::mt19937_64 random(5);
    for (int round = 0; round < 60; ++round) {
        SCOPED_TRACE(testing::Message() << "round " << round);
        // Few to many positions, corners shared by many triangles, and minus zero.
        std::vector<Vec3> vertices = make_degenerate_soup(random, 5 + 10 * round).vertices();
        std::vector<Triangle> triangles;
        for (int i = 0; i < 400; ++i) {
            const auto any = [&] { return static_cast<std::uint32_t>(random() % vertices.size()); };
            triangles.push_back({i % 2 == 0 ? 0 : any(), any(), any()});
        }
        for (std::size_t i = 0; i < vertices.size(); i += 3) {
            vertices[i] = vertices[i].cwiseProduct(Vec3(1, -0.0, 1));
        }
        const Mesh mesh = make_mesh(vertices, triangles);
        expect_same_counts(analyse_topology(mesh), naive_topology(mesh));
    }
}

TEST(Topology, SolidsAreClosedAndInOnePiece) {
    for (const Mesh& mesh : {make_sphere(2),
                             make_box({1, 2, 3}),
                             make_gridded_box({1, 1, 1}, 3),
                             make_torus(2, 0.5, 12, 8)}) {
        const Topology topology = analyse_topology(mesh);
        EXPECT_TRUE(topology.is_closed());
        EXPECT_EQ(topology.component_triangles, std::vector<std::uint32_t>{0});
        EXPECT_EQ(topology.degenerate, 0u);
        EXPECT_EQ(topology.duplicate, 0u);
    }
}

TEST(Topology, EqualCoordinatesAreOneVertex) {
    const Topology topology = analyse_topology(unshared(make_sphere(2)));
    EXPECT_TRUE(topology.is_closed());
    EXPECT_EQ(topology.component_triangles.size(), 1u);
}

TEST(Topology, AMissingTriangleLeavesThreeBoundaryEdges) {
    const Topology topology = analyse_topology(without_triangle(make_box({1, 1, 1}), 5));
    EXPECT_EQ(topology.boundary_edges, 3u);
    EXPECT_EQ(topology.non_manifold_edges, 0u);
    EXPECT_FALSE(topology.is_closed());
}

TEST(Topology, ADuplicateIsCountedWhateverItsFirstCornerAndSense) {
    const Mesh box = make_box({1, 1, 1});
    const Triangle& t = box.triangles()[0];
    for (const Triangle& again : {t, Triangle{t[1], t[2], t[0]}, Triangle{t[1], t[0], t[2]}}) {
        const Topology topology = analyse_topology(with_triangle(box, again));
        EXPECT_EQ(topology.duplicate, 1u);
        EXPECT_EQ(topology.non_manifold_edges, 3u);
        EXPECT_FALSE(topology.is_closed());
    }
}

TEST(Topology, AFlippedTriangleIsInconsistentOnItsEdges) {
    const Mesh box = make_box({1, 1, 1});
    const Triangle t = box.triangles()[3];
    const Mesh flipped = with_triangle(without_triangle(box, 3), {t[0], t[2], t[1]});
    const Topology topology = analyse_topology(flipped);
    EXPECT_EQ(topology.inconsistent_edges, 3u);
    EXPECT_EQ(topology.boundary_edges, 0u);
    EXPECT_FALSE(topology.is_closed());
}

TEST(Topology, DegenerateTrianglesAreCountedAndThoseOfTwoCornersBoundNothing) {
    const Mesh box = make_box({2, 2, 2});
    std::vector<Vec3> vertices = box.vertices();
    std::vector<Triangle> triangles = box.triangles();
    const auto first = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), {{5, 0, 0}, {6, 0, 0}, {7, 0, 0}, {9, 9, 9}});
    triangles.push_back({first, first + 1, first + 2});     // Three collinear corners.
    triangles.push_back({first + 3, first + 3, first + 3}); // A point.
    triangles.push_back({0, 1, 1});                         // An edge of the box.
    const Topology topology = analyse_topology(make_mesh(vertices, triangles));

    EXPECT_EQ(topology.degenerate, 3u);
    EXPECT_EQ(topology.boundary_edges, 3u); // Those of the flat triangle.
    EXPECT_EQ(topology.component_triangles, (std::vector<std::uint32_t>{0, 12, 13}));
}

TEST(Topology, AFlatTriangleMayCloseASeam) {
    // A tetrahedron with a midpoint on one edge, on one side only; a triangle without area fills
    // the gap.
    const std::vector<Vec3> vertices{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 0, 0}};
    std::vector<Triangle> triangles{{0, 2, 4}, {4, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    EXPECT_EQ(analyse_topology(make_mesh(vertices, triangles)).boundary_edges, 3u);
    triangles.push_back({0, 4, 1});
    const Topology topology = analyse_topology(make_mesh(vertices, triangles));
    EXPECT_EQ(topology.degenerate, 1u);
    EXPECT_TRUE(topology.is_closed());
}

TEST(Topology, ComponentsAreNamedByTheirFirstTriangles) {
    const Mesh near = make_box({1, 1, 1});
    const Mesh far = translated(near, {10, 0, 0});
    const Topology topology = analyse_topology(join({near, far, translated(near, {20, 0, 0})}));
    EXPECT_EQ(topology.component_triangles, (std::vector<std::uint32_t>{0, 12, 24}));
    EXPECT_TRUE(topology.is_closed());
}

TEST(Topology, BodiesThatShareOneVertexAreOneComponent) {
    const Mesh box = make_box({1, 1, 1});
    const Topology topology = analyse_topology(join({box, translated(box, {1, 1, 1})}));
    EXPECT_EQ(topology.component_triangles.size(), 1u);
    EXPECT_TRUE(topology.is_closed());
}

TEST(Topology, DoesNotDependOnTheOrderOfTriangles) {
    std::mt19937_64 random(4);
    for (int round = 0; round < 20; ++round) {
        const Mesh mesh = make_degenerate_soup(random, 200);
        std::vector<Triangle> reversed(mesh.triangles().rbegin(), mesh.triangles().rend());
        const Topology one = analyse_topology(mesh);
        const Topology other = analyse_topology(make_mesh(mesh.vertices(), std::move(reversed)));
        EXPECT_EQ(one.degenerate, other.degenerate);
        expect_same_counts(one, other);
        EXPECT_EQ(one.component_triangles.size(), other.component_triangles.size());
    }
}

} // namespace cd::tests
