#include "worker/execution/joined_searches.hpp"

#include "common/core/limits/worker.hpp"

#include <algorithm>

namespace cd {

ScenarioRun
JoinedSearch::run(const Scenario& scenario, const Query& query, const RunOptions& options) {
    stop_ = options.stop;
    RunOptions with_own_stop = options;
    with_own_stop.stop = [this] { return stop_ && stop_(); };
    SubtreePair whole;
    whole.a.wide = trees_.first.lock()->view();
    whole.b.wide = trees_.second.lock()->view();
    ScenarioRun run = run_on_subtrees(kept_, {&whole, 1}, scenario, query, with_own_stop);
    stop_ = nullptr;
    return run;
}

std::unique_ptr<JoinedSearch> JoinedSearches::take(const Tree& a, const Tree& b) {
    const std::lock_guard lock(mutex_);
    const auto found = std::find_if(
        kept_.rbegin(), kept_.rend(), [&](const auto& search) { return search->is_of(a, b); });
    if (found == kept_.rend()) {
        return std::make_unique<JoinedSearch>(a, b);
    }
    std::unique_ptr<JoinedSearch> search = std::move(*found);
    kept_.erase(std::next(found).base());
    return search;
}

void JoinedSearches::give_back(std::unique_ptr<JoinedSearch> search) {
    const std::lock_guard lock(mutex_);
    std::erase_if(kept_, [](const auto& kept) { return kept->has_lost_a_tree(); });
    if (kept_.size() == limits::joined_searches_max) {
        kept_.erase(kept_.begin());
    }
    kept_.push_back(std::move(search));
}

} // namespace cd
