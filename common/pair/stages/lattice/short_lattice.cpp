#include "common/pair/stages/lattice/short_lattice.hpp"

#include "common/pair/numbers/two_doubles.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace cd {

namespace {

using wide_int::word_bits;
using wide_int::word_mask;

/// A number in lattice units has at most this many bits, so that a sum of two fits n words.
template <std::size_t n>
constexpr int bits_of_number = wide_int::bits_max(n) - 1;

double largest_of(const Vec3& v) {
    return std::max(std::max(std::abs(v.x()), std::abs(v.y())), std::abs(v.z()));
}

double power_of_two(int exponent) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

/// Converts numbers up to `largest` to a lattice, and records whether all lie on it.
template <std::size_t n>
class Converter {
  public:
    explicit Converter(double largest) {
        const auto biased = static_cast<int>(std::bit_cast<std::uint64_t>(largest) >> 52);
        // |x| < 2^(biased - 1022), also for denormal numbers. The exponent is limited so that
        // powers are doubles; for tiny numbers the lattice is thus coarser than it could be.
        exponent_ = std::max(biased - 1022 - bits_of_number<n>, -1000);
        units_ = power_of_two(-exponent_);
        unit_ = power_of_two(exponent_);
    }

    /// Converts x to whole units; |x| <= `largest` keeps the casts defined. Converting back tells
    /// if x is on the lattice. (The product is exact unless denormal; the test holds then, too.)
    WideInt<n> operator()(double x) {
        const double scaled = x * units_;
        WideInt<n> whole;
        if constexpr (n == 1) {
            whole.word[0] = static_cast<std::int64_t>(scaled);
            missed_ += std::abs(static_cast<double>(whole.word[0]) * unit_ - x);
        } else {
            // Truncates, so that the rest has x's remaining digits and its sign.
            const auto high = static_cast<std::int64_t>(scaled * 0x1p-60);
            const double rest = scaled - static_cast<double>(high) * 0x1p60;
            const auto low = static_cast<std::int64_t>(rest);
            whole.word[0] = low & word_mask;
            whole.word[1] = high + (low >> word_bits);
            missed_ += std::abs(static_cast<double>(low) - rest) + std::abs(scaled * unit_ - x);
        }
        return whole;
    }

    [[nodiscard]] bool is_exact() const { return missed_ == 0; }

  private:
    int exponent_ = 0;
    double units_ = 1;  ///< 2^-exponent_: lattice units in 1.
    double unit_ = 1;   ///< 2^exponent_: the lattice's unit.
    double missed_ = 0; ///< Sum of the errors of all conversions; 0 if all were exact.
};

template <std::size_t n>
WideInt<n> sum(const WideInt<n>& l, const WideInt<n>& r) {
    if constexpr (n == 1) {
        return {{l.word[0] + r.word[0]}};
    } else {
        const std::int64_t low = l.word[0] + r.word[0];
        return {{low & word_mask, l.word[1] + r.word[1] + (low >> word_bits)}};
    }
}

} // namespace

ShortLattice::ShortLattice(const PosePair& poses)
    : translation_a_(poses.a.translation()),
      translation_b_(poses.b.translation()),
      largest_translation_(std::max(largest_of(translation_a_), largest_of(translation_b_))) {
    for (int row = 0; row < 3; ++row) {
        for (int k = 0; k < 3; ++k) {
            const double entry = poses.b.matrix()(row, k);
            if (entry != 0) {
                source_[static_cast<std::size_t>(row)] = k;
                direction_[row] = entry;
            }
        }
    }
}

template <std::size_t n>
bool ShortLattice::place(const Corners& a, const Corners& b, LatticeCorners<n>& placed) const {
    static_assert(n == 1 || n == 2);
    TwoDoubles largest_of_both{largest_translation_, largest_translation_};
    for (std::size_t i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
            const TwoDoubles x = two_doubles::magnitudes(TwoDoubles{a[i][k], b[i][k]});
            largest_of_both = x > largest_of_both ? x : largest_of_both;
        }
    }
    const double largest = std::max(largest_of_both[0], largest_of_both[1]);
    Converter<n> in_units(largest);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int k = static_cast<int>(axis);
        for (std::size_t i = 0; i < 3; ++i) {
            placed[i][axis] = in_units(a[i][k]);
            placed[3 + i][axis] = in_units(b[i][source_[axis]] * direction_[k]);
        }
    }
    if (largest_translation_ != 0) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const WideInt<n> of_a = in_units(translation_a_[static_cast<int>(axis)]);
            const WideInt<n> of_b = in_units(translation_b_[static_cast<int>(axis)]);
            for (std::size_t i = 0; i < 3; ++i) {
                placed[i][axis] = sum(placed[i][axis], of_a);
                placed[3 + i][axis] = sum(placed[3 + i][axis], of_b);
            }
        }
    }
    return in_units.is_exact();
}

template bool ShortLattice::place(const Corners&, const Corners&, LatticeCorners<1>&) const;
template bool ShortLattice::place(const Corners&, const Corners&, LatticeCorners<2>&) const;

} // namespace cd
