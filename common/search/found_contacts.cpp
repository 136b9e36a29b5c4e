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
    : options_(options), test_(poses, options.first_stage, options.decision) {
    if (options.clearance) {
        distance_.emplace(poses, distance_stage(options.first_stage));
    }
}

void FoundContacts::restart(const PosePair& poses) {
    test_.restart(poses);
    if (distance_) {
        distance_->restart(poses);
    }
    if (corners_.capacity() > kept_at_least) {
        corners_ = {};
    }
    pairs_.clear();
    corners_.clear();
    count_ = 0;
    near_count_ = 0;
    triangle_tests_ = 0;
    has_proper_ = false;
}

/// Returns for each candidate of class Separate, in order, whether it is within the clearance; none
/// without a clearance.
template <class Triangles>
std::span<const std::uint8_t> FoundContacts::near_among(const Triangles& a,
                                                        const Triangles& b,
                                                        std::span<const Candidate> candidates,
                                                        std::span<const PairClass> kinds) {
    if (!distance_) {
        return {};
    }
    separate_.clear();
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        if (kinds[i] == PairClass::Separate) {
            separate_.push_back(candidates[i]);
        }
    }
    return distance_->within(a, b, separate_, *options_.clearance);
}

bool FoundContacts::count_pair(PairClass kind) {
    if (kind == PairClass::Near) {
        ++near_count_;
        return options_.keep_pairs && !options_.only_touches;
    }
    ++count_;
    has_proper_ = has_proper_ || kind == PairClass::Proper;
    if (has_proper_ && options_.only_touches) {
        pairs_.clear();
        return false;
    }
    return options_.keep_pairs;
}

template <class Triangles>
void FoundContacts::add(const Triangles& a,
                        std::span<const std::uint32_t> ids_a,
                        const Triangles& b,
                        std::span<const std::uint32_t> ids_b,
                        std::span<const Candidate> candidates) {
    triangle_tests_ += candidates.size();
    const auto kinds = test_.classify(a, b, candidates);
    const auto near = near_among(a, b, candidates, kinds);
    std::size_t next_separate = 0;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        PairClass kind = kinds[i];
        if (kind == PairClass::Separate) {
            if (near.empty() || near[next_separate++] == 0) {
                continue;
            }
            kind = PairClass::Near;
        }
        if (!count_pair(kind)) {
            continue;
        }
        const Candidate& found = candidates[i];
        pairs_.push_back({ids_a[found.a], ids_b[found.b], kind});
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
