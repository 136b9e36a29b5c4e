#include "common/search/found_contacts.hpp"

#include "common/geometry/triangle_blocks.hpp"

#include <algorithm>
#include <utility>

namespace cd {

namespace {

/// Below this number of pairs, neither sorting early nor returning memory pays.
constexpr std::size_t kept_at_least = 1u << 16;

} // namespace

FoundContacts::FoundContacts(const PosePair& poses, const SearchOptions& options)
    : options_(options), test_(poses, options.first_stage, options.decision) {}

void FoundContacts::restart(const PosePair& poses) {
    test_.restart(poses);
    if (corners_.capacity() > kept_at_least) {
        corners_ = {};
    }
    pairs_.clear();
    corners_.clear();
    count_ = 0;
    triangle_tests_ = 0;
    has_proper_ = false;
}

template <class Triangles>
void FoundContacts::add(const Triangles& a,
                        std::span<const std::uint32_t> ids_a,
                        const Triangles& b,
                        std::span<const std::uint32_t> ids_b,
                        std::span<const Candidate> candidates) {
    triangle_tests_ += candidates.size();
    const auto kinds = test_.classify(a, b, candidates);
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        if (kinds[i] == PairClass::Separate) {
            continue;
        }
        ++count_;
        has_proper_ = has_proper_ || kinds[i] == PairClass::Proper;
        if (has_proper_ && options_.only_touches) {
            pairs_.clear();
            continue;
        }
        if (!options_.keep_pairs) {
            continue;
        }
        const Candidate& found = candidates[i];
        pairs_.push_back({ids_a[found.a], ids_b[found.b], kinds[i]});
        if (options_.keep_corners) {
            corners_.push_back({a.corners_at(found.a), b.corners_at(found.b)});
        }
    }
    // Sorting drops the surplus pairs. Sorts are so rare that they cost little compared to the
    // search.
    if (pairs_.size() / 2 > options_.pairs_max && pairs_.size() > kept_at_least) {
        sort();
    }
}

template void FoundContacts::add(const TriangleSpan&,
                                 std::span<const std::uint32_t>,
                                 const TriangleSpan&,
                                 std::span<const std::uint32_t>,
                                 std::span<const Candidate>);
template void FoundContacts::add(const TriangleBlocks&,
                                 std::span<const std::uint32_t>,
                                 const TriangleBlocks&,
                                 std::span<const std::uint32_t>,
                                 std::span<const Candidate>);

std::vector<ContactPair> FoundContacts::take_pairs() {
    if (pairs_.capacity() > kept_at_least) {
        return std::exchange(pairs_, {});
    }
    std::vector<ContactPair> taken(pairs_.begin(), pairs_.end());
    pairs_.clear();
    return taken;
}

void FoundContacts::sort() {
    const std::size_t kept =
        static_cast<std::size_t>(std::min<std::uint64_t>(pairs_.size(), options_.pairs_max));
    if (options_.keep_corners) {
        sorter_.sort(pairs_, corners_);
        corners_.resize(kept);
    } else {
        sorter_.sort(pairs_);
    }
    pairs_.resize(kept);
}

} // namespace cd
