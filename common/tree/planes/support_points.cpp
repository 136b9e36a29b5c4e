#include "common/tree/planes/support_points.hpp"

#include "common/tree/planes/hull_choice.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <span>

namespace cd {

namespace {

/// A point farther from the hull than this share of the node's size is chosen, if there is room.
constexpr double eps_share = 0x1p-12;

/// A node with at most this many points chooses all of them, if enough are equal: vertices are in
/// the blocks of several leaves.
constexpr std::size_t sorted_points_max = 512;

/// The points that a large node chose.
struct Chosen {
    std::vector<FloatPoint> points;
    double eps = 0;
};

/// Makes the points of one tree.
class Maker {
  public:
    Maker(const WideView& tree, std::span<SupportSet> sets);

    [[nodiscard]] std::array<float, 3> center() const { return center_; }
    [[nodiscard]] double radius() const { return radius_; }

    void choose_all(ThreadPool* pool);
    /// Moves the chosen points to one array.
    [[nodiscard]] std::vector<float> take_columns();

  private:
    void find_center();
    void find_ranges();
    void choose(std::uint32_t node);
    void add_points(std::uint32_t node, std::vector<FloatPoint>& to) const;

    const WideView& tree_;
    std::span<SupportSet> sets_;
    std::array<float, 3> center_{};
    double radius_ = 0;
    std::vector<std::vector<std::uint32_t>> large_; ///< Large nodes, by their height above others.
    std::vector<Chosen> chosen_;                    ///< By node; empty for small ones.
};

Maker::Maker(const WideView& tree, std::span<SupportSet> sets)
    : tree_(tree), sets_(sets), chosen_(tree.nodes.size()) {
    find_center();
    find_ranges();
}

void Maker::find_center() {
    const TriangleBlocks& blocks = tree_.triangles;
    Vec3 low = blocks.vertex(0);
    Vec3 high = low;
    for (std::size_t i = 0; i < blocks.vertex_begin.back(); ++i) {
        const Vec3 vertex = blocks.vertex(i);
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
    }
    double square = 0;
    for (int k = 0; k < 3; ++k) {
        const auto middle = static_cast<float>(0.5 * (low[k] + high[k]));
        center_[static_cast<std::size_t>(k)] = middle;
        const double half =
            std::max(high[k] - static_cast<double>(middle), static_cast<double>(middle) - low[k]);
        square += half * half;
    }
    radius_ = (1 + 0x1p-40) * std::sqrt(square);
}

/// Finds the vertices below each node, and which nodes are large. The blocks below a node follow
/// each other.
void Maker::find_ranges() {
    struct Range {
        std::uint32_t begin = std::numeric_limits<std::uint32_t>::max();
        std::uint32_t end = 0;
        std::uint32_t height = 0; ///< Of a large node: 1 + the largest of its children.
    };
    std::vector<Range> ranges(tree_.nodes.size());
    const auto vertex_begin = tree_.triangles.vertex_begin;
    for (std::size_t i = tree_.nodes.size(); i-- > 0;) {
        const WideNode& node = tree_.nodes[i];
        Range& range = ranges[i];
        if (node.is_leaf) {
            range = {vertex_begin[node.first], vertex_begin[node.first + 1], 0};
        } else {
            for (std::uint32_t child = node.first; child < node.first + node.count; ++child) {
                range.begin = std::min(range.begin, ranges[child].begin);
                range.end = std::max(range.end, ranges[child].end);
                range.height = std::max(range.height, ranges[child].height);
            }
        }
        if (range.end - range.begin > support_vertices_max) {
            range.height += 1;
            large_.resize(std::max<std::size_t>(large_.size(), range.height));
            large_[range.height - 1].push_back(static_cast<std::uint32_t>(i));
        } else {
            sets_[i].first = range.begin;
            sets_[i].count = static_cast<std::uint16_t>(range.end - range.begin);
        }
    }
}

void Maker::add_points(std::uint32_t node, std::vector<FloatPoint>& to) const {
    if (!chosen_[node].points.empty()) {
        to.insert(to.end(), chosen_[node].points.begin(), chosen_[node].points.end());
        return;
    }
    const SupportSet& set = sets_[node];
    for (std::uint32_t i = set.first; i < set.first + set.count; ++i) {
        const Vec3 vertex = tree_.triangles.vertex(i);
        FloatPoint point;
        for (std::size_t k = 0; k < 3; ++k) {
            point[k] =
                static_cast<float>(vertex[static_cast<int>(k)] - static_cast<double>(center_[k]));
        }
        to.push_back(point);
    }
}

void Maker::choose(std::uint32_t node) {
    const WideNode& parent = tree_.nodes[node];
    std::vector<FloatPoint> points;
    double eps = 0;
    for (std::uint32_t child = parent.first; child < parent.first + parent.count; ++child) {
        add_points(child, points);
        eps = std::max(eps, chosen_[child].eps);
    }
    FloatPoint least = points.front();
    FloatPoint most = least;
    for (const FloatPoint& point : points) {
        for (std::size_t k = 0; k < 3; ++k) {
            least[k] = std::min(least[k], point[k]);
            most[k] = std::max(most[k], point[k]);
        }
    }
    const double size = std::hypot(most[0] - least[0], most[1] - least[1], most[2] - least[2]);
    if (points.size() <= sorted_points_max) {
        std::ranges::sort(points);
        points.erase(std::ranges::unique(points).begin(), points.end());
        if (points.size() <= support_points_max) {
            chosen_[node] = {std::move(points), eps};
            return;
        }
    }
    const HullChoice choice = choose_hull(points, support_points_max, eps_share * size, radius_);
    chosen_[node].eps = eps + choice.eps;
    for (const std::uint32_t number : choice.numbers) {
        chosen_[node].points.push_back(points[number]);
    }
}

void Maker::choose_all(ThreadPool* pool) {
    for (const std::vector<std::uint32_t>& nodes : large_) {
        parallel_for(pool, nodes.size(), [&](std::size_t i) { choose(nodes[i]); });
    }
}

std::vector<float> Maker::take_columns() {
    std::vector<float> columns;
    for (std::size_t i = 0; i < chosen_.size(); ++i) {
        const std::vector<FloatPoint>& points = chosen_[i].points;
        if (points.empty()) {
            continue;
        }
        sets_[i].first = static_cast<std::uint32_t>(columns.size() / 3);
        sets_[i].count = static_cast<std::uint16_t>(points.size());
        sets_[i].is_chosen = true;
        sets_[i].eps = std::nextafter(static_cast<float>(chosen_[i].eps),
                                      std::numeric_limits<float>::infinity());
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t n = 0; n < padded(sets_[i].count); ++n) {
                columns.push_back(points[std::min(n, points.size() - 1)][k]);
            }
        }
    }
    return columns;
}

} // namespace

std::uint64_t next_support_id() {
    static std::atomic<std::uint64_t> last = 0;
    return ++last;
}

SupportPoints::SupportPoints(const WideView& tree, ThreadPool* pool) : sets_(tree.nodes.size()) {
    Maker maker(tree, sets_);
    maker.choose_all(pool);
    columns_ = maker.take_columns();
    center_ = maker.center();
    radius_ = maker.radius();
}

} // namespace cd
