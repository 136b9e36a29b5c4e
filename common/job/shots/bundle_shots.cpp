#include "common/job/shots/bundle_shots.hpp"

#include "common/job/shots/stable_order.hpp"
#include "common/shots/bundle/bundle_depths.hpp"
#include "common/shots/bundle/bundle_search.hpp"
#include "common/shots/bundle/parallel_lines.hpp"
#include "common/shots/line_hit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

namespace cd {

namespace {

/// A hit, and where its triangle and line are.
struct Pass {
    double depth = 0; ///< NaN if it is not known.
    std::uint32_t triangle = 0;
    std::uint32_t line = 0;
    Candidate slots;
    std::uint32_t pair = 0; ///< Among the pairs of subtrees.
    std::uint8_t flags = 0;
};

/// The lines of one bundle, or that it has none that are parallel.
struct KnownLines {
    std::vector<std::uint32_t> ids; ///< Of the bundle, by slot.
    bool are_parallel = false;
    ParallelLines lines;
};

/// The lines of subtrees of one tree. Scenarios that share a bundle share its lines.
class LinesByBundle {
  public:
    /// Returns the lines of a bundle; null unless they are parallel. Valid until the next call.
    [[nodiscard]] const ParallelLines* of(const WideView& bundle) {
        const std::span<const std::uint32_t> ids = bundle.triangles.ids;
        // Subtrees of one tree that have the same triangles in the same order are the same.
        auto found = std::ranges::find_if(
            known_, [&](const KnownLines& each) { return std::ranges::equal(each.ids, ids); });
        if (found == known_.end()) {
            if (known_.size() == known_most) {
                known_.pop_back();
            }
            found = known_.insert(known_.end(), {{ids.begin(), ids.end()}, false, {}});
            found->are_parallel = found->lines.assign(bundle);
        }
        std::rotate(known_.begin(), found, found + 1);
        return known_.front().are_parallel ? &known_.front().lines : nullptr;
    }

  private:
    static constexpr std::size_t known_most = 16;

    std::vector<KnownLines> known_; ///< Those used last come first.
};

std::vector<std::uint32_t> lines_in(const FoundContacts& found) {
    std::vector<std::uint32_t> lines;
    for (const ContactPair& pair : found.pairs()) {
        lines.push_back(pair.b);
    }
    std::ranges::sort(lines);
    return lines;
}

/// Tells lines whose hits need no further decision from others.
class SimpleLines {
  public:
    /// Selects the hits of a scenario, and the pairs of subtrees that they refer to.
    void restart(std::span<const Pass> passes, std::span<const SubtreePair> pairs) {
        passes_ = passes;
        pairs_ = pairs;
        by_line_.clear();
    }

    /// Keeps the hits of simple lines, with `only_first` the first of each, and moves those of
    /// other lines to `found`. Returns how many it moves.
    [[nodiscard]] std::size_t settle(FoundContacts& found, bool only_first) {
        const std::vector<std::uint32_t> not_simple = lines_in(found);
        auto next = not_simple.begin();
        std::size_t moved = 0;
        keys_.clear();
        std::ranges::transform(passes_, std::back_inserter(keys_), &Pass::line);
        const std::span<const std::uint32_t> sorted = order_.of(keys_);
        for (auto from = sorted.begin(); from != sorted.end();) {
            const std::uint32_t line = keys_[*from];
            const auto to =
                std::find_if(from, sorted.end(), [&](std::uint32_t i) { return keys_[i] != line; });
            next = std::lower_bound(next, not_simple.end(), line);
            const bool is_found = next != not_simple.end() && *next == line;
            if (is_found || !is_simple({from, to})) {
                move({from, to}, found);
                moved += static_cast<std::size_t>(to - from);
            } else {
                keep({from, to}, only_first);
            }
            from = to;
        }
        return moved;
    }

    /// Returns the hits that were kept by triangle; those of a triangle are in the order of lines.
    [[nodiscard]] std::span<const LineShot> by_triangle() {
        keys_.clear();
        std::ranges::transform(by_line_, std::back_inserter(keys_), &LineShot::triangle);
        by_triangle_.clear();
        for (const std::uint32_t i : order_.of(keys_)) {
            by_triangle_.push_back(by_line_[i]);
        }
        return by_triangle_;
    }

  private:
    /// Returns whether all depths of a line, whose hits are given by their indices, are known and
    /// differ.
    [[nodiscard]] bool is_simple(std::span<const std::uint32_t> of_line) {
        if (of_line.size() == 1) {
            return !std::isnan(passes_[of_line[0]].depth);
        }
        depths_.clear();
        for (const std::uint32_t i : of_line) {
            if (std::isnan(passes_[i].depth)) {
                return false;
            }
            depths_.push_back(passes_[i].depth);
        }
        std::ranges::sort(depths_);
        return std::ranges::adjacent_find(depths_) == depths_.end();
    }

    void keep(std::span<const std::uint32_t> of_line, bool only_first) {
        const auto shot_of = [this](std::uint32_t i) {
            const Pass& pass = passes_[i];
            return LineShot{pass.triangle, pass.line, {pass.depth, pass.flags, 0}};
        };
        if (only_first) {
            const auto depth = [this](std::uint32_t i) { return passes_[i].depth; };
            by_line_.push_back(shot_of(*std::ranges::min_element(of_line, {}, depth)));
            return;
        }
        std::ranges::transform(of_line, std::back_inserter(by_line_), shot_of);
    }

    void move(std::span<const std::uint32_t> of_line, FoundContacts& found) const {
        for (const std::uint32_t i : of_line) {
            const SubtreePair& pair = pairs_[passes_[i].pair];
            const TriangleBlocks& a = pair.a.wide.triangles;
            const TriangleBlocks& b = pair.b.wide.triangles;
            found.add(a, a.ids, b, b.ids, {&passes_[i].slots, 1});
        }
    }

    std::span<const Pass> passes_;
    std::span<const SubtreePair> pairs_;
    StableOrder order_;
    std::vector<std::uint32_t> keys_; ///< For `order_`.
    std::vector<double> depths_;      ///< Of a line.
    std::vector<LineShot> by_line_;
    std::vector<LineShot> by_triangle_;
};

} // namespace

struct BundleShots::State {
    BundleSearch search;
    BundleDepths depths;
    LinesByBundle lines;
    PosePair poses;
    std::span<const IgnoredRange> ignored;
    bool needs_depths = false;
    std::vector<SubtreePair> pairs;
    std::vector<Pass> passes; ///< Empty without depths.
    std::vector<Candidate> open;
    SimpleLines simple;
    std::uint64_t count = 0;
    QueryStatistics before; ///< Of earlier scenarios.

    explicit State(double bound_scale) : search(bound_scale), depths(bound_scale) {}

    [[nodiscard]] QueryStatistics statistics() const {
        QueryStatistics all{search.box_tests(), search.line_tests(), {}};
        all.decisions[PairStage::Double] = search.line_tests();
        return all;
    }

    [[nodiscard]] bool is_ignored_pair(std::uint32_t a, std::uint32_t b) const {
        return !ignored.empty() && is_ignored(ignored, a, b);
    }

    void add_passes(std::span<const LinePass> found, const ParallelLines& of, std::uint64_t most) {
        const SubtreePair& pair = pairs.back();
        const TriangleBlocks& a = pair.a.wide.triangles;
        const LineRows rows = of.rows();
        for (const LinePass& pass : found) {
            const std::uint32_t slot = of.slots()[pass.line];
            const std::uint32_t triangle = a.ids[pass.triangle];
            const std::uint32_t line = pair.b.wide.triangles.ids[slot];
            if (is_ignored_pair(triangle, line)) {
                continue;
            }
            ++count;
            if (needs_depths && passes.size() < most) {
                const auto number = static_cast<std::uint32_t>(pairs.size() - 1);
                passes.push_back({0, triangle, line, {pass.triangle, slot}, number, pass.flags});
                depths.add(a.corners_at(pass.triangle),
                           {rows.across[0][pass.line], rows.across[1][pass.line]});
                if (depths.is_full()) {
                    take_depths();
                }
            }
        }
    }

    void take_depths() {
        const std::span<const double> taken = depths.take();
        auto pass = passes.end() - static_cast<std::ptrdiff_t>(taken.size());
        for (const double depth : taken) {
            (pass++)->depth = depth;
        }
    }

    void decide_open(std::span<const Candidate> given, FoundContacts& found) {
        const TriangleBlocks& a = pairs.back().a.wide.triangles;
        const TriangleBlocks& b = pairs.back().b.wide.triangles;
        open.clear();
        std::ranges::copy_if(given, std::back_inserter(open), [&](const Candidate& pair) {
            return !is_ignored_pair(a.ids[pair.a], b.ids[pair.b]);
        });
        found.add(a, a.ids, b, b.ids, open);
    }
};

BundleShots::BundleShots(double bound_scale) : state_(std::make_unique<State>(bound_scale)) {}
BundleShots::BundleShots(BundleShots&&) noexcept = default;
BundleShots& BundleShots::operator=(BundleShots&&) noexcept = default;
BundleShots::~BundleShots() = default;

void BundleShots::restart(const PosePair& poses,
                          std::span<const IgnoredRange> ignored,
                          bool needs_depths) {
    State& s = *state_;
    s.poses = poses;
    s.ignored = ignored;
    s.needs_depths = needs_depths;
    s.pairs.clear();
    s.passes.clear();
    s.count = 0;
    s.before = s.statistics();
}

BundleShots::Collected
BundleShots::collect(const SubtreePair& pair, FoundContacts& found, const StopCheck& stop) {
    State& s = *state_;
    if (pair.a.wide.nodes.empty() || pair.b.wide.nodes.empty() ||
        (s.needs_depths && !BundleDepths::suits(s.poses))) {
        return Collected::None;
    }
    const ParallelLines* const lines = s.lines.of(pair.b.wide);
    if (lines == nullptr || !s.search.start(pair.a.wide, *lines, s.poses)) {
        return Collected::None;
    }
    s.pairs.push_back(pair);
    s.depths.restart(s.poses, *lines);
    while (!s.search.is_done()) {
        if (stop && stop()) {
            return Collected::Stopped;
        }
        const BundleSearch::Found next = s.search.next();
        s.add_passes(next.passes, *lines, found.pairs_max());
        s.decide_open(next.open, found);
    }
    s.take_depths();
    return Collected::All;
}

std::uint64_t BundleShots::count() const {
    return state_->count;
}

std::span<const LineShot> BundleShots::settle(FoundContacts& found, bool only_first) {
    State& s = *state_;
    s.simple.restart(s.passes, s.pairs);
    s.count -= s.simple.settle(found, only_first);
    return s.simple.by_triangle();
}

QueryStatistics BundleShots::statistics() const {
    const State& s = *state_;
    QueryStatistics now = s.statistics();
    now.box_tests -= s.before.box_tests;
    now.triangle_tests -= s.before.triangle_tests;
    now.decisions[PairStage::Double] -= s.before.decisions[PairStage::Double];
    return now;
}

} // namespace cd
