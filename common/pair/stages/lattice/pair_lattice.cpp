#include "common/pair/stages/lattice/pair_lattice.hpp"

#include "common/pair/numbers/dyadic.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>

namespace cd {

namespace {

using wide_int::Column;
using wide_int::word_bits;
using wide_int::word_mask;

/// A nonzero double: mantissa * 2^exponent, odd mantissa.
struct Parts {
    std::int64_t mantissa = 0;
    int exponent = 0;
};

Parts parts_of(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    const auto biased = static_cast<int>(bits >> 52 & 0x7ff);
    const std::uint64_t fraction = bits & 0xf'ffff'ffff'ffff;
    const std::uint64_t whole = biased == 0 ? fraction : fraction | std::uint64_t{1} << 52;
    const int zeros = std::countr_zero(whole);
    const auto odd = static_cast<std::int64_t>(whole >> zeros);
    return {value < 0 ? -odd : odd, std::max(biased, 1) - 1075 + zeros};
}

int bits_of(std::int64_t value) {
    return static_cast<int>(std::bit_width(static_cast<std::uint64_t>(std::abs(value))));
}

template <std::size_t n>
using Columns = std::array<Column, n>;

/// Adds magnitude * factor * 2^shift for a magnitude of `size` words and a factor below 2^53. Drops
/// overflow past the last column: sums are modulo 2^(60 n). Each of the at most four sums that meet
/// in a column adds two products below 2^120 to it.
template <std::size_t n>
void add_shifted(Columns<n>& columns,
                 const std::int64_t* magnitude,
                 std::size_t size,
                 std::int64_t factor,
                 int shift) {
    const auto first = static_cast<std::size_t>(shift / word_bits);
    const Column moved = Column{factor} * (std::int64_t{1} << (shift % word_bits));
    const auto low = static_cast<std::int64_t>(moved) & word_mask;
    const auto high = static_cast<std::int64_t>(moved >> word_bits);
    for (std::size_t i = 0; i < size && first + i < n; ++i) {
        columns[first + i] += Column{magnitude[i]} * low;
        if (first + i + 1 < n) {
            columns[first + i + 1] += Column{magnitude[i]} * high;
        }
    }
}

/// Returns the number below 2^bits_max(n) that equals the sum of the columns modulo 2^(60 n).
template <std::size_t n>
WideInt<n> carried(const Columns<n>& columns) {
    WideInt<n> value =
        wide_int::carried<n>(columns[n - 1], [&](std::size_t i) { return columns[i]; });
    constexpr int unused = 64 - word_bits;
    const auto last = static_cast<std::uint64_t>(value.word[n - 1]) << unused;
    value.word[n - 1] = static_cast<std::int64_t>(last) >> unused;
    return value;
}

} // namespace

void PoseLattice::Range::add(int low, int past) {
    lowest = is_empty ? low : std::min(lowest, low);
    end = is_empty ? past : std::max(end, past);
    is_empty = false;
}

bool PoseLattice::assign(Number& number, Range& range, const Dyadic& value) {
    if (value.mantissa == 0) {
        return true;
    }
    ExactInt rest = abs(value.mantissa);
    const auto zeros = static_cast<int>(lsb(rest));
    rest >>= zeros;
    const auto bits = static_cast<int>(msb(rest)) + 1;
    if (bits > word_bits * static_cast<int>(Number::words_max)) {
        return false;
    }
    number.exponent = value.exponent + zeros;
    number.is_negative = value.mantissa < 0;
    for (; rest != 0; rest >>= word_bits) {
        number.word[number.size++] = static_cast<std::int64_t>(rest & word_mask);
    }
    range.add(number.exponent, number.exponent + bits);
    return true;
}

bool PoseLattice::assign(Body& body, const ExactPose& pose, const Dyadic& other_norm) {
    bool fits = true;
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t k = 0; k < 3; ++k) {
            fits = fits &&
                   assign(body.linear[row][k], body.columns[k], pose.linear[row][k] * other_norm);
        }
        fits = fits &&
               assign(body.translation[row], body.translations, pose.translation[row] * other_norm);
    }
    return fits;
}

PoseLattice::PoseLattice(const PosePair& poses) {
    const ExactPose a = to_exact(poses.a);
    const ExactPose b = to_exact(poses.b);
    fits_ = assign(bodies_[0], a, b.norm) && assign(bodies_[1], b, a.norm);
}

void PoseLattice::add(Range& range, const Body& body, const Corners& corners) {
    for (const Vec3& corner : corners) {
        for (std::size_t k = 0; k < 3; ++k) {
            const double x = corner[static_cast<int>(k)];
            if (x == 0 || body.columns[k].is_empty) {
                continue;
            }
            const Parts parts = parts_of(x);
            range.add(body.columns[k].lowest + parts.exponent,
                      body.columns[k].end + parts.exponent + bits_of(parts.mantissa));
        }
    }
    if (!body.translations.is_empty) {
        range.add(body.translations.lowest, body.translations.end);
    }
}

PoseLattice::Extent PoseLattice::extent_of(const Corners& a, const Corners& b) const {
    Range range;
    add(range, bodies_[0], a);
    add(range, bodies_[1], b);
    // A coordinate is a sum of four numbers of this range, which needs two more bits.
    return {range.lowest, range.end + 2 - range.lowest};
}

template <std::size_t n>
WideVec<n> PoseLattice::placed_in(const Body& body, const Vec3& corner, int lowest) {
    std::array<Parts, 3> x;
    for (std::size_t k = 0; k < 3; ++k) {
        const double value = corner[static_cast<int>(k)];
        x[k] = value == 0 ? Parts{} : parts_of(value);
    }
    WideVec<n> placed;
    for (std::size_t row = 0; row < 3; ++row) {
        Columns<n> columns{};
        for (std::size_t k = 0; k < 3; ++k) {
            const Number& m = body.linear[row][k];
            if (m.size != 0 && x[k].mantissa != 0) {
                add_shifted(columns,
                            m.word.data(),
                            m.size,
                            m.is_negative ? -x[k].mantissa : x[k].mantissa,
                            m.exponent + x[k].exponent - lowest);
            }
        }
        const Number& t = body.translation[row];
        if (t.size != 0) {
            add_shifted(
                columns, t.word.data(), t.size, t.is_negative ? -1 : 1, t.exponent - lowest);
        }
        placed[row] = carried(columns);
    }
    return placed;
}

template <std::size_t n>
void PoseLattice::place(const Corners& a,
                        const Corners& b,
                        const Extent& extent,
                        LatticeCorners<n>& placed) const {
    for (std::size_t i = 0; i < 3; ++i) {
        placed[i] = placed_in<n>(bodies_[0], a[i], extent.lowest);
        placed[3 + i] = placed_in<n>(bodies_[1], b[i], extent.lowest);
    }
}

template void
PoseLattice::place(const Corners&, const Corners&, const Extent&, LatticeCorners<1>&) const;
template void
PoseLattice::place(const Corners&, const Corners&, const Extent&, LatticeCorners<2>&) const;
template void
PoseLattice::place(const Corners&, const Corners&, const Extent&, LatticeCorners<3>&) const;
template void
PoseLattice::place(const Corners&, const Corners&, const Extent&, LatticeCorners<4>&) const;
template void
PoseLattice::place(const Corners&, const Corners&, const Extent&, LatticeCorners<5>&) const;
template void
PoseLattice::place(const Corners&, const Corners&, const Extent&, LatticeCorners<6>&) const;
template void
PoseLattice::place(const Corners&, const Corners&, const Extent&, LatticeCorners<8>&) const;
template void
PoseLattice::place(const Corners&, const Corners&, const Extent&, LatticeCorners<16>&) const;

} // namespace cd
