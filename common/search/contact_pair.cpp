#include "common/search/contact_pair.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/engine.hpp"

#include <hwy/contrib/sort/vqsort.h>

#include <algorithm>
#include <utility>

namespace cd {

namespace {

constexpr unsigned kind_bits = 2;
constexpr unsigned index_bits = 31;
static_assert(limits::mesh_triangles_max <= std::uint64_t{1} << index_bits);

/// Packs a pair into a key; keys compare like their pairs.
std::uint64_t key_of(const ContactPair& pair) {
    return (std::uint64_t{pair.a} << index_bits | pair.b) << kind_bits |
           static_cast<std::uint64_t>(pair.kind);
}

ContactPair pair_of(std::uint64_t key) {
    const std::uint64_t indices = key >> kind_bits;
    return {static_cast<std::uint32_t>(indices >> index_bits),
            static_cast<std::uint32_t>(indices & ((std::uint64_t{1} << index_bits) - 1)),
            static_cast<PairClass>(key & ((1u << kind_bits) - 1))};
}

} // namespace

struct PairSorter::Scratch {
    hwy::Sorter sorter;
    std::vector<std::uint64_t> keys;
    std::vector<std::pair<std::uint64_t, std::size_t>>
        order; ///< Each key with its index before the sort.
    std::vector<PairCorners> corners;
};

PairSorter::PairSorter() : scratch_(std::make_unique<Scratch>()) {}
PairSorter::PairSorter(PairSorter&&) noexcept = default;
PairSorter& PairSorter::operator=(PairSorter&&) noexcept = default;
PairSorter::~PairSorter() = default;

void PairSorter::sort(std::vector<ContactPair>& pairs) {
    std::vector<std::uint64_t>& keys = scratch_->keys;
    keys.resize(pairs.size());
    std::transform(pairs.begin(), pairs.end(), keys.begin(), key_of);
    scratch_->sorter(keys.data(), keys.size(), hwy::SortAscending());
    std::transform(keys.begin(), keys.end(), pairs.begin(), pair_of);
}

void PairSorter::sort(std::vector<ContactPair>& pairs, std::vector<PairCorners>& corners) {
    CD_CHECK(pairs.size() == corners.size());
    Scratch& s = *scratch_;
    s.order.clear();
    for (const ContactPair& pair : pairs) {
        s.order.emplace_back(key_of(pair), s.order.size());
    }
    std::sort(s.order.begin(), s.order.end());
    s.corners.clear();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        pairs[i] = pair_of(s.order[i].first);
        s.corners.push_back(corners[s.order[i].second]);
    }
    corners.swap(s.corners);
}

} // namespace cd
