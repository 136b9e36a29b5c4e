#include "common/tree/planes/plane_stack.hpp"

#include "common/core/prefetch.hpp"

#include <limits>
#include <utility>

namespace cd {

namespace {

/// More steps part hardly more pairs than opening their nodes does.
constexpr std::uint32_t plane_steps = 3;
/// The same where one normal has been tried on all pairs of a visit.
constexpr std::uint32_t sibling_steps = 2;

/// Steps for the plane between whole bodies, which a search for the nearest pair makes once.
constexpr std::uint32_t root_steps = 16;

/// A pair that no plane parted is tried again under each such pose among near ones.
constexpr std::uint32_t retry_period = 8;

/// Fetches the sets of points that a visit of the node needs.
void prefetch_children(const PlaneBody& body, std::uint32_t node) {
    if (!body.nodes[node].is_leaf) {
        prefetch(body.sets + body.nodes[node].first, wide_children_max * sizeof(SupportSet));
    }
}

} // namespace

void PlaneStack::reset(const PlanePose& pose, const WideView& a, const WideView& b, bool is_near) {
    pose_ = pose;
    // Proofs hold for the trees that they were made for, and for no later ones at their addresses.
    const bool has_same_trees = a_ && a_->id == a.support.id && b_->id == b.support.id;
    uses_kept_ = is_near && has_same_trees;
    if (!kept_ && uses_kept_) {
        kept_.emplace();
    } else if (kept_ && !uses_kept_) {
        kept_->forget();
    }
    a_.emplace(a);
    b_.emplace(b);
    pairs_.clear();
}

void PlaneStack::push_roots() {
    pairs_.push_back({{0, 0}, first_normal(pose_), false});
}

PlaneNormal PlaneStack::root_normal() const {
    PlanePose pose = pose_;
    pose.reach = 0;
    PlaneNormal normal = first_normal(pose);
    static_cast<void>(separate(pose, *a_, 0, *b_, 0, root_steps, normal));
    return normal;
}

/// Tries to part a pair, unless that failed lately. Sets the pair's normal to the last one tried.
bool PlaneStack::is_apart(Waiting& pair) {
    if (!uses_kept_) {
        return separate(pose_, *a_, pair.nodes.a, *b_, pair.nodes.b, plane_steps, pair.normal) > 0;
    }
    const auto [kept, is_known] = kept_->of(pair.nodes);
    if (is_known) {
        pair.normal = kept.normal;
        if (kept.failures > 0 && ++kept.failures % retry_period != 0) {
            return false;
        }
        if (kept.failures == 0 && kept.proof.holds(pose_, pair.normal)) {
            return true;
        }
    }
    const float slack =
        separate(pose_, *a_, pair.nodes.a, *b_, pair.nodes.b, plane_steps, pair.normal);
    const bool is_apart = slack > 0;
    if (is_apart) {
        kept.proof = PlaneProof(pose_, *b_, pair.nodes.b, pair.normal, slack);
    }
    kept.normal = pair.normal;
    kept.failures = is_apart ? 0 : 1;
    return is_apart;
}

bool PlaneStack::parts(WidePair nodes, const PlaneNormal& normal) {
    Waiting pair{nodes, normal, false};
    return is_apart(pair);
}

std::optional<WidePair> PlaneStack::next() {
    while (!pairs_.empty()) {
        Waiting pair = pairs_.back();
        pairs_.pop_back();
        if (pair.is_tested || !is_apart(pair)) {
            normal_ = pair.normal;
            prefetch_children(*a_, pair.nodes.a);
            prefetch_children(*b_, pair.nodes.b);
            return pair.nodes;
        }
    }
    return std::nullopt;
}

void PlaneStack::push_children(std::span<const WidePair> pairs) {
    if (uses_kept_) {
        for (const WidePair& pair : pairs) {
            pairs_.push_back({pair, normal_, false});
        }
    } else if (!pairs.empty()) {
        trials_.resize(pairs.size());
        separate_siblings(pose_, *a_, *b_, pairs, sibling_steps, normal_, trials_);
        // The others keep their order, in which neighbours share nodes.
        std::size_t next = pairs_.size();
        float least_slack = std::numeric_limits<float>::infinity();
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            if (trials_[i].is_apart) {
                continue;
            }
            if (trials_[i].slack < least_slack) {
                least_slack = trials_[i].slack;
                next = pairs_.size();
            }
            pairs_.push_back({pairs[i], trials_[i].normal, true});
        }
        if (next < pairs_.size()) {
            std::swap(pairs_[next], pairs_.back());
        }
    }
}

WidePair PlaneStack::pop() {
    const WidePair pair = pairs_.back().nodes;
    pairs_.pop_back();
    return pair;
}

} // namespace cd
