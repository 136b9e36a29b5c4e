// Finds the contacts of two trees: simultaneous descent, then the exact decision.
#pragma once

#include "common/geometry/triangle_pair.hpp"
#include "common/tree/box_test.hpp"
#include "common/tree/obb_tree.hpp"

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// Triangles `a` of A and `b` of B that share a point, by their places in their meshes.
struct ContactPair {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    PairClass kind = PairClass::Touch;

    friend auto operator<=>(const ContactPair&, const ContactPair&) = default;
};

/// The paper's N_b and N_p (section 3), and how the pairs were decided.
struct QueryStatistics {
    std::uint64_t box_tests = 0;
    std::uint64_t triangle_tests = 0;
    PairStatistics decisions;

    QueryStatistics& operator+=(const QueryStatistics& other);
};

/// Pairs of triangle ids that are to be passed over: a in [a_begin, a_end) with b in its range.
struct IgnoredRange {
    std::uint32_t a_begin = 0;
    std::uint32_t a_end = 0;
    std::uint32_t b_begin = 0;
    std::uint32_t b_end = 0;

    friend bool operator==(const IgnoredRange&, const IgnoredRange&) = default;
};

[[nodiscard]] bool
is_ignored(std::span<const IgnoredRange> ignored, std::uint32_t a, std::uint32_t b);

/// The corners of one found pair, each in its body's coordinates.
struct PairCorners {
    Corners a;
    Corners b;
};

/// One scenario's search. Subtrees of A and B are handed in pair by pair; what they hold in contact
/// gathers in `pairs`. Keeps scratch memory between calls; one thread at a time.
///
/// The decision of a pair is exact and boxes never reject a touching pair, so what is found does
/// not depend on how the trees were cut into subtrees.
class ContactSearch {
  public:
    /// `ignored` outlives the search. With `keep_corners`, the corners of each found pair are kept
    /// beside it, for shared points: the subtrees may be gone by then.
    ContactSearch(const PosePair& poses,
                  std::span<const IgnoredRange> ignored,
                  bool keep_corners = false);

    /// True as soon as any two triangles under the two roots touch. Adds nothing to `pairs`.
    [[nodiscard]] bool any(const TreeView& a, const TreeView& b);

    /// Adds every contact under the two roots to `pairs`.
    void collect(const TreeView& a, const TreeView& b);

    /// Sorts the pairs, each with its corners.
    void sort();

    /// As found, until sorted.
    [[nodiscard]] std::vector<ContactPair>& pairs() { return pairs_; }
    /// One for each of `pairs` if they were to be kept, else none.
    [[nodiscard]] std::vector<PairCorners>& corners() { return corners_; }
    [[nodiscard]] TrianglePairTest& test() { return test_; }
    [[nodiscard]] QueryStatistics statistics() const;

  private:
    struct NodePair {
        std::uint32_t a;
        std::uint32_t b;
    };

    template <class OnLeaves>
    bool descend(const TreeView& a, const TreeView& b, const OnLeaves& on_leaves);
    template <class OnPair>
    bool visit_leaves(const TreeView& a,
                      const TreeView& b,
                      const NodePair& leaves,
                      const OnPair& on_pair);

    BoxTest boxes_;
    std::span<const IgnoredRange> ignored_;
    bool keep_corners_;
    TrianglePairTest test_;
    std::vector<ContactPair> pairs_;
    std::vector<PairCorners> corners_;
    std::vector<NodePair> stack_;
    std::vector<Aabb> bounds_; ///< Of the triangles of one leaf of B, as A sees them.
    std::uint64_t box_tests_ = 0;
    std::uint64_t triangle_tests_ = 0;
};

/// All contact pairs of two whole trees, sorted.
[[nodiscard]] std::vector<ContactPair>
contact_pairs(const ObbTree& a, const ObbTree& b, const PosePair& poses);

} // namespace cd
