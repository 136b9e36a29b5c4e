// The contact search over binary trees.
#pragma once

#include "common/geometry/aabb.hpp"
#include "common/search/contact_search.hpp"
#include "common/tree/box_test.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace cd {

/// Searches binary trees, for bodies that a wide tree cannot hold.
class BinarySearch final : public ContactSearch {
  public:
    /// `ignored` must outlive the search.
    explicit BinarySearch(const PosePair& poses,
                          std::span<const IgnoredRange> ignored = {},
                          const SearchOptions& options = {});

    void restart(const PosePair& poses) override;
    void ignore(std::span<const IgnoredRange> ignored) override;
    void set_clearance(double clearance) override;
    [[nodiscard]] bool any(const TreeView& a, const TreeView& b) override;
    [[nodiscard]] Nearness any_near(const TreeView& a, const TreeView& b) override;
    void collect(const TreeView& a, const TreeView& b) override;
    void find_nearest(const TreeView& a, const TreeView& b) override;
    [[nodiscard]] NearestFound& nearest() override { return *nearest_; }
    [[nodiscard]] FoundContacts& contacts() override { return contacts_; }
    [[nodiscard]] SearchReport report() const override;

  private:
    struct NodePair {
        std::uint32_t a;
        std::uint32_t b;
    };
    /// The relative pose of the current scenario, and the data that box tests derive from it.
    struct Placement {
        RelativePose b_to_a;
        BoxTest boxes;
        BoxTest near_boxes;      ///< Counts boxes within the clearance as overlapping.
        double reach_per_length; ///< `body_reach` of the length 1.

        Placement(const PosePair& poses, const std::optional<double>& clearance);
    };
    /// Findings and counters of the search since the last `restart()`.
    struct Progress {
        std::uint64_t box_tests = 0;
        std::uint32_t steps_unpolled = 0; ///< Steps of the descent since the last call of `stop_`.
        bool is_stopped = false;
    };

    template <class OnLeaves>
    bool
    descend(const BoxTest& boxes, const TreeView& a, const TreeView& b, const OnLeaves& on_leaves);
    [[nodiscard]] bool must_stop();
    void add_candidates(const BoxTest& boxes,
                        const TreeView& a,
                        const TreeView& b,
                        const NodePair& leaves);
    [[nodiscard]] bool decide_any(const TreeView& a, const TreeView& b);
    [[nodiscard]] Nearness decide_near(const TreeView& a, const TreeView& b);
    void decide_candidates(const TreeView& a, const TreeView& b);
    void narrow(const TreeView& a, const TreeView& b);

    StopCheck stop_;
    std::optional<double> clearance_;
    std::span<const IgnoredRange> ignored_;
    Placement placement_;
    Progress progress_;
    FoundContacts contacts_;
    std::optional<NearestFound> nearest_; ///< Empty unless the options ask for it.
    std::vector<NodePair> stack_;
    std::vector<Aabb> bounds_;          ///< Boxes of one leaf's triangles of B, in A's coordinates.
    std::vector<Candidate> candidates_; ///< Triangle pairs to be decided, by index in the trees.
};

} // namespace cd
