// Bullet's sweep of one convex body against another, in floats. Bodies with dents are replaced by
// their hulls, so impacts come early where a dent comes first.
#include "bench/peers/engines/bullet_values.hpp"
#include "bench/peers/motions/motion_engine.hpp"

#include <LinearMath/btConvexHullComputer.h>
#include <btBulletCollisionCommon.h>

namespace cd::bench {

namespace {

std::unique_ptr<btConvexHullShape> hull_of(const Mesh& mesh) {
    std::vector<btVector3> points;
    for (const Vec3& vertex : mesh.vertices()) {
        points.push_back(bullet_vector(vertex));
    }
    btConvexHullComputer computer;
    computer.compute(
        &points[0].x(), static_cast<int>(sizeof(btVector3)), static_cast<int>(points.size()), 0, 0);
    auto hull = std::make_unique<btConvexHullShape>();
    for (int i = 0; i < computer.vertices.size(); ++i) {
        hull->addPoint(computer.vertices[i], false);
    }
    hull->recalcLocalAabb();
    hull->setMargin(0);
    return hull;
}

class BulletMotionBodies final : public MotionBodies {
  public:
    BulletMotionBodies()
        : dispatcher_(&configuration_), world_(&dispatcher_, &broadphase_, &configuration_) {}
    ~BulletMotionBodies() override { world_.removeCollisionObject(&object_); }

    void load(const MotionScene& scene) override {
        a_ = hull_of(*scene.a);
        b_ = hull_of(*scene.b);
        object_.setCollisionShape(a_.get());
        world_.addCollisionObject(&object_);
    }

    /// Bullet sweeps one body, so B moves in A's frame: no path turns A.
    Impact find(const KeyedPath& path) override {
        const btTransform from =
            bullet_transform(path.from.a).inverseTimes(bullet_transform(path.from.b));
        const btTransform to =
            bullet_transform(path.to.a).inverseTimes(bullet_transform(path.to.b));
        btCollisionWorld::ClosestConvexResultCallback closest(from.getOrigin(), to.getOrigin());
        world_.convexSweepTest(b_.get(), from, to, closest);
        const double time = closest.m_closestHitFraction;
        return {closest.hasHit() ? Impact::Kind::Found : Impact::Kind::None, time, time};
    }

  private:
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_;
    btDbvtBroadphase broadphase_;
    btCollisionWorld world_;
    btCollisionObject object_;
    std::unique_ptr<btConvexHullShape> a_;
    std::unique_ptr<btConvexHullShape> b_;
};

} // namespace

void add_bullet_motions(std::vector<MotionEngine>& engines) {
    engines.push_back({"Bullet convex sweep, hulls", false, [] {
                           return std::make_unique<BulletMotionBodies>();
                       }});
}

} // namespace cd::bench
