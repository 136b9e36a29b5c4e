// Why signs of turns decide. In the bundle's coordinates, with the axes in the order (k, k + 1,
// k + 2) for lines along k, d = q - p is (d_0, 0, 0), and
//     det(d, v_i - p, v_j - p) = d_0 * ((v_i - p)_1 (v_j - p)_2 - (v_i - p)_2 (v_j - p)_1),
// d_0 times the turn from v_i to v_j around the line. A rotation changes no determinant. So the
// turns have the signs of SegmentHit's edges, or all the opposite ones. If all three are positive,
// or all negative, the line passes through the triangle's inside, and it crosses it if its ends are
// on both sides of all corners along the axis. If one is positive and one negative, it misses.
#include "common/shots/bundle/bundle_search.hpp"

#include "common/core/check.hpp"
#include "common/core/prefetch.hpp"
#include "common/shots/bundle/bundle_grid_kernel.hpp"
#include "common/shots/line_hit.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace cd {

namespace {

/// The search returns to its caller once it has found so many pairs.
constexpr std::size_t found_at_once = 512;

/// Prefetches a block's corners and vertices.
void prefetch_block(const TriangleBlocks& blocks, std::uint32_t block) {
    const std::size_t first = 3 * std::size_t{blocks.vertex_begin[block]};
    const std::size_t end = 3 * std::size_t{blocks.vertex_begin[block + 1]};
    if (blocks.doubles.empty()) {
        prefetch(&blocks.floats[first], (end - first) * sizeof(float));
    } else {
        prefetch(&blocks.doubles[first], (end - first) * sizeof(double));
    }
    prefetch(&blocks.corners[std::size_t{block_size} * block], block_size * sizeof(BlockCorners));
}

} // namespace

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
    across_ = {lines_across(lines), bundle_across(lines, frame_->error(), bound_scale_)};
    stack_.push_back(0);
    return true;
}

BundleSearch::Found BundleSearch::next() {
    found_.triangles.clear();
    found_.lines.clear();
    found_.open.clear();
    while (found_.lines.size() + found_.open.size() < found_at_once && !is_done()) {
        if (waiting_.is_full() || stack_.empty()) {
            test_leaf(waiting_.take());
        } else {
            const std::uint32_t node = stack_.back();
            stack_.pop_back();
            visit(a_.nodes[node]);
        }
    }
    return {found_.triangles, found_.lines, found_.open};
}

/// Returns a bit mask of the children that may meet lines.
std::uint32_t BundleSearch::children_of(const WideNode& node) const {
    const std::array<double, 2> middle = lines_->middle();
    ChildrenAcross boxes;
    std::uint32_t children =
        children_with_lines(node, node_across(node, *frame_, middle), across_.of_boxes, boxes) &
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
    tests_.boxes += node.count;
    if (found == 0) {
        return;
    }
    if (node.is_leaf) {
        waiting_.add({&node, found});
        prefetch_block(a_.triangles, node.first);
        return;
    }
    // The first child comes to lie on top, so that the walk goes forward in memory.
    while (found != 0) {
        const auto last = static_cast<std::uint32_t>(std::bit_width(found)) - 1;
        found ^= 1u << last;
        prefetch(&a_.nodes[node.first + last], sizeof(WideNode));
        stack_.push_back(node.first + last);
    }
}

void BundleSearch::test_leaf(const Leaf& leaf) {
    const std::uint32_t block = leaf.node->first;
    const BundleAcross& bundle = across_.of_triangles;
    place_block(a_.triangles, block, leaf.triangles, *frame_, bundle, placed_);
    const LineRows rows = lines_->rows();
    LineWalk walk;
    for (bool is_done = false; !is_done;) {
        is_done = lines_->is_grid() ? mark_grid_pairs(placed_, bundle, rows, walk, marked_)
                                    : mark_pairs(placed_, bundle, rows, walk, marked_);
        add_marked(block_size * block);
    }
}

/// Adds the marked pairs of the block with the given first slot.
void BundleSearch::add_marked(std::uint32_t first_slot) {
    const bool rises = lines_->ends()[1] > lines_->ends()[0];
    const MarkedPairs& marked = marked_;
    tests_.lines += marked.tested - marked.open;
    const auto end = static_cast<std::uint32_t>(found_.lines.size());
    for (std::uint32_t run = 0; run < marked.runs; ++run) {
        const auto& [triangle, begin, turns_left] = marked.of_triangles[run];
        const std::uint32_t slot = first_slot + placed_.places[triangle];
        // The lines of a triangle may come in several calls of the kernel.
        if (found_.triangles.empty() || found_.triangles.back().slot != slot) {
            const int side = turns_left == rises ? hit_flag::back : hit_flag::front;
            const int flags = hit_flag::crosses | side;
            found_.triangles.push_back({slot, end + begin, static_cast<std::uint8_t>(flags)});
        }
    }
    found_.lines.insert(
        found_.lines.end(), marked.passing.begin(), marked.passing.begin() + marked.passes);
    for (std::uint32_t i = 0; i < marked.open; ++i) {
        const std::uint32_t slot = first_slot + placed_.places[marked.open_triangles[i]];
        found_.open.push_back({slot, lines_->slots()[marked.open_lines[i]]});
    }
}

} // namespace cd
