#include "common/geometry/short_lattice.hpp"

#include <cmath>

namespace cd {

namespace {

using wide_int::word_bits;
using wide_int::word_mask;

/// x is whole, if the result says so, and below 2^(bits_max(n) - 1): a sum of two is in reach.
template <std::size_t n>
bool convert(double x, WideInt<n>& whole) {
    // Doubles near the limit are whole; NaN fails here.
    constexpr double limit = n == 1 ? 0x1p57 : 0x1p117;
    if (!(std::abs(x) < limit)) {
        return false;
    }
    if constexpr (n == 1) {
        whole.word[0] = static_cast<std::int64_t>(x);
        return static_cast<double>(whole.word[0]) == x;
    } else {
        // Cut off, so that the rest has the digits that are left of x, and its sign.
        const auto high = static_cast<std::int64_t>(x * 0x1p-60);
        const double rest = x - static_cast<double>(high) * 0x1p60;
        const auto low = static_cast<std::int64_t>(rest);
        whole.word[0] = low & word_mask;
        whole.word[1] = high + (low >> word_bits);
        return static_cast<double>(low) == rest;
    }
}

template <std::size_t n>
WideInt<n> sum(const WideInt<n>& l, const WideInt<n>& r) {
    return wide_int::carried<n>(
        wide_int::Column{l.word[n - 1]} + r.word[n - 1],
        [&](std::size_t i) { return wide_int::Column{l.word[i]} + r.word[i]; });
}

} // namespace

ShortLattice::ShortLattice(const PosePair& poses)
    : translation_a_(poses.a.translation()), translation_b_(poses.b.translation()) {
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t k = 0; k < 3; ++k) {
            const double entry = poses.b.matrix()(static_cast<int>(row), static_cast<int>(k));
            if (entry != 0) {
                source_[row] = k;
                direction_[static_cast<int>(row)] = entry;
            }
        }
    }
}

void ShortLattice::set_unit(int lowest) {
    // Within these, a multiplication neither overflows nor rounds, but for numbers so small that
    // they are no multiples of the unit: those become other fractions, or 0, and must not.
    if (lowest >= -960 && lowest <= 960) {
        units_ = std::ldexp(1.0, -lowest);
    }
}

template <std::size_t n>
std::optional<LatticeCorners<n>> ShortLattice::corners(const Corners& a, const Corners& b) const {
    LatticeCorners<n> placed;
    bool fits = true;
    const auto convert_in_units = [&](double x, WideInt<n>& whole) {
        const double scaled = x * units_;
        fits = fits && convert<n>(scaled, whole) && (scaled != 0 || x == 0);
    };
    for (int k = 0; k < 3 && fits; ++k) {
        const auto axis = static_cast<std::size_t>(k);
        WideInt<n> of_a;
        WideInt<n> of_b;
        convert_in_units(translation_a_[k], of_a);
        convert_in_units(translation_b_[k], of_b);
        for (std::size_t i = 0; i < 3; ++i) {
            convert_in_units(a[i][k], placed[i][axis]);
            convert_in_units(b[i][static_cast<int>(source_[axis])] * direction_[k],
                             placed[3 + i][axis]);
            placed[i][axis] = sum(placed[i][axis], of_a);
            placed[3 + i][axis] = sum(placed[3 + i][axis], of_b);
        }
    }
    return fits ? std::optional(placed) : std::nullopt;
}

template std::optional<LatticeCorners<1>> ShortLattice::corners(const Corners&,
                                                                const Corners&) const;
template std::optional<LatticeCorners<2>> ShortLattice::corners(const Corners&,
                                                                const Corners&) const;

} // namespace cd
