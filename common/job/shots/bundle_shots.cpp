#include "common/job/shots/bundle_shots.hpp"

#include "common/job/shots/passes.hpp"
#include "common/job/shots/simple_lines.hpp"
#include "common/shots/bundle/bundle_depths.hpp"
#include "common/shots/bundle/bundle_search.hpp"
#include "common/shots/bundle/parallel_lines.hpp"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace cd {

namespace {

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
    [[nodiscard]] const KnownLines* of(const WideView& bundle) {
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
        return known_.front().are_parallel ? &known_.front() : nullptr;
    }

  private:
    static constexpr std::size_t known_most = 16;

    std::vector<KnownLines> known_; ///< Those used last come first.
};

} // namespace

struct BundleShots::State {
    struct Scratch {
        std::vector<PassedTriangle> triangles;
        std::vector<std::uint32_t> lines;
        std::vector<Candidate> open;
    };

    BundleSearch search;
    BundleDepths depths;
    LinesByBundle lines;
    PosePair poses;
    std::span<const IgnoredRange> ignored;
    bool needs_depths = false;
    std::vector<SubtreePair> pairs;
    Passes passes; ///< Empty without depths.
    Scratch scratch;
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

    /// Adds hits of lines, as long as there are at most `most`.
    void add_passes(const BundleSearch::Found& all, const KnownLines& of, std::uint64_t most) {
        const BundleSearch::Found found = without_ignored(all, of);
        count += found.lines.size();
        if (!needs_depths || count > most) {
            return;
        }
        const std::uint32_t begin = passes.count();
        passes.grow(found.lines.size());
        for (std::size_t i = 0; i < found.lines.size(); ++i) {
            const std::uint32_t slot = of.lines.slots()[found.lines[i]];
            passes.slots[begin + i] = slot;
            passes.lines[begin + i] = of.ids[slot];
        }
        const TriangleBlocks& a = pairs.back().a.wide.triangles;
        const auto number = static_cast<std::uint32_t>(pairs.size() - 1);
        for (std::size_t i = 0; i < found.triangles.size(); ++i) {
            const PassedTriangle& passed = found.triangles[i];
            passes.add_group(
                {a.ids[passed.slot], passed.slot, number, begin + passed.begin, passed.flags},
                static_cast<std::uint32_t>(found.lines_of(i).size()));
        }
        depths.find(a, found.triangles, found.lines, passes.depths);
    }

    /// Returns what triangles may hit of the found. Valid until the next call.
    [[nodiscard]] BundleSearch::Found without_ignored(const BundleSearch::Found& found,
                                                      const KnownLines& of) {
        if (ignored.empty()) {
            return found;
        }
        scratch.triangles.clear();
        scratch.lines.clear();
        for (std::size_t i = 0; i < found.triangles.size(); ++i) {
            PassedTriangle passed = found.triangles[i];
            const std::uint32_t triangle = pairs.back().a.wide.triangles.ids[passed.slot];
            passed.begin = static_cast<std::uint32_t>(scratch.lines.size());
            std::ranges::copy_if(
                found.lines_of(i), std::back_inserter(scratch.lines), [&](std::uint32_t place) {
                    return !is_ignored_pair(triangle, of.ids[of.lines.slots()[place]]);
                });
            if (scratch.lines.size() > passed.begin) {
                scratch.triangles.push_back(passed);
            }
        }
        return {scratch.triangles, scratch.lines, found.open};
    }

    void decide_open(std::span<const Candidate> given, FoundContacts& found) {
        const TriangleBlocks& a = pairs.back().a.wide.triangles;
        const TriangleBlocks& b = pairs.back().b.wide.triangles;
        std::vector<Candidate>& open = scratch.open;
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
    const KnownLines* const lines = s.lines.of(pair.b.wide);
    if (lines == nullptr || !s.search.start(pair.a.wide, lines->lines, s.poses)) {
        return Collected::None;
    }
    s.pairs.push_back(pair);
    s.depths.restart(s.poses, lines->lines);
    while (!s.search.is_done()) {
        if (stop && stop()) {
            return Collected::Stopped;
        }
        const BundleSearch::Found next = s.search.next();
        s.add_passes(next, *lines, found.pairs_max());
        s.decide_open(next.open, found);
    }
    return Collected::All;
}

std::uint64_t BundleShots::count() const {
    return state_->count;
}

SettledHits BundleShots::settle(FoundContacts& found, bool only_first) {
    State& s = *state_;
    s.simple.restart(s.passes, s.pairs);
    std::uint64_t moved = 0;
    SettledHits settled = s.simple.settle(found, only_first, moved);
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
