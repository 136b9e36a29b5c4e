#include "common/search/traverse.hpp"

#include "common/core/check.hpp"
#include "common/tree/wide/candidates_at_once.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cd {

namespace {

/// What decides which of two boxes is descended: its surface.
float size_of(const ObbNode& node) {
    const auto& [x, y, z] = node.half;
    return x * y + y * z + z * x;
}

double squared_distance(const ObbNode& a, const PosedBox& b) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double d = a.center[i] - b.center[i];
        sum += d * d;
    }
    return sum;
}

TriangleSpan triangles_of(const TreeView& tree) {
    return {tree.vertices, tree.triangles};
}

/// Half the diagonal.
double radius_of(const ObbNode& node) {
    double sum = 0;
    for (const float half : node.half) {
        sum += static_cast<double>(half) * static_cast<double>(half);
    }
    return std::sqrt(sum);
}

/// Bounds |R| for the true linear part R: |R|^2 <= the largest sum of |entries| in a row of R'R.
double stretch_of(const Pose& pose) {
    const Mat3 r = pose.rotation();
    const double reach = r.cwiseAbs().maxCoeff();
    // An entry of R'R has three products, each with three roundings and two entries that may err.
    const double error = 3 * (2.01 * reach * pose.rotation_error() + 4 * 0x1p-53 * reach * reach);
    const double square = (r.transpose() * r).cwiseAbs().rowwise().sum().maxCoeff() + 3 * error;
    const double stretch = std::sqrt(square) * (1 + 0x1p-50);
    return stretch >= 0 ? stretch : std::numeric_limits<double>::infinity(); // NaN: overflow.
}

/// A fraction of a second of work, even where every pair needs exact arithmetic.
constexpr std::uint32_t steps_between_stop_checks = 1024;
/// Below this, pairs beyond the limit are not worth a sort on the way, nor memory giving back.
constexpr std::size_t kept_at_least = 1u << 16;

} // namespace

ContactSearch::ContactSearch(const PosePair& poses,
                             std::span<const IgnoredRange> ignored,
                             const SearchOptions& options)
    : relative_(relative_pose(poses)),
      descent_(relative_),
      ignored_(ignored),
      options_(options),
      stretch_(stretch_under(poses)),
      test_(poses, options.first_stage, options.decision) {}

void ContactSearch::restart(const PosePair& poses) {
    relative_ = relative_pose(poses);
    boxes_.reset();
    descent_.restart(relative_);
    stretch_ = stretch_under(poses);
    test_.restart(poses);
    if (corners_.capacity() > kept_at_least) {
        corners_ = {};
    }
    pairs_.clear();
    corners_.clear();
    undecided_.reset();
    pair_count_ = 0;
    has_proper_ = false;
    is_stopped_ = false;
    steps_unchecked_ = 0;
    box_tests_ = 0;
    triangle_tests_ = 0;
}

double ContactSearch::stretch_under(const PosePair& poses) const {
    return options_.tolerance > 0 ? stretch_of(poses.a) : 1;
}

const BoxTest& ContactSearch::boxes() {
    if (!boxes_) {
        boxes_.emplace(relative_);
    }
    return *boxes_;
}

/// Whether to end the descent; asks only now and then.
bool ContactSearch::must_stop(std::uint32_t steps) {
    steps_unchecked_ += steps;
    if (options_.stop && steps_unchecked_ >= steps_between_stop_checks) {
        steps_unchecked_ = 0;
        is_stopped_ = options_.stop();
    }
    return is_stopped_;
}

/// Calls `on_leaves` for the pairs of leaves whose boxes, and those of all above them, may overlap,
/// until it returns true; whether it did. Ends early when it must stop.
template <class OnLeaves>
bool ContactSearch::descend(const TreeView& a, const TreeView& b, const OnLeaves& on_leaves) {
    CD_CHECK(!a.nodes.empty()); // Who leaves the binary form out has the wide one of both.
    CD_CHECK(!b.nodes.empty());
    // The box of B that was posed last: going down A, one of B meets many of A in a row.
    const BoxTest& boxes = this->boxes();
    std::uint32_t posed_place = 0;
    PosedBox posed = boxes.pose(b.nodes[0]);
    stack_.clear();
    ++box_tests_;
    if (boxes.may_overlap(a.nodes[0], posed)) {
        stack_.push_back({0, 0});
    }
    while (!stack_.empty() && !must_stop(1)) {
        const NodePair now = stack_.back();
        stack_.pop_back();
        const ObbNode& node_a = a.nodes[now.a];
        const ObbNode& node_b = b.nodes[now.b];
        if (options_.tolerance > 0 && leave_undecided(node_a, node_b)) {
            continue;
        }
        if (node_a.is_leaf() && node_b.is_leaf()) {
            if (on_leaves(now)) {
                return true;
            }
            continue;
        }
        const bool down_a =
            node_b.is_leaf() || (!node_a.is_leaf() && size_of(node_a) >= size_of(node_b));
        const std::array<NodePair, 2> next =
            down_a ? std::array<NodePair, 2>{{{now.a + 1, now.b}, {node_a.right, now.b}}}
                   : std::array<NodePair, 2>{{{now.a, now.b + 1}, {now.a, node_b.right}}};
        // The nearer of the two comes first, so that a search for any contact soon ends.
        double distance_before = 0;
        std::size_t pushed = 0;
        for (const NodePair& pair : next) {
            if (pair.b != posed_place) {
                posed = boxes.pose(b.nodes[pair.b]);
                posed_place = pair.b;
            }
            ++box_tests_;
            const ObbNode& box_a = a.nodes[pair.a];
            if (!boxes.may_overlap(box_a, posed)) {
                continue;
            }
            const double distance = squared_distance(box_a, posed);
            stack_.push_back(pair);
            if (++pushed == 2 && distance > distance_before) {
                std::swap(stack_[stack_.size() - 1], stack_[stack_.size() - 2]);
            }
            distance_before = distance;
        }
    }
    return false;
}

/// Whether the two overlapping boxes are small enough to be left as they are; if so, notes how far
/// apart their contents can be.
bool ContactSearch::leave_undecided(const ObbNode& a, const ObbNode& b) {
    if (!(2 * (radius_of(a) + radius_of(b)) <= options_.tolerance)) {
        return false;
    }
    double distance = stretch_ * boxes().distance_max(a, boxes().pose(b));
    if (std::isnan(distance)) { // The poses leave the range of double.
        distance = std::numeric_limits<double>::infinity();
    }
    undecided_ = std::min(undecided_.value_or(distance), distance);
    return true;
}

/// The pairs of two leaves' triangles that may touch.
void ContactSearch::add_candidates(const TreeView& a, const TreeView& b, const NodePair& leaves) {
    const ObbNode& node_a = a.nodes[leaves.a];
    const ObbNode& node_b = b.nodes[leaves.b];
    bounds_.clear();
    for (std::uint32_t j = node_b.triangles_begin; j < node_b.triangles_end; ++j) {
        bounds_.push_back(boxes().bounds(triangles_of(b).corners_at(j)));
    }
    for (std::uint32_t i = node_a.triangles_begin; i < node_a.triangles_end; ++i) {
        const Aabb own = bounding_box(triangles_of(a).corners_at(i));
        for (std::uint32_t j = node_b.triangles_begin; j < node_b.triangles_end; ++j) {
            if (!are_apart(own, bounds_[j - node_b.triangles_begin]) &&
                !is_ignored(ignored_, a.triangle_ids[i], b.triangle_ids[j])) {
                candidates_.push_back({i, j});
            }
        }
    }
}

bool ContactSearch::uses_wide(const TreeView& a, const TreeView& b) const {
    return !a.wide.nodes.empty() && !b.wide.nodes.empty() && !(options_.tolerance > 0);
}

std::span<const Candidate>
ContactSearch::next_candidates(const WideView& a, const WideView& b, std::size_t wanted) {
    std::span<Candidate> found = descent_.next(wanted);
    if (!ignored_.empty()) {
        const auto rest = std::ranges::remove_if(found, [&](const Candidate& pair) {
            return is_ignored(ignored_, a.triangles.ids[pair.a], b.triangles.ids[pair.b]);
        });
        found = found.first(found.size() - rest.size());
    }
    triangle_tests_ += found.size();
    return found;
}

bool ContactSearch::any_in_wide(const WideView& a, const WideView& b) {
    using Aim = WideDescent::Aim;
    descent_.start(a, b, expects_contact_ ? Aim::LikelyFirst : Aim::First);
    expects_contact_ = false;
    while (!descent_.is_done() && !is_stopped_ && !expects_contact_) {
        const auto found = next_candidates(a, b, candidates_at_once_for_any);
        expects_contact_ = test_.find_touch(a.triangles, b.triangles, found).has_value();
        static_cast<void>(must_stop(steps_between_stop_checks));
    }
    return expects_contact_;
}

bool ContactSearch::decide_any(const TreeView& a, const TreeView& b) {
    triangle_tests_ += candidates_.size();
    const bool touch = test_.find_touch(triangles_of(a), triangles_of(b), candidates_).has_value();
    candidates_.clear();
    return touch;
}

bool ContactSearch::any(const TreeView& a, const TreeView& b) {
    if (uses_wide(a, b)) {
        return any_in_wide(a.wide, b.wide);
    }
    const bool touch = descend(a, b, [&](const NodePair& leaves) {
        add_candidates(a, b, leaves);
        return candidates_.size() >= candidates_at_once_for_any && decide_any(a, b);
    });
    return touch || decide_any(a, b);
}

template <class Triangles>
void ContactSearch::add_contacts(const Triangles& a,
                                 std::span<const std::uint32_t> ids_a,
                                 const Triangles& b,
                                 std::span<const std::uint32_t> ids_b,
                                 std::span<const Candidate> candidates) {
    const auto kinds = test_.classify(a, b, candidates);
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        if (kinds[i] == PairClass::Separate) {
            continue;
        }
        ++pair_count_;
        has_proper_ = has_proper_ || kinds[i] == PairClass::Proper;
        if (has_proper_ && options_.only_touches) {
            pairs_.clear();
            continue;
        }
        if (!options_.keep_pairs) {
            continue;
        }
        const Candidate& found = candidates[i];
        pairs_.push_back({ids_a[found.a], ids_b[found.b], kinds[i]});
        if (options_.keep_corners) {
            corners_.push_back({a.corners_at(found.a), b.corners_at(found.b)});
        }
    }
    // Seldom enough that sorting costs little beside finding.
    if (pairs_.size() / 2 > options_.pairs_max && pairs_.size() > kept_at_least) {
        sort();
    }
}

void ContactSearch::decide_candidates(const TreeView& a, const TreeView& b) {
    triangle_tests_ += candidates_.size();
    add_contacts(triangles_of(a), a.triangle_ids, triangles_of(b), b.triangle_ids, candidates_);
    candidates_.clear();
}

void ContactSearch::collect_in_wide(const WideView& a, const WideView& b) {
    for (descent_.start(a, b); !descent_.is_done() && !is_stopped_;) {
        const auto found = next_candidates(a, b, candidates_at_once);
        add_contacts(a.triangles, a.triangles.ids, b.triangles, b.triangles.ids, found);
        static_cast<void>(must_stop(steps_between_stop_checks));
    }
}

void ContactSearch::collect(const TreeView& a, const TreeView& b) {
    if (uses_wide(a, b)) {
        collect_in_wide(a.wide, b.wide);
        return;
    }
    descend(a, b, [&](const NodePair& leaves) {
        add_candidates(a, b, leaves);
        if (candidates_.size() >= candidates_at_once) {
            decide_candidates(a, b);
        }
        return false;
    });
    decide_candidates(a, b);
}

std::vector<ContactPair> ContactSearch::take_pairs() {
    if (pairs_.capacity() > kept_at_least) {
        return std::exchange(pairs_, {});
    }
    std::vector<ContactPair> taken(pairs_.begin(), pairs_.end());
    pairs_.clear();
    return taken;
}

void ContactSearch::sort() {
    const std::size_t kept =
        static_cast<std::size_t>(std::min<std::uint64_t>(pairs_.size(), options_.pairs_max));
    if (options_.keep_corners) {
        sorter_.sort(pairs_, corners_);
        corners_.resize(kept);
    } else {
        sorter_.sort(pairs_);
    }
    pairs_.resize(kept);
}

QueryStatistics ContactSearch::statistics() const {
    return {box_tests_ + descent_.box_tests(), triangle_tests_, test_.statistics()};
}

std::vector<ContactPair> contact_pairs(const ObbTree& a, const ObbTree& b, const PosePair& poses) {
    ContactSearch search(poses, {});
    search.collect(a.view(), b.view());
    search.sort();
    return search.take_pairs();
}

} // namespace cd
