// FCL for one number type: its triangle test, and its meshes under trees of boxes.
#pragma once

#include "bench/peers/engines/engine.hpp"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/detail/traversal/collision/intersect.h>

#include <array>
#include <memory>
#include <vector>

namespace cd::bench {

template <class Number>
struct FclPairTest {
    using Vector = fcl::Vector3<Number>;

    static bool touches(const Corners& a, const Corners& b) {
        const auto v = [](const Vec3& p) { return Vector(p.cast<Number>()); };
        return fcl::detail::Intersect<Number>::intersect_Triangle(
            v(a[0]), v(a[1]), v(a[2]), v(b[0]), v(b[1]), v(b[2]));
    }

    static std::vector<Vec3> points(const Corners& a, const Corners& b) {
        const auto v = [](const Vec3& p) { return Vector(p.cast<Number>()); };
        // Larger than any result of FCL's triangle clipping.
        std::array<Vector, 16> found;
        unsigned count = 0;
        Number depth = 0;
        Vector normal = Vector::Zero();
        if (!fcl::detail::Intersect<Number>::intersect_Triangle(v(a[0]),
                                                                v(a[1]),
                                                                v(a[2]),
                                                                v(b[0]),
                                                                v(b[1]),
                                                                v(b[2]),
                                                                found.data(),
                                                                &count,
                                                                &depth,
                                                                &normal)) {
            return {};
        }
        std::vector<Vec3> points;
        for (unsigned i = 0; i < count; ++i) {
            points.push_back(found[i].template cast<double>());
        }
        return points;
    }
};

template <class Box>
std::shared_ptr<fcl::BVHModel<Box>> fcl_model(const Mesh& mesh) {
    using Number = typename Box::S;
    std::vector<fcl::Vector3<Number>> vertices;
    for (const Vec3& v : mesh.vertices()) {
        vertices.push_back(v.cast<Number>());
    }
    std::vector<fcl::Triangle> triangles;
    for (const Triangle& t : mesh.triangles()) {
        triangles.emplace_back(t[0], t[1], t[2]);
    }
    auto model = std::make_shared<fcl::BVHModel<Box>>();
    model->beginModel();
    model->addSubModel(vertices, triangles);
    model->endModel();
    return model;
}

template <class Number>
fcl::Transform3<Number> fcl_transform(const Pose& pose) {
    fcl::Transform3<Number> to = fcl::Transform3<Number>::Identity();
    to.linear() = pose.rotation().template cast<Number>();
    to.translation() = pose.translation().template cast<Number>();
    return to;
}

template <class Box>
class FclMeshEngine final : public MeshEngine {
    using Number = typename Box::S;
    using Model = fcl::BVHModel<Box>;

  public:
    void load(const std::shared_ptr<const Mesh>& a, const std::shared_ptr<const Mesh>& b) override {
        a_ = fcl_model<Box>(*a);
        b_ = fcl_model<Box>(*b);
    }

    MeshAnswer ask(const PosePair& poses, Level level) override {
        fcl::CollisionRequest<Number> request;
        request.num_max_contacts = level == Level::Any ? 1 : ~std::size_t{0};
        request.enable_contact = level == Level::Contacts;
        fcl::CollisionResult<Number> result;
        fcl::collide(a_.get(),
                     fcl_transform<Number>(poses.a),
                     b_.get(),
                     fcl_transform<Number>(poses.b),
                     request,
                     result);
        MeshAnswer answer;
        answer.touches = result.isCollision();
        answer.pair_count = result.numContacts();
        if (level >= Level::Pairs) {
            for (std::size_t i = 0; i < result.numContacts(); ++i) {
                const auto& contact = result.getContact(i);
                answer.pairs.emplace_back(static_cast<std::uint32_t>(contact.b1),
                                          static_cast<std::uint32_t>(contact.b2));
            }
        }
        return answer;
    }

  private:
    std::shared_ptr<Model> a_;
    std::shared_ptr<Model> b_;
};

/// Meshes under trees of `Box`.
template <class Box>
Engine fcl_mesh_engine(const char* name) {
    Engine engine;
    engine.name = name;
    engine.make_meshes = [] { return std::make_unique<FclMeshEngine<Box>>(); };
    engine.levels = {Level::Any, Level::Count, Level::Pairs, Level::Contacts};
    return engine;
}

/// Pairs of triangles, and meshes under trees of OBBs.
template <class Number>
Engine fcl_engine(const char* name) {
    Engine engine = fcl_mesh_engine<fcl::OBB<Number>>(name);
    engine.make_pairs = [] { return std::make_unique<WorldPairEngine<FclPairTest<Number>>>(); };
    return engine;
}

} // namespace cd::bench
