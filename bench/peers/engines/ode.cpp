// ODE's triangle meshes (OPCODE).
#include "bench/peers/engines/peers.hpp"

#include <ode/ode.h>

#include <algorithm>
#include <array>
#include <cstdarg>
#include <limits>

namespace cd::bench {

namespace {

/// Initialises ODE once per process.
void start_ode() {
    static const bool started = [] {
        dInitODE2(0);
        dAllocateODEDataForThread(dAllocateMaskAll);
        // Suppresses thousands of warnings about full tables on stderr.
        dSetMessageHandler([](int, const char*, va_list) {});
        return true;
    }();
    static_cast<void>(started);
}

/// A mesh in ODE's arrays, which its geometry refers to.
class OdeMesh {
  public:
    OdeMesh(std::vector<Vec3> vertices, std::span<const Triangle> triangles)
        : vertices_(std::move(vertices)), data_(dGeomTriMeshDataCreate()) {
        for (const Triangle& t : triangles) {
            indices_.insert(indices_.end(), t.begin(), t.end());
        }
        dGeomTriMeshDataBuildDouble(data_,
                                    vertices_.data(),
                                    static_cast<int>(sizeof(Vec3)),
                                    static_cast<int>(vertices_.size()),
                                    indices_.data(),
                                    static_cast<int>(indices_.size()),
                                    static_cast<int>(3 * sizeof(dTriIndex)));
        geometry_ = dCreateTriMesh(nullptr, data_, nullptr, nullptr, nullptr);
    }
    OdeMesh(const OdeMesh&) = delete;
    OdeMesh& operator=(const OdeMesh&) = delete;
    ~OdeMesh() {
        dGeomDestroy(geometry_);
        dGeomTriMeshDataDestroy(data_);
    }

    void pose(const Pose& pose) {
        const Mat3 r = pose.rotation();
        dMatrix3 rotation{};
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                rotation[4 * i + j] = r(i, j);
            }
        }
        const Vec3& t = pose.translation();
        dGeomSetRotation(geometry_, rotation);
        dGeomSetPosition(geometry_, t.x(), t.y(), t.z());
    }

    [[nodiscard]] dGeomID geometry() const { return geometry_; }

  private:
    std::vector<Vec3> vertices_;
    std::vector<dTriIndex> indices_;
    dTriMeshDataID data_;
    dGeomID geometry_ = nullptr;
};

int collide(const OdeMesh& a, const OdeMesh& b, std::vector<dContactGeom>& contacts, int flags) {
    return dCollide(a.geometry(),
                    b.geometry(),
                    flags | static_cast<int>(contacts.size()),
                    contacts.data(),
                    static_cast<int>(sizeof(dContactGeom)));
}

class OdePairEngine final : public PairEngine {
  public:
    OdePairEngine() { start_ode(); }

    void prepare(std::span<const PairGroup> groups) override {
        pairs_.clear();
        for (const PairGroup& group : groups) {
            for (const Candidate& c : group.candidates) {
                pairs_.emplace_back(made(group.poses.a, group.a.corners_at(c.a), -1),
                                    made(group.poses.b, group.b.corners_at(c.b), 1));
            }
        }
    }

    void decide(std::span<std::uint8_t> answers) override {
        std::vector<dContactGeom> contacts(1);
        for (std::size_t i = 0; i < pairs_.size(); ++i) {
            answers[i] = collide(*pairs_[i].first,
                                 *pairs_[i].second,
                                 contacts,
                                 static_cast<int>(CONTACTS_UNIMPORTANT)) > 0
                             ? 1
                             : 0;
        }
    }

    [[nodiscard]] bool gives_points() const override { return true; }

    [[nodiscard]] SharedPoints shared_points(const PairGroup& group, const Candidate& c) override {
        const auto a = made(group.poses.a, group.a.corners_at(c.a), -1);
        const auto b = made(group.poses.b, group.b.corners_at(c.b), 1);
        std::vector<dContactGeom> contacts(16);
        const int count = collide(*a, *b, contacts, 0);
        SharedPoints shared;
        for (int i = 0; i < count; ++i) {
            const dReal* p = contacts[static_cast<std::size_t>(i)].pos;
            shared.points.emplace_back(p[0], p[1], p[2]);
        }
        return shared;
    }

  private:
    /// A single triangle has no tree, and dCollide would crash: each mesh gets a second triangle,
    /// far off on its own side.
    static std::unique_ptr<OdeMesh> made(const Pose& pose, const Corners& corners, double side) {
        const Corners t = WorldFrame(pose)(corners);
        double size = 1;
        for (const Vec3& corner : t) {
            size = std::max(size, corner.cwiseAbs().maxCoeff());
        }
        std::vector<Vec3> vertices(t.begin(), t.end());
        for (const Vec3& corner : t) {
            vertices.emplace_back(corner + Vec3(side * 100 * size, 0, 0));
        }
        constexpr std::array<Triangle, 2> triangles{{{0, 1, 2}, {3, 4, 5}}};
        return std::make_unique<OdeMesh>(std::move(vertices), triangles);
    }

    std::vector<std::pair<std::unique_ptr<OdeMesh>, std::unique_ptr<OdeMesh>>> pairs_;
};

class OdeMeshEngine final : public MeshEngine {
  public:
    OdeMeshEngine() { start_ode(); }

    void load(const std::shared_ptr<const Mesh>& a, const std::shared_ptr<const Mesh>& b) override {
        a_ = std::make_unique<OdeMesh>(a->vertices(), a->triangles());
        b_ = std::make_unique<OdeMesh>(b->vertices(), b->triangles());
    }

    MeshAnswer ask(const PosePair& poses, Level level) override {
        a_->pose(poses.a);
        b_->pose(poses.b);
        const bool any = level == Level::Any;
        // The interface can return no more contacts than this.
        contacts_.resize(any ? 1 : std::numeric_limits<std::uint16_t>::max());
        const int count =
            collide(*a_, *b_, contacts_, any ? static_cast<int>(CONTACTS_UNIMPORTANT) : 0);
        MeshAnswer answer;
        answer.touches = count > 0;
        answer.pair_count = static_cast<std::uint64_t>(count);
        if (level >= Level::Pairs) {
            for (int i = 0; i < count; ++i) {
                const dContactGeom& contact = contacts_[static_cast<std::size_t>(i)];
                // Merged contacts name no triangles.
                if (contact.side1 >= 0 && contact.side2 >= 0) {
                    answer.pairs.emplace_back(static_cast<std::uint32_t>(contact.side1),
                                              static_cast<std::uint32_t>(contact.side2));
                }
            }
        }
        return answer;
    }

  private:
    std::unique_ptr<OdeMesh> a_;
    std::unique_ptr<OdeMesh> b_;
    std::vector<dContactGeom> contacts_;
};

} // namespace

void add_ode(std::vector<Engine>& engines) {
    Engine engine;
    engine.name = "ODE";
    engine.make_pairs = [] { return std::make_unique<OdePairEngine>(); };
    engine.make_meshes = [] { return std::make_unique<OdeMeshEngine>(); };
    // ODE always clips, and counts only with contacts.
    engine.levels = {Level::Any, Level::Contacts};
    engines.push_back(engine);
}

} // namespace cd::bench
