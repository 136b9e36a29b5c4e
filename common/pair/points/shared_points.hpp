// The points that two touching triangles share, correctly rounded.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/geometry/types.hpp"
#include "common/pair/points/double_double_points.hpp"
#include "common/pair/points/exact_points.hpp"
#include "common/pair/points/shared_corners.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace cd {

/// How many pairs' points, and how many origins, each path made.
struct PointStatistics {
    std::uint64_t points_fast = 0;
    std::uint64_t points_exact = 0;
    std::uint64_t origins_fast = 0;
    std::uint64_t origins_exact = 0;
};

/// Makes the shared points of pairs under one pair of poses. The corners and the poses' numbers are
/// taken as the rationals that they denote, and each result is rounded once, to the nearest finite
/// double (to even; see `nearest_double`): the same bits on every host.
///
/// First in pairs of doubles, whose error bound tells whether all numbers near enough round alike;
/// which corners a touching or coplanar pair shares, integers of few words tell them. Where that is
/// not enough, all is done in integers. Not for use by two threads at once.
class SharedPoints {
  public:
    enum class Path : std::uint8_t { Any, Exact }; ///< The results are the same.

    /// Costs little: what the paths need is made when first asked for.
    explicit SharedPoints(const PosePair& poses, Path path = Path::Any)
        : poses_(poses), path_(path) {}

    /// As if made anew with other poses, but keeps scratch memory.
    void restart(const PosePair& poses);

    /// The first corner of A in the world, rounded.
    [[nodiscard]] Vec3 origin(const Corners& a);

    /// The corners of the set of points that the triangles share, each as the exact point minus the
    /// rounded `origin(a)`, rounded: so that origin plus point is as near to the truth as can be.
    /// Valid until the next call.
    ///
    /// Nothing for triangles that do not meet; one point; the two ends of a segment, the
    /// lexicographically lesser first; or a convex polygon of up to six corners, turning left
    /// around A's normal from the lexicographically least on. Order and number are those of the
    /// exact points: corners that differ may round to the same.
    [[nodiscard]] std::span<const Vec3> points(const Corners& a, const Corners& b);

    [[nodiscard]] const PointStatistics& statistics() const { return statistics_; }

  private:
    [[nodiscard]] DoubleDoublePoints* fast();
    [[nodiscard]] ExactPoints& exact();
    [[nodiscard]] std::optional<std::span<const Vec3>>
    fast_points(const Corners& a, const Corners& b, const Vec3& origin);
    [[nodiscard]] Vec3 offset();

    PosePair poses_;
    Path path_;
    std::optional<DoubleDoublePoints> fast_;
    std::optional<SharedCornerFinder> finder_;
    std::optional<ExactPoints> exact_;
    std::optional<Corners> last_a_; ///< Pairs of one triangle often follow each other.
    Vec3 last_origin_;
    std::optional<Vec3> last_offset_; ///< Of last_a_'s first corner from that.
    std::vector<Vec3> points_;
    PointStatistics statistics_;
};

} // namespace cd
