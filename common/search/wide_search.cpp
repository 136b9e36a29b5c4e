#include "common/search/wide_search.hpp"

#include "common/core/check.hpp"
#include "common/geometry/reach.hpp"
#include "common/tree/wide/candidates_at_once.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace cd {

namespace {

/// A clearance above this share of the shorter body's length is large: most pairs of boxes are
/// within it although few pairs of triangles may be, so that only the nearest boxes are promising.
/// Speed hardly depends on the share: 1/500 and 1/20 are as good for two cars.
constexpr double large_share = 1.0 / 64;

/// Returns the longest side of the root's box, within a few percent.
double length_of(const WideView& tree) {
    const std::array<float, 4>& steps = tree.nodes.front().steps;
    return 254.0 * std::max({steps[0], steps[1], steps[2]});
}

bool is_large(double clearance, const WideView& a, const WideView& b) {
    return clearance > large_share * std::min(length_of(a), length_of(b));
}

} // namespace

WideSearch::WideSearch(const PosePair& poses,
                       std::span<const IgnoredRange> ignored,
                       const SearchOptions& options)
    : clearance_(options.clearance),
      b_to_a_(relative_pose(poses)),
      descent_(b_to_a_),
      ignored_(ignored),
      stop_(options.stop),
      contacts_(poses, options) {
    if (options.nearest_up_to) {
        nearest_.emplace(poses, distance_stage(options.first_stage), *options.nearest_up_to);
    }
    if (clearance_ || nearest_) {
        near_.emplace(NearDescent{WideDescent(b_to_a_)});
        place_near(poses);
    }
}

void WideSearch::restart(const PosePair& poses) {
    b_to_a_ = relative_pose(poses);
    descent_.restart(b_to_a_);
    contacts_.restart(poses);
    if (clearance_) {
        place_near(poses);
    }
    if (nearest_) {
        near_->waiting = poses;
    }
    is_stopped_ = false;
}

void WideSearch::ignore(std::span<const IgnoredRange> ignored) {
    ignored_ = ignored;
    if (nearest_) {
        nearest_->forget_ignored(ignored);
    }
}

void WideSearch::set_clearance(double clearance) {
    CD_CHECK(clearance_);
    clearance_ = clearance;
    contacts_.set_clearance(clearance);
}

void WideSearch::place_near(const PosePair& poses) {
    near_->reach_per_length = body_reach(poses, 1);
    near_->rotation_a = poses.a.rotation();
    near_->descent.restart(b_to_a_, clearance_ ? body_reach(poses, *clearance_) : 0);
}

/// Tells the descent and the nearest pair of the last `restart`, unless they know of it.
void WideSearch::begin_nearest() {
    if (const auto poses = std::exchange(near_->waiting, std::nullopt)) {
        nearest_->restart(*poses);
        place_near(*poses);
    }
}

NearestFound& WideSearch::nearest() {
    begin_nearest();
    return *nearest_;
}

/// Returns the reach that finds every pair which may change the answer.
double WideSearch::nearest_reach() const {
    constexpr double more_than_rounding = 1 + 0x1p-50;
    return more_than_rounding * near_->reach_per_length * nearest_->bound();
}

/// Gives the descent the direction in which the bodies are nearest, so far.
void WideSearch::set_direction() {
    const Vec3 in_a = near_->rotation_a.transpose() * nearest_->displacement();
    const double length = in_a.norm();
    if (length > 0 && std::isfinite(length)) {
        near_->descent.set_direction(in_a / length);
    }
}

void WideSearch::poll_stop() {
    is_stopped_ = stop_ && stop_();
}

/// Returns the next candidates without ignored pairs.
std::span<const Candidate> WideSearch::next_candidates(WideDescent& descent,
                                                       const WideView& a,
                                                       const WideView& b,
                                                       std::size_t wanted) {
    std::span<Candidate> found = descent.next(wanted);
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
        const auto found = next_candidates(descent_, a.wide, b.wide, candidates_at_once_for_any);
        if (const auto touch = contacts_.find_touch(a.wide.triangles, b.wide.triangles, found)) {
            descent_.note_contact(a.wide, b.wide, found[*touch]);
            touches = true;
        }
        poll_stop();
    }
    descent_.note_answer(touches);
    return touches;
}

Nearness WideSearch::any_near(const TreeView& a, const TreeView& b) {
    CD_CHECK(near_ && !a.wide.nodes.empty() && !b.wide.nodes.empty());
    WideDescent& descent = near_->descent;
    const bool nearest_first = is_large(*clearance_, a.wide, b.wide);
    descent.start(
        a.wide, b.wide, nearest_first ? WideDescent::Aim::Nearest : WideDescent::Aim::Any);
    Nearness nearness = Nearness::Far;
    while (!descent.is_done() && !is_stopped_ && nearness == Nearness::Far) {
        const auto found = next_candidates(descent, a.wide, b.wide, candidates_at_once_for_any);
        if (const auto near = contacts_.find_near(a.wide.triangles, b.wide.triangles, found)) {
            descent.note_contact(a.wide, b.wide, found[near->index]);
            nearness = near->touches ? Nearness::Contact : Nearness::Near;
        }
        poll_stop();
    }
    if (!nearest_first) {
        descent.note_answer(nearness != Nearness::Far);
    }
    return nearness;
}

void WideSearch::collect(const TreeView& a, const TreeView& b) {
    CD_CHECK(!a.wide.nodes.empty() && !b.wide.nodes.empty());
    const TriangleBlocks& of_a = a.wide.triangles;
    const TriangleBlocks& of_b = b.wide.triangles;
    using Aim = WideDescent::Aim;
    WideDescent& descent = clearance_ ? near_->descent : descent_;
    const std::uint64_t before = contacts_.count() + contacts_.near_count();
    descent.start(a.wide, b.wide, expects_none_ ? Aim::AllUnlikely : Aim::All);
    while (!descent.is_done() && !is_stopped_) {
        const auto found = next_candidates(descent, a.wide, b.wide, candidates_at_once);
        contacts_.add(of_a, of_a.ids, of_b, of_b.ids, found);
        poll_stop();
    }
    expects_none_ = contacts_.count() + contacts_.near_count() == before;
}

void WideSearch::find_nearest(const TreeView& a, const TreeView& b) {
    CD_CHECK(nearest_ && !a.wide.nodes.empty() && !b.wide.nodes.empty());
    const TriangleBlocks& of_a = a.wide.triangles;
    const TriangleBlocks& of_b = b.wide.triangles;
    begin_nearest();
    WideDescent& descent = near_->descent;
    descent.set_reach(nearest_reach());
    set_direction();
    descent.start(a.wide, b.wide, WideDescent::Aim::Nearest);
    while (!descent.is_done() && !is_stopped_) {
        const auto found = next_candidates(descent, a.wide, b.wide, candidates_at_once_for_nearest);
        nearest_->add(of_a, of_a.ids, of_b, of_b.ids, found);
        descent.set_reach(nearest_reach());
        set_direction();
        poll_stop();
    }
    nearest_->settle();
}

SearchReport WideSearch::report() const {
    const std::uint64_t box_tests =
        descent_.box_tests() + (near_ && !near_->waiting ? near_->descent.box_tests() : 0);
    return {contacts_.statistics(box_tests), is_stopped_, &b_to_a_};
}

} // namespace cd
