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
    [[nodiscard]] bool any(const TreeView& a, const TreeView& b) override;
    [[nodiscard]] Nearness any_near(const TreeView& a, const TreeView& b) override;
    void collect(const TreeView& a, const TreeView& b) override;
    [[nodiscard]] FoundContacts& contacts() override { return contacts_; }
    [[nodiscard]] SearchReport report() const override;

  private:
    [[nodiscard]] std::span<const Candidate> next_candidates(WideDescent& descent,
                                                             const WideView& a,
                                                             const WideView& b,
                                                             std::size_t wanted);
    void poll_stop();

    std::optional<double> clearance_;
    RelativePose b_to_a_;
    WideDescent descent_; ///< Finds contacts.
    /// Finds pairs within the clearance; empty without one. Other pairs are likely than for
    /// contacts, so this descent has its own memory of earlier poses.
    std::optional<WideDescent> near_descent_;
    std::span<const IgnoredRange> ignored_;
    StopCheck stop_;
    FoundContacts contacts_;
    bool expects_none_ = true; ///< The last call of `collect` found no pair; true at first.
    bool is_stopped_ = false;
};

} // namespace cd
