// CGAL's exact predicates on triangles transformed to the world in doubles: exact, but for the
// rounded triangles.
#include "bench/peers/engines/peers.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Intersections_3/Triangle_3_Triangle_3.h>

namespace cd::bench {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

struct CgalPairTest {
    static Kernel::Triangle_3 triangle(const Corners& t) {
        const auto p = [](const Vec3& v) { return Kernel::Point_3(v.x(), v.y(), v.z()); };
        return {p(t[0]), p(t[1]), p(t[2])};
    }

    static bool touches(const Corners& a, const Corners& b) {
        return CGAL::do_intersect(triangle(a), triangle(b));
    }
};

} // namespace

void add_cgal(std::vector<Engine>& engines) {
    Engine engine;
    engine.name = "CGAL EPICK, rounded pose";
    engine.make_pairs = [] { return std::make_unique<WorldPairEngine<CgalPairTest>>(); };
    engines.push_back(engine);
}

} // namespace cd::bench
