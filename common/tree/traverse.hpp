// Finds the contacts of two trees: simultaneous descent, then the exact decision.
#pragma once

#include "common/geometry/triangle_pair.hpp"
#include "common/tree/obb_tree.hpp"

#include <compare>
#include <cstdint>
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

[[nodiscard]] bool is_ignored(std::span<const IgnoredRange> ignored, std::uint32_t a, std::uint32_t b);

/// One scenario's search. Subtrees of A and B are handed in pair by pair; what they hold in contact
/// gathers in `pairs`. Keeps scratch memory between calls; one thread at a time.
class ContactSearch {
  public:
    ContactSearch(const PosePair& poses, std::span<const IgnoredRange> ignored);

    /// True as soon as any two triangles under the two roots touch.
    [[nodiscard]] bool any(const TreeView& a, const TreeView& b);

    /// Adds every contact under the two roots to `pairs`, unsorted. With `corners_wanted`, the
    /// corners of each found pair are kept beside it, for shared points.
    void collect(const TreeView& a, const TreeView& b);

    [[nodiscard]] std::vector<ContactPair>& pairs() { return pairs_; }
    [[nodiscard]] TrianglePairTest& test() { return test_; }
    [[nodiscard]] QueryStatistics statistics() const;

  private:
    PosePair poses_;
    RelativePose relative_;
    std::span<const IgnoredRange> ignored_;
    TrianglePairTest test_;
    std::vector<ContactPair> pairs_;
    std::vector<std::uint64_t> stack_;
    QueryStatistics statistics_;
};

} // namespace cd
