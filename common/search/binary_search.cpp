#include "common/search/binary_search.hpp"

#include "common/core/check.hpp"
#include "common/geometry/reach.hpp"
#include "common/tree/wide/candidates_at_once.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace cd {

namespace {

/// Returns an eighth of the surface area of the node's box. The descent opens the node with the
/// larger area.
float size_of(const ObbNode& node) {
    const auto& [x, y, z] = node.half;
    return x * y + y * z + z * x;
}

/// Returns the squared distance between the two boxes' centres.
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

/// Steps of the descent between two polls of `stop`. This number of steps takes a fraction of a
/// second even if every pair needs exact arithmetic.
constexpr std::uint32_t steps_between_stop_checks = 1024;

} // namespace

BinarySearch::Placement::Placement(const PosePair& poses, const std::optional<double>& clearance)
    : b_to_a(relative_pose(poses)),
      boxes(b_to_a),
      near_boxes(b_to_a, 1, clearance ? body_reach(poses, *clearance) : 0),
      reach_per_length(body_reach(poses, 1)) {}

BinarySearch::BinarySearch(const PosePair& poses,
                           std::span<const IgnoredRange> ignored,
                           const SearchOptions& options)
    : stop_(options.stop),
      clearance_(options.clearance),
      ignored_(ignored),
      placement_(poses, clearance_),
      contacts_(poses, options) {
    if (options.nearest_up_to) {
        nearest_.emplace(poses, distance_stage(options.first_stage), *options.nearest_up_to);
    }
}

void BinarySearch::restart(const PosePair& poses) {
    placement_ = Placement(poses, clearance_);
    progress_ = {};
    contacts_.restart(poses);
    if (nearest_) {
        nearest_->restart(poses);
    }
}

void BinarySearch::ignore(std::span<const IgnoredRange> ignored) {
    ignored_ = ignored;
    if (nearest_) {
        nearest_->forget_ignored(ignored);
    }
}

void BinarySearch::set_clearance(double clearance) {
    CD_CHECK(clearance_);
    clearance_ = clearance;
    contacts_.set_clearance(clearance);
}

/// Returns whether the descent must end; polls `stop_` once in `steps_between_stop_checks` calls.
bool BinarySearch::must_stop() {
    if (stop_ && ++progress_.steps_unpolled >= steps_between_stop_checks) {
        progress_.steps_unpolled = 0;
        progress_.is_stopped = stop_();
    }
    return progress_.is_stopped;
}

/// Descends both trees and calls `on_leaves` for each pair of leaves whose boxes may overlap.
/// Returns true as soon as `on_leaves` returns true, and false at the end or on a stop.
template <class OnLeaves>
bool BinarySearch::descend(const BoxTest& boxes,
                           const TreeView& a,
                           const TreeView& b,
                           const OnLeaves& on_leaves) {
    CD_CHECK(!a.nodes.empty());
    CD_CHECK(!b.nodes.empty());
    // Keeps the last posed box of B, because one box of B meets many boxes of A in a row.
    std::uint32_t posed_place = 0;
    PosedBox posed = boxes.pose(b.nodes[0]);
    stack_.clear();
    ++progress_.box_tests;
    if (boxes.may_overlap(a.nodes[0], posed)) {
        stack_.push_back({0, 0});
    }
    while (!stack_.empty() && !must_stop()) {
        const NodePair now = stack_.back();
        stack_.pop_back();
        const ObbNode& node_a = a.nodes[now.a];
        const ObbNode& node_b = b.nodes[now.b];
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
        // The nearer pair is popped first, so that a search for any contact ends soon.
        double distance_before = 0;
        std::size_t pushed = 0;
        for (const NodePair& pair : next) {
            if (pair.b != posed_place) {
                posed = boxes.pose(b.nodes[pair.b]);
                posed_place = pair.b;
            }
            ++progress_.box_tests;
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

/// Adds to `candidates_` each pair of the leaves' triangles whose axis-aligned boxes meet, without
/// ignored pairs.
void BinarySearch::add_candidates(const BoxTest& boxes,
                                  const TreeView& a,
                                  const TreeView& b,
                                  const NodePair& leaves) {
    const ObbNode& node_a = a.nodes[leaves.a];
    const ObbNode& node_b = b.nodes[leaves.b];
    bounds_.clear();
    for (std::uint32_t j = node_b.triangles_begin; j < node_b.triangles_end; ++j) {
        bounds_.push_back(boxes.bounds(triangles_of(b).corners_at(j)));
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

bool BinarySearch::decide_any(const TreeView& a, const TreeView& b) {
    const bool touch =
        contacts_.find_touch(triangles_of(a), triangles_of(b), candidates_).has_value();
    candidates_.clear();
    return touch;
}

bool BinarySearch::any(const TreeView& a, const TreeView& b) {
    const BoxTest& boxes = placement_.boxes;
    const bool touch = descend(boxes, a, b, [&](const NodePair& leaves) {
        add_candidates(boxes, a, b, leaves);
        return candidates_.size() >= candidates_at_once_for_any && decide_any(a, b);
    });
    return touch || decide_any(a, b);
}

Nearness BinarySearch::decide_near(const TreeView& a, const TreeView& b) {
    const auto near = contacts_.find_near(triangles_of(a), triangles_of(b), candidates_);
    candidates_.clear();
    return !near ? Nearness::Far : near->touches ? Nearness::Contact : Nearness::Near;
}

Nearness BinarySearch::any_near(const TreeView& a, const TreeView& b) {
    const BoxTest& boxes = placement_.near_boxes;
    Nearness nearness = Nearness::Far;
    descend(boxes, a, b, [&](const NodePair& leaves) {
        add_candidates(boxes, a, b, leaves);
        if (candidates_.size() >= candidates_at_once_for_any) {
            nearness = decide_near(a, b);
        }
        return nearness != Nearness::Far;
    });
    return nearness != Nearness::Far ? nearness : decide_near(a, b);
}

void BinarySearch::decide_candidates(const TreeView& a, const TreeView& b) {
    contacts_.add(triangles_of(a), a.triangle_ids, triangles_of(b), b.triangle_ids, candidates_);
    candidates_.clear();
}

void BinarySearch::collect(const TreeView& a, const TreeView& b) {
    const BoxTest& boxes = clearance_ ? placement_.near_boxes : placement_.boxes;
    descend(boxes, a, b, [&](const NodePair& leaves) {
        add_candidates(boxes, a, b, leaves);
        if (candidates_.size() >= candidates_at_once) {
            decide_candidates(a, b);
        }
        return false;
    });
    decide_candidates(a, b);
}

/// Adds the candidates to the nearest pair, and lowers the reach of the boxes accordingly.
void BinarySearch::narrow(const TreeView& a, const TreeView& b) {
    constexpr double more_than_rounding = 1 + 0x1p-50;
    nearest_->add(triangles_of(a), a.triangle_ids, triangles_of(b), b.triangle_ids, candidates_);
    candidates_.clear();
    placement_.near_boxes.set_reach(more_than_rounding * placement_.reach_per_length *
                                    nearest_->bound());
}

void BinarySearch::find_nearest(const TreeView& a, const TreeView& b) {
    CD_CHECK(nearest_);
    narrow(a, b);
    descend(placement_.near_boxes, a, b, [&](const NodePair& leaves) {
        add_candidates(placement_.near_boxes, a, b, leaves);
        narrow(a, b);
        return false;
    });
    nearest_->settle();
}

SearchReport BinarySearch::report() const {
    return {contacts_.statistics(progress_.box_tests), progress_.is_stopped, &placement_.b_to_a};
}

} // namespace cd
