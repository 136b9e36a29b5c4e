#include "common/search/wide_search.hpp"

#include "common/core/check.hpp"
#include "common/tree/wide/candidates_at_once.hpp"

#include <algorithm>

namespace cd {

WideSearch::WideSearch(const PosePair& poses,
                       std::span<const IgnoredRange> ignored,
                       const SearchOptions& options)
    : b_to_a_(relative_pose(poses)),
      descent_(b_to_a_),
      ignored_(ignored),
      stop_(options.stop),
      contacts_(poses, options) {}

void WideSearch::restart(const PosePair& poses) {
    b_to_a_ = relative_pose(poses);
    descent_.restart(b_to_a_);
    contacts_.restart(poses);
    is_stopped_ = false;
}

void WideSearch::poll_stop() {
    is_stopped_ = stop_ && stop_();
}

/// Returns the next candidates without ignored pairs.
std::span<const Candidate>
WideSearch::next_candidates(const WideView& a, const WideView& b, std::size_t wanted) {
    std::span<Candidate> found = descent_.next(wanted);
    if (!ignored_.empty()) {
        const auto rest = std::ranges::remove_if(found, [&](const Candidate& pair) {
            return is_ignored(ignored_, a.triangles.ids[pair.a], b.triangles.ids[pair.b]);
        });
        found = found.first(found.size() - rest.size());
    }
    return found;
}

bool WideSearch::any(const TreeView& a, const TreeView& b) {
    CD_CHECK(!a.wide.nodes.empty() && !b.wide.nodes.empty());
    descent_.start(a.wide, b.wide, WideDescent::Aim::Any);
    bool touches = false;
    while (!descent_.is_done() && !is_stopped_ && !touches) {
        const auto found = next_candidates(a.wide, b.wide, candidates_at_once_for_any);
        if (const auto touch = contacts_.find_touch(a.wide.triangles, b.wide.triangles, found)) {
            descent_.note_contact(a.wide, b.wide, found[*touch]);
            touches = true;
        }
        poll_stop();
    }
    descent_.note_answer(touches);
    return touches;
}

void WideSearch::collect(const TreeView& a, const TreeView& b) {
    CD_CHECK(!a.wide.nodes.empty() && !b.wide.nodes.empty());
    const TriangleBlocks& of_a = a.wide.triangles;
    const TriangleBlocks& of_b = b.wide.triangles;
    using Aim = WideDescent::Aim;
    const std::uint64_t before = contacts_.count();
    descent_.start(a.wide, b.wide, expects_none_ ? Aim::AllUnlikely : Aim::All);
    while (!descent_.is_done() && !is_stopped_) {
        const auto found = next_candidates(a.wide, b.wide, candidates_at_once);
        contacts_.add(of_a, of_a.ids, of_b, of_b.ids, found);
        poll_stop();
    }
    expects_none_ = contacts_.count() == before;
}

SearchReport WideSearch::report() const {
    return {contacts_.statistics(descent_.box_tests()), is_stopped_, &b_to_a_};
}

} // namespace cd
