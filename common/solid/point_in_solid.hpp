// Where a point lies in the solid that a closed mesh bounds: exact parity.
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

/// A point in a solid's coordinates: rounded with a bound, and exactly if need be.
class SolidPoint {
  public:
    /// `error` bounds how far each component of `rounded` is from the exact one.
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

enum class Place : std::uint8_t { Outside, Inside, OnSurface };

/// A closed body as a solid: a point is inside when a ray from it crosses the surface an odd number
/// of times. How the triangles are wound does not matter. The tree outlives this; one thread.
class SolidTest {
  public:
    explicit SolidTest(const ObbTree& solid) : solid_(solid) {}

    /// `left_out`, ascending and apart, are not part of the surface; the others bound a solid.
    [[nodiscard]] Place place_of(SolidPoint& point, std::span<const IdRange> left_out = {});

    /// Whether the solid lies right beside a point, on one side of a plane through it.
    /// `passed_over` are triangles of the solid, ascending, with nothing on that side, and all that
    /// hold the point. `side_of` tells on which side, 1 or -1, a direction leads from the plane, or
    /// 0.
    [[nodiscard]] bool is_inside_beside(SolidPoint& point,
                                        const std::function<int(const Vec3& direction)>& side_of,
                                        int side,
                                        std::span<const std::uint32_t> passed_over);

    /// On which side of a triangle with area the solid lies, next to the triangle's centroid: 1 for
    /// the side to which the cross product of its edges points, -1 for the other; 0 where both
    /// sides are alike because the centroid lies on another of the body's triangles as well.
    [[nodiscard]] int solid_side(std::uint32_t triangle);

    [[nodiscard]] const SettleStatistics& statistics() const { return statistics_; }

  private:
    enum class Verdict : std::uint8_t { Even, Odd, OnSurface, Unclear };

    [[nodiscard]] std::uint64_t attempts_max() const;
    [[nodiscard]] std::optional<Vec3> shortest_way_out(const SolidPoint& point) const;
    [[nodiscard]] Verdict
    cast_ray(SolidPoint& point, const Vec3& direction, std::span<const IdRange> passed_over);

    const ObbTree& solid_;
    std::vector<std::uint32_t> waiting_; ///< Nodes; empty between rays.
    std::vector<IdRange> passed_over_;   ///< While rays beside one point are cast.
    SettleStatistics statistics_;
};

} // namespace cd
