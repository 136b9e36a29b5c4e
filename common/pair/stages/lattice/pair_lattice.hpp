// A pair's corners in the world as integers on one lattice, whatever the poses.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/pair/stages/integer/integer_signs.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace cd {

struct Dyadic;
struct ExactPose;

/// Two poses as integers times powers of two. As for every exact stage, both worlds are scaled by
/// the norms of both quaternions, which changes no sign.
class PoseLattice {
  public:
    explicit PoseLattice(const PosePair& poses);

    /// False when the poses' numbers have more digits than there is room for; then nothing below
    /// may be called.
    [[nodiscard]] bool fits() const { return fits_; }

    /// Where the lattice of a pair lies: its unit is 2^lowest, and the coordinates of all corners
    /// are below 2^bits units.
    struct Extent {
        int lowest = 0;
        int bits = 0;
    };
    [[nodiscard]] Extent extent_of(const Corners& a, const Corners& b) const;

    /// The corners in units of the lattice; extent.bits is at most bits_max(n).
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
    /// (-1)^is_negative * (sum of word[i] 2^(60 i)) * 2^exponent, odd but for zero.
    struct Number {
        static constexpr std::size_t words_max = 8;
        std::array<std::int64_t, words_max> word{};
        std::size_t size = 0; ///< Words in use: 0 for zero.
        int exponent = 0;
        bool is_negative = false;
    };
    /// Exponents of numbers that are not zero: multiples of 2^lowest, below 2^end.
    struct Range {
        int lowest = 0;
        int end = 0;
        bool is_empty = true;

        void add(int low, int past);
    };
    struct Body {
        std::array<std::array<Number, 3>, 3> linear; ///< By row.
        std::array<Number, 3> translation;
        std::array<Range, 3> columns; ///< Of the linear part.
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
