// CGAL on whole meshes: for all pairs, its box intersection with its exact test of (rounded)
// triangles; for any contact, its detector for rigid meshes.
#include "bench/peers/engines/peers.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Intersections_3/Triangle_3_Triangle_3.h>
#include <CGAL/Rigid_triangle_mesh_collision_detection.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace cd::bench {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;

Point point(const Vec3& p) {
    return {p.x(), p.y(), p.z()};
}

/// A body's triangles in the world, with their boxes and a bounding box.
struct WorldTriangles {
    std::vector<Kernel::Triangle_3> triangles;
    std::vector<Box> boxes;
    CGAL::Bbox_3 all;

    void place(const Mesh& mesh, const Pose& pose) {
        const WorldFrame to_world(pose);
        triangles.clear();
        boxes.clear();
        all = CGAL::Bbox_3();
        for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
            const Corners t = to_world(mesh.corners(i));
            triangles.emplace_back(point(t[0]), point(t[1]), point(t[2]));
            boxes.emplace_back(triangles.back().bbox(), i);
            all += boxes.back().bbox();
        }
    }

    /// Fills `near`, which the box intersection reorders.
    void find_near(const CGAL::Bbox_3& other, std::vector<Box>& near) const {
        near.clear();
        std::copy_if(boxes.begin(), boxes.end(), std::back_inserter(near), [&](const Box& box) {
            return CGAL::do_overlap(box.bbox(), other);
        });
    }
};

class CgalBoxes final : public MeshEngine {
  public:
    void load(const std::shared_ptr<const Mesh>& a, const std::shared_ptr<const Mesh>& b) override {
        mesh_a_ = a;
        mesh_b_ = b;
        a_.place(*a, pose_a_);
    }

    MeshAnswer ask(const PosePair& poses, Level /*level*/) override {
        if (!(poses.a == pose_a_)) {
            pose_a_ = poses.a;
            a_.place(*mesh_a_, pose_a_);
        }
        b_.place(*mesh_b_, poses.b);
        a_.find_near(b_.all, near_a_);
        b_.find_near(a_.all, near_b_);
        MeshAnswer answer;
        const auto decide = [&](const Box& a, const Box& b) {
            if (CGAL::do_intersect(a_.triangles[a.info()], b_.triangles[b.info()])) {
                answer.pairs.emplace_back(a.info(), b.info());
            }
        };
        CGAL::box_intersection_d(
            near_a_.begin(), near_a_.end(), near_b_.begin(), near_b_.end(), decide);
        answer.pair_count = answer.pairs.size();
        answer.touches = answer.pair_count > 0;
        return answer;
    }

  private:
    std::shared_ptr<const Mesh> mesh_a_;
    std::shared_ptr<const Mesh> mesh_b_;
    Pose pose_a_;
    WorldTriangles a_;
    WorldTriangles b_;
    std::vector<Box> near_a_;
    std::vector<Box> near_b_;
};

class CgalDetector final : public MeshEngine {
    using Surface = CGAL::Surface_mesh<Point>;

  public:
    void load(const std::shared_ptr<const Mesh>& a, const std::shared_ptr<const Mesh>& b) override {
        namespace parameters = CGAL::parameters;
        surfaces_ = {soup(*a), soup(*b)};
        for (const Surface& surface : surfaces_) {
            detector_.add_mesh(surface, parameters::apply_per_connected_component(false));
        }
    }

    MeshAnswer ask(const PosePair& poses, Level /*level*/) override {
        detector_.set_transformation(0, transformation(poses.a));
        detector_.set_transformation(1, transformation(poses.b));
        MeshAnswer answer;
        answer.touches = !detector_.get_all_intersections(0).empty();
        answer.pair_count = answer.touches ? 1 : 0;
        return answer;
    }

  private:
    /// Returns triangles without shared vertices: CGAL's meshes must be manifold.
    static Surface soup(const Mesh& mesh) {
        Surface surface;
        const auto count = static_cast<Surface::size_type>(mesh.triangles().size());
        surface.reserve(3 * count, 3 * count, count);
        for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
            const Corners t = mesh.corners(i);
            surface.add_face(surface.add_vertex(point(t[0])),
                             surface.add_vertex(point(t[1])),
                             surface.add_vertex(point(t[2])));
        }
        return surface;
    }

    static Kernel::Aff_transformation_3 transformation(const Pose& pose) {
        const Mat3 r = pose.rotation();
        const Vec3& t = pose.translation();
        return {r(0, 0),
                r(0, 1),
                r(0, 2),
                t.x(),
                r(1, 0),
                r(1, 1),
                r(1, 2),
                t.y(),
                r(2, 0),
                r(2, 1),
                r(2, 2),
                t.z()};
    }

    std::array<Surface, 2> surfaces_; ///< The detector refers to them.
    CGAL::Rigid_triangle_mesh_collision_detection<Surface> detector_;
};

} // namespace

void add_cgal_meshes(std::vector<Engine>& engines) {
    Engine boxes;
    boxes.name = "CGAL boxes";
    boxes.make_meshes = [] { return std::make_unique<CgalBoxes>(); };
    boxes.levels = {Level::Pairs};
    engines.push_back(boxes);

    Engine detector;
    detector.name = "CGAL rigid detector";
    detector.make_meshes = [] { return std::make_unique<CgalDetector>(); };
    detector.levels = {Level::Any};
    engines.push_back(detector);
}

} // namespace cd::bench
