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

#if HWY_TARGET == HWY_SCALAR // Vectors of the scalar target have one lane, too small for a word.

void sum_run(const WeightedRoot* roots,
             std::size_t count,
             const std::uint64_t* words,
             std::size_t stride,
             std::uint16_t* out) {
    std::fill_n(out, 64, std::uint16_t{0});
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint64_t word = words[roots[i].root * stride];
        for (std::size_t slot = 0; slot < 64; ++slot) {
            const std::uint64_t bit = word >> (16 * (slot % 4) + slot / 4) & 1;
            out[slot] = static_cast<std::uint16_t>(out[slot] + bit * roots[i].weight);
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

/// Returns for each slot the bit that the slot tests. Slots are lanes, counted through all vectors.
/// Every four lanes hold one word as four quarters of sixteen bits, and slot p tests bit p / 4 of
/// quarter p % 4. Therefore slot p belongs to column 16 (p % 4) + p / 4 of the word.
HWY_INLINE std::array<V, vectors> bits_of_slots() {
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

/// Writes to each slot p of `out` the sum of weights of all roots r whose word `words[r * stride]`
/// has the bit of column 16 (p % 4) + p / 4. All weights together fit sixteen bits.
void sum_run(const WeightedRoot* HWY_RESTRICT roots,
             std::size_t count,
             const std::uint64_t* HWY_RESTRICT words,
             std::size_t stride,
             std::uint16_t* HWY_RESTRICT out) {
    const Lanes d;
    const std::array<V, vectors> bits = bits_of_slots();
    std::array<V, vectors> sums;
    sums.fill(hn::Zero(d));
    for (std::size_t i = 0; i < count; ++i) {
        // Words without a bit are not skipped: the branch is unpredictable, and a misprediction
        // costs more than the additions.
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

/// Returns the length of the longest prefix of `roots` whose weights together fit sixteen bits.
std::size_t run_length(std::span<const WeightedRoot> roots) {
    std::uint32_t left = run_weight_max;
    std::size_t count = 0;
    while (count < roots.size() && roots[count].weight <= left) {
        left -= roots[count].weight;
        ++count;
    }
    return count;
}

/// Adds one root of any weight, without SIMD.
void add_heavy(const WeightedRoot& root,
               const std::uint64_t* rows,
               std::size_t row_words,
               std::span<std::uint64_t> sums) {
    const std::uint64_t* row = rows + root.root * row_words;
    for (std::size_t column = 0; column < 64 * row_words; ++column) {
        sums[column] += (row[column / 64] >> column % 64 & 1) * root.weight;
    }
}

/// Adds roots whose weights together fit sixteen bits.
void add_run(std::span<const WeightedRoot> run,
             const std::uint64_t* rows,
             std::size_t row_words,
             std::span<std::uint64_t> sums) {
    alignas(64) std::array<std::uint16_t, 64> held;
    for (std::size_t word = 0; word < row_words; ++word) {
        HWY_DYNAMIC_DISPATCH(sum_run)(run.data(), run.size(), rows + word, row_words, held.data());
        std::uint64_t* const out = sums.data() + 64 * word;
        for (std::size_t quarter = 0; quarter < 4; ++quarter) {
            for (std::size_t bit = 0; bit < 16; ++bit) {
                out[16 * quarter + bit] += held[4 * bit + quarter];
            }
        }
    }
}

} // namespace

void add_row_sums(std::span<const WeightedRoot> roots,
                  const std::uint64_t* rows,
                  std::size_t row_words,
                  std::span<std::uint64_t> sums) {
    while (!roots.empty()) {
        const std::size_t count = run_length(roots);
        if (count == 0) {
            add_heavy(roots.front(), rows, row_words, sums);
            roots = roots.subspan(1);
            continue;
        }
        add_run(roots.first(count), rows, row_words, sums);
        roots = roots.subspan(count);
    }
}

} // namespace cd
#endif
