// Whether and how two posed triangles meet: the one place that decides contacts.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/geometry/types.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

namespace cd {

struct TriangleBlocks;

/// How two closed triangles meet (NUMERICS, section 1).
enum class PairClass : std::uint8_t {
    Separate = 0, ///< No shared point.
    Touch = 1,    ///< Shared points, but neither of the two below; always so with a degenerate one.
    Coplanar = 2, ///< In one plane, overlapping with positive area.
    Proper = 3,   ///< Not coplanar, and the relative interiors share a point.
};

/// The stages of the decision, cheapest first (NUMERICS, section 2). Each gives proofs only.
enum class PairStage : std::uint8_t {
    Float = 0,   ///< Floats with an error bound, as many pairs at once as the processor takes.
    Double = 1,  ///< Doubles with an error bound.
    Lattice = 2, ///< Integers of a fixed number of words: neither body rotated against the other.
    DoubleDouble = 3, ///< Pairs of doubles with an error bound: rotated bodies.
    WideInteger = 4,  ///< Integers of a fixed number of words, whatever the poses.
    Arbitrary = 5,    ///< Integers of any size: exact on every input.
};
inline constexpr std::size_t pair_stage_count = 6;

[[nodiscard]] std::string_view to_text(PairStage stage);

/// How many pairs each stage settled: a pair counts for the highest stage that it needed. Calls
/// with but a few candidates pass over floats, which take as long for a few as for many.
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

/// The triangles of a body, or of a part of it, in its own coordinates.
struct TriangleSpan {
    std::span<const Vec3> vertices;
    std::span<const Triangle> triangles;

    [[nodiscard]] Corners corners(std::uint32_t place) const {
        const Triangle& t = triangles[place];
        return {vertices[t[0]], vertices[t[1]], vertices[t[2]]};
    }
};

/// A triangle of A and one of B, by their places in their spans or blocks, that may touch.
struct Candidate {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
};

/// Decides triangle pairs under one pair of poses, exactly: the corners and the poses' numbers are
/// taken as the rationals that they denote. Degenerate triangles are points and segments.
///
/// Every answer depends on the two triangles and the poses alone, not on what was asked before.
/// Not for use by two threads at once.
class TrianglePairTest {
  public:
    /// Stages before `first` are passed over; the answers are the same whatever it is.
    explicit TrianglePairTest(const PosePair& poses, PairStage first = PairStage::Float);
    TrianglePairTest(TrianglePairTest&&) noexcept;
    TrianglePairTest& operator=(TrianglePairTest&&) noexcept;
    ~TrianglePairTest();

    /// As if made anew with other poses, but keeps scratch memory.
    void restart(const PosePair& poses);

    /// The class of one pair, from stage Double on.
    [[nodiscard]] PairClass classify(const Corners& a, const Corners& b);

    /// The class of each candidate, in their order; valid until the next call. Much faster for many
    /// at once than one by one: very few begin with stage Double.
    [[nodiscard]] std::span<const PairClass>
    classify(const TriangleSpan& a, const TriangleSpan& b, std::span<const Candidate> candidates);
    [[nodiscard]] std::span<const PairClass> classify(const TriangleBlocks& a,
                                                      const TriangleBlocks& b,
                                                      std::span<const Candidate> candidates);

    /// The place of some candidate that touches, if any does; what the cheap stages prove spares
    /// the others.
    [[nodiscard]] std::optional<std::size_t>
    find_touch(const TriangleSpan& a, const TriangleSpan& b, std::span<const Candidate> candidates);
    [[nodiscard]] std::optional<std::size_t> find_touch(const TriangleBlocks& a,
                                                        const TriangleBlocks& b,
                                                        std::span<const Candidate> candidates);

    /// The corners of the set of shared points of two triangles, correctly rounded, relative to
    /// `point_origin(a)`: see SharedPoints. Valid until the next call.
    [[nodiscard]] std::span<const Vec3> shared_points(const Corners& a, const Corners& b);

    /// The first corner of A in the world, correctly rounded: what shared points are relative to.
    [[nodiscard]] Vec3 point_origin(const Corners& a);

    [[nodiscard]] const PairStatistics& statistics() const;

  private:
    struct State;
    template <class Triangles>
    std::span<const PairClass>
    classify_all(const Triangles& a, const Triangles& b, std::span<const Candidate> candidates);
    /// The classes of those candidates that floats leave open.
    template <class Triangles>
    void classify_ties(const Triangles& a,
                       const Triangles& b,
                       std::span<const Candidate> candidates,
                       std::span<const std::size_t> ties);
    template <class Triangles>
    std::optional<std::size_t>
    find_any_touch(const Triangles& a, const Triangles& b, std::span<const Candidate> candidates);

    std::unique_ptr<State> state_;
};

} // namespace cd
