// Whether and how two posed triangles meet: the one place that decides contacts.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/geometry/types.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace cd {

/// How two closed triangles meet (NUMERICS, section 1).
enum class PairClass : std::uint8_t {
    Separate = 0, ///< No shared point.
    Touch = 1,    ///< Shared points, but neither of the two below; always so with a degenerate one.
    Coplanar = 2, ///< In one plane, overlapping with positive area.
    Proper = 3,   ///< Not coplanar, and the relative interiors share a point.
};

/// How many pairs each stage of the decision settled.
struct PairStatistics {
    std::uint64_t by_double = 0;
    std::uint64_t by_exact = 0;

    PairStatistics& operator+=(const PairStatistics& other);
};

/// Decides triangle pairs under one pair of poses, exactly: the corners and the poses' numbers are
/// taken as the rationals that they denote. Degenerate triangles are points and segments.
///
/// Every answer depends on the two triangles and the poses alone, not on what was asked before.
/// Not for use by two threads at once.
class TrianglePairTest {
  public:
    explicit TrianglePairTest(const PosePair& poses);
    TrianglePairTest(TrianglePairTest&&) noexcept;
    TrianglePairTest& operator=(TrianglePairTest&&) noexcept;
    ~TrianglePairTest();

    /// True when the closed triangles share a point.
    [[nodiscard]] bool touches(const Corners& a, const Corners& b);

    [[nodiscard]] PairClass classify(const Corners& a, const Corners& b);

    /// The corners of the set of shared points of two triangles that `classify` found to meet, as
    /// `kind`: one point, the two ends of a segment, or a convex polygon of up to six points in
    /// order. Relative to `point_origin(a)`, in doubles, by a fixed sequence of operations.
    [[nodiscard]] std::vector<Vec3>
    shared_points(const Corners& a, const Corners& b, PairClass kind);

    /// The first corner of A in the world, rounded: what shared points are relative to.
    [[nodiscard]] Vec3 point_origin(const Corners& a) const;

    [[nodiscard]] const PairStatistics& statistics() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace cd
