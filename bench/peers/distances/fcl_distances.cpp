#include "bench/peers/distances/distance_engine.hpp"
#include "bench/peers/engines/fcl_engine.hpp"

#include <fcl/narrowphase/detail/primitive_shape_algorithm/triangle_distance.h>
#include <fcl/narrowphase/distance.h>

namespace cd::bench {

namespace {

template <class Box>
class FclDistanceMeshes final : public DistanceMeshes {
  public:
    void load(const std::shared_ptr<const Mesh>& a, const std::shared_ptr<const Mesh>& b) override {
        a_ = fcl_model<Box>(*a);
        b_ = fcl_model<Box>(*b);
    }

    MeshDistance distance(const PosePair& poses) override {
        const fcl::DistanceRequest<double> request;
        fcl::DistanceResult<double> result;
        const double distance = fcl::distance(a_.get(),
                                              fcl_transform<double>(poses.a),
                                              b_.get(),
                                              fcl_transform<double>(poses.b),
                                              request,
                                              result);
        return {
            distance, static_cast<std::uint32_t>(result.b1), static_cast<std::uint32_t>(result.b2)};
    }

  private:
    std::shared_ptr<fcl::BVHModel<Box>> a_;
    std::shared_ptr<fcl::BVHModel<Box>> b_;
};

double distance_of_pair(const Corners& a, const Corners& b, const PosePair& poses) {
    const Corners of_a = WorldFrame(poses.a)(a);
    const Corners of_b = WorldFrame(poses.b)(b);
    fcl::Vector3d p;
    fcl::Vector3d q;
    return fcl::detail::TriangleDistance<double>::triDistance(of_a.data(), of_b.data(), p, q);
}

template <class Box>
std::unique_ptr<DistanceMeshes> make_meshes() {
    return std::make_unique<FclDistanceMeshes<Box>>();
}

} // namespace

void add_fcl_distances(std::vector<DistanceEngine>& engines) {
    engines.push_back({"FCL RSS double", false, &make_meshes<fcl::RSS<double>>, &distance_of_pair});
    engines.push_back({"FCL OBBRSS double", false, &make_meshes<fcl::OBBRSS<double>>, {}});
}

} // namespace cd::bench
