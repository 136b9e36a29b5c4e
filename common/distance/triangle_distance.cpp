#include "common/distance/triangle_distance.hpp"

#include "common/distance/stages/double/double_distance.hpp"
#include "common/distance/stages/double_double/double_double_distance.hpp"
#include "common/distance/stages/double_double/double_double_nearest.hpp"
#include "common/distance/stages/exact/exact_distance.hpp"
#include "common/distance/stages/float/float_distance.hpp"
#include "common/geometry/triangle_blocks.hpp"
#include "common/pair/points/exact_points.hpp"
#include "common/pair/points/shared_points.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <vector>

namespace cd {

std::string_view to_text(DistanceStage stage) {
    constexpr std::array<std::string_view, distance_stage_count> names{
        "float", "double", "double-double", "exact"};
    return names[static_cast<std::size_t>(stage)];
}

std::uint64_t DistanceStatistics::total() const {
    return std::accumulate(settled.begin(), settled.end(), std::uint64_t{0});
}

DistanceStatistics& DistanceStatistics::operator+=(const DistanceStatistics& other) {
    for (std::size_t i = 0; i < distance_stage_count; ++i) {
        settled[i] += other.settled[i];
    }
    return *this;
}

/// Calls with fewer candidates skip the float stage, which costs as much for a few pairs as for
/// many.
constexpr std::size_t float_distances_min = 4;

struct TriangleDistance::State {
    PosePair poses;
    DistanceStage first;
    std::optional<FloatDistance> in_float;                ///< Empty until first used.
    std::optional<DoubleDistance> in_double;              ///< Empty until first used.
    std::optional<DoubleDoubleDistance> in_double_double; ///< Empty until first used.
    std::optional<DoubleDoubleNearest> nearest;           ///< Empty until first used.
    SharedPoints origins;                                 ///< Computes origins alone.
    std::optional<ExactDistance> exact;                   ///< Empty until first used.
    DistanceStatistics statistics;
    std::vector<NearVerdict> verdicts;        ///< One per candidate of the last call.
    std::vector<std::uint8_t> answers;        ///< One per candidate of the last call.
    std::array<std::vector<float>, 2> bounds; ///< Lower and upper ones of the last candidates.

    State(const PosePair& given, DistanceStage first_stage)
        : poses(given), first(first_stage), origins(given) {}

    /// Returns the float verdict of each candidate, and counts the proven ones. All are Unknown if
    /// floats are skipped.
    template <class Triangles>
    std::span<const NearVerdict> float_verdicts(const Triangles& a,
                                                const Triangles& b,
                                                std::span<const Candidate> candidates,
                                                double d) {
        verdicts.assign(candidates.size(), NearVerdict::Unknown);
        if (first <= DistanceStage::Float && candidates.size() >= float_distances_min) {
            if (!in_float) {
                in_float.emplace(poses);
            }
            in_float->decide(a, b, candidates, d, verdicts);
            const auto unknown = std::count(verdicts.begin(), verdicts.end(), NearVerdict::Unknown);
            statistics[DistanceStage::Float] += verdicts.size() - static_cast<std::size_t>(unknown);
        }
        return verdicts;
    }
    [[nodiscard]] const DoubleDistance& in_doubles() {
        if (!in_double) {
            in_double.emplace(poses);
        }
        return *in_double;
    }
    [[nodiscard]] DoublePair look_at(const Corners& a, const Corners& b) {
        return first <= DistanceStage::Double ? in_doubles().look_at(a, b)
                                              : in_doubles().choose(a, b);
    }
    [[nodiscard]] DistanceBounds<DoubleDouble>
    look_closer(const Corners& a, const Corners& b, const DoublePair& pair) {
        if (!in_double_double) {
            in_double_double.emplace(poses);
        }
        return in_double_double->bounds(a, b, pair.near_a, pair.feature);
    }
    [[nodiscard]] std::optional<NearestPoints>
    nearest_in_double_double(const Corners& a, const Corners& b, std::size_t likely) {
        if (!nearest) {
            nearest.emplace(poses);
        }
        const Vec3 origin = origins.origin(a);
        return nearest->nearest(
            a, b, origin, likely, [&] { return ExactPoints(poses).offset(a, origin); });
    }
    [[nodiscard]] ExactDistance& in_integers() {
        ++statistics[DistanceStage::Exact];
        if (!exact) {
            exact.emplace(poses);
        }
        return *exact;
    }
};

TriangleDistance::TriangleDistance(const PosePair& poses, DistanceStage first)
    : state_(std::make_unique<State>(poses, first)) {}
TriangleDistance::TriangleDistance(TriangleDistance&&) noexcept = default;
TriangleDistance& TriangleDistance::operator=(TriangleDistance&&) noexcept = default;
TriangleDistance::~TriangleDistance() = default;

void TriangleDistance::restart(const PosePair& poses) {
    state_->poses = poses;
    state_->in_float.reset();
    state_->in_double.reset();
    state_->in_double_double.reset();
    state_->nearest.reset();
    state_->origins.restart(poses);
    state_->exact.reset();
    state_->statistics = {};
}

bool TriangleDistance::is_within(const Corners& a, const Corners& b, double d) {
    State& s = *state_;
    if (s.first == DistanceStage::Exact) {
        return s.in_integers().is_within(a, b, d, 0);
    }
    const DoublePair pair = s.look_at(a, b);
    if (const auto proven = pair.is_within(d)) {
        ++s.statistics[DistanceStage::Double];
        return *proven;
    }
    if (const auto proven = cd::is_within(s.look_closer(a, b, pair), d)) {
        ++s.statistics[DistanceStage::DoubleDouble];
        return *proven;
    }
    return s.in_integers().is_within(a, b, d, pair.feature);
}

double TriangleDistance::rounded(const Corners& a, const Corners& b) {
    State& s = *state_;
    if (s.first == DistanceStage::Exact) {
        return s.in_integers().rounded(a, b, 0);
    }
    const DoublePair pair = s.look_at(a, b);
    if (const auto proven = cd::rounded(s.look_closer(a, b, pair))) {
        ++s.statistics[DistanceStage::DoubleDouble];
        return *proven;
    }
    return s.in_integers().rounded(a, b, pair.feature);
}

NearestPoints TriangleDistance::nearest(const Corners& a, const Corners& b) {
    State& s = *state_;
    if (s.first == DistanceStage::Exact) {
        return s.in_integers().nearest(a, b, 0);
    }
    const std::size_t likely = s.look_at(a, b).feature;
    if (const auto proven = s.nearest_in_double_double(a, b, likely)) {
        ++s.statistics[DistanceStage::DoubleDouble];
        return *proven;
    }
    return s.in_integers().nearest(a, b, likely);
}

Vec3 TriangleDistance::displacement(const Corners& a, const Corners& b) {
    return state_->in_doubles().displacement(a, b);
}

template <class Triangles>
std::span<const std::uint8_t> TriangleDistance::within(const Triangles& a,
                                                       const Triangles& b,
                                                       std::span<const Candidate> candidates,
                                                       double d) {
    const std::span<const NearVerdict> verdicts = state_->float_verdicts(a, b, candidates, d);
    std::vector<std::uint8_t>& answers = state_->answers;
    answers.resize(candidates.size());
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const Candidate& c = candidates[i];
        const bool is_near = verdicts[i] == NearVerdict::Unknown
                                 ? is_within(a.corners_at(c.a), b.corners_at(c.b), d)
                                 : verdicts[i] == NearVerdict::Near;
        answers[i] = is_near ? 1 : 0;
    }
    return answers;
}

template <class Triangles>
std::optional<std::size_t> TriangleDistance::find_within(const Triangles& a,
                                                         const Triangles& b,
                                                         std::span<const Candidate> candidates,
                                                         double d) {
    const std::span<const NearVerdict> verdicts = state_->float_verdicts(a, b, candidates, d);
    const auto near = std::find(verdicts.begin(), verdicts.end(), NearVerdict::Near);
    if (near != verdicts.end()) {
        return static_cast<std::size_t>(near - verdicts.begin());
    }
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const Candidate& c = candidates[i];
        if (verdicts[i] == NearVerdict::Unknown &&
            is_within(a.corners_at(c.a), b.corners_at(c.b), d)) {
            return i;
        }
    }
    return std::nullopt;
}

template std::span<const std::uint8_t> TriangleDistance::within(const TriangleSpan&,
                                                                const TriangleSpan&,
                                                                std::span<const Candidate>,
                                                                double);
template std::span<const std::uint8_t> TriangleDistance::within(const TriangleBlocks&,
                                                                const TriangleBlocks&,
                                                                std::span<const Candidate>,
                                                                double);
template std::optional<std::size_t> TriangleDistance::find_within(const TriangleSpan&,
                                                                  const TriangleSpan&,
                                                                  std::span<const Candidate>,
                                                                  double);
template std::optional<std::size_t> TriangleDistance::find_within(const TriangleBlocks&,
                                                                  const TriangleBlocks&,
                                                                  std::span<const Candidate>,
                                                                  double);

template <class Triangles>
TriangleDistance::Bounds TriangleDistance::bounds(const Triangles& a,
                                                  const Triangles& b,
                                                  std::span<const Candidate> candidates) {
    State& s = *state_;
    auto& [lower, upper] = s.bounds;
    lower.assign(candidates.size(), 0);
    upper.assign(candidates.size(), std::numeric_limits<float>::infinity());
    if (s.first <= DistanceStage::Float) {
        if (!s.in_float) {
            s.in_float.emplace(s.poses);
        }
        s.in_float->bound(a, b, candidates, lower, upper);
    }
    return {lower, upper};
}

template TriangleDistance::Bounds
TriangleDistance::bounds(const TriangleSpan&, const TriangleSpan&, std::span<const Candidate>);
template TriangleDistance::Bounds
TriangleDistance::bounds(const TriangleBlocks&, const TriangleBlocks&, std::span<const Candidate>);

const DistanceStatistics& TriangleDistance::statistics() const {
    return state_->statistics;
}

} // namespace cd
