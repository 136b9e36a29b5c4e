// The shared points of two touching triangles, correctly rounded.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/geometry/types.hpp"
#include "common/pair/points/crossing/crossing_points.hpp"
#include "common/pair/points/double_double_points.hpp"
#include "common/pair/points/exact_points.hpp"
#include "common/pair/points/shared_corners.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace cd {

/// Counts the pairs whose points, and the triangles whose origin, each path computed: `fast` is
/// double-double, `exact` is integers. Pairs that double-double computed together with others count
/// as `points_together` alone.
struct PointStatistics {
    std::uint64_t points_together = 0;
    std::uint64_t points_fast = 0;
    std::uint64_t points_exact = 0;
    std::uint64_t origins_fast = 0;
    std::uint64_t origins_exact = 0;
};

/// Computes the shared points of pairs under one pair of poses. Corners and poses are taken as the
/// rationals that they denote. Each result is rounded once, to the nearest finite double (ties to
/// even; see `nearest_double`): the same bits on every host.
///
/// Double-double runs first, with an error bound that shows whether the rounding is certain: for
/// crossing pairs in a batch with one pair per SIMD lane, for others one by one. For
/// touching and coplanar pairs, integers of few words find the shared corners. If that does not
/// suffice, integers compute everything. Not thread-safe.
class SharedPoints {
  public:
    /// Receives a pair's origin and points, which are valid during the call.
    using Receiver = std::function<void(const Vec3& origin, std::span<const Vec3> points)>;

    /// `Exact` skips double-double; the results are the same.
    enum class Path : std::uint8_t { Any, Exact };

    /// Cheap: each path prepares the poses when first used.
    explicit SharedPoints(const PosePair& poses, Path path = Path::Any)
        : poses_(poses), path_(path) {}

    /// Starts over with other poses and empty statistics, but keeps scratch memory.
    void restart(const PosePair& poses);

    /// Returns the first corner of A in the world, rounded.
    [[nodiscard]] Vec3 origin(const Corners& a);

    /// Returns the corners of the triangles' shared set, each as the exact point minus the rounded
    /// `origin(a)`, rounded; so origin plus point is as accurate as possible. Valid until the next
    /// call.
    ///
    /// The result is empty for triangles that do not meet; one point; the two ends of a segment,
    /// the lexicographically lesser first; or a convex polygon of up to six corners, turning left
    /// around A's normal from the lexicographically least on. Order and number are those of the
    /// exact points: distinct corners may round to equal ones.
    [[nodiscard]] std::span<const Vec3> points(const Corners& a, const Corners& b);

    /// Passes the origin and points of each pair to `receive`, in order: much faster than one by
    /// one.
    void for_each(std::span<const PairCorners> pairs, const Receiver& receive);

    [[nodiscard]] const PointStatistics& statistics() const { return statistics_; }

  private:
    [[nodiscard]] DoubleDoublePoints* fast();
    [[nodiscard]] ExactPoints& exact();
    [[nodiscard]] std::optional<std::span<const Vec3>>
    fast_points(const Corners& a, const Corners& b, const Vec3& origin);
    [[nodiscard]] Vec3 offset();
    /// Computes at most `CrossingPoints::pairs_max` pairs; returns null if that does not pay.
    [[nodiscard]] const CrossingPoints* together(std::span<const PairCorners> pairs);

    PosePair poses_;
    Path path_;
    std::optional<CrossingPoints> together_;
    std::optional<DoubleDoublePoints> fast_;
    std::optional<SharedCornerFinder> finder_;
    std::optional<ExactPoints> exact_;
    std::optional<Corners> last_a_; ///< Triangle of `last_origin_`; pairs often share A's.
    Vec3 last_origin_;
    std::optional<Vec3> last_offset_; ///< `last_a_`'s first corner minus `last_origin_`.
    std::vector<Vec3> points_;
    PointStatistics statistics_;
};

} // namespace cd
