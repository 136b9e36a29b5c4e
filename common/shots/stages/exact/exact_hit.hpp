// The last stage: hits in integers of any size, right on every finite input.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/geometry/types.hpp"
#include "common/pair/numbers/dyadic.hpp"
#include "common/shots/line_hit.hpp"

#include <cstdint>
#include <optional>

namespace cd {

/// The share n / d of a segment that lies before a hit; d > 0, and 0 <= n <= d.
struct ExactShare {
    ExactInt n = 0;
    ExactInt d = 1;

    /// Returns a negative number if this share is less, a positive one if it is more, 0 if equal.
    [[nodiscard]] int compare(const ExactShare& other) const {
        const ExactInt left = n * other.d;
        return left.compare(other.n * d);
    }
};

/// Answers what SegmentHit answers. Takes some 10 microseconds.
class ExactHit {
  public:
    explicit ExactHit(const PosePair& poses);

    struct Found {
        std::uint8_t flags = 0;
        ExactShare share;
    };
    /// Returns the hit of a triangle of A and a segment of B; nothing if they share no point.
    [[nodiscard]] std::optional<Found> find(const Corners& a, const Segment& line) const;

  private:
    PosePair poses_;
    ExactPose a_;
    ExactPose b_;
};

/// Returns a share times a segment's length, rounded as by `nearest_double`.
[[nodiscard]] double rounded_depth(const ExactShare& share, double length);

} // namespace cd
