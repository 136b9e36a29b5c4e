// Proves that lines cross each closed mesh of the corpus an even number of times, through its
// vertices and the middles of its edges.
#include "common/shots/segment_hit.hpp"
#include "tests/corpus/scenes.hpp"
#include "tests/support/hard_pairs.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <set>
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

/// Returns a power of two that is at least thrice the size of the mesh.
double reach_of(const Mesh& mesh) {
    Vec3 low = mesh.vertices()[0];
    Vec3 high = low;
    for (const Vec3& vertex : mesh.vertices()) {
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
    }
    int exponent = 0;
    std::frexp((high - low).maxCoeff(), &exponent);
    return std::ldexp(1.0, exponent + 2);
}

/// A line with both ends outside of the mesh, in a direction of small whole numbers.
Segment line_through(std::mt19937_64& random, const Mesh& mesh, double reach) {
    const Triangle& t = mesh.triangles()[random() % mesh.triangles().size()];
    const Vec3& corner = mesh.vertices()[t[0]];
    const Vec3 point =
        random() % 2 == 0 ? corner : Vec3(corner + 0.5 * (mesh.vertices()[t[1]] - corner));
    Vec3 step = lattice_point(random, 3);
    if (step == Vec3::Zero()) {
        step.z() = 1;
    }
    return {point - reach * step, point + reach * step};
}

void expect_even(const Mesh& mesh, std::uint64_t lines, std::uint64_t& crossings) {
    const std::vector<Corners> triangles = corners_of(mesh);
    const double reach = reach_of(mesh);
    SegmentHit engine({});
    for (SeededRandom random : seeds(lines)) {
        std::size_t crossed = 0;
        for (const LineHit& hit : engine.hits(triangles, line_through(random, mesh, reach))) {
            crossed += (hit.flags & hit_flag::crosses) != 0 ? 1u : 0u;
        }
        ASSERT_EQ(crossed % 2, 0u);
        crossings += crossed;
    }
}

} // namespace

TEST(LineParity, IsEvenOnEachClosedMesh) {
    std::set<const Mesh*> seen;
    std::uint64_t crossings = 0;
    for (const Scene& scene : corpus_scenes()) {
        SCOPED_TRACE(scene.name);
        for (const Body& body : {scene.a, scene.b}) {
            if (body.closed && seen.insert(body.mesh.get()).second) {
                expect_even(*body.mesh, raised(100), crossings);
            }
        }
    }
    EXPECT_GT(seen.size(), 20u);
    EXPECT_GT(crossings, 1000u);
}

} // namespace cd::tests
