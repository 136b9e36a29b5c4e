// Proves that lines cross closed meshes an even number of times, and enter and leave in turn: also
// where they pass through vertices and edges, and along faces.
#include "common/geometry/mesh.hpp"
#include "common/geometry/topology.hpp"
#include "common/shots/segment_hit.hpp"
#include "tests/support/hard_pairs.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace cd::tests {

namespace {

std::vector<Corners> corners_of(const Mesh& mesh) {
    std::vector<Corners> all;
    for (const Triangle& t : mesh.triangles()) {
        all.push_back({mesh.vertices()[t[0]], mesh.vertices()[t[1]], mesh.vertices()[t[2]]});
    }
    return all;
}

/// Cubes of size 1 that share their faces.
Mesh make_cube_grid(int n) {
    std::vector<Mesh> cubes;
    for (int x = 0; x < n; ++x) {
        for (int y = 0; y < n; ++y) {
            for (int z = 0; z < n; ++z) {
                cubes.push_back(make_box_between(Vec3(x, y, z), Vec3(x + 1, y + 1, z + 1)));
            }
        }
    }
    return join(cubes);
}

/// Rounds the corners to multiples of 2^-10, so that lines through them have short ends.
Mesh on_grid(const Mesh& mesh) {
    const auto nearest = [](double x) { return std::round(1024 * x) / 1024; };
    return mapped(
        mesh, [&](const Vec3& x) { return Vec3(nearest(x.x()), nearest(x.y()), nearest(x.z())); });
}

/// A closed mesh, and the number of solids that may overlap in a point.
struct Solid {
    Mesh mesh;
    int depth_most = 1;
};

std::map<std::string, std::function<Solid()>> solids() {
    return {
        {"box", [] { return Solid{make_box(Vec3(2, 4, 6))}; }},
        {"gridded box", [] { return Solid{make_gridded_box(Vec3(2, 4, 6), 4)}; }},
        {"grid of cubes", [] { return Solid{make_cube_grid(3)}; }},
        {"sphere", [] { return Solid{on_grid(make_sphere(2))}; }},
        {"torus", [] { return Solid{on_grid(make_torus(2, 0.5, 12, 8))}; }},
        {"sphere around a sphere",
         [] {
             return Solid{on_grid(join({make_sphere(1), scaled(make_sphere(1), 0.5)})), 2};
         }},
        {"hollow box",
         [] {
             return Solid{join({make_box(Vec3(6, 6, 6)), reversed(make_box(Vec3(2, 2, 2)))})};
         }},
        {"two boxes with a common face",
         [] {
             return Solid{join({make_box_between(Vec3(0, 0, 0), Vec3(2, 2, 2)),
                                make_box_between(Vec3(2, 0, 0), Vec3(4, 2, 2))})};
         }},
        {"boxes that overlap",
         [] {
             return Solid{join({make_box_between(Vec3(0, 0, 0), Vec3(2, 2, 2)),
                                make_box_between(Vec3(1, 1, 0), Vec3(3, 3, 2))}),
                          2};
         }},
        {"the same box twice",
         [] {
             return Solid{join({make_box(Vec3(2, 2, 2)), make_box(Vec3(2, 2, 2))}), 2};
         }},
    };
}

/// A point of the mesh that lines like to miss: a corner, the middle of an edge or of a face.
Vec3 hard_point(std::mt19937_64& random, const Mesh& mesh) {
    const Triangle& t = mesh.triangles()[random() % mesh.triangles().size()];
    const Vec3& a = mesh.vertices()[t[0]];
    const Vec3& b = mesh.vertices()[t[1]];
    const Vec3& c = mesh.vertices()[t[2]];
    switch (random() % 4) {
    case 0:
        return 0.5 * (a + b);
    case 1:
        return 0.25 * (a + b) + 0.5 * c;
    default:
        return a;
    }
}

/// A line through a hard point with both ends outside of the mesh, which is within 8 of the origin.
/// Its direction is of small whole numbers, or to another point of the mesh.
Segment hard_line(std::mt19937_64& random, const Mesh& mesh) {
    const Vec3 point = hard_point(random, mesh);
    Vec3 step =
        random() % 3 == 0 ? Vec3(8 * (hard_point(random, mesh) - point)) : lattice_point(random, 2);
    if (step.cwiseAbs().maxCoeff() < 0.125) {
        step = Vec3(0, 1, 0);
    }
    const double reach = step.cwiseAbs().maxCoeff() < 1 ? 256 : 32;
    return {point - reach * step, point + reach * step};
}

/// Expects entries and exits in turn: the number of solids around a point between two places of the
/// line is never negative, and 0 at the end.
void expect_closed(std::span<const LineHit> hits, int depth_most) {
    int depth = 0;
    std::size_t crossings = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if ((hits[i].flags & hit_flag::crosses) != 0) {
            ++crossings;
            depth += (hits[i].flags & hit_flag::front) != 0 ? 1 : -1;
        }
        const bool is_last = i + 1 == hits.size();
        const bool ends =
            is_last || hits[i + 1].depth != hits[i].depth || hits[i + 1].rank != hits[i].rank;
        ASSERT_TRUE(!ends || (depth >= 0 && depth <= depth_most)) << i;
    }
    ASSERT_EQ(depth, 0);
    ASSERT_EQ(crossings % 2, 0u);
}

Pose turned(std::mt19937_64& random) {
    return random() % 2 == 0 ? Pose() : make_pose(random, 5);
}

} // namespace

class ClosedMeshTest : public testing::TestWithParam<std::string> {};

TEST_P(ClosedMeshTest, LinesEnterAndLeaveInTurn) {
    const Solid solid = solids().at(GetParam())();
    const std::vector<Corners> triangles = corners_of(solid.mesh);
    int borders = 0;
    for (SeededRandom random : seeds(raised(100))) {
        const Segment line = hard_line(random, solid.mesh);
        const Pose pose = turned(random);
        SegmentHit engine({pose, pose});
        const std::span<const LineHit> hits = engine.hits(triangles, line);
        expect_closed(hits, solid.depth_most);
        if (HasFatalFailure()) {
            return;
        }
        borders += std::any_of(hits.begin(), hits.end(), [](const LineHit& hit) {
            return (hit.flags & (hit_flag::edge | hit_flag::corner)) != 0;
        });
    }
    EXPECT_GT(borders, 50);
}

TEST_P(ClosedMeshTest, ChainedSegmentsCrossAsTheWholeLineDoes) {
    const Solid solid = solids().at(GetParam())();
    const std::vector<Corners> triangles = corners_of(solid.mesh);
    for (SeededRandom random : seeds(raised(20))) {
        const Segment line = hard_line(random, solid.mesh);
        const Vec3 middle = 0.5 * (line.p + line.q); // The hard point, on a plane of the mesh.
        SegmentHit engine({});
        int sum = 0;
        for (const Segment& part : {Segment{line.p, middle}, Segment{middle, line.q}}) {
            for (const LineHit& hit : engine.hits(triangles, part)) {
                sum += (hit.flags & hit_flag::crosses) != 0 ? 1 : 0;
            }
        }
        int whole = 0;
        for (const LineHit& hit : engine.hits(triangles, line)) {
            whole += (hit.flags & hit_flag::crosses) != 0 ? 1 : 0;
        }
        ASSERT_EQ(sum, whole);
    }
}

INSTANTIATE_TEST_SUITE_P(,
                         ClosedMeshTest,
                         testing::ValuesIn([] {
                             std::vector<std::string> names;
                             for (const auto& [name, make] : solids()) {
                                 names.push_back(name);
                             }
                             return names;
                         }()),
                         [](const auto& of) {
                             std::string name = of.param;
                             std::replace(name.begin(), name.end(), ' ', '_');
                             return name;
                         });

} // namespace cd::tests
