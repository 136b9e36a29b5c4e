#include "common/tree/traverse.hpp"

#include <algorithm>
#include <numeric>
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

/// A comparison with NaN, which only B's box can hold, does not part them.
bool are_apart(const Aabb& a, const Aabb& b) {
    return a.max.x() < b.min.x() || a.min.x() > b.max.x() || a.max.y() < b.min.y() ||
           a.min.y() > b.max.y() || a.max.z() < b.min.z() || a.min.z() > b.max.z();
}

Corners corners_at(const TreeView& tree, std::uint32_t place) {
    const Triangle& t = tree.triangles[place];
    return {tree.vertices[t[0]], tree.vertices[t[1]], tree.vertices[t[2]]};
}

} // namespace

QueryStatistics& QueryStatistics::operator+=(const QueryStatistics& other) {
    box_tests += other.box_tests;
    triangle_tests += other.triangle_tests;
    decisions += other.decisions;
    return *this;
}

bool is_ignored(std::span<const IgnoredRange> ignored, std::uint32_t a, std::uint32_t b) {
    return std::any_of(ignored.begin(), ignored.end(), [&](const IgnoredRange& range) {
        return a >= range.a_begin && a < range.a_end && b >= range.b_begin && b < range.b_end;
    });
}

ContactSearch::ContactSearch(const PosePair& poses,
                             std::span<const IgnoredRange> ignored,
                             bool keep_corners)
    : boxes_(relative_pose(poses)), ignored_(ignored), keep_corners_(keep_corners), test_(poses) {}

/// Calls `on_leaves` for the pairs of leaves whose boxes, and those of all above them, may overlap,
/// until it returns true; whether it did.
template <class OnLeaves>
bool ContactSearch::descend(const TreeView& a, const TreeView& b, const OnLeaves& on_leaves) {
    // The box of B that was posed last: going down A, one of B meets many of A in a row.
    std::uint32_t posed_place = 0;
    PosedBox posed = boxes_.pose(b.nodes[0]);
    stack_.clear();
    ++box_tests_;
    if (boxes_.may_overlap(a.nodes[0], posed)) {
        stack_.push_back({0, 0});
    }
    while (!stack_.empty()) {
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
        // The nearer of the two comes first, so that a search for any contact soon ends.
        double distance_before = 0;
        std::size_t pushed = 0;
        for (const NodePair& pair : next) {
            if (pair.b != posed_place) {
                posed = boxes_.pose(b.nodes[pair.b]);
                posed_place = pair.b;
            }
            ++box_tests_;
            const ObbNode& box_a = a.nodes[pair.a];
            if (!boxes_.may_overlap(box_a, posed)) {
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

/// Calls `on_pair(triangle of A, triangle of B)`, as places in the trees, for the pairs of two
/// leaves that may touch, until it returns true; whether it did.
template <class OnPair>
bool ContactSearch::visit_leaves(const TreeView& a,
                                 const TreeView& b,
                                 const NodePair& leaves,
                                 const OnPair& on_pair) {
    const ObbNode& node_a = a.nodes[leaves.a];
    const ObbNode& node_b = b.nodes[leaves.b];
    bounds_.clear();
    for (std::uint32_t j = node_b.triangles_begin; j < node_b.triangles_end; ++j) {
        bounds_.push_back(boxes_.bounds(corners_at(b, j)));
    }
    for (std::uint32_t i = node_a.triangles_begin; i < node_a.triangles_end; ++i) {
        const Aabb own = bounding_box(corners_at(a, i));
        for (std::uint32_t j = node_b.triangles_begin; j < node_b.triangles_end; ++j) {
            if (are_apart(own, bounds_[j - node_b.triangles_begin]) ||
                is_ignored(ignored_, a.triangle_ids[i], b.triangle_ids[j])) {
                continue;
            }
            ++triangle_tests_;
            if (on_pair(i, j)) {
                return true;
            }
        }
    }
    return false;
}

bool ContactSearch::any(const TreeView& a, const TreeView& b) {
    const auto touch = [&](std::uint32_t i, std::uint32_t j) {
        return test_.touches(corners_at(a, i), corners_at(b, j));
    };
    return descend(a, b, [&](const NodePair& leaves) { return visit_leaves(a, b, leaves, touch); });
}

void ContactSearch::collect(const TreeView& a, const TreeView& b) {
    const auto add = [&](std::uint32_t i, std::uint32_t j) {
        const Corners corners_a = corners_at(a, i);
        const Corners corners_b = corners_at(b, j);
        const PairClass kind = test_.classify(corners_a, corners_b);
        if (kind != PairClass::Separate) {
            pairs_.push_back({a.triangle_ids[i], b.triangle_ids[j], kind});
            if (keep_corners_) {
                corners_.push_back({corners_a, corners_b});
            }
        }
        return false;
    };
    descend(a, b, [&](const NodePair& leaves) { return visit_leaves(a, b, leaves, add); });
}

void ContactSearch::sort() {
    if (!keep_corners_) {
        std::sort(pairs_.begin(), pairs_.end());
        return;
    }
    std::vector<std::size_t> order(pairs_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [this](std::size_t i, std::size_t j) {
        return pairs_[i] < pairs_[j];
    });
    std::vector<ContactPair> pairs;
    std::vector<PairCorners> corners;
    pairs.reserve(order.size());
    corners.reserve(order.size());
    for (const std::size_t i : order) {
        pairs.push_back(pairs_[i]);
        corners.push_back(corners_[i]);
    }
    pairs_ = std::move(pairs);
    corners_ = std::move(corners);
}

QueryStatistics ContactSearch::statistics() const {
    return {box_tests_, triangle_tests_, test_.statistics()};
}

std::vector<ContactPair> contact_pairs(const ObbTree& a, const ObbTree& b, const PosePair& poses) {
    ContactSearch search(poses, {});
    search.collect(a.view(), b.view());
    search.sort();
    return std::move(search.pairs());
}

} // namespace cd
