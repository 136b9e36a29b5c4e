#include "common/search/contact_pair.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/engine.hpp"

#include <hwy/contrib/sort/vqsort.h>

#include <algorithm>
#include <utility>

namespace cd {

namespace {

constexpr unsigned kind_bits = 2;
constexpr unsigned place_bits = 31;
static_assert(limits::mesh_triangles_max <= std::uint64_t{1} << place_bits);

/// Two bits hold the class: no pair is Separate, so Near takes its number. Each pair occurs once,
/// so classes never decide the order.
constexpr std::uint64_t kind_mask = (1u << kind_bits) - 1;
static_assert((static_cast<std::uint64_t>(PairClass::Near) & kind_mask) ==
              static_cast<std::uint64_t>(PairClass::Separate));

/// Packs a pair into a key; keys compare like their pairs.
std::uint64_t key_of(const ContactPair& pair) {
    return (std::uint64_t{pair.a} << place_bits | pair.b) << kind_bits |
           (static_cast<std::uint64_t>(pair.kind) & kind_mask);
}

ContactPair pair_of(std::uint64_t key) {
    const std::uint64_t places = key >> kind_bits;
    const auto kind = static_cast<PairClass>(key & kind_mask);
    return {static_cast<std::uint32_t>(places >> place_bits),
            static_cast<std::uint32_t>(places & ((std::uint64_t{1} << place_bits) - 1)),
            kind == PairClass::Separate ? PairClass::Near : kind};
}

} // namespace

struct PairSorter::Scratch {
    hwy::Sorter sorter;
    std::vector<std::uint64_t> keys;
    std::vector<std::pair<std::uint64_t, std::size_t>>
        places; ///< Each key with its index before the sort.
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
    s.places.clear();
    for (const ContactPair& pair : pairs) {
        s.places.emplace_back(key_of(pair), s.places.size());
    }
    std::sort(s.places.begin(), s.places.end());
    s.corners.clear();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        pairs[i] = pair_of(s.places[i].first);
        s.corners.push_back(corners[s.places[i].second]);
    }
    corners.swap(s.corners);
}

} // namespace cd
