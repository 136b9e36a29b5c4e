#include "common/tree/cut.hpp"

#include "common/core/limits/engine.hpp"
#include "common/geometry/reach.hpp"
#include "common/tree/box_test.hpp"
#include "common/tree/build/build_fit.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>

namespace cd {

namespace {

/// A node above or on the cut, as the traversal reaches it.
struct TopNode {
    std::uint32_t node = 0; ///< Index in the tree.
    std::uint32_t depth = 0;
    std::uint32_t parent = 0; ///< Index of a right child's parent in the upper tree; else 0.
    bool is_right = false;
};

/// Calls `visit` for the nodes above and on the cut, in preorder.
void for_each_top_node(const ObbTree& tree,
                       const std::function<void(const TopNode&)>& visit,
                       std::uint32_t depth) {
    // In preorder, the index of a node in the upper tree is the number of nodes visited before it.
    std::uint32_t place = 0;
    std::vector<TopNode> waiting{TopNode{}};
    while (!waiting.empty()) {
        const TopNode top = waiting.back();
        waiting.pop_back();
        visit(top);
        const ObbNode& node = tree.nodes()[top.node];
        if (!node.is_leaf() && top.depth < depth) {
            waiting.push_back({node.right, top.depth + 1, place, true});
            waiting.push_back({top.node + 1, top.depth + 1, 0, false});
        }
        ++place;
    }
}

double size_of(const ObbNode& node) {
    return static_cast<double>(node.half[0]) + static_cast<double>(node.half[1]) +
           static_cast<double>(node.half[2]);
}

/// Returns whether the descent opens `a` instead of `b`. The descent opens the inner node with the
/// larger box, so that both boxes stay alike in size.
bool opens_a(const ObbNode& a, const ObbNode& b) {
    return !a.is_leaf() && (b.is_leaf() || size_of(a) >= size_of(b));
}

/// One simultaneous descent of two upper trees. Its pairs hold indices in `nodes`, not root
/// numbers.
class TopDescent {
  public:
    TopDescent(const TreeTop& a, const TreeTop& b, const PosePair& poses, double clearance)
        : a_(a),
          b_(b),
          boxes_(relative_pose(poses), 1, body_reach(poses, clearance)),
          posed_(boxes_.pose(b.nodes[0])) {}

    /// Calls `visit` for the pairs of leaves of the upper trees whose boxes may overlap, until it
    /// returns false.
    template <class Visit>
    void visit_leaf_pairs(const Visit& visit) {
        push_if_overlapping({0, 0});
        while (!waiting_.empty()) {
            const RootPair now = waiting_.back();
            waiting_.pop_back();
            const ObbNode& a = a_.nodes[now.a];
            const ObbNode& b = b_.nodes[now.b];
            if (a.is_leaf() && b.is_leaf()) {
                if (!visit(now)) {
                    return;
                }
            } else if (opens_a(a, b)) {
                push_if_overlapping({now.a + 1, now.b});
                push_if_overlapping({a.right, now.b});
            } else {
                push_if_overlapping({now.a, now.b + 1});
                push_if_overlapping({now.a, b.right});
            }
        }
    }

    [[nodiscard]] std::uint64_t box_tests() const { return box_tests_; }

  private:
    void push_if_overlapping(const RootPair& nodes) {
        if (nodes.b != posed_place_) {
            posed_ = boxes_.pose(b_.nodes[nodes.b]);
            posed_place_ = nodes.b;
        }
        ++box_tests_;
        if (boxes_.may_overlap(a_.nodes[nodes.a], posed_)) {
            waiting_.push_back(nodes);
        }
    }

    const TreeTop& a_;
    const TreeTop& b_;
    BoxTest boxes_;
    /// The box of B at `posed_place_`, cached because a descent of A tests one box of B many times.
    PosedBox posed_;
    std::uint32_t posed_place_ = 0;
    std::vector<RootPair> waiting_;
    std::uint64_t box_tests_ = 0;
};

/// Descends two upper trees to the boxes that are nearest to each other.
class BoundDescent {
  public:
    BoundDescent(const TreeTop& a, const TreeTop& b, const PosePair& poses)
        : a_(a), b_(b), poses_(poses), boxes_(relative_pose(poses)), near_(boxes_) {
        // Covers the frames of boxes and, by 1.5 times, the skew.
        stretch_ = 1 + 2 * relative_pose(poses).skew + 8 * axes_error_max;
        visit({0, 0});
    }

    /// Returns a bound on the least distance in A's coordinates. Opens the last pair first, which
    /// is the nearer one of two; leaves out pairs that are farther apart than the bound.
    [[nodiscard]] double bound() {
        while (!waiting_.empty()) {
            const RootPair now = waiting_.back();
            waiting_.pop_back();
            const ObbNode& a = a_.nodes[now.a];
            const ObbNode& b = b_.nodes[now.b];
            near_.set_reach(body_reach(poses_, world_reach(poses_.a, bound_)));
            if ((a.is_leaf() && b.is_leaf()) || !near_.may_overlap(a, b)) {
                continue;
            }
            const bool is_a = opens_a(a, b);
            const RootPair one = is_a ? RootPair{now.a + 1, now.b} : RootPair{now.a, now.b + 1};
            const RootPair other = is_a ? RootPair{a.right, now.b} : RootPair{now.a, b.right};
            const bool is_one_nearer = visit(one) < visit(other);
            if (is_one_nearer) {
                std::swap(waiting_[waiting_.size() - 1], waiting_[waiting_.size() - 2]);
            }
        }
        return bound_;
    }

  private:
    /// Adds a pair, and returns the greatest distance of its boxes.
    double visit(const RootPair& nodes) {
        const ObbNode& a = a_.nodes[nodes.a];
        const PosedBox b = boxes_.pose(b_.nodes[nodes.b]);
        double between = 0;
        double half_a = 0;
        double half_b = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double apart = b.center[i] - a.center[i];
            const auto of_a = static_cast<double>(a.half[i]);
            between += apart * apart;
            half_a += of_a * of_a;
            half_b += b.half[i] * b.half[i];
        }
        const double most =
            stretch_ * (std::sqrt(between) + std::sqrt(half_a) + std::sqrt(half_b)) + 2 * b.error;
        bound_ = std::min(bound_, most);
        waiting_.push_back(nodes);
        return most;
    }

    const TreeTop& a_;
    const TreeTop& b_;
    const PosePair& poses_;
    BoxTest boxes_;
    BoxTest near_;
    std::vector<RootPair> waiting_;
    double stretch_; ///< At least the factor by which a box of B and the frames lengthen a vector.
    double bound_ = std::numeric_limits<double>::infinity();
};

/// Returns the number of the root at a node of the upper tree.
RootIndex root_at(const TreeTop& top, std::uint32_t node) {
    const auto at = std::lower_bound(top.root_nodes.begin(), top.root_nodes.end(), node);
    return static_cast<RootIndex>(at - top.root_nodes.begin());
}

std::vector<RootIndex> distinct(std::vector<RootIndex> roots) {
    std::sort(roots.begin(), roots.end());
    roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
    return roots;
}

} // namespace

TreeTop cut_tree(const ObbTree& tree, std::uint32_t depth) {
    std::vector<ObbNode> nodes;
    const auto add = [&](const TopNode& at) {
        if (at.is_right) {
            nodes[at.parent].right = static_cast<std::uint32_t>(nodes.size());
        }
        ObbNode node = tree.nodes()[at.node];
        if (at.depth == depth) {
            node.right = 0;
        }
        nodes.push_back(node);
    };
    for_each_top_node(tree, add, depth);
    return make_tree_top(std::move(nodes));
}

std::vector<std::uint32_t> cut_nodes(const ObbTree& tree, std::uint32_t depth) {
    std::vector<std::uint32_t> places;
    const auto add = [&](const TopNode& at) {
        if (at.depth == depth || tree.nodes()[at.node].is_leaf()) {
            places.push_back(at.node);
        }
    };
    for_each_top_node(tree, add, depth);
    return places;
}

TreeTop make_tree_top(std::vector<ObbNode> nodes) {
    TreeTop top;
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
        if (nodes[i].is_leaf()) {
            top.root_nodes.push_back(i);
        }
    }
    top.nodes = std::move(nodes);
    return top;
}

Result<CollidingRoots>
colliding_roots(const TreeTop& a, const TreeTop& b, const PosePair& poses, double clearance) {
    CollidingRoots found;
    bool are_too_many = false;
    const auto add = [&](const RootPair& pair) {
        are_too_many = found.pairs.size() == limits::root_pairs_max;
        if (!are_too_many) {
            found.pairs.push_back(pair);
        }
        return !are_too_many;
    };
    found.box_tests = visit_colliding_roots(a, b, poses, clearance, add);
    if (are_too_many) {
        return Error{ErrorCode::TooLarge,
                     "more than " + std::to_string(limits::root_pairs_max) +
                         " pairs of distribution roots overlap; a smaller distribution depth "
                         "helps"};
    }
    std::sort(found.pairs.begin(), found.pairs.end());
    return found;
}

std::uint64_t visit_colliding_roots(const TreeTop& a,
                                    const TreeTop& b,
                                    const PosePair& poses,
                                    double clearance,
                                    const std::function<bool(const RootPair&)>& visit) {
    TopDescent descent(a, b, poses, clearance);
    descent.visit_leaf_pairs([&](const RootPair& nodes) {
        return visit({root_at(a, nodes.a), root_at(b, nodes.b)});
    });
    return descent.box_tests();
}

TreeTop whole_body(const TreeTop& top) {
    ObbNode root = top.nodes.front();
    root.right = 0;
    return make_tree_top({root});
}

double distance_bound(const TreeTop& a, const TreeTop& b, const PosePair& poses) {
    return world_reach(poses.a, BoundDescent(a, b, poses).bound());
}

std::vector<RootIndex> roots_of_a(std::span<const RootPair> pairs) {
    std::vector<RootIndex> roots;
    roots.reserve(pairs.size());
    for (const RootPair& pair : pairs) {
        roots.push_back(pair.a);
    }
    return distinct(std::move(roots));
}

std::vector<RootIndex> roots_of_b(std::span<const RootPair> pairs) {
    std::vector<RootIndex> roots;
    roots.reserve(pairs.size());
    for (const RootPair& pair : pairs) {
        roots.push_back(pair.b);
    }
    return distinct(std::move(roots));
}

} // namespace cd
