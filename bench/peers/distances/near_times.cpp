#include "bench/peers/distances/near_times.hpp"

#include "bench/accuracy/timing.hpp"
#include "bench/peers/ours.hpp"
#include "bench/timed_work.hpp"
#include "common/core/check.hpp"
#include "common/distance/stages/float/float_distance.hpp"
#include "common/geometry/reach.hpp"
#include "common/geometry/simd_target.hpp"
#include "common/pair/triangle_pair.hpp"
#include "common/search/contact_search.hpp"
#include "common/tree/wide/candidates_at_once.hpp"
#include "common/tree/wide/wide_descent.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace cd::bench {

namespace {

/// Finds and decides the candidates of one pose.
class NearWork {
  public:
    NearWork(const WideView& a, const WideView& b, const PosePair& poses, double clearance)
        : floats_(poses) {
        WideDescent descent(relative_pose(poses));
        descent.restart(relative_pose(poses), body_reach(poses, clearance));
        TrianglePairTest test(poses);
        for (descent.start(a, b); !descent.is_done();) {
            const std::span<const Candidate> found = descent.next(candidates_at_once);
            const auto kinds = test.classify(a.triangles, b.triangles, found);
            for (std::size_t i = 0; i < found.size(); ++i) {
                if (kinds[i] == PairClass::Separate) {
                    candidates_.push_back(found[i]);
                }
            }
        }
    }

    [[nodiscard]] std::size_t size() const { return candidates_.size(); }

    /// Returns how many candidates floats do not decide.
    [[nodiscard]] std::size_t
    decide(const TriangleBlocks& a, const TriangleBlocks& b, double clearance) const {
        std::array<NearVerdict, candidates_at_once> verdicts{};
        std::size_t unknown = 0;
        for (std::size_t i = 0; i < candidates_.size(); i += candidates_at_once) {
            const std::size_t count = std::min(candidates_at_once, candidates_.size() - i);
            const auto some = std::span(verdicts).first(count);
            floats_.decide(a, b, std::span(candidates_).subspan(i, count), clearance, some);
            unknown += static_cast<std::size_t>(std::ranges::count(some, NearVerdict::Unknown));
        }
        return unknown;
    }

  private:
    FloatDistance floats_;
    std::vector<Candidate> candidates_;
};

} // namespace

std::vector<NearFloats>
measure_near_floats(const Scene& scene, double clearance, std::size_t rounds) {
    const auto tree_a = build_ours(scene.a, 1);
    const auto tree_b = build_ours(scene.b, 1);
    const WideView a = tree_a->view().wide;
    const WideView b = tree_b->view().wide;
    CD_CHECK(!a.nodes.empty() && !b.nodes.empty());
    std::vector<NearWork> works;
    std::uint64_t candidates = 0;
    for (const PosePair& poses : scene.poses) {
        candidates += works.emplace_back(a, b, poses, clearance).size();
    }
    const SimdTarget before = simd_target();
    const auto targets = available_simd_targets();
    std::vector<NearFloats> rows(targets.size());
    std::vector<std::vector<double>> seconds(targets.size());
    for (std::size_t round = 0; round < rounds; ++round) {
        for (std::size_t t = 0; t < targets.size(); ++t) {
            CD_CHECK(force_simd_target(to_text(targets[t])).has_value());
            rows[t] = {std::string(to_text(targets[t])), candidates, 0, 0};
            const double start = processor_seconds();
            for (const NearWork& work : works) {
                rows[t].unknown += work.decide(a.triangles, b.triangles, clearance);
            }
            seconds[t].push_back(processor_seconds() - start);
        }
    }
    CD_CHECK(force_simd_target(to_text(before)).has_value());
    for (std::size_t t = 0; t < targets.size() && candidates > 0; ++t) {
        rows[t].candidate_ns = 1e9 * median(seconds[t]) / static_cast<double>(candidates);
    }
    return rows;
}

NearQueries::NearQueries(const Scene& scene, double clearance)
    : scene_(scene),
      a_(build_ours(scene.a, 1)),
      b_(build_ours(scene.b, 1)),
      search_(make_search(a_->view(),
                          b_->view(),
                          scene.poses.front(),
                          {},
                          {.keep_pairs = true, .clearance = clearance})) {}

void NearQueries::run(std::size_t rounds) {
    const TreeView a = a_->view();
    const TreeView b = b_->view();
    for (std::size_t round = 0; round < rounds; ++round) {
        const double seconds = seconds_of([&] {
            for (const PosePair& poses : scene_.poses) {
                search_->restart(poses);
                static_cast<void>(search_->any_near(a, b));
            }
        });
        round_means_.push_back(seconds / static_cast<double>(scene_.poses.size()));
    }
}

double NearQueries::quickest_round() const {
    return *std::ranges::min_element(round_means_);
}

double NearQueries::median_round() const {
    return median(round_means_);
}

} // namespace cd::bench
