#include "common/search/binary_search.hpp"

#include "common/core/check.hpp"
#include "common/tree/wide/candidates_at_once.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
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

/// Returns half the box's diagonal.
double radius_of(const ObbNode& node) {
    double sum = 0;
    for (const float half : node.half) {
        sum += static_cast<double>(half) * static_cast<double>(half);
    }
    return std::sqrt(sum);
}

/// Returns an upper bound on the factor by which the pose's exact linear part R lengthens vectors,
/// or infinity on overflow. |R|^2 is at most the largest row sum of |R'R|.
double stretch_of(const Pose& pose) {
    const Mat3 r = pose.rotation();
    const double reach = r.cwiseAbs().maxCoeff();
    // An entry of R'R sums three products. In each, both factors may err, and up to three
    // operations round.
    const double error = 3 * (2.01 * reach * pose.rotation_error() + 4 * 0x1p-53 * reach * reach);
    const double square = (r.transpose() * r).cwiseAbs().rowwise().sum().maxCoeff() + 3 * error;
    const double stretch = std::sqrt(square) * (1 + 0x1p-50);
    return stretch >= 0 ? stretch : std::numeric_limits<double>::infinity(); // NaN: overflow.
}

/// Steps of the descent between two polls of `stop`. This number of steps takes a fraction of a
/// second even if every pair needs exact arithmetic.
constexpr std::uint32_t steps_between_stop_checks = 1024;

} // namespace

BinarySearch::Placement::Placement(const PosePair& poses, double tolerance)
    : b_to_a(relative_pose(poses)),
      boxes(b_to_a),
      stretch(tolerance > 0 ? stretch_of(poses.a) : 1) {}

BinarySearch::BinarySearch(const PosePair& poses,
                           std::span<const IgnoredRange> ignored,
                           const SearchOptions& options)
    : tolerance_(options.tolerance),
      stop_(options.stop),
      ignored_(ignored),
      placement_(poses, tolerance_),
      contacts_(poses, options) {}

void BinarySearch::restart(const PosePair& poses) {
    placement_ = Placement(poses, tolerance_);
    progress_ = {};
    contacts_.restart(poses);
}

/// Returns whether the descent must end; polls `stop_` once in `steps_between_stop_checks` calls.
bool BinarySearch::must_stop() {
    if (stop_ && ++progress_.steps_unpolled >= steps_between_stop_checks) {
        progress_.steps_unpolled = 0;
        progress_.is_stopped = stop_();
    }
    return progress_.is_stopped;
}

/// Descends both trees and calls `on_leaves` for each pair of leaves whose boxes may overlap,
/// except below pairs of boxes that the tolerance leaves undecided. Returns true as soon as
/// `on_leaves` returns true, and false at the end or on a stop.
template <class OnLeaves>
bool BinarySearch::descend(const TreeView& a, const TreeView& b, const OnLeaves& on_leaves) {
    CD_CHECK(!a.nodes.empty());
    CD_CHECK(!b.nodes.empty());
    const BoxTest& boxes = placement_.boxes;
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
        if (tolerance_ > 0 && leave_undecided(node_a, node_b)) {
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

/// Returns true if two overlapping boxes are so small that the tolerance leaves them undecided. If
/// true, lowers `undecided_distance` to an upper bound on the distance between their triangles.
bool BinarySearch::leave_undecided(const ObbNode& a, const ObbNode& b) {
    if (!(2 * (radius_of(a) + radius_of(b)) <= tolerance_)) {
        return false;
    }
    double distance =
        placement_.stretch * placement_.boxes.distance_max(a, placement_.boxes.pose(b));
    if (std::isnan(distance)) { // The poses leave the range of double.
        distance = std::numeric_limits<double>::infinity();
    }
    progress_.undecided_distance =
        std::min(progress_.undecided_distance.value_or(distance), distance);
    return true;
}

/// Adds to `candidates_` each pair of the leaves' triangles whose axis-aligned boxes meet, without
/// ignored pairs.
void BinarySearch::add_candidates(const TreeView& a, const TreeView& b, const NodePair& leaves) {
    const ObbNode& node_a = a.nodes[leaves.a];
    const ObbNode& node_b = b.nodes[leaves.b];
    bounds_.clear();
    for (std::uint32_t j = node_b.triangles_begin; j < node_b.triangles_end; ++j) {
        bounds_.push_back(placement_.boxes.bounds(triangles_of(b).corners_at(j)));
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
    const bool touch = descend(a, b, [&](const NodePair& leaves) {
        add_candidates(a, b, leaves);
        return candidates_.size() >= candidates_at_once_for_any && decide_any(a, b);
    });
    return touch || decide_any(a, b);
}

void BinarySearch::decide_candidates(const TreeView& a, const TreeView& b) {
    contacts_.add(triangles_of(a), a.triangle_ids, triangles_of(b), b.triangle_ids, candidates_);
    candidates_.clear();
}

void BinarySearch::collect(const TreeView& a, const TreeView& b) {
    descend(a, b, [&](const NodePair& leaves) {
        add_candidates(a, b, leaves);
        if (candidates_.size() >= candidates_at_once) {
            decide_candidates(a, b);
        }
        return false;
    });
    decide_candidates(a, b);
}

SearchReport BinarySearch::report() const {
    return {contacts_.statistics(progress_.box_tests),
            progress_.undecided_distance,
            progress_.is_stopped,
            &placement_.b_to_a};
}

} // namespace cd
