// libccd's GJK on triangles. Its MPR is left out: it does not terminate on some touching triangles.
#include "bench/peers/engines/peers.hpp"

#include <ccd/ccd.h>
#include <ccd/vec3.h>

namespace cd::bench {

namespace {

void furthest(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* found) {
    const Corners& t = *static_cast<const Corners*>(object);
    const Vec3 along(direction->v[0], direction->v[1], direction->v[2]);
    std::size_t best = 0;
    for (std::size_t i = 1; i < 3; ++i) {
        if (t[i].dot(along) > t[best].dot(along)) {
            best = i;
        }
    }
    ccdVec3Set(found, t[best].x(), t[best].y(), t[best].z());
}

struct CcdPairTest {
    ccd_t settings;

    CcdPairTest() {
        CCD_INIT(&settings);
        settings.support1 = furthest;
        settings.support2 = furthest;
        // FCL uses this limit; the default has no limit.
        settings.max_iterations = 500;
    }

    [[nodiscard]] bool touches(const Corners& a, const Corners& b) const {
        return ccdGJKIntersect(&a, &b, &settings) != 0;
    }
};

} // namespace

void add_ccd(std::vector<Engine>& engines) {
    Engine engine;
    engine.name = "libccd GJK";
    engine.make_pairs = [] { return std::make_unique<WorldPairEngine<CcdPairTest>>(); };
    engines.push_back(engine);
}

} // namespace cd::bench
