#include "common/pair/triangle_pair.hpp"

#include "common/geometry/triangle_blocks.hpp"
#include "common/pair/pair_cascade.hpp"
#include "common/pair/points/shared_points.hpp"
#include "common/pair/stages/double_batch/double_triangle_pairs.hpp"
#include "common/pair/stages/float/float_triangle_pair.hpp"
#include "common/pair/stages/float/plain_poses.hpp"

#include <algorithm>
#include <numeric>
#include <optional>

namespace cd {

std::string_view to_text(PairStage stage) {
    constexpr std::array<std::string_view, pair_stage_count> names{
        "float", "double", "lattice", "double-double", "wide integer", "arbitrary"};
    return names[static_cast<std::size_t>(stage)];
}

std::uint64_t PairStatistics::total() const {
    return std::accumulate(settled.begin(), settled.end(), std::uint64_t{0});
}

PairStatistics& PairStatistics::operator+=(const PairStatistics& other) {
    for (std::size_t i = 0; i < pair_stage_count; ++i) {
        settled[i] += other.settled[i];
    }
    return *this;
}

/// Calls with fewer candidates skip the float stage, which costs as much for a few pairs as for
/// many.
constexpr std::size_t float_candidates_min = 4;

/// Fewer ties (pairs that floats leave open) are decided one by one instead of in one batch.
constexpr std::size_t ties_at_once_min = 3;

struct TrianglePairTest::State {
    PosePair poses;
    std::optional<FloatTrianglePair> in_float;     ///< Empty until first used.
    std::optional<DoubleTrianglePairs> in_doubles; ///< Empty until first used.
    std::optional<PairCascade> later;              ///< Empty until first used.
    SharedPoints points;
    PairStage first;
    PairDecision decision;
    PairStatistics statistics;
    std::vector<FloatVerdict> verdicts; ///< One per candidate of the last call.
    std::vector<PairClass> kinds;       ///< One per candidate of the last call.

    State(const PosePair& given, PairStage first_stage, PairDecision until)
        : poses(given), points(given), first(first_stage), decision(until) {}

    [[nodiscard]] bool stops_after_floats() const { return decision == PairDecision::FloatsOnly; }

    /// Returns the float verdict of each candidate, and counts the proven ones. All are Unknown if
    /// floats are skipped.
    template <class Triangles>
    std::span<const FloatVerdict>
    float_verdicts(const Triangles& a, const Triangles& b, std::span<const Candidate> candidates) {
        verdicts.assign(candidates.size(), FloatVerdict::Unknown);
        if (first <= PairStage::Float &&
            (candidates.size() >= float_candidates_min || stops_after_floats())) {
            if (!in_float) {
                in_float.emplace(poses);
            }
            in_float->classify(a, b, candidates, verdicts);
            const auto unknown =
                std::count(verdicts.begin(), verdicts.end(), FloatVerdict::Unknown);
            statistics[PairStage::Float] += verdicts.size() - static_cast<std::size_t>(unknown);
        }
        return verdicts;
    }
};

TrianglePairTest::TrianglePairTest(const PosePair& poses, PairStage first, PairDecision decision)
    : state_(std::make_unique<State>(poses, first, decision)) {}
TrianglePairTest::TrianglePairTest(TrianglePairTest&&) noexcept = default;
TrianglePairTest& TrianglePairTest::operator=(TrianglePairTest&&) noexcept = default;
TrianglePairTest::~TrianglePairTest() = default;

void TrianglePairTest::restart(const PosePair& poses) {
    State& s = *state_;
    s.poses = poses;
    s.in_float.reset();
    s.in_doubles.reset();
    s.later.reset();
    s.points.restart(poses);
    s.statistics = {};
}

PairClass TrianglePairTest::classify(const Corners& a, const Corners& b) {
    State& s = *state_;
    if (s.stops_after_floats()) {
        return PairClass::Touch;
    }
    if (!s.later) {
        s.later.emplace(s.poses, s.first);
    }
    const PairCascade::Decision decision = s.later->classify(a, b);
    ++s.statistics[decision.stage];
    return decision.kind;
}

template <class Triangles>
std::span<const PairClass> TrianglePairTest::classify(const Triangles& a,
                                                      const Triangles& b,
                                                      std::span<const Candidate> candidates) {
    const std::span<const FloatVerdict> verdicts = state_->float_verdicts(a, b, candidates);
    std::vector<PairClass>& kinds = state_->kinds;
    kinds.resize(candidates.size());
    // Avoids a branch: it is unpredictable which candidates touch.
    std::transform(verdicts.begin(), verdicts.end(), kinds.begin(), [](FloatVerdict verdict) {
        return verdict == FloatVerdict::Proper ? PairClass::Proper : PairClass::Separate;
    });
    std::array<std::size_t, DoubleTrianglePairs::pairs_max> ties{};
    std::size_t count = 0;
    const auto end = verdicts.end();
    for (auto at = verdicts.begin(); (at = std::find(at, end, FloatVerdict::Unknown)) != end;
         ++at) {
        ties[count++] = static_cast<std::size_t>(at - verdicts.begin());
        if (count == ties.size()) {
            classify_ties(a, b, candidates, ties);
            count = 0;
        }
    }
    classify_ties(a, b, candidates, std::span(ties).first(count));
    return kinds;
}

template <class Triangles>
void TrianglePairTest::classify_ties(const Triangles& a,
                                     const Triangles& b,
                                     std::span<const Candidate> candidates,
                                     std::span<const std::size_t> ties) {
    State& s = *state_;
    const auto corners_a = [&](std::size_t i) { return a.corners_at(candidates[i].a); };
    const auto corners_b = [&](std::size_t i) { return b.corners_at(candidates[i].b); };
    bool at_once =
        ties.size() >= ties_at_once_min && s.first <= PairStage::Double && !s.stops_after_floats();
    if (at_once && !s.in_doubles) {
        s.in_doubles.emplace(plain_poses(s.poses));
    }
    at_once = at_once && s.in_doubles->pays();
    if (at_once) {
        for (const std::size_t i : ties) {
            s.in_doubles->add(corners_a(i), corners_b(i));
        }
        s.in_doubles->decide();
    }
    for (std::size_t place = 0; place < ties.size(); ++place) {
        const std::size_t i = ties[place];
        const auto decided = at_once ? s.in_doubles->decided(place) : std::nullopt;
        if (decided) {
            s.kinds[i] = *decided;
            ++s.statistics[PairStage::Double];
        } else {
            s.kinds[i] = classify(corners_a(i), corners_b(i));
        }
    }
}

template <class Triangles>
std::optional<std::size_t> TrianglePairTest::find_touch(const Triangles& a,
                                                        const Triangles& b,
                                                        std::span<const Candidate> candidates) {
    const std::span<const FloatVerdict> verdicts = state_->float_verdicts(a, b, candidates);
    const auto proper = std::find(verdicts.begin(), verdicts.end(), FloatVerdict::Proper);
    if (proper != verdicts.end()) {
        return static_cast<std::size_t>(proper - verdicts.begin());
    }
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        if (verdicts[i] == FloatVerdict::Unknown &&
            classify(a.corners_at(candidates[i].a), b.corners_at(candidates[i].b)) !=
                PairClass::Separate) {
            return i;
        }
    }
    return std::nullopt;
}

template std::span<const PairClass>
TrianglePairTest::classify(const TriangleSpan&, const TriangleSpan&, std::span<const Candidate>);
template std::span<const PairClass> TrianglePairTest::classify(const TriangleBlocks&,
                                                               const TriangleBlocks&,
                                                               std::span<const Candidate>);
template std::optional<std::size_t>
TrianglePairTest::find_touch(const TriangleSpan&, const TriangleSpan&, std::span<const Candidate>);
template std::optional<std::size_t> TrianglePairTest::find_touch(const TriangleBlocks&,
                                                                 const TriangleBlocks&,
                                                                 std::span<const Candidate>);

void TrianglePairTest::shared_points(std::span<const PairCorners> pairs,
                                     const PointReceiver& receive) {
    state_->points.for_each(pairs, receive);
}

const PairStatistics& TrianglePairTest::statistics() const {
    return state_->statistics;
}

} // namespace cd
