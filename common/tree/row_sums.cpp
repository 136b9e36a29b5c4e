#include "common/tree/row_sums.hpp"

#include "common/geometry/highway_targets.hpp"

#include <algorithm>
#include <array>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "common/tree/row_sums.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR // Its vectors have one lane, which no word fits in.

void sum_run(const WeightedRoot* roots,
             std::size_t count,
             const std::uint64_t* words,
             std::size_t stride,
             std::uint16_t* out) {
    std::fill_n(out, 64, std::uint16_t{0});
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint64_t word = words[roots[i].root * stride];
        for (std::size_t place = 0; place < 64; ++place) {
            const std::uint64_t bit = word >> (16 * (place % 4) + place / 4) & 1;
            out[place] = static_cast<std::uint16_t>(out[place] + bit * roots[i].weight);
        }
    }
}

#else

namespace hn = hwy::HWY_NAMESPACE;

using Lanes = hn::ScalableTag<std::uint16_t>;
using Words = hn::Repartition<std::uint64_t, Lanes>;
using V = hn::Vec<Lanes>;

constexpr std::size_t lanes = hn::MaxLanes(Lanes());
constexpr std::size_t vectors = 64 / lanes;

/// A word stands four times sixteen bits in each four lanes; place p (lane and vector in one) looks
/// at bit p / 4 of the quarter p % 4, which is column 16 (p % 4) + p / 4.
HWY_INLINE std::array<V, vectors> bits_of_places() {
    std::array<V, vectors> bits;
    for (std::size_t i = 0; i < vectors; ++i) {
        alignas(64) std::array<std::uint16_t, lanes> values;
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            values[lane] = static_cast<std::uint16_t>(1u << ((i * lanes + lane) / 4));
        }
        bits[i] = hn::Load(Lanes(), values.data());
    }
    return bits;
}

/// Sums by place. The weights together fit sixteen bits.
void sum_run(const WeightedRoot* HWY_RESTRICT roots,
             std::size_t count,
             const std::uint64_t* HWY_RESTRICT words,
             std::size_t stride,
             std::uint16_t* HWY_RESTRICT out) {
    const Lanes d;
    const std::array<V, vectors> bits = bits_of_places();
    std::array<V, vectors> sums;
    sums.fill(hn::Zero(d));
    for (std::size_t i = 0; i < count; ++i) {
        // Words without a bit are not left out: whether there is one cannot be foretold, and a
        // wrong guess costs more than the additions.
        const V all = hn::BitCast(d, hn::Set(Words(), words[roots[i].root * stride]));
        const V weight = hn::Set(d, static_cast<std::uint16_t>(roots[i].weight));
        for (std::size_t v = 0; v < vectors; ++v) {
            sums[v] = hn::Add(sums[v], hn::IfThenElseZero(hn::TestBit(all, bits[v]), weight));
        }
    }
    for (std::size_t v = 0; v < vectors; ++v) {
        hn::Store(sums[v], d, out + v * lanes);
    }
}

#endif

} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cd {

namespace {

HWY_EXPORT(sum_run);

constexpr std::uint32_t run_weight_max = 0xffff;

/// How many roots from the first on weigh no more together than a run may.
std::size_t run_length(std::span<const WeightedRoot> roots) {
    std::uint32_t left = run_weight_max;
    std::size_t count = 0;
    while (count < roots.size() && roots[count].weight <= left) {
        left -= roots[count].weight;
        ++count;
    }
    return count;
}

void add_heavy(std::uint32_t weight, std::uint64_t word, std::span<std::uint64_t, 64> sums) {
    for (std::size_t column = 0; column < 64; ++column) {
        sums[column] += (word >> column & 1) * weight;
    }
}

} // namespace

void add_row_sums(std::span<const WeightedRoot> roots,
                  const std::uint64_t* words,
                  std::size_t stride,
                  std::span<std::uint64_t, 64> sums) {
    alignas(64) std::array<std::uint16_t, 64> held;
    while (!roots.empty()) {
        const std::size_t count = run_length(roots);
        if (count == 0) {
            add_heavy(roots.front().weight, words[roots.front().root * stride], sums);
            roots = roots.subspan(1);
            continue;
        }
        HWY_DYNAMIC_DISPATCH(sum_run)(roots.data(), count, words, stride, held.data());
        for (std::size_t place = 0; place < 64; ++place) {
            sums[16 * (place % 4) + place / 4] += held[place];
        }
        roots = roots.subspan(count);
    }
}

} // namespace cd
#endif
