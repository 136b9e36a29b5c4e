// Decides whether a triangle of one body enters the solid of another body that it touches.
#pragma once

#include "common/pair/triangle_pair.hpp"
#include "common/solid/point_in_solid.hpp"
#include "common/solid/posed_triangle.hpp"
#include "common/tree/obb_tree.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace cd {

/// A triangle of the outer body in contact with the current inner triangle.
struct OuterContact {
    std::uint32_t triangle = 0;
    PairClass kind = PairClass::Touch;
};

/// Tests triangles of an inner body, each with all its contacts, none of them proper. The trees and
/// poses outlive this object; one thread at a time may use it.
class TriangleInSolid {
  public:
    TriangleInSolid(const ObbTree& outer,
                    const Pose& outer_pose,
                    const ObbTree& inner,
                    const Pose& inner_pose);

    /// Returns true when a point in the interior of the triangle lies strictly inside the outer
    /// solid. The contacts are sorted by their triangles.
    [[nodiscard]] bool reaches_inside(std::uint32_t triangle,
                                      std::span<const OuterContact> contacts);

    [[nodiscard]] const SettleStatistics& statistics() const { return solid_.statistics(); }

  private:
    /// An edge of the outer body in the triangle's plane, or a corner: then both ends are equal.
    struct Edge {
        Vec3 from;
        Vec3 to;
        int winding =
            0; ///< Winding of a coplanar triangle that the edge bounds; 0 if there is none.
    };

    [[nodiscard]] std::span<const std::uint32_t> ids_of(std::span<const OuterContact> contacts);
    [[nodiscard]] std::optional<int> open_side(PosedTriangle& inner,
                                               std::span<const OuterContact> contacts);
    [[nodiscard]] int plane_side(PosedTriangle& inner, std::uint32_t outer_vertex);
    void add_edge(const Vec3& from, const Vec3& to, int winding);
    void add_touching(PosedTriangle& inner, std::uint32_t outer_triangle);
    void find_edges(PosedTriangle& inner, std::span<const OuterContact> contacts);
    void keep_boundary_edges();
    [[nodiscard]] bool any_cell_inside(PosedTriangle& inner);
    [[nodiscard]] bool any_piece_inside(PosedTriangle& inner,
                                        std::span<const OuterContact> contacts);

    const ObbTree& outer_;
    const ObbTree& inner_;
    ExactFrame frame_;
    RelativePose inner_to_outer_;
    SolidTest solid_;
    /// Plane sides of outer vertices, cached where doubles prove none, because triangles in contact
    /// often share vertices.
    std::unordered_map<std::uint32_t, int> plane_sides_;
    std::vector<std::uint32_t> ids_; ///< Outer triangles of the current contacts.
    std::vector<Edge> edges_;        ///< Edges that may enter the current triangle.
};

} // namespace cd
