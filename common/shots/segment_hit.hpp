// Decides where and how a line meets posed triangles. No other code decides hits.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/geometry/types.hpp"
#include "common/shots/line_hit.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace cd {

/// The stages of the decision, cheapest first. A stage proves an answer or gives none; later stages
/// decide what earlier ones leave open.
enum class HitStage : std::uint8_t {
    Double = 0,       ///< Doubles with an error bound.
    DoubleDouble = 1, ///< Numbers of two doubles with an error bound.
    Integer = 2,      ///< Integers of a fixed number of words.
    Exact = 3,        ///< Integers of any size: exact on every input.
};
inline constexpr std::size_t hit_stage_count = 4;

[[nodiscard]] std::string_view to_text(HitStage stage);

/// Counts the answers of each stage. An answer that needs several stages counts for the last.
/// Depths are never settled by stages Double and Integer.
struct HitStatistics {
    std::array<std::uint64_t, hit_stage_count> decisions{};
    std::array<std::uint64_t, hit_stage_count> depths{};
    std::uint64_t ties = 0; ///< Hits whose depth, rounded, another hit of the line has as well.

    HitStatistics& operator+=(const HitStatistics& other);

    friend bool operator==(const HitStatistics&, const HitStatistics&) = default;
};

/// Decides hits of triangles of A and segments of B under one pair of poses, exactly: corners and
/// poses are taken as the rationals that they denote (docs/exactness.md).
///
/// A triangle and a segment meet if the closed sets share a point; the hit is the first shared
/// point seen from p. The share of the segment before it is an exact number lambda in [0, 1], and
/// the depth is lambda times the segment's length: that of its own coordinates, rounded once to a
/// double (see `segment_length`). The product is rounded once more, to the nearest finite double,
/// ties to even. A segment that is a point has depth 0.
///
/// Some hits count as crossings, and those of a line that starts and ends outside a closed mesh are
/// even in number, exactly. With d = q - p, the line passes an edge from v_i to v_j on the side
/// that is the sign of det(d, v_i - p, v_j - p). Where that is 0, p and q are moved by (eps, eps^2,
/// eps^3) along the world's axes, for an eps that is smaller than any positive number in question
/// (simulation of simplicity). A segment crosses if it passes all three edges on one side, and
/// - its ends are on different sides of the plane, or p is in the plane and q is not.
/// So a segment holds its end p, and not its end q: of two chained segments of a line that meet in
/// the plane, the later one crosses. A segment that is in the plane never does, nor does one that
/// meets a triangle without area.
///
/// Every answer depends only on the triangles, the segment and the poses; no answer depends on a
/// stage or on earlier calls. Not thread-safe.
class SegmentHit {
  public:
    /// Skips the stages before `first`, which changes no answer.
    explicit SegmentHit(const PosePair& poses, HitStage first = HitStage::Double);
    SegmentHit(SegmentHit&&) noexcept;
    SegmentHit& operator=(SegmentHit&&) noexcept;
    ~SegmentHit();

    /// Starts over with other poses and empty statistics, but keeps scratch memory.
    void restart(const PosePair& poses);

    /// Returns the flags (`hit_flag`) of a triangle's hit; nothing if they share no point.
    [[nodiscard]] std::optional<std::uint8_t> flags(const Corners& a, const Segment& line);

    /// Returns the hits of one line among the given triangles of A, in order along the line: by
    /// exact lambda, then leaving before entering before neither, then by place among the given.
    /// Valid until the next call.
    [[nodiscard]] std::span<const LineHit> hits(std::span<const Corners> a, const Segment& line);

    [[nodiscard]] const HitStatistics& statistics() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace cd
