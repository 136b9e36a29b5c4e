// Decides whether and how two posed triangles meet. No other code decides contacts.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/geometry/types.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

namespace cd {

/// How two closed triangles meet (docs/formats.md, Classes).
enum class PairClass : std::uint8_t {
    Separate = 0, ///< No shared point.
    Touch = 1, ///< Shared points, but neither Coplanar nor Proper; the only contact that degenerate
               ///< triangles have.
    Coplanar = 2, ///< In one plane, overlapping with positive area.
    Proper = 3,   ///< Not coplanar, and the relative interiors share a point.
    Near = 4,     ///< No shared point, but at most the query's clearance apart. Never an answer of
                  ///< `TrianglePairTest`.
};

/// The stages of the decision, roughly cheapest first (docs/exactness.md). A stage proves an answer
/// or gives none.
enum class PairStage : std::uint8_t {
    Float = 0,   ///< Floats with an error bound, one pair per SIMD lane.
    Double = 1,  ///< Doubles with an error bound.
    Lattice = 2, ///< Integers of a fixed number of words, for bodies without relative rotation.
    DoubleDouble = 3, ///< Numbers of two doubles with an error bound, for rotated bodies.
    WideInteger = 4,  ///< Integers of a fixed number of words, for any poses.
    Arbitrary = 5,    ///< Integers of any size: exact on every input.
};
inline constexpr std::size_t pair_stage_count = 6;

[[nodiscard]] std::string_view to_text(PairStage stage);

/// How far a pair's decision goes.
enum class PairDecision : std::uint8_t {
    Exact,
    FloatsOnly, ///< Pairs that floats leave open count as touching, which is often wrong. For
                ///< measuring what the exact answer costs.
};

/// Counts the pairs that each stage decided. A pair that needs several stages counts for the last.
/// Calls with few candidates skip stage Float, which costs as much for a few as for many.
struct PairStatistics {
    std::array<std::uint64_t, pair_stage_count> settled{};

    [[nodiscard]] std::uint64_t& operator[](PairStage stage) {
        return settled[static_cast<std::size_t>(stage)];
    }
    [[nodiscard]] std::uint64_t operator[](PairStage stage) const {
        return settled[static_cast<std::size_t>(stage)];
    }
    [[nodiscard]] std::uint64_t total() const;
    PairStatistics& operator+=(const PairStatistics& other);

    friend bool operator==(const PairStatistics&, const PairStatistics&) = default;
};

/// A view of all or some triangles of a body, in the body's coordinates.
struct TriangleSpan {
    std::span<const Vec3> vertices;
    std::span<const Triangle> triangles;

    [[nodiscard]] Corners corners_at(std::uint32_t place) const {
        const Triangle& t = triangles[place];
        return {vertices[t[0]], vertices[t[1]], vertices[t[2]]};
    }
};

/// A pair that may touch: a triangle of A and one of B, as an index into a TriangleSpan or a slot
/// of TriangleBlocks.
struct Candidate {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
};

/// Decides triangle pairs under one pair of poses, exactly: corners and poses are taken as the
/// rationals that they denote. Degenerate triangles are points and segments.
///
/// Every answer depends only on the two triangles and the poses, not on earlier calls. Not
/// thread-safe.
class TrianglePairTest {
  public:
    /// Skips the stages before `first`, which changes no answer.
    explicit TrianglePairTest(const PosePair& poses,
                              PairStage first = PairStage::Float,
                              PairDecision decision = PairDecision::Exact);
    TrianglePairTest(TrianglePairTest&&) noexcept;
    TrianglePairTest& operator=(TrianglePairTest&&) noexcept;
    ~TrianglePairTest();

    /// Starts over with other poses and empty statistics, but keeps scratch memory.
    void restart(const PosePair& poses);

    /// Classifies one pair; never uses stage Float.
    [[nodiscard]] PairClass classify(const Corners& a, const Corners& b);

    /// Classifies the candidates of two bodies, each a TriangleSpan or TriangleBlocks. Returns a
    /// class per candidate, in order, valid until the next call. Many candidates in one call are
    /// much faster than one by one.
    template <class Triangles>
    [[nodiscard]] std::span<const PairClass>
    classify(const Triangles& a, const Triangles& b, std::span<const Candidate> candidates);

    /// Returns the index of any touching candidate, or nothing if none touches. `Triangles` is
    /// TriangleSpan or TriangleBlocks. A contact that a cheap stage proves saves testing the other
    /// candidates.
    template <class Triangles>
    [[nodiscard]] std::optional<std::size_t>
    find_touch(const Triangles& a, const Triangles& b, std::span<const Candidate> candidates);

    /// Receives a pair's origin and shared points, which are valid during the call.
    using PointReceiver = std::function<void(const Vec3& origin, std::span<const Vec3> points)>;

    /// Passes to `receive`, for each pair in order, an origin, which is the first corner of A in
    /// the world, and the corners of the set of shared points, relative to that origin. Both are
    /// correctly rounded: see SharedPoints.
    void shared_points(std::span<const PairCorners> pairs, const PointReceiver& receive);

    [[nodiscard]] const PairStatistics& statistics() const;

  private:
    struct State;
    /// Classifies the candidates that floats leave open; `ties` are their indices, in ascending
    /// order.
    template <class Triangles>
    void classify_ties(const Triangles& a,
                       const Triangles& b,
                       std::span<const Candidate> candidates,
                       std::span<const std::size_t> ties);

    std::unique_ptr<State> state_;
};

} // namespace cd
