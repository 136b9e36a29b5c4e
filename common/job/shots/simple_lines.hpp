// Tells lines whose hits need no further decision from others.
#pragma once

#include "common/core/limits/engine.hpp"
#include "common/job/shots/equal_depths.hpp"
#include "common/job/shots/passes.hpp"
#include "common/job/shots/settled_hits.hpp"
#include "common/job/shots/stable_order.hpp"
#include "common/search/found_contacts.hpp"
#include "common/search/subtree_pair.hpp"
#include "common/shots/line_hit.hpp"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace cd {

/// Settles the hits of lines all of whose depths are known and differ, unless equal ones are on
/// triangles with the same corners. Keeps scratch memory between scenarios.
class SimpleLines {
  public:
    /// Selects the hits of a scenario, and the pairs of subtrees that they refer to.
    void restart(const Passes& passes, std::span<const SubtreePair> pairs);

    /// Returns the hits of simple lines, with `only_first` the first of each. Moves those of other
    /// lines, and of lines that `found` has a pair of, to `found`. Counts in `moved` how many it
    /// moves. Call it once after `restart`.
    [[nodiscard]] SettledHits settle(FoundContacts& found, bool only_first, std::uint64_t& moved);

  private:
    static constexpr std::uint32_t none = EqualDepths::none;

    struct Line {
        std::uint32_t first = none; ///< Index of its first hit, if that is asked for.
        bool is_simple = true;
    };

    /// Two groups on triangles with the same corners: a later and an earlier one.
    struct Coincident {
        std::size_t group = 0; ///< The first group is never the later one.
        std::size_t earlier = 0;
    };

    /// A hit with its triangle and the side of the triangle that the line enters.
    struct Placed {
        std::uint32_t hit = 0;     ///< Its index.
        std::uint32_t of_side = 0; ///< 2 * the triangle, + 1 if the hit is on its back.

        static_assert(limits::mesh_triangles_max <= std::uint64_t{1} << 31);
        [[nodiscard]] std::uint32_t triangle() const { return of_side >> 1; }
        [[nodiscard]] std::uint8_t flags() const {
            return hit_flag::crosses | ((of_side & 1) != 0 ? hit_flag::back : hit_flag::front);
        }
    };

    void find_open(const FoundContacts& found);
    void open(std::uint32_t line);
    [[nodiscard]] bool is_at_one_place(std::size_t group, std::size_t earlier);
    void find_first();
    void move_open(FoundContacts& found, std::uint64_t& moved);
    void put_in_order();
    [[nodiscard]] SettledHits sorted(bool only_first);
    void keep_settled(bool only_first);
    [[nodiscard]] std::size_t sort_triangle(SettledHits& settled, std::size_t of);

    const Passes* passes_ = nullptr;
    std::span<const SubtreePair> pairs_;
    std::vector<Line> lines_;         ///< By index in the mesh.
    std::vector<std::uint32_t> open_; ///< Lines that are not simple.
    Coincident coincident_;           ///< Those found last.
    EqualDepths equal_;
    StableOrder order_;
    std::vector<std::uint32_t> triangles_; ///< By group.
    std::vector<Placed> in_order_;         ///< By triangle.
    std::vector<std::size_t>
        disordered_; ///< Settled hits that precede, in order, the hit before them.
    std::vector<std::pair<std::uint32_t, PairHit>> by_line_; ///< Hits of one triangle.
    std::vector<Candidate> moving_;
};

} // namespace cd
