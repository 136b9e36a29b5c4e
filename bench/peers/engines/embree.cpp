// Embree's collision of two scenes of boxes. It cannot transform scenes, so each pose needs new
// boxes of B and a refit of its tree (measured several times as fast as any rebuild, search
// included). It has no triangle test, so it uses our exact one: the comparison is of the search.
#include "bench/peers/engines/embree_handles.hpp"
#include "bench/peers/engines/peers.hpp"
#include "common/core/check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

namespace cd::bench {

namespace {

struct FloatBox {
    std::array<float, 3> min;
    std::array<float, 3> max;
};

/// Returns the box of three points, widened by the error of rounding to floats and by `slack`.
FloatBox box_around(const Vec3& p, const Vec3& q, const Vec3& r, double slack) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const Vec3 min = p.cwiseMin(q).cwiseMin(r);
    const Vec3 max = p.cwiseMax(q).cwiseMax(r);
    FloatBox box{};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        box.min[i] = std::nextafter(static_cast<float>(min[k] - slack), -infinity);
        box.max[i] = std::nextafter(static_cast<float>(max[k] + slack), infinity);
    }
    return box;
}

/// The boxes of a mesh's triangles as a scene of one geometry.
class BoxScene {
  public:
    BoxScene(RTCDevice device, std::size_t triangles, bool is_refitted)
        : boxes_(triangles),
          scene_(rtcNewScene(device)),
          geometry_(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER)) {
        if (is_refitted) {
            // Only scenes of this quality respect the geometry's quality.
            rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_LOW);
            rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_DYNAMIC);
            rtcSetGeometryBuildQuality(geometry_.get(), RTC_BUILD_QUALITY_REFIT);
        } else {
            rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_HIGH);
        }
        rtcSetGeometryUserPrimitiveCount(geometry_.get(), static_cast<unsigned>(triangles));
        rtcSetGeometryUserData(geometry_.get(), this);
        rtcSetGeometryBoundsFunction(geometry_.get(), tell_bounds, nullptr);
        rtcAttachGeometry(scene_.get(), geometry_.get());
    }

    void build(const Mesh& mesh, std::span<const Vec3> vertices, double slack) {
        for (std::size_t i = 0; i < boxes_.size(); ++i) {
            const Triangle& t = mesh.triangles()[i];
            boxes_[i] = box_around(vertices[t[0]], vertices[t[1]], vertices[t[2]], slack);
        }
        rtcCommitGeometry(geometry_.get());
        rtcCommitScene(scene_.get());
    }

    [[nodiscard]] RTCScene scene() const { return scene_.get(); }

  private:
    static void tell_bounds(const RTCBoundsFunctionArguments* args) {
        const auto* self = static_cast<const BoxScene*>(args->geometryUserPtr);
        const FloatBox& box = self->boxes_[args->primID];
        RTCBounds& bounds = *args->bounds_o;
        bounds.lower_x = box.min[0];
        bounds.lower_y = box.min[1];
        bounds.lower_z = box.min[2];
        bounds.upper_x = box.max[0];
        bounds.upper_y = box.max[1];
        bounds.upper_z = box.max[2];
    }

    std::vector<FloatBox> boxes_;
    EmbreeOwned<RTCScene> scene_;
    EmbreeOwned<RTCGeometry> geometry_;
};

class EmbreeMeshEngine final : public MeshEngine {
  public:
    void load(const std::shared_ptr<const Mesh>& a, const std::shared_ptr<const Mesh>& b) override {
        device_.reset(rtcNewDevice("threads=1,set_affinity=0"));
        CD_CHECK(device_ != nullptr);
        mesh_a_ = a;
        mesh_b_ = b;
        a_ = std::make_unique<BoxScene>(device_.get(), a->triangles().size(), false);
        b_ = std::make_unique<BoxScene>(device_.get(), b->triangles().size(), true);
        a_->build(*a, a->vertices(), 0);
        b_->build(*b, b->vertices(), 0);
        moved_.resize(b->vertices().size());
    }

    MeshAnswer ask(const PosePair& poses, Level level) override {
        move_b(relative_pose(poses));
        candidates_.clear();
        rtcCollide(a_->scene(), b_->scene(), take, this);
        MeshAnswer answer;
        const TriangleSpan a{mesh_a_->vertices(), mesh_a_->triangles()};
        const TriangleSpan b{mesh_b_->vertices(), mesh_b_->triangles()};
        TrianglePairTest test(poses);
        const auto kinds = test.classify(a, b, candidates_);
        for (std::size_t i = 0; i < candidates_.size(); ++i) {
            if (kinds[i] != PairClass::Separate) {
                ++answer.pair_count;
                if (level >= Level::Pairs) {
                    answer.pairs.emplace_back(candidates_[i].a, candidates_[i].b);
                }
            }
        }
        answer.touches = answer.pair_count > 0;
        return answer;
    }

  private:
    void move_b(const RelativePose& b_to_a) {
        double largest = b_to_a.translation.cwiseAbs().maxCoeff();
        for (std::size_t i = 0; i < moved_.size(); ++i) {
            const Vec3& vertex = mesh_b_->vertices()[i];
            moved_[i] = b_to_a.rotation * vertex + b_to_a.translation;
            largest = std::max(largest, 3 * vertex.cwiseAbs().maxCoeff());
        }
        constexpr double rounding = 32 * std::numeric_limits<double>::epsilon();
        const double slack =
            largest * (rounding + b_to_a.rotation_error) + b_to_a.translation_error;
        b_->build(*mesh_b_, moved_, slack);
    }

    static void take(void* self, RTCCollision* collisions, unsigned count) {
        auto& candidates = static_cast<EmbreeMeshEngine*>(self)->candidates_;
        for (unsigned i = 0; i < count; ++i) {
            candidates.push_back({collisions[i].primID0, collisions[i].primID1});
        }
    }

    std::shared_ptr<const Mesh> mesh_a_;
    std::shared_ptr<const Mesh> mesh_b_;
    EmbreeOwned<RTCDevice> device_;
    std::unique_ptr<BoxScene> a_;
    std::unique_ptr<BoxScene> b_;
    std::vector<Vec3> moved_; ///< B's vertices in A's frame.
    std::vector<Candidate> candidates_;
};

} // namespace

void add_embree(std::vector<Engine>& engines) {
    Engine engine;
    engine.name = "Embree, our triangle test";
    engine.make_meshes = [] { return std::make_unique<EmbreeMeshEngine>(); };
    // The search cannot be stopped, so any contact costs as much as all pairs.
    engine.levels = {Level::Any, Level::Count, Level::Pairs};
    engines.push_back(engine);
}

} // namespace cd::bench
