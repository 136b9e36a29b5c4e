// Hits of bundles of parallel lines, proven in doubles and double-double, many at a time.
#pragma once

#include "common/core/host/stop_check.hpp"
#include "common/geometry/pose.hpp"
#include "common/job/shots/settled_hits.hpp"
#include "common/search/found_contacts.hpp"
#include "common/search/subtree_pair.hpp"
#include "common/tree/ignored_range.hpp"
#include "common/tree/query_statistics.hpp"

#include <cstdint>
#include <memory>
#include <span>

namespace cd {

/// Finds the hits of one scenario whose bundles are of parallel lines, as far as that is simple:
/// lines that pass through the inside of each triangle they meet, at depths that round apart unless
/// two triangles have the same corners. All others are left to `SegmentHit`. Keeps scratch memory
/// between scenarios.
class BundleShots {
  public:
    BundleShots();
    BundleShots(BundleShots&&) noexcept;
    BundleShots& operator=(BundleShots&&) noexcept;
    ~BundleShots();

    /// Starts a scenario. Without depths, hits are only counted. `ignored` outlives the scenario.
    void restart(const PosePair& poses, std::span<const IgnoredRange> ignored, bool needs_depths);

    /// What `collect` has done.
    enum class Collected : std::uint8_t {
        All,     ///< All hits are either counted here or in `found`.
        None,    ///< Nothing: the poses, the trees or the lines do not suit.
        Stopped, ///< Some; the rest is not known.
    };
    /// Finds the hits under a pair of subtrees, which live until the scenario's end. Decides pairs
    /// that doubles leave open in `found`, under the same poses, and adds the contacts to it.
    [[nodiscard]] Collected
    collect(const SubtreePair& pair, FoundContacts& found, const StopCheck& stop);

    /// Returns the number of hits of `collect` that are not in `found`.
    [[nodiscard]] std::uint64_t count() const;

    /// Moves hits to `found` that need SegmentHit: all of a line of which `found` has a contact, of
    /// which a depth is unknown, or of which two depths of different triangles round alike. Returns
    /// the others; with `only_first`, the first one of each line. Call it once, after `collect`
    /// with depths, and only if `count` is at most `found.pairs_max()`: further hits are not kept.
    [[nodiscard]] SettledHits settle(FoundContacts& found, bool only_first);

    /// Returns the statistics since `restart`.
    [[nodiscard]] QueryStatistics statistics() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace cd
