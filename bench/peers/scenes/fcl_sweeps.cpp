// FCL's managers. FCL boxes a turned body by the cube around its sphere, so more pairs are left.
#include "bench/peers/engines/fcl_engine.hpp"
#include "bench/peers/scenes/sweep_engine.hpp"

#include <fcl/broadphase/broadphase_SaP.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/box.h>

namespace cd::bench {

namespace {

template <class Manager>
class FclSweep final : public BroadPhase {
  public:
    void load(const CrowdScene& scene) override {
        manager_ = std::make_unique<Manager>();
        objects_.clear();
        std::vector<fcl::CollisionObject<double>*> registered;
        for (std::size_t i = 0; i < scene.boxes.size(); ++i) {
            const Vec3 size = scene.boxes[i].box.size();
            objects_.push_back(std::make_unique<fcl::CollisionObject<double>>(
                std::make_shared<fcl::Box<double>>(size),
                fcl_transform<double>(scene.steps.front()[i])));
            objects_.back()->setUserData(reinterpret_cast<void*>(i)); // NOLINT
            registered.push_back(objects_.back().get());
        }
        manager_->registerObjects(registered);
        manager_->setup();
    }

    const std::vector<BodyPair>& step(const std::vector<Pose>& poses) override {
        for (std::size_t i = 0; i < objects_.size(); ++i) {
            objects_[i]->setTransform(fcl_transform<double>(poses[i]));
            objects_[i]->computeAABB();
        }
        manager_->update();
        pairs_.clear();
        manager_->collide(&pairs_, keep);
        return pairs_;
    }

  private:
    static std::size_t index_of(const fcl::CollisionObject<double>& object) {
        return reinterpret_cast<std::size_t>(object.getUserData()); // NOLINT
    }

    /// Never ends the search.
    static bool
    keep(fcl::CollisionObject<double>* a, fcl::CollisionObject<double>* b, void* pairs) {
        static_cast<std::vector<BodyPair>*>(pairs)->push_back(pair_of(index_of(*a), index_of(*b)));
        return false;
    }

    std::vector<std::unique_ptr<fcl::CollisionObject<double>>> objects_;
    std::unique_ptr<Manager> manager_;
    std::vector<BodyPair> pairs_;
};

} // namespace

void add_fcl_sweeps(std::vector<SweepEngine>& engines) {
    using Tree = fcl::DynamicAABBTreeCollisionManager<double>;
    using Sap = fcl::SaPCollisionManager<double>;
    engines.push_back(
        {"FCL dynamic AABB tree", false, [] { return std::make_unique<FclSweep<Tree>>(); }});
    engines.push_back({"FCL SaP", false, [] { return std::make_unique<FclSweep<Sap>>(); }});
}

} // namespace cd::bench
