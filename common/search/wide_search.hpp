// The contact search over wide trees.
#pragma once

#include "common/search/contact_search.hpp"
#include "common/tree/wide/wide_descent.hpp"

#include <cstddef>
#include <optional>
#include <span>

namespace cd {

/// Searches wide trees. If earlier answers make a contact likely, `any` looks
/// at the most promising boxes first; else it begins with planes. So does `collect` if its last
/// call found none.
class WideSearch final : public ContactSearch {
  public:
    /// `ignored` must outlive the search.
    explicit WideSearch(const PosePair& poses,
                        std::span<const IgnoredRange> ignored = {},
                        const SearchOptions& options = {});

    void restart(const PosePair& poses) override;
    void ignore(std::span<const IgnoredRange> ignored) override;
    void set_clearance(double clearance) override;
    [[nodiscard]] bool any(const TreeView& a, const TreeView& b) override;
    [[nodiscard]] Nearness any_near(const TreeView& a, const TreeView& b) override;
    void collect(const TreeView& a, const TreeView& b) override;
    void find_nearest(const TreeView& a, const TreeView& b) override;
    [[nodiscard]] NearestFound& nearest() override;
    [[nodiscard]] FoundContacts& contacts() override { return contacts_; }
    [[nodiscard]] SearchReport report() const override;

  private:
    /// Finds near or nearest pairs. Other pairs are likely than for contacts, so this descent has
    /// its own memory of earlier poses.
    struct NearDescent {
        WideDescent descent;
        Mat3 rotation_a = Mat3::Identity();
        double reach_per_length = 1; ///< `body_reach` of the length 1.
        /// The poses of the last `restart`, until a nearest pair is wanted: of bodies that touch,
        /// none is.
        std::optional<PosePair> waiting = {};
    };

    [[nodiscard]] std::span<const Candidate>
    next_candidates(WideDescent& descent, const WideView& a, const WideView& b, std::size_t wanted);
    void place_near(const PosePair& poses);
    void begin_nearest();
    [[nodiscard]] double nearest_reach() const;
    void set_direction();
    void poll_stop();

    std::optional<double> clearance_;
    RelativePose b_to_a_;
    WideDescent descent_;             ///< Finds contacts.
    std::optional<NearDescent> near_; ///< Empty unless the options ask for near or nearest pairs.
    std::span<const IgnoredRange> ignored_;
    StopCheck stop_;
    FoundContacts contacts_;
    std::optional<NearestFound> nearest_; ///< Empty unless the options ask for it.
    bool expects_none_ = true; ///< The last call of `collect` found no pair; true at first.
    bool is_stopped_ = false;
};

} // namespace cd
