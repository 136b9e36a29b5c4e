// Exact point-in-solid test by parity, for the solid that a closed mesh bounds.
#pragma once

#include "common/solid/exact_frame.hpp"
#include "common/solid/settle_statistics.hpp"
#include "common/tree/id_range.hpp"
#include "common/tree/obb_tree.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace cd {

/// A point in a solid's coordinates: rounded with an error bound, and exact on demand.
class SolidPoint {
  public:
    /// `error` bounds the error of each component of `rounded`.
    SolidPoint(const Vec3& rounded, double error, std::function<ExactPoint()> exact)
        : rounded_(rounded), error_(error), make_exact_(std::move(exact)) {}

    [[nodiscard]] const Vec3& rounded() const { return rounded_; }
    [[nodiscard]] double error() const { return error_; }
    [[nodiscard]] const ExactPoint& exact();
    [[nodiscard]] bool needed_exact() const { return exact_.has_value(); }

  private:
    Vec3 rounded_;
    double error_;
    std::function<ExactPoint()> make_exact_;
    std::optional<ExactPoint> exact_;
};

enum class Location : std::uint8_t { Outside, Inside, OnSurface };

/// A closed body as a solid: a point is inside when a ray from it crosses the surface an odd number
/// of times. The winding of the triangles does not matter. The tree outlives this object; one
/// thread at a time may use it.
class SolidTest {
  public:
    explicit SolidTest(const ObbTree& solid) : solid_(solid) {}

    /// Classifies `point`. The ranges `left_out`, ascending and disjoint, are not part of the
    /// surface; the other triangles bound a solid.
    [[nodiscard]] Location locate(SolidPoint& point, std::span<const IdRange> left_out = {});

    /// Returns whether the solid lies right beside a point, on side `side` of a plane through the
    /// point. `passed_over` are ascending ids of triangles of the solid: at least all that contain
    /// the point, and none that extends to that side. `side_of` returns on which side of the plane,
    /// 1 or -1, a direction leads, or 0 in the plane.
    [[nodiscard]] bool is_inside_beside(SolidPoint& point,
                                        const std::function<int(const Vec3& direction)>& side_of,
                                        int side,
                                        std::span<const std::uint32_t> passed_over);

    /// Returns on which side of a triangle with area the solid lies, next to the triangle's
    /// centroid: 1 for the side to which the cross product of its edges points, -1 for the other
    /// side. Returns 0 if the centroid lies on another triangle of the body as well, since both
    /// sides are then alike.
    [[nodiscard]] int solid_side(std::uint32_t triangle);

    [[nodiscard]] const SettleStatistics& statistics() const { return statistics_; }

  private:
    enum class Verdict : std::uint8_t { Even, Odd, OnSurface, Unclear };

    [[nodiscard]] std::uint64_t attempts_max() const;
    [[nodiscard]] std::optional<Vec3> shortest_way_out(const SolidPoint& point) const;
    [[nodiscard]] Verdict
    cast_ray(SolidPoint& point, const Vec3& direction, std::span<const IdRange> passed_over);

    const ObbTree& solid_;
    std::vector<std::uint32_t> waiting_; ///< Stack of nodes that `cast_ray` has yet to test.
    std::vector<IdRange> passed_over_;   ///< The triangles passed over by `is_inside_beside`.
    SettleStatistics statistics_;
};

} // namespace cd
