#include "common/scene/sweep_kernel.hpp"

#include "common/core/check.hpp"
#include "common/geometry/highway_targets.hpp"

#include <bit>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "common/scene/sweep_kernel.cpp"
#include <hwy/foreach_target.h>
// Everything below is compiled for every target.
#include <hwy/highway.h>

#ifndef CD_COMMON_SCENE_SWEEP_KERNEL_CPP
#define CD_COMMON_SCENE_SWEEP_KERNEL_CPP

namespace cd {

/// For each byte, the places of its bits that are set, ascending, then zeros.
inline constexpr auto lanes_of_bits = [] {
    std::array<std::array<std::int32_t, 8>, 256> table{};
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        std::size_t count = 0;
        for (std::int32_t lane = 0; lane < 8; ++lane) {
            if ((byte >> lane & 1) != 0) {
                table[byte][count++] = lane;
            }
        }
    }
    return table;
}();

} // namespace cd

#endif

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, sweep_padding>;
using Numbers = hn::RebindToUnsigned<Floats>;

constexpr std::size_t lanes = hn::MaxLanes(Floats());

/// One box in all lanes.
struct BroadBox {
    HWY_INLINE BroadBox(const SweepColumns& boxes, std::uint32_t at)
        : low_1(hn::Set(Floats(), boxes.low[1][at])),
          high_1(hn::Set(Floats(), boxes.high[1][at])),
          low_2(hn::Set(Floats(), boxes.low[2][at])),
          high_2(hn::Set(Floats(), boxes.high[2][at])) {}

    /// Returns which boxes from `at` on overlap this one on axes 1 and 2.
    HWY_INLINE hn::Mask<Floats> overlaps(const SweepColumns& boxes, std::uint32_t at) const {
        const Floats d;
        const auto on_1 = hn::And(hn::Le(hn::LoadU(d, boxes.low[1] + at), high_1),
                                  hn::Ge(hn::LoadU(d, boxes.high[1] + at), low_1));
        const auto on_2 = hn::And(hn::Le(hn::LoadU(d, boxes.low[2] + at), high_2),
                                  hn::Ge(hn::LoadU(d, boxes.high[2] + at), low_2));
        return hn::And(on_1, on_2);
    }

    hn::Vec<Floats> low_1;
    hn::Vec<Floats> high_1;
    hn::Vec<Floats> low_2;
    hn::Vec<Floats> high_2;
};

HWY_INLINE std::uint32_t bits_of(hn::Mask<Floats> mask) {
    std::array<std::uint8_t, 8> bytes{}; // Highway may write eight.
    hn::StoreMaskBits(Floats(), mask, bytes.data());
    std::uint16_t bits = 0;
    std::memcpy(&bits, bytes.data(), sizeof(bits));
    return bits;
}

/// Writes the numbers in the lanes of the bits, one behind the other. Other numbers may follow
/// them, `lanes` in all. Returns how many they are.
HWY_INLINE std::size_t write_some(hn::Vec<Numbers> numbers, std::uint32_t bits, std::uint32_t* to) {
    const Numbers dn;
    if constexpr (lanes <= 8) {
        // GCC 12 copies the table of Highway's CompressStore to the stack at each call.
        const auto order = hn::SetTableIndices(dn, lanes_of_bits[bits].data());
        hn::StoreU(hn::TableLookupLanes(numbers, order), dn, to);
    } else {
        // Highway may read eight bytes. A compressing store is microcode on AMD's Zen 4.
        const std::array<std::uint8_t, 8> bytes{static_cast<std::uint8_t>(bits),
                                                static_cast<std::uint8_t>(bits >> 8)};
        hn::StoreU(hn::Compress(numbers, hn::LoadMaskBits(dn, bytes.data())), dn, to);
    }
    return static_cast<std::size_t>(std::popcount(bits));
}

/// Compares the box at `row` with those of `others` from `first` on. Whether a block of boxes has a
/// hit is hard to predict. So the first loop only notes the blocks that have one, without a branch,
/// each as its place and 16 bits for its hits. The second loop, which takes few blocks, writes
/// them.
HWY_INLINE std::size_t write_row(const SweepColumns& rows,
                                 std::uint32_t row,
                                 const SweepColumns& others,
                                 std::uint32_t first,
                                 std::uint32_t* blocks,
                                 std::uint32_t* keys) {
    const Floats d;
    const Numbers dn;
    const BroadBox box(rows, row);
    const float end = rows.high[0][row];
    std::size_t noted = 0;
    for (std::uint32_t at = first; others.low[0][at] <= end;
         at += static_cast<std::uint32_t>(lanes)) {
        const std::uint32_t hits = bits_of(box.overlaps(others, at));
        blocks[noted] = at << 16 | hits;
        noted += hits != 0 ? 1 : 0;
    }
    if (noted == 0) {
        return 0;
    }
    // Of all blocks the last one alone can have boxes that begin after the end.
    std::uint32_t& last = blocks[noted - 1];
    const auto begins = hn::Le(hn::LoadU(d, others.low[0] + (last >> 16)), hn::Set(d, end));
    last &= 0xFFFF0000u | bits_of(begins);
    const auto body = hn::Set(dn, rows.body[row]);
    std::size_t count = 0;
    for (std::size_t i = 0; i < noted; ++i) {
        const auto bodies = hn::LoadU(dn, others.body + (blocks[i] >> 16));
        const auto pairs = hn::Or(hn::ShiftLeft<16>(hn::Min(body, bodies)), hn::Max(body, bodies));
        count += write_some(pairs, blocks[i] & 0xFFFFu, keys + count);
    }
    return count;
}

std::size_t overlaps(const SweepColumns& rows,
                     const SweepColumns& others,
                     SweepFrom from,
                     SweepPlace& place,
                     std::uint32_t* blocks,
                     std::span<std::uint32_t> keys) {
    const std::size_t row_keys = others.count + sweep_padding;
    std::size_t count = 0;
    SweepPlace at = place;
    for (; at.row < rows.count && keys.size() - count >= row_keys; ++at.row) {
        const float begin = rows.low[0][at.row];
        // Both loops end at the padding, with which no number compares.
        if (from == SweepFrom::Next) {
            at.first = at.row + 1;
        } else if (from == SweepFrom::Equal) {
            for (; others.low[0][at.first] < begin; ++at.first) {
            }
        } else {
            for (; others.low[0][at.first] <= begin; ++at.first) {
            }
        }
        count += write_row(rows, at.row, others, at.first, blocks, keys.data() + count);
    }
    place = at;
    return count;
}

} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cd {

namespace {

HWY_EXPORT(overlaps);

} // namespace

std::size_t write_overlaps(const SweepColumns& rows,
                           const SweepColumns& others,
                           SweepFrom from,
                           SweepPlace& place,
                           std::span<std::uint32_t> blocks,
                           std::span<std::uint32_t> keys) {
    CD_CHECK(blocks.size() >= others.count + sweep_padding);
    return HWY_DYNAMIC_DISPATCH(overlaps)(rows, others, from, place, blocks.data(), keys);
}

} // namespace cd
#endif
