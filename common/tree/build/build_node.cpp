#include "common/tree/build/build_node.hpp"

#include "common/core/check.hpp"
#include "common/tree/build/build_bins.hpp"
#include "common/tree/build/build_few.hpp"

#include <algorithm>
#include <optional>

namespace cd {

namespace {

/// Returns the size of the left child, for triangles that no axis tells apart.
std::uint32_t half_of(std::size_t count) {
    return static_cast<std::uint32_t>(count / 2);
}

bool is_binned(const BuildOptions& options, std::size_t count) {
    return options.rule == SplitRule::Quarter && count > options.sweep_triangles_max;
}

Vec3 origin_of(std::span<const BuildTriangle> triangles, std::span<const Vec3> vertices) {
    // Coordinates are measured from a corner, so that the squares do not swamp the differences.
    return vertices[triangles.front().vertices[0]];
}

} // namespace

std::vector<ObbNode> SubtreeMaker::make(std::span<BuildTriangle> triangles, std::uint32_t begin) {
    triangles_ = triangles;
    begin_ = begin;
    projections_.resize(std::max(projections_.size(), triangles.size()));
    scratch_.resize(std::max(scratch_.size(), triangles.size()));
    nodes_.clear();
    const auto add_node = [&](std::uint32_t from, std::uint32_t to) {
        ObbNode& node = nodes_.emplace_back().node;
        node.triangles_begin = from;
        node.triangles_end = to;
    };
    add_node(begin, begin + static_cast<std::uint32_t>(triangles.size()));
    for (std::size_t level_begin = 0; level_begin < nodes_.size();) {
        const std::size_t level_end = nodes_.size();
        fit_level(level_begin);
        for (std::size_t i = level_begin; i < level_end; ++i) {
            ObbNode node = nodes_[i].node;
            const std::uint32_t left = make_node(node);
            nodes_[i] = {node, left == 0 ? 0 : static_cast<std::uint32_t>(nodes_.size())};
            if (left != 0) {
                add_node(node.triangles_begin, node.triangles_begin + left);
                add_node(node.triangles_begin + left, node.triangles_end);
            }
        }
        level_begin = level_end;
    }
    return in_preorder();
}

/// Sets the axes of the nodes from `level_begin` on, all at once.
void SubtreeMaker::fit_level(std::size_t level_begin) {
    const std::span<LevelNode> level = std::span(nodes_).subspan(level_begin);
    if (!input_.measurable || input_.options.boxes == BoxKind::Aabb) {
        for (LevelNode& one : level) {
            one.node.axes = body_axes;
        }
        return;
    }
    moments_.clear();
    for (const LevelNode& one : level) {
        const std::span<const BuildTriangle> triangles = triangles_of(one.node);
        moments_.push_back(
            sum_moments(triangles, input_.vertices, origin_of(triangles, input_.vertices)));
    }
    const std::vector<std::array<float, 9>> axes = fit_axes(moments_);
    for (std::size_t i = 0; i < level.size(); ++i) {
        level[i].node.axes = axes[i];
    }
}

/// Sets the box of a node whose axes are set, and moves the triangles of the left child to the
/// front. Returns the number of these triangles; 0 for a leaf.
std::uint32_t SubtreeMaker::make_node(ObbNode& node) {
    const std::span<BuildTriangle> triangles = triangles_of(node);
    const bool leaf = triangles.size() <= input_.options.leaf_triangles_max;
    if (!input_.measurable) {
        set_unbounded_box(node);
        return leaf ? 0 : half_of(triangles.size());
    }
    const Vec3 origin = origin_of(triangles, input_.vertices);
    const std::span<Projection> projections = std::span(projections_).first(triangles.size());
    const Projection whole = project(triangles, input_.vertices, origin, node.axes, projections);
    set_box(whole, origin, node);
    return leaf ? 0 : part(triangles, projections, whole);
}

std::vector<ObbNode> SubtreeMaker::in_preorder() {
    sizes_.assign(nodes_.size(), 1);
    for (std::size_t i = nodes_.size(); i-- > 0;) {
        if (nodes_[i].left != 0) {
            sizes_[i] += sizes_[nodes_[i].left] + sizes_[nodes_[i].left + 1];
        }
    }
    preorder_.assign(nodes_.size(), 0);
    std::vector<ObbNode> ordered(nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        const auto& [node, left] = nodes_[i];
        ObbNode& to = ordered[preorder_[i]];
        to = node;
        if (left != 0) {
            preorder_[left] = preorder_[i] + 1;
            preorder_[left + 1] = preorder_[left] + sizes_[left];
            to.right = preorder_[left + 1];
        }
    }
    return ordered;
}

std::uint32_t SubtreeMaker::part(std::span<BuildTriangle> triangles,
                                 std::span<const Projection> projections,
                                 const Projection& whole) {
    const BuildOptions& options = input_.options;
    if (triangles.size() <= std::min(few_triangles_max, std::size_t{options.sweep_triangles_max})) {
        const std::optional<FewSplit> few = sweep_few(projections, whole, options.rule);
        return few ? part_by(triangles,
                             scratch_,
                             [&](std::uint32_t i) { return (few->left >> i & 1) != 0; })
                   : half_of(triangles.size());
    }
    std::optional<Split> split;
    if (is_binned(options, triangles.size())) {
        Bins bins(whole);
        bins.add(projections);
        split = binned_split(projections, whole, bins, sweep_);
    } else {
        split = sweep_split(projections, whole, options.rule, sweep_);
    }
    if (!split) {
        return half_of(triangles.size());
    }
    const std::uint32_t left = part_triangles(triangles, projections, 0, *split, scratch_);
    CD_CHECK(left == split->left_count);
    return left;
}

struct LargeNodeMaker::Piece {
    std::size_t node;    ///< Index among the nodes of the wave.
    std::uint32_t begin; ///< Index among the triangles of the node.
    std::uint32_t end;
    std::uint32_t left_before = 0; ///< Number of triangles of earlier pieces that go left.
    std::uint32_t left_count = 0;
};

/// Makes several large nodes at once, step by step. The pieces of one step run in any order.
class LargeNodeMaker::Wave {
  public:
    Wave(LargeNodeMaker& maker, std::span<NodeToMake> nodes) : maker_(maker), nodes_(nodes) {
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const std::uint32_t count = nodes[i].node.triangle_count();
            for (std::uint32_t begin = 0; begin < count; begin += piece_triangles_max) {
                pieces_.push_back({i, begin, std::min(count, begin + piece_triangles_max)});
            }
            origins_.push_back(origin_of(nodes[i].triangles, maker.input_.vertices));
        }
    }

    void fit();
    void enclose();
    void split();
    void part();

  private:
    template <class Function>
    void for_pieces(const Function& function) {
        parallel_for(maker_.pool_, pieces_.size(), [&](std::size_t i) { function(i); });
    }

    [[nodiscard]] std::span<BuildTriangle> triangles_of(const Piece& piece) const {
        return nodes_[piece.node].triangles.subspan(piece.begin, piece.end - piece.begin);
    }
    [[nodiscard]] std::span<Projection> projections_of(std::size_t node) const {
        return std::span(maker_.projections_)
            .subspan(nodes_[node].node.triangles_begin, nodes_[node].node.triangle_count());
    }
    [[nodiscard]] std::span<Projection> projections_of(const Piece& piece) const {
        return projections_of(piece.node).subspan(piece.begin, piece.end - piece.begin);
    }
    void gather_sides();

    LargeNodeMaker& maker_;
    std::span<NodeToMake> nodes_;
    std::vector<Piece> pieces_;
    std::vector<Vec3> origins_; ///< Indexed by node, like `wholes_` and `splits_`.
    std::vector<Projection> wholes_;
    std::vector<std::optional<Split>> splits_;
};

void LargeNodeMaker::Wave::fit() {
    if (maker_.input_.options.boxes == BoxKind::Aabb) {
        for (NodeToMake& node : nodes_) {
            node.node.axes = body_axes;
        }
        return;
    }
    std::vector<Moments> parts(pieces_.size());
    for_pieces([&](std::size_t i) {
        const Piece& piece = pieces_[i];
        parts[i] = sum_moments(triangles_of(piece), maker_.input_.vertices, origins_[piece.node]);
    });
    std::vector<Moments> sums(nodes_.size());
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        sums[pieces_[i].node] += parts[i];
    }
    const std::vector<std::array<float, 9>> axes = fit_axes(sums);
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        nodes_[i].node.axes = axes[i];
    }
}

void LargeNodeMaker::Wave::enclose() {
    std::vector<Projection> parts(pieces_.size());
    for_pieces([&](std::size_t i) {
        const Piece& piece = pieces_[i];
        parts[i] = project(triangles_of(piece),
                           maker_.input_.vertices,
                           origins_[piece.node],
                           nodes_[piece.node].node.axes,
                           projections_of(piece));
    });
    wholes_.assign(nodes_.size(), empty_projection());
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        extend(wholes_[pieces_[i].node], parts[i]);
    }
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        set_box(wholes_[i], origins_[i], nodes_[i].node);
    }
}

void LargeNodeMaker::Wave::split() {
    const BuildOptions& options = maker_.input_.options;
    std::vector<Bins> parts;
    for (const Piece& piece : pieces_) {
        parts.emplace_back(wholes_[piece.node]);
    }
    for_pieces([&](std::size_t i) {
        if (is_binned(options, nodes_[pieces_[i].node].triangles.size())) {
            parts[i].add(projections_of(pieces_[i]));
        }
    });
    std::vector<Bins> bins(wholes_.begin(), wholes_.end());
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        bins[pieces_[i].node] += parts[i];
    }
    splits_.resize(nodes_.size());
    parallel_for(maker_.pool_, nodes_.size(), [&](std::size_t i) {
        SweepScratch scratch;
        const std::span<const Projection> projections = projections_of(i);
        splits_[i] = is_binned(options, projections.size())
                         ? binned_split(projections, wholes_[i], bins[i], scratch)
                         : sweep_split(projections, wholes_[i], options.rule, scratch);
    });
}

void LargeNodeMaker::Wave::part() {
    for_pieces([&](std::size_t i) {
        Piece& piece = pieces_[i];
        if (splits_[piece.node]) {
            const std::span<BuildTriangle> scratch =
                std::span(maker_.triangles_)
                    .subspan(nodes_[piece.node].node.triangles_begin + piece.begin,
                             piece.end - piece.begin);
            piece.left_count = part_triangles(triangles_of(piece),
                                              projections_of(piece),
                                              piece.begin,
                                              *splits_[piece.node],
                                              scratch);
        }
    });
    for (Piece& piece : pieces_) {
        std::uint32_t& left = nodes_[piece.node].left_count;
        piece.left_before = left;
        left += piece.left_count;
    }
    gather_sides();
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        if (splits_[i]) {
            CD_CHECK(nodes_[i].left_count == splits_[i]->left_count);
        } else {
            nodes_[i].left_count = half_of(nodes_[i].triangles.size());
        }
    }
}

/// Moves the triangles of each node's left child to the front. Requires that they come first in
/// each piece.
void LargeNodeMaker::Wave::gather_sides() {
    const auto scratch_of = [&](const Piece& piece) {
        return maker_.triangles_.begin() + nodes_[piece.node].node.triangles_begin;
    };
    for_pieces([&](std::size_t i) {
        const Piece& piece = pieces_[i];
        if (splits_[piece.node]) {
            const auto from = triangles_of(piece);
            const auto left = scratch_of(piece) + piece.left_before;
            const auto right =
                scratch_of(piece) + nodes_[piece.node].left_count + piece.begin - piece.left_before;
            std::copy_n(from.begin(), piece.left_count, left);
            std::copy(from.begin() + piece.left_count, from.end(), right);
        }
    });
    for_pieces([&](std::size_t i) {
        const Piece& piece = pieces_[i];
        if (splits_[piece.node]) {
            const auto to = triangles_of(piece);
            std::copy_n(scratch_of(piece) + piece.begin, to.size(), to.begin());
        }
    });
}

void LargeNodeMaker::make(std::span<NodeToMake> nodes) {
    if (!input_.measurable) {
        for (NodeToMake& node : nodes) {
            set_unbounded_box(node.node);
            node.left_count = half_of(node.triangles.size());
        }
        return;
    }
    Wave wave(*this, nodes);
    wave.fit();
    wave.enclose();
    wave.split();
    wave.part();
}

} // namespace cd
