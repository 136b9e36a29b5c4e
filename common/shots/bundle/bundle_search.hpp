// Finds where lines of a bundle pass through triangles: descends A's tree and asks each box and
// triangle which lines its shadow holds.
#pragma once

#include "common/pair/triangle_pair.hpp"
#include "common/shots/bundle/bundle_boxes_kernel.hpp"
#include "common/shots/bundle/bundle_frame.hpp"
#include "common/shots/bundle/bundle_marks_kernel.hpp"
#include "common/shots/bundle/bundle_triangles_kernel.hpp"
#include "common/shots/bundle/parallel_lines.hpp"
#include "common/shots/bundle/passed_triangle.hpp"
#include "common/tree/wide/wide_node.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace cd {

/// The search projects A along the lines. A line that is at a positive distance from the shadows of
/// a triangle's edges, by the signs of three turns, passes through it or misses it; doubles prove
/// nearly all signs, with the bound of `turn_error_of`. Pairs that stay open are left to the
/// caller.
class BundleSearch {
  public:
    /// Multiplies the error bound of turns by `bound_scale`. Answers are right only from 1 on;
    /// tests use less to show that the bound is needed.
    explicit BundleSearch(double bound_scale = 1) : bound_scale_(bound_scale) {}

    /// Starts to look for `lines`, which belong to B, in A's tree. Returns false if the poses do
    /// not suit; the lines and the tree must live until the search is done. Keeps scratch memory.
    [[nodiscard]] bool start(const WideView& a, const ParallelLines& lines, const PosePair& poses);

    [[nodiscard]] bool is_done() const { return stack_.empty() && waiting_.empty(); }

    /// Some pairs of triangles and lines, valid until the next call.
    struct Found {
        std::span<const PassedTriangle> triangles;
        std::span<const std::uint32_t> lines; ///< Places among the lines.
        std::span<const Candidate> open;      ///< Pairs of slots of A and B that may meet.

        /// Returns the lines that pass through a triangle of the list.
        [[nodiscard]] std::span<const std::uint32_t> lines_of(std::size_t i) const {
            const std::size_t begin = triangles[i].begin;
            const std::size_t end =
                i + 1 < triangles.size() ? triangles[i + 1].begin : lines.size();
            return lines.subspan(begin, end - begin);
        }
    };
    /// Continues the search until it has found some pairs or is done. Never tells a pair, nor the
    /// passes of a triangle, twice.
    [[nodiscard]] Found next();

    /// Returns the number of boxes tested since construction.
    [[nodiscard]] std::uint64_t box_tests() const { return tests_.boxes; }
    /// Returns the number of pairs of triangles and lines decided since construction; open ones do
    /// not count.
    [[nodiscard]] std::uint64_t line_tests() const { return tests_.lines; }

  private:
    /// A leaf some of whose triangles may meet lines.
    struct Leaf {
        const WideNode* node = nullptr;
        std::uint32_t triangles = 0; ///< Bit mask.
    };
    /// The lines as boxes and triangles are compared with them.
    struct Across {
        LinesAcross of_boxes;
        BundleAcross of_triangles;
    };
    struct Tests {
        std::uint64_t boxes = 0;
        std::uint64_t lines = 0;
    };
    /// What `Found` shows.
    struct Lists {
        std::vector<PassedTriangle> triangles;
        std::vector<std::uint32_t> lines;
        std::vector<Candidate> open;
    };
    /// Leaves that wait for their triangles to arrive from memory, the oldest first.
    class Leaves {
      public:
        [[nodiscard]] bool empty() const { return begin_ == end_; }
        [[nodiscard]] bool is_full() const { return end_ - begin_ == most; }
        void clear() { begin_ = end_; }
        void add(const Leaf& leaf) { leaves_[end_++ % most] = leaf; }
        [[nodiscard]] Leaf take() { return leaves_[begin_++ % most]; }

      private:
        static constexpr std::uint32_t most = 8;

        std::array<Leaf, most> leaves_;
        std::uint32_t begin_ = 0; ///< Counts on and wraps around.
        std::uint32_t end_ = 0;
    };

    [[nodiscard]] std::uint32_t children_of(const WideNode& node) const;
    void visit(const WideNode& node);
    void test_leaf(const Leaf& leaf);
    void add_marked(std::uint32_t first_slot);

    double bound_scale_;
    WideView a_;
    const ParallelLines* lines_ = nullptr;
    Across across_;
    std::optional<BundleFrame> frame_;
    std::vector<std::uint32_t> stack_;
    Leaves waiting_;
    BlockAcross placed_; ///< The triangles of the leaf that is tested.
    MarkedPairs marked_;
    Lists found_;
    Tests tests_;
};

} // namespace cd
