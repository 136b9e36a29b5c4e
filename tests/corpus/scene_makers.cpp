#include "common/core/check.hpp"
#include "tests/corpus/pair_makers.hpp"
#include "tests/corpus/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace cd::tests {

namespace {

struct Box {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 high = Vec3::Constant(-std::numeric_limits<double>::infinity());
};

/// Returns a triangle's box in the world, computed in one fixed order and grown by more than the
/// rounding.
Box box_of(const Corners& corners, const Pose& pose) {
    const Mat3 r = pose.rotation();
    Box box;
    for (const Vec3& corner : corners) {
        for (int k = 0; k < 3; ++k) {
            const double turned = (r(k, 0) * corner[0] + r(k, 1) * corner[1]) + r(k, 2) * corner[2];
            const double x = turned + pose.translation()[k];
            const double slack = 1e-8 * std::abs(x) + 1e-12;
            box.low[k] = std::min(box.low[k], x - slack);
            box.high[k] = std::max(box.high[k], x + slack);
        }
    }
    return box;
}

bool overlap(const Box& a, const Box& b) {
    for (int k = 0; k < 3; ++k) {
        if (a.low[k] > b.high[k] || b.low[k] > a.high[k]) {
            return false;
        }
    }
    return true;
}

std::vector<Box> boxes_of(const Mesh& mesh, const Pose& pose) {
    std::vector<Box> boxes;
    for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
        boxes.push_back(box_of(mesh.corners(i), pose));
    }
    return boxes;
}

/// Neighbouring triangle pairs of a category's scenes, listed on first use.
class ScenePairs {
  public:
    explicit ScenePairs(std::string category) : category_(std::move(category)) {}

    [[nodiscard]] PosedPair draw(std::mt19937_64& random) {
        std::call_once(listed_, [&] { list(); });
        const Place& place = places_[random() % places_.size()];
        const Scene& scene = *place.scene;
        return shuffled(
            random, {scene.a.mesh->corners(place.a), scene.b.mesh->corners(place.b), scene.poses});
    }

  private:
    struct Place {
        const Scene* scene;
        std::uint32_t a;
        std::uint32_t b;
    };

    void list() {
        for (const Scene& scene : corpus_scenes()) {
            if (scene.category == category_) {
                add(scene);
            }
        }
        CD_CHECK(!places_.empty());
    }

    void add(const Scene& scene) {
        const std::vector<Box> a = boxes_of(*scene.a.mesh, scene.poses.a);
        const std::vector<Box> b = boxes_of(*scene.b.mesh, scene.poses.b);
        for (std::uint32_t i = 0; i < a.size(); ++i) {
            for (std::uint32_t j = 0; j < b.size(); ++j) {
                if (overlap(a[i], b[j])) {
                    places_.push_back({&scene, i, j});
                }
            }
        }
    }

    std::string category_;
    std::once_flag listed_;
    std::vector<Place> places_;
};

} // namespace

void add_scene_makers(PairMakers& makers) {
    for (const char* category : {"stacked boxes",
                                 "boxes that cross along their grid lines",
                                 "nested boxes",
                                 "turned boxes",
                                 "spheres",
                                 "tori",
                                 "gears",
                                 "terrain",
                                 "thin walls",
                                 "UTM buildings"}) {
        makers[std::string("of scenes: ") + category] =
            [pairs = std::make_shared<ScenePairs>(category)](std::mt19937_64& random) {
                return pairs->draw(random);
            };
    }
}

} // namespace cd::tests
