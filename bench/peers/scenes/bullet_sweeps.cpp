#include "bench/peers/engines/bullet_values.hpp"
#include "bench/peers/scenes/sweep_engine.hpp"

#include <btBulletCollisionCommon.h>

namespace cd::bench {

namespace {

/// The dynamic trees of boxes, with the pairs that they keep from step to step.
class BulletSweep final : public BroadPhase {
  public:
    BulletSweep() : dispatcher_(&configuration_) {}
    ~BulletSweep() override { clear(); }

    void load(const CrowdScene& scene) override {
        clear();
        for (std::size_t i = 0; i < scene.boxes.size(); ++i) {
            const Vec3 half = 0.5 * scene.boxes[i].box.size();
            shapes_.push_back(std::make_unique<btBoxShape>(bullet_vector(half)));
            const auto [low, high] = box_of(i, scene.steps.front()[i]);
            proxies_.push_back(broadphase_.createProxy(low,
                                                       high,
                                                       BOX_SHAPE_PROXYTYPE,
                                                       reinterpret_cast<void*>(i), // NOLINT
                                                       btBroadphaseProxy::DefaultFilter,
                                                       btBroadphaseProxy::AllFilter,
                                                       &dispatcher_));
        }
    }

    const std::vector<BodyPair>& step(const std::vector<Pose>& poses) override {
        for (std::size_t i = 0; i < proxies_.size(); ++i) {
            const auto [low, high] = box_of(i, poses[i]);
            broadphase_.setAabb(proxies_[i], low, high, &dispatcher_);
        }
        broadphase_.calculateOverlappingPairs(&dispatcher_);
        pairs_.clear();
        const btBroadphasePairArray& found =
            broadphase_.getOverlappingPairCache()->getOverlappingPairArray();
        for (int i = 0; i < found.size(); ++i) {
            pairs_.push_back(pair_of(index_of(*found[i].m_pProxy0), index_of(*found[i].m_pProxy1)));
        }
        return pairs_;
    }

  private:
    struct Bounds {
        btVector3 low;
        btVector3 high;
    };

    [[nodiscard]] Bounds box_of(std::size_t body, const Pose& pose) const {
        Bounds bounds;
        shapes_[body]->getAabb(bullet_transform(pose), bounds.low, bounds.high);
        return bounds;
    }

    static std::size_t index_of(const btBroadphaseProxy& proxy) {
        return reinterpret_cast<std::size_t>(proxy.m_clientObject); // NOLINT
    }

    void clear() {
        for (btBroadphaseProxy* const proxy : proxies_) {
            broadphase_.destroyProxy(proxy, &dispatcher_);
        }
        proxies_.clear();
        shapes_.clear();
    }

    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_;
    btDbvtBroadphase broadphase_;
    std::vector<std::unique_ptr<btBoxShape>> shapes_;
    std::vector<btBroadphaseProxy*> proxies_;
    std::vector<BodyPair> pairs_;
};

} // namespace

void add_bullet_sweeps(std::vector<SweepEngine>& engines) {
    engines.push_back(
        {"Bullet btDbvtBroadphase", false, [] { return std::make_unique<BulletSweep>(); }});
}

} // namespace cd::bench
