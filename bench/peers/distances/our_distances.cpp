#include "bench/peers/distances/distance_engine.hpp"
#include "bench/peers/ours.hpp"
#include "common/distance/triangle_distance.hpp"
#include "common/search/contact_search.hpp"
#include "common/search/nearest_found.hpp"

#include <limits>
#include <memory>

namespace cd::bench {

namespace {

/// The search that jobs run: whether the bodies touch, then the nearest pair of those that do not.
class OurDistanceMeshes final : public DistanceMeshes {
  public:
    void load(const std::shared_ptr<const Mesh>& a, const std::shared_ptr<const Mesh>& b) override {
        search_.reset();
        a_ = build_ours(a, 1);
        b_ = build_ours(b, 1);
    }

    MeshDistance distance(const PosePair& poses) override {
        const TreeView a = a_->view();
        const TreeView b = b_->view();
        if (search_) {
            search_->restart(poses);
        } else {
            search_ = make_search(
                a, b, poses, {}, {.nearest_up_to = std::numeric_limits<double>::infinity()});
        }
        if (search_->any(a, b)) {
            return {};
        }
        search_->find_nearest(a, b);
        const NearestPair& nearest = *search_->nearest().best();
        return {nearest.distance, nearest.a, nearest.b};
    }

  private:
    std::shared_ptr<const ObbTree> a_;
    std::shared_ptr<const ObbTree> b_;
    std::unique_ptr<ContactSearch> search_; ///< Reused from pose to pose, as jobs do.
};

} // namespace

DistanceEngine our_distances() {
    return {"cdcluster",
            true,
            [] { return std::make_unique<OurDistanceMeshes>(); },
            [](const Corners& a, const Corners& b, const PosePair& poses) {
                return TriangleDistance(poses).rounded(a, b);
            }};
}

} // namespace cd::bench
