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
#include <tuple>
#include <utility>
#include <vector>

namespace cd {

namespace {

/// No slot has this number.
constexpr std::uint32_t no_slot = 0xffffffff;

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

/// Sorts hits, of which those of a triangle mostly follow each other in the order of their lines.
class ShotSorter {
  public:
    void sort(std::vector<LineShot>& shots) {
        begins_.clear();
        triangles_.clear();
        for (std::size_t i = 0; i < shots.size(); ++i) {
            if (i == 0 || shots[i].triangle != shots[i - 1].triangle) {
                begins_.push_back(static_cast<std::uint32_t>(i));
                triangles_.push_back(shots[i].triangle);
            }
        }
        begins_.push_back(static_cast<std::uint32_t>(shots.size()));
        sorted_.clear();
        for (const std::uint32_t group : order_.of(triangles_)) {
            sorted_.insert(
                sorted_.end(), shots.begin() + begins_[group], shots.begin() + begins_[group + 1]);
        }
        const auto place = [](const LineShot& shot) {
            return std::uint64_t{shot.triangle} << 32 | shot.line;
        };
        if (!std::ranges::is_sorted(sorted_, {}, place)) {
            std::ranges::sort(sorted_, {}, place);
        }
        shots.swap(sorted_);
    }

  private:
    StableOrder order_;
    std::vector<std::uint32_t> triangles_; ///< Of each group of hits.
    std::vector<std::uint32_t> begins_;    ///< Of each group, and the number of all hits.
    std::vector<LineShot> sorted_;
};

/// Tells lines whose hits need no further decision from others.
class SimpleLines {
  public:
    /// Selects the hits of a scenario, and the pairs of subtrees that they refer to.
    void restart(std::span<const Pass> passes, std::span<const SubtreePair> pairs) {
        passes_ = passes;
        pairs_ = pairs;
    }

    /// Returns the hits of simple lines, with `only_first` the first of each, and moves those of
    /// other lines to `found`. Counts in `moved` how many it moves.
    [[nodiscard]] std::span<const LineShot>
    settle(FoundContacts& found, bool only_first, std::uint64_t& moved) {
        for (const ContactPair& pair : found.pairs()) {
            line(pair.b).is_simple = false;
            touched_.push_back(pair.b);
        }
        link();
        simple_.clear();
        for (std::uint32_t i = 0; i < passes_.size(); ++i) {
            const Line& of = lines_[passes_[i].line];
            if (!of.is_simple) {
                move(passes_[i], found);
                ++moved;
            } else if (!only_first) {
                keep(i);
            } else if (of.last == i) {
                keep(first_of(i));
            }
        }
        for (const std::uint32_t touched : touched_) {
            lines_[touched] = {};
        }
        touched_.clear();
        sorter_.sort(simple_);
        return simple_;
    }

  private:
    static constexpr std::uint32_t none = 0xffffffff;
    /// Lines of more hits are left to SegmentHit: all depths of a line are compared in pairs.
    static constexpr std::uint32_t hits_most = 128;

    /// A line of the mesh.
    struct Line {
        std::uint32_t last = none; ///< Index of its last hit.
        std::uint32_t hits = 0;
        bool is_simple = true; ///< All depths are known, and equal ones are exactly equal.
    };

    [[nodiscard]] Line& line(std::uint32_t number) {
        if (number >= lines_.size()) {
            lines_.resize(number + std::size_t{1});
        }
        return lines_[number];
    }

    /// Links the hits of each line, and finds the lines that are not simple.
    void link() {
        previous_.resize(passes_.size());
        for (std::uint32_t i = 0; i < passes_.size(); ++i) {
            Line& of = line(passes_[i].line);
            if (of.hits == 0) {
                touched_.push_back(passes_[i].line);
            }
            of.is_simple = of.is_simple && of.hits < hits_most && is_apart(i, of.last);
            previous_[i] = of.last;
            of.last = i;
            ++of.hits;
        }
    }

    /// Returns whether a hit's depth is known, and no earlier one of the line rounds alike, unless
    /// that is on a triangle with the same corners.
    [[nodiscard]] bool is_apart(std::uint32_t i, std::uint32_t earlier) const {
        const double depth = passes_[i].depth;
        for (; earlier != none; earlier = previous_[earlier]) {
            if (passes_[earlier].depth == depth &&
                !are_coincident(corners_of(i), corners_of(earlier))) {
                return false;
            }
        }
        return !std::isnan(depth);
    }

    [[nodiscard]] Corners corners_of(std::uint32_t i) const {
        return pairs_[passes_[i].pair].a.wide.triangles.corners_at(passes_[i].slots.a);
    }

    /// Returns the index of the first hit of a line whose last index is given.
    [[nodiscard]] std::uint32_t first_of(std::uint32_t last) const {
        const auto place = [this](std::uint32_t i) {
            const Pass& pass = passes_[i];
            return std::tuple(pass.depth, order_at_one_depth(pass.flags), pass.triangle);
        };
        std::uint32_t first = last;
        for (std::uint32_t i = previous_[last]; i != none; i = previous_[i]) {
            first = place(i) < place(first) ? i : first;
        }
        return first;
    }

    void keep(std::uint32_t i) {
        const Pass& pass = passes_[i];
        simple_.push_back({pass.triangle, pass.line, {pass.depth, pass.flags, 0}});
    }

    void move(const Pass& pass, FoundContacts& found) const {
        const TriangleBlocks& a = pairs_[pass.pair].a.wide.triangles;
        const TriangleBlocks& b = pairs_[pass.pair].b.wide.triangles;
        found.add(a, a.ids, b, b.ids, {&pass.slots, 1});
    }

    std::span<const Pass> passes_;
    std::span<const SubtreePair> pairs_;
    std::vector<Line> lines_; ///< By index in the mesh.
    std::vector<std::uint32_t> touched_;
    std::vector<std::uint32_t> previous_; ///< Of the line of each hit.
    std::vector<LineShot> simple_;
    ShotSorter sorter_;
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
        Corners corners;
        std::uint32_t last_slot = no_slot;
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
                if (pass.triangle != last_slot) {
                    last_slot = pass.triangle;
                    corners = a.corners_at(pass.triangle);
                }
                depths.add(corners, {rows.across[0][pass.line], rows.across[1][pass.line]});
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

BundleShots::BundleShots() : state_(std::make_unique<State>()) {}
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
    std::uint64_t moved = 0;
    const std::span<const LineShot> settled = s.simple.settle(found, only_first, moved);
    s.count -= moved;
    return settled;
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
