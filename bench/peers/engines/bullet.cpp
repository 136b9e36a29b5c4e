// Bullet's GImpact, in floats: the steps of its collision algorithm for two meshes.
#include "bench/peers/engines/bullet_values.hpp"
#include "bench/peers/engines/peers.hpp"

#include <BulletCollision/CollisionShapes/btTriangleIndexVertexArray.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>

namespace cd::bench {

namespace {

bool meet(btPrimitiveTriangle& a, btPrimitiveTriangle& b, GIM_TRIANGLE_CONTACT& contact) {
    a.buildTriPlane();
    b.buildTriPlane();
    return a.overlap_test_conservative(b) && a.find_triangle_collision_clip_method(b, contact);
}

struct BulletPairTest {
    btScalar margin;

    [[nodiscard]] btPrimitiveTriangle triangle(const Corners& t) const {
        btPrimitiveTriangle made;
        for (std::size_t i = 0; i < 3; ++i) {
            made.m_vertices[i] = bullet_vector(t[i]);
        }
        made.m_margin = margin;
        return made;
    }

    [[nodiscard]] bool touches(const Corners& a, const Corners& b) const {
        btPrimitiveTriangle ta = triangle(a);
        btPrimitiveTriangle tb = triangle(b);
        GIM_TRIANGLE_CONTACT contact;
        return meet(ta, tb, contact);
    }

    [[nodiscard]] std::vector<Vec3> points(const Corners& a, const Corners& b) const {
        btPrimitiveTriangle ta = triangle(a);
        btPrimitiveTriangle tb = triangle(b);
        GIM_TRIANGLE_CONTACT contact;
        std::vector<Vec3> points;
        if (meet(ta, tb, contact)) {
            for (int i = 0; i < contact.m_point_count; ++i) {
                const btVector3& p = contact.m_points[i];
                points.emplace_back(p.x(), p.y(), p.z());
            }
        }
        return points;
    }
};

/// A mesh in Bullet's arrays, which its shape refers to.
struct BulletMesh {
    std::vector<float> vertices;
    std::vector<int> indices;
    std::unique_ptr<btTriangleIndexVertexArray> arrays;
    std::unique_ptr<btGImpactMeshShapePart> shape;

    explicit BulletMesh(const Mesh& mesh) {
        for (const Vec3& v : mesh.vertices()) {
            for (const double x : {v.x(), v.y(), v.z()}) {
                vertices.push_back(static_cast<float>(x));
            }
        }
        for (const Triangle& t : mesh.triangles()) {
            for (const std::uint32_t i : t) {
                indices.push_back(static_cast<int>(i));
            }
        }
        arrays =
            std::make_unique<btTriangleIndexVertexArray>(static_cast<int>(mesh.triangles().size()),
                                                         indices.data(),
                                                         static_cast<int>(3 * sizeof(int)),
                                                         static_cast<int>(mesh.vertices().size()),
                                                         vertices.data(),
                                                         static_cast<int>(3 * sizeof(float)));
        shape = std::make_unique<btGImpactMeshShapePart>(arrays.get(), 0);
        shape->setMargin(0);
        shape->updateBound();
        shape->lockChildShapes();
    }
};

class BulletMeshEngine final : public MeshEngine {
  public:
    void load(const std::shared_ptr<const Mesh>& a, const std::shared_ptr<const Mesh>& b) override {
        a_ = std::make_unique<BulletMesh>(*a);
        b_ = std::make_unique<BulletMesh>(*b);
    }

    MeshAnswer ask(const PosePair& poses, Level level) override {
        const btTransform to_world_a = bullet_transform(poses.a);
        const btTransform to_world_b = bullet_transform(poses.b);
        btPairSet boxes;
        btGImpactBoxSet::find_collision(
            a_->shape->getBoxSet(), to_world_a, b_->shape->getBoxSet(), to_world_b, boxes);
        MeshAnswer answer;
        for (int i = 0; i < boxes.size(); ++i) {
            btPrimitiveTriangle ta;
            btPrimitiveTriangle tb;
            a_->shape->getPrimitiveTriangle(boxes[i].m_index1, ta);
            b_->shape->getPrimitiveTriangle(boxes[i].m_index2, tb);
            ta.applyTransform(to_world_a);
            tb.applyTransform(to_world_b);
            GIM_TRIANGLE_CONTACT contact;
            if (!meet(ta, tb, contact)) {
                continue;
            }
            answer.touches = true;
            ++answer.pair_count;
            if (level == Level::Any) {
                break;
            }
            if (level >= Level::Pairs) {
                answer.pairs.emplace_back(static_cast<std::uint32_t>(boxes[i].m_index1),
                                          static_cast<std::uint32_t>(boxes[i].m_index2));
            }
        }
        return answer;
    }

  private:
    std::unique_ptr<BulletMesh> a_;
    std::unique_ptr<BulletMesh> b_;
};

} // namespace

void add_bullet(std::vector<Engine>& engines) {
    Engine engine;
    engine.name = "Bullet GImpact";
    engine.make_pairs = [] {
        return std::make_unique<WorldPairEngine<BulletPairTest>>(BulletPairTest{0});
    };
    engine.make_meshes = [] { return std::make_unique<BulletMeshEngine>(); };
    // The algorithm always clips, so contacts cost no more than pairs.
    engine.levels = {Level::Any, Level::Count, Level::Pairs, Level::Contacts};
    engines.push_back(engine);

    Engine with_margin;
    with_margin.name = "Bullet GImpact, margin 0.01";
    with_margin.make_pairs = [] {
        return std::make_unique<WorldPairEngine<BulletPairTest>>(BulletPairTest{0.01f});
    };
    engines.push_back(with_margin);
}

} // namespace cd::bench
