// Locates points relative to a closed surface, in integers, by the parity of a ray's crossings.
#pragma once

#include "tests/support/exact_world.hpp"
#include "tests/support/oracle.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace cd::tests {

enum class PointPlace { Outside, Inside, OnSurface };

/// The solid bounded by a closed surface. Triangles without area are ignored.
class ExactSolid {
  public:
    explicit ExactSolid(const std::vector<ExactTriangle>& surface) : surface_(surface) {}

    [[nodiscard]] PointPlace place(const WeightedPoint& point);

    /// Tells whether the solid lies towards `direction` (an index from 0) from `point`, which may
    /// be on the surface. Returns nothing if the ray from there meets an edge or lies in a face.
    [[nodiscard]] std::optional<bool> is_solid_towards(const WeightedPoint& point,
                                                       std::size_t direction);

  private:
    /// A triangle prepared for rays of one direction: all values are linear in the ray's origin.
    struct Target {
        ExactPoint normal;
        Integer offset;
        int along = 0; ///< Sign of normal.direction.
        std::array<ExactPoint, 3> edge_normals;
        std::array<Integer, 3> edge_offsets;
    };
    struct Count {
        bool on_surface = false;
        bool is_odd = false;
    };

    [[nodiscard]] std::optional<Count> count(const WeightedPoint& point, std::size_t direction);
    [[nodiscard]] const std::vector<Target>& targets(std::size_t direction);

    std::vector<ExactTriangle> surface_;
    std::vector<std::vector<Target>> targets_; ///< One list per direction, made on first use.
};

} // namespace cd::tests
