// The pairs that a search finds, from the exact decision of its candidates to sorted pairs.
#pragma once

#include "common/distance/triangle_distance.hpp"
#include "common/geometry/pose.hpp"
#include "common/pair/triangle_pair.hpp"
#include "common/search/contact_pair.hpp"
#include "common/search/search_options.hpp"
#include "common/tree/query_statistics.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace cd {

/// Decides candidates, counts the contacts and near pairs among them, and keeps the pairs that the
/// options ask for. Keeps scratch memory between scenarios; one thread at a time may use an
/// instance.
class FoundContacts {
  public:
    FoundContacts(const PosePair& poses, const SearchOptions& options);

    /// Forgets all pairs, and decides later candidates under `poses`.
    void restart(const PosePair& poses);

    /// Replaces the clearance of the options, which have one, for later candidates.
    void set_clearance(double clearance) { options_.clearance = clearance; }

    /// Decides candidates of two bodies, each a TriangleSpan or TriangleBlocks, and adds the
    /// contacts and near pairs. `ids_a` and `ids_b` map the candidates' indices to triangles of the
    /// meshes.
    template <class Triangles>
    void add(const Triangles& a,
             std::span<const std::uint32_t> ids_a,
             const Triangles& b,
             std::span<const std::uint32_t> ids_b,
             std::span<const Candidate> candidates);

    /// Returns the position of a candidate pair that touches, if there is one; adds no contact.
    template <class Triangles>
    [[nodiscard]] std::optional<std::size_t>
    find_touch(const Triangles& a, const Triangles& b, std::span<const Candidate> candidates) {
        triangle_tests_ += candidates.size();
        return test_.find_touch(a, b, candidates);
    }

    /// A candidate that is near or touches.
    struct NearCandidate {
        std::size_t index;
        bool touches;
    };
    /// Returns a candidate within the options' clearance, if there is one: one that touches, if any
    /// of these does. Adds no pair.
    template <class Triangles>
    [[nodiscard]] std::optional<NearCandidate>
    find_near(const Triangles& a, const Triangles& b, std::span<const Candidate> candidates) {
        if (const auto touching = find_touch(a, b, candidates)) {
            return NearCandidate{*touching, true};
        }
        const auto near = distance_->find_within(a, b, candidates, *options_.clearance);
        return near ? std::optional(NearCandidate{*near, false}) : std::nullopt;
    }

    /// Returns the number of added contacts, kept or not.
    [[nodiscard]] std::uint64_t count() const { return count_; }
    /// Returns the number of added near pairs, kept or not.
    [[nodiscard]] std::uint64_t near_count() const { return near_count_; }
    /// Returns whether any added contact is proper.
    [[nodiscard]] bool has_proper() const { return has_proper_; }

    /// Returns how many pairs are kept at most, as the options say.
    [[nodiscard]] std::uint64_t pairs_max() const { return options_.pairs_max; }

    /// Sorts the pairs, each with its corners, and keeps the first `pairs_max`.
    void sort();

    /// Returns the kept pairs: in the order found, or ascending once `sort` was called.
    [[nodiscard]] const std::vector<ContactPair>& pairs() const { return pairs_; }
    /// Moves the pairs to the caller; `corners()` stays.
    [[nodiscard]] std::vector<ContactPair> take_pairs();
    /// Returns the corners of each kept pair, in the pairs' order; empty unless the options keep
    /// corners.
    [[nodiscard]] const std::vector<PairCorners>& corners() const { return corners_; }

    /// Returns the pair test under the current poses, which also computes shared points.
    [[nodiscard]] TrianglePairTest& test() { return test_; }
    /// Returns the distances under the current poses. The options have a clearance.
    [[nodiscard]] TriangleDistance& distance() { return *distance_; }

    /// Returns the statistics of this object's decisions, together with the search's `box_tests`.
    [[nodiscard]] QueryStatistics statistics(std::uint64_t box_tests) const {
        return {box_tests, triangle_tests_, test_.statistics()};
    }

  private:
    template <class Triangles>
    [[nodiscard]] std::span<const std::uint8_t> near_among(const Triangles& a,
                                                           const Triangles& b,
                                                           std::span<const Candidate> candidates,
                                                           std::span<const PairClass> kinds);
    /// Counts a pair that touches or is near, and returns whether it is to be kept.
    [[nodiscard]] bool count_pair(PairClass kind);

    SearchOptions options_;
    TrianglePairTest test_;
    std::optional<TriangleDistance> distance_; ///< Empty without a clearance.
    std::vector<Candidate> separate_;          ///< Scratch memory of `near_among`.
    std::vector<ContactPair> pairs_;
    std::vector<PairCorners> corners_;
    PairSorter sorter_;
    std::uint64_t count_ = 0;
    std::uint64_t near_count_ = 0;
    std::uint64_t triangle_tests_ = 0;
    bool has_proper_ = false;
};

} // namespace cd
