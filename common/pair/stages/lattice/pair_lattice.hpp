// A pair's world corners as integers on one lattice, for any poses.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/pair/stages/integer/integer_signs.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace cd {

struct Dyadic;
struct ExactPose;

/// Two poses as integers times powers of two. As in every exact stage, both norms of quaternions
/// scale both worlds, which changes no sign.
class PoseLattice {
  public:
    explicit PoseLattice(const PosePair& poses);

    /// Returns false if the poses have too many digits; then no method below may be called.
    [[nodiscard]] bool fits() const { return fits_; }

    /// The lattice of a pair: its unit is 2^lowest, and all corners' |coordinates| are below 2^bits
    /// units.
    struct Extent {
        int lowest = 0;
        int bits = 0;
    };
    [[nodiscard]] Extent extent_of(const Corners& a, const Corners& b) const;

    /// Converts the corners to lattice units; extent.bits must be at most bits_max(n).
    template <std::size_t n>
    void place(const Corners& a,
               const Corners& b,
               const Extent& extent,
               LatticeCorners<n>& placed) const;

    template <std::size_t n>
    [[nodiscard]] LatticeCorners<n>
    corners(const Corners& a, const Corners& b, const Extent& extent) const {
        LatticeCorners<n> placed;
        place(a, b, extent, placed);
        return placed;
    }

  private:
    /// (-1)^is_negative * (sum of word[i] 2^(60 i)) * 2^exponent. The sum is odd unless 0.
    struct Number {
        static constexpr std::size_t words_max = 8;
        std::array<std::int64_t, words_max> word{};
        std::size_t size = 0; ///< Number of words in use: 0 for zero.
        int exponent = 0;
        bool is_negative = false;
    };
    /// Bounds nonzero numbers: all are multiples of 2^lowest, with magnitudes below 2^end.
    struct Range {
        int lowest = 0;
        int end = 0;
        bool is_empty = true;

        void add(int low, int past);
    };
    struct Body {
        std::array<std::array<Number, 3>, 3> linear; ///< Row-major.
        std::array<Number, 3> translation;
        std::array<Range, 3> columns; ///< Ranges of the linear part's columns.
        Range translations;
    };

    [[nodiscard]] static bool assign(Number& number, Range& range, const Dyadic& value);
    [[nodiscard]] static bool assign(Body& body, const ExactPose& pose, const Dyadic& other_norm);
    static void add(Range& range, const Body& body, const Corners& corners);
    template <std::size_t n>
    static WideVec<n> placed_in(const Body& body, const Vec3& corner, int lowest);

    std::array<Body, 2> bodies_;
    bool fits_ = false;
};

} // namespace cd
