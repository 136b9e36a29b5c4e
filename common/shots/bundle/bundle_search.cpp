// Why signs of turns decide. In the bundle's coordinates, with the axes in the order (k, k + 1,
// k + 2) for lines along k, d = q - p is (d_0, 0, 0), and
//     det(d, v_i - p, v_j - p) = d_0 * ((v_i - p)_1 (v_j - p)_2 - (v_i - p)_2 (v_j - p)_1),
// d_0 times the turn from v_i to v_j around the line. A rotation changes no determinant. So the
// turns have the signs of SegmentHit's edges, or all the opposite ones. If all three are positive,
// or all negative, the line passes through the triangle's inside, and it crosses it if its ends are
// on both sides of all corners along the axis. If one is positive and one negative, it misses.
#include "common/shots/bundle/bundle_search.hpp"

#include "common/core/check.hpp"
#include "common/shots/line_hit.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace cd {

namespace {

/// The search returns to its caller once it has found so many pairs.
constexpr std::size_t found_at_once = 512;

void prefetch(const void* from, std::size_t bytes) {
    const auto* line = static_cast<const char*>(from);
    for (std::size_t i = 0; i < bytes; i += 64) {
        __builtin_prefetch(line + i);
    }
}

/// Prefetches a block's corners, and its vertices up to the count that most blocks have.
void prefetch_block(const TriangleBlocks& blocks, std::uint32_t block) {
    constexpr std::size_t numbers = 3 * std::size_t{block_size};
    const std::size_t first = 3 * std::size_t{blocks.vertex_begin[block]};
    if (blocks.doubles.empty()) {
        prefetch(&blocks.floats[first], numbers * sizeof(float));
    } else {
        prefetch(&blocks.doubles[first], numbers * sizeof(double));
    }
    prefetch(&blocks.corners[std::size_t{block_size} * block], block_size * sizeof(BlockCorners));
}

} // namespace

/// With u = 2^-53, e for the error and L, M for the bounds of differences on the two axes, L + M =
/// S: a computed difference of a corner and a line is at most L and errs by e + u L. The product of
/// two errs by L (e + u M) + M (e + u L) + (e + u S)^2, and rounding by u L M; two products by
/// twice that, and their difference by another 2 u L M. With L M <= S^2 / 4 that is at most
///     2 S e + u S^2 + 2 (e + u S)^2 + u S^2.
/// The bound below has room for the last term's u S, and for its own roundings.
double turn_error(double across, double error) {
    constexpr double u = 0x1p-53;
    return 1.01 * (2 * across * error + 3 * u * across * across + 2 * error * error) + 0x1p-1000;
}

bool BundleSearch::start(const WideView& a, const ParallelLines& lines, const PosePair& poses) {
    CD_CHECK(!a.nodes.empty());
    stack_.clear();
    waiting_.clear();
    if (!BundleFrame::suits(poses)) {
        return false;
    }
    frame_.emplace(poses, lines.axis(), std::max(a.extent, a.triangles.reach));
    if (!std::isfinite(frame_->error())) {
        return false;
    }
    a_ = a;
    lines_ = &lines;
    across_ = lines_across(lines);
    stack_.push_back(0);
    return true;
}

BundleSearch::Found BundleSearch::next() {
    passes_.clear();
    open_.clear();
    while (passes_.size() + open_.size() < found_at_once && !is_done()) {
        if (waiting_.size() == waiting_most || stack_.empty()) {
            const Leaf leaf = waiting_.front();
            waiting_.erase(waiting_.begin());
            test_leaf(leaf);
        } else {
            const std::uint32_t node = stack_.back();
            stack_.pop_back();
            visit(a_.nodes[node]);
        }
    }
    return {passes_, open_};
}

/// Returns a bit mask of the children that may meet lines.
std::uint32_t BundleSearch::children_of(const WideNode& node) const {
    const std::array<double, 2> middle = lines_->middle();
    ChildrenAcross boxes;
    std::uint32_t children =
        children_with_lines(node, node_across(node, *frame_, middle), across_, boxes) &
        ((1u << node.count) - 1);
    if (lines_->is_grid()) {
        return children;
    }
    std::uint32_t found = 0;
    for (; children != 0; children &= children - 1) {
        const auto child = static_cast<std::size_t>(std::countr_zero(children));
        const std::array<double, 2> low{middle[0] + double{boxes.low[0][child]},
                                        middle[1] + double{boxes.low[1][child]}};
        const std::array<double, 2> high{middle[0] + double{boxes.high[0][child]},
                                         middle[1] + double{boxes.high[1][child]}};
        found |= lines_->may_hold(low, high) ? 1u << child : 0u;
    }
    return found;
}

/// Puts the children that may meet lines on the stack, or lets the leaf wait.
void BundleSearch::visit(const WideNode& node) {
    std::uint32_t found = children_of(node);
    box_tests_ += node.count;
    if (found == 0) {
        return;
    }
    if (node.is_leaf) {
        waiting_.push_back({&node, found});
        prefetch_block(a_.triangles, node.first);
        return;
    }
    for (; found != 0; found &= found - 1) {
        const std::uint32_t child =
            node.first + static_cast<std::uint32_t>(std::countr_zero(found));
        prefetch(&a_.nodes[child], sizeof(WideNode));
        stack_.push_back(child);
    }
}

void BundleSearch::test_leaf(const Leaf& leaf) {
    place_block(a_.triangles, leaf.node->first, *frame_, placed_);
    for (std::uint32_t left = leaf.triangles; left != 0; left &= left - 1) {
        const std::uint32_t slot =
            block_size * leaf.node->first + static_cast<std::uint32_t>(std::countr_zero(left));
        test_triangle(slot, a_.triangles.corners[slot]);
    }
}

void BundleSearch::test_triangle(std::uint32_t slot, const BlockCorners& corners) {
    const double error = frame_->error();
    const auto& at = placed_.at;
    TriangleAcross triangle;
    double across = 0;
    for (std::size_t which = 0; which < 2; ++which) {
        const std::array<double, 3> place{
            at[1 + which][corners[0]], at[1 + which][corners[1]], at[1 + which][corners[2]]};
        const double low = std::min(std::min(place[0], place[1]), place[2]) - error;
        const double high = std::max(std::max(place[0], place[1]), place[2]) + error;
        const std::uint32_t first = lines_->bin_of(low, which);
        const std::uint32_t last = lines_->bin_of(high, which);
        if (!lines_->may_hold(which, first, last, low, high)) {
            return;
        }
        triangle.corners[which] = place;
        triangle.bins.first[which] = first;
        triangle.bins.last[which] = last;
        across += high - low + lines_->bin_size(which);
    }
    triangle.error = bound_scale_ * turn_error(across, error);
    const auto [least, most] = std::minmax(lines_->ends()[0], lines_->ends()[1]);
    bool is_between = true;
    for (std::size_t i = 0; i < 3; ++i) {
        const double along = at[0][corners[i]];
        is_between = is_between && along - error > least && along + error < most;
    }
    const LineRows rows = lines_->rows();
    MarkedLines marked;
    for (bool is_done = false; !is_done;) {
        is_done = mark_lines(triangle, rows, marked);
        line_tests_ += marked.tested;
        add(slot, is_between, marked);
    }
}

/// Adds marked lines of a triangle that is between the lines' ends or not.
void BundleSearch::add(std::uint32_t slot, bool is_between, const MarkedLines& marked) {
    const bool rises = lines_->ends()[1] > lines_->ends()[0];
    for (std::size_t i = 0; i < marked.count; ++i) {
        const std::uint32_t line = marked.lines[i];
        if (marked.passes[i] == LinePasses::Unknown || !is_between) {
            open_.push_back({slot, lines_->slots()[line]});
            --line_tests_;
            continue;
        }
        const bool is_back = (marked.passes[i] == LinePasses::Along) == rises;
        const int side = is_back ? hit_flag::back : hit_flag::front;
        passes_.push_back({slot, line, static_cast<std::uint8_t>(hit_flag::crosses | side)});
    }
}

} // namespace cd
