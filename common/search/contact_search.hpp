// Finds the contacts of two bodies: simultaneous descent of their trees, then the exact decision.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/search/contact_pair.hpp"
#include "common/search/found_contacts.hpp"
#include "common/search/nearest_found.hpp"
#include "common/search/search_options.hpp"
#include "common/tree/ignored_range.hpp"
#include "common/tree/obb_tree.hpp"
#include "common/tree/query_statistics.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace cd {

/// Statistics and flags of a search since its last `restart`.
struct SearchReport {
    QueryStatistics statistics;
    bool is_stopped = false;              ///< True: a stop ended the search early.
    const RelativePose* b_to_a = nullptr; ///< The relative pose, valid until the next `restart`.
};

/// How near the nearest pair that a search found is.
enum class Nearness : std::uint8_t {
    Far,     ///< No pair is within the clearance.
    Near,    ///< The pair found is within the clearance and shares no point.
    Contact, ///< The pair found shares a point.
};

/// Searches one scenario after another. After a few scenarios the search allocates no memory where
/// both trees are wide and doubles decide all pairs. Callers pass subtrees of A and B pair by pair;
/// any number of searches may share subtrees. One thread at a time may use a search.
///
/// The decision of a pair is exact, and boxes never reject a touching pair. So the contacts depend
/// neither on how the trees are cut into subtrees nor on the form of the trees.
class ContactSearch {
  public:
    virtual ~ContactSearch() = default;

    /// Starts a search under other poses. Keeps scratch memory, and the last answer of `any`, which
    /// the next call of `any` expects again.
    virtual void restart(const PosePair& poses) = 0;

    /// Replaces the ignored ranges for what follows; call `restart` afterwards. They outlive the
    /// search, or are replaced.
    virtual void ignore(std::span<const IgnoredRange> ignored) = 0;

    /// Replaces the clearance for what follows; call `restart` afterwards. The options have a
    /// clearance.
    virtual void set_clearance(double clearance) = 0;

    /// Returns whether any triangle of `a` touches a triangle of `b`. Adds nothing to `contacts()`.
    /// A search may expect its last answer again and try the likely boxes first, so the statistics
    /// depend on earlier calls, but the answer never does.
    [[nodiscard]] virtual bool any(const TreeView& a, const TreeView& b) = 0;

    /// Looks for any triangle of `a` that is within the clearance of a triangle of `b`, and says
    /// how near the first pair found is. If it is Near, other pairs may touch. The options have a
    /// clearance. Otherwise like `any`.
    [[nodiscard]] virtual Nearness any_near(const TreeView& a, const TreeView& b) = 0;

    /// Adds every contact of `a` and `b` to `contacts()`, and with a clearance every near pair.
    virtual void collect(const TreeView& a, const TreeView& b) = 0;

    /// Finds the nearest pair of `a` and `b`, unless `nearest()` has a nearer one already. No
    /// triangles of the bodies touch.
    virtual void find_nearest(const TreeView& a, const TreeView& b) = 0;

    /// Returns the nearest pair of all calls of `find_nearest` since the last `restart`.
    [[nodiscard]] virtual NearestFound& nearest() = 0;

    /// Returns the contacts of all calls of `collect` since the last `restart`.
    [[nodiscard]] virtual FoundContacts& contacts() = 0;

    [[nodiscard]] virtual SearchReport report() const = 0;
};

/// Returns a WideSearch if both bodies have a wide tree, else a BinarySearch. All trees passed to
/// the search must have the same form. `ignored` must outlive the search, unless it is replaced.
[[nodiscard]] std::unique_ptr<ContactSearch> make_search(const TreeView& a,
                                                         const TreeView& b,
                                                         const PosePair& poses,
                                                         std::span<const IgnoredRange> ignored = {},
                                                         const SearchOptions& options = {});

/// Returns all contact pairs of two whole trees, sorted.
[[nodiscard]] std::vector<ContactPair>
contact_pairs(const ObbTree& a, const ObbTree& b, const PosePair& poses);

} // namespace cd
