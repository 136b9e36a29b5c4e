#include "bench/peers/distances/distance_engine.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/distance/triangle_distance.hpp"
#include "common/search/contact_search.hpp"
#include "common/search/nearest_found.hpp"
#include "common/tree/build/build.hpp"

#include <limits>
#include <optional>
#include <utility>

namespace cd::bench {

namespace {

ObbTree tree_of(const std::shared_ptr<const Mesh>& mesh) {
    ThreadPool pool(1);
    ObbTree tree = build_tree(mesh, {}, pool);
    tree.prepare_planes(&pool);
    return tree;
}

/// The search that jobs run: whether the bodies touch, then the nearest pair of those that do not.
class OurDistanceMeshes final : public DistanceMeshes {
  public:
    void load(const std::shared_ptr<const Mesh>& a, const std::shared_ptr<const Mesh>& b) override {
        search_.reset();
        a_.emplace(tree_of(a));
        b_.emplace(tree_of(b));
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
    std::optional<ObbTree> a_;
    std::optional<ObbTree> b_;
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
