// Decides how far apart two posed triangles are. No other code decides distances.
#pragma once

#include "common/distance/nearest_points.hpp"
#include "common/geometry/pose.hpp"
#include "common/geometry/types.hpp"
#include "common/pair/triangle_pair.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

namespace cd {

/// The stages of the decision, cheapest first. A stage proves an answer or gives none; later stages
/// decide what earlier ones leave open.
enum class DistanceStage : std::uint8_t {
    Float = 0,        ///< Floats with an error bound, one pair per SIMD lane.
    Double = 1,       ///< Doubles with an error bound.
    DoubleDouble = 2, ///< Numbers of two doubles with an error bound.
    Exact = 3,        ///< Integers of any size: exact on every input.
};
inline constexpr std::size_t distance_stage_count = 4;

[[nodiscard]] std::string_view to_text(DistanceStage stage);

/// Counts the answers of each stage. An answer that needs several stages counts for the last.
struct DistanceStatistics {
    std::array<std::uint64_t, distance_stage_count> settled{};

    [[nodiscard]] std::uint64_t& operator[](DistanceStage stage) {
        return settled[static_cast<std::size_t>(stage)];
    }
    [[nodiscard]] std::uint64_t operator[](DistanceStage stage) const {
        return settled[static_cast<std::size_t>(stage)];
    }
    [[nodiscard]] std::uint64_t total() const;
    DistanceStatistics& operator+=(const DistanceStatistics& other);

    friend bool operator==(const DistanceStatistics&, const DistanceStatistics&) = default;
};

/// Decides distances of triangle pairs under one pair of poses, exactly: corners, poses and
/// distances are taken as the rationals that they denote. The distance of two closed triangles is
/// the least distance of a point of one and a point of the other, in the world and in the job's
/// unit; a matrix that is not rigid changes it. Degenerate triangles are points and segments.
///
/// The triangles of each pair must share no point (see TrianglePairTest). Every answer depends only
/// on the two triangles, the poses and the argument `d`, a finite number that is not negative; no
/// answer depends on a stage or on earlier calls. Not thread-safe.
class TriangleDistance {
  public:
    /// Skips the stages before `first`, which changes no answer.
    explicit TriangleDistance(const PosePair& poses, DistanceStage first = DistanceStage::Float);
    TriangleDistance(TriangleDistance&&) noexcept;
    TriangleDistance& operator=(TriangleDistance&&) noexcept;
    ~TriangleDistance();

    /// Starts over with other poses and empty statistics, but keeps scratch memory.
    void restart(const PosePair& poses);

    /// Tests whether the distance is at most `d`; never uses stage Float.
    [[nodiscard]] bool is_within(const Corners& a, const Corners& b, double d);

    /// Returns the distance rounded to the nearest finite double, ties to even. It is positive
    /// unless the distance is at most half of the least denormal number.
    [[nodiscard]] double rounded(const Corners& a, const Corners& b);

    [[nodiscard]] NearestPoints nearest(const Corners& a, const Corners& b);

    /// Returns about the vector from the nearest point of A to that of B, in the world. Promises
    /// nothing: a search uses it to look at promising pairs first.
    [[nodiscard]] Vec3 displacement(const Corners& a, const Corners& b);

    /// Tests for each candidate of two bodies, each a TriangleSpan or TriangleBlocks, whether its
    /// distance is at most `d`. Returns a 1 or 0 per candidate, in order, valid until the next
    /// call. Many candidates in one call are much faster than one by one.
    template <class Triangles>
    [[nodiscard]] std::span<const std::uint8_t>
    within(const Triangles& a, const Triangles& b, std::span<const Candidate> candidates, double d);

    /// Returns the index of any candidate whose distance is at most `d`, or nothing if there is
    /// none. `Triangles` is TriangleSpan or TriangleBlocks. A candidate that a cheap stage proves
    /// saves testing the others.
    template <class Triangles>
    [[nodiscard]] std::optional<std::size_t> find_within(const Triangles& a,
                                                         const Triangles& b,
                                                         std::span<const Candidate> candidates,
                                                         double d);

    /// Numbers between which the distance of each candidate is, in order; 0 and infinity where
    /// nothing is proven.
    struct Bounds {
        std::span<const float> lower;
        std::span<const float> upper;
    };
    /// Returns bounds of the distance of each candidate in floats, valid until the next call.
    /// `Triangles` is TriangleSpan or TriangleBlocks.
    template <class Triangles>
    [[nodiscard]] Bounds
    bounds(const Triangles& a, const Triangles& b, std::span<const Candidate> candidates);

    [[nodiscard]] const DistanceStatistics& statistics() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace cd
