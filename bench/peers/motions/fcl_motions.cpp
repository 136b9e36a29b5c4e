#include "bench/peers/engines/fcl_engine.hpp"
#include "bench/peers/motions/motion_engine.hpp"

#include <fcl/narrowphase/continuous_collision.h>

namespace cd::bench {

namespace {

constexpr std::size_t samples = 1000; // Of the naive solver; 3 mm apart on a path of 3 m.

/// FCL's conservative advancement of meshes takes neither the number of iterations nor the error
/// from the request. It adds the signed bounds of both bodies (fcl #555). Of two boxes of which one
/// moves, it finds the impact if that is the first, and misses it otherwise. So B, which moves on
/// all paths, comes first.
template <class Box>
class FclMotionBodies final : public MotionBodies {
  public:
    explicit FclMotionBodies(fcl::CCDSolverType solver)
        : request_(samples, 1.0 / samples, fcl::CCDM_LINEAR, fcl::GST_LIBCCD, solver) {}

    void load(const MotionScene& scene) override {
        a_ = fcl_model<Box>(*scene.a);
        b_ = fcl_model<Box>(*scene.b);
    }

    Impact find(const KeyedPath& path) override {
        fcl::ContinuousCollisionResult<double> result;
        fcl::continuousCollide(b_.get(),
                               fcl_transform<double>(path.from.b),
                               fcl_transform<double>(path.to.b),
                               a_.get(),
                               fcl_transform<double>(path.from.a),
                               fcl_transform<double>(path.to.a),
                               request_,
                               result);
        return {result.is_collide ? Impact::Kind::Found : Impact::Kind::None,
                result.time_of_contact,
                result.time_of_contact};
    }

  private:
    fcl::ContinuousCollisionRequest<double> request_;
    std::shared_ptr<fcl::BVHModel<Box>> a_;
    std::shared_ptr<fcl::BVHModel<Box>> b_;
};

template <class Box>
MotionEngine engine_of(const char* name, fcl::CCDSolverType solver) {
    return {name, false, [solver] { return std::make_unique<FclMotionBodies<Box>>(solver); }};
}

} // namespace

void add_fcl_motions(std::vector<MotionEngine>& engines) {
    engines.push_back(engine_of<fcl::RSS<double>>("FCL conservative advancement, RSS",
                                                  fcl::CCDC_CONSERVATIVE_ADVANCEMENT));
    engines.push_back(engine_of<fcl::OBBRSS<double>>("FCL conservative advancement, OBBRSS",
                                                     fcl::CCDC_CONSERVATIVE_ADVANCEMENT));
    engines.push_back(
        engine_of<fcl::OBBRSS<double>>("FCL naive, 1,000 samples, OBBRSS", fcl::CCDC_NAIVE));
}

} // namespace cd::bench
