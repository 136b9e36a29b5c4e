// Replaces TrianglePairTest in query_cost_float_only: triangle_pair.cpp without the stages after
// the floats, so that open cases are answered at once, and wrongly. The linker finds this before
// the library, so the product needs no switch for it.
#include "common/geometry/triangle_blocks.hpp"
#include "common/pair/points/shared_points.hpp"
#include "common/pair/stages/float/float_triangle_pair.hpp"
#include "common/pair/triangle_pair.hpp"

#include <algorithm>
#include <numeric>

namespace cd {

std::string_view to_text(PairStage) {
    return "float";
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

struct TrianglePairTest::State {
    FloatTrianglePair in_float;
    SharedPoints points;
    PairStatistics statistics;
    std::vector<FloatVerdict> verdicts;
    std::vector<PairClass> kinds;

    explicit State(const PosePair& poses) : in_float(poses), points(poses) {}

    template <class Triangles>
    std::span<const FloatVerdict>
    float_verdicts(const Triangles& a, const Triangles& b, std::span<const Candidate> candidates) {
        verdicts.assign(candidates.size(), FloatVerdict::Unknown);
        in_float.classify(a, b, candidates, verdicts);
        const auto unknown = std::count(verdicts.begin(), verdicts.end(), FloatVerdict::Unknown);
        statistics[PairStage::Float] += verdicts.size() - static_cast<std::size_t>(unknown);
        return verdicts;
    }
};

TrianglePairTest::TrianglePairTest(const PosePair& poses, PairStage)
    : state_(std::make_unique<State>(poses)) {}
TrianglePairTest::TrianglePairTest(TrianglePairTest&&) noexcept = default;
TrianglePairTest& TrianglePairTest::operator=(TrianglePairTest&&) noexcept = default;
TrianglePairTest::~TrianglePairTest() = default;

void TrianglePairTest::restart(const PosePair& poses) {
    state_->in_float = FloatTrianglePair(poses);
    state_->points.restart(poses);
    state_->statistics = {};
}

PairClass TrianglePairTest::classify(const Corners&, const Corners&) {
    return PairClass::Touch;
}

template <class Triangles>
std::span<const PairClass> TrianglePairTest::classify_all(const Triangles& a,
                                                          const Triangles& b,
                                                          std::span<const Candidate> candidates) {
    const std::span<const FloatVerdict> verdicts = state_->float_verdicts(a, b, candidates);
    std::vector<PairClass>& kinds = state_->kinds;
    kinds.resize(candidates.size());
    std::transform(verdicts.begin(), verdicts.end(), kinds.begin(), [](FloatVerdict verdict) {
        return verdict == FloatVerdict::Proper     ? PairClass::Proper
               : verdict == FloatVerdict::Separate ? PairClass::Separate
                                                   : PairClass::Touch;
    });
    return kinds;
}

template <class Triangles>
std::optional<std::size_t> TrianglePairTest::find_any_touch(const Triangles& a,
                                                            const Triangles& b,
                                                            std::span<const Candidate> candidates) {
    const std::span<const FloatVerdict> verdicts = state_->float_verdicts(a, b, candidates);
    const auto found = std::find_if(verdicts.begin(), verdicts.end(), [](FloatVerdict verdict) {
        return verdict != FloatVerdict::Separate;
    });
    return found == verdicts.end()
               ? std::nullopt
               : std::optional(static_cast<std::size_t>(found - verdicts.begin()));
}

std::span<const PairClass> TrianglePairTest::classify(const TriangleSpan& a,
                                                      const TriangleSpan& b,
                                                      std::span<const Candidate> candidates) {
    return classify_all(a, b, candidates);
}

std::span<const PairClass> TrianglePairTest::classify(const TriangleBlocks& a,
                                                      const TriangleBlocks& b,
                                                      std::span<const Candidate> candidates) {
    return classify_all(a, b, candidates);
}

std::optional<std::size_t> TrianglePairTest::find_touch(const TriangleSpan& a,
                                                        const TriangleSpan& b,
                                                        std::span<const Candidate> candidates) {
    return find_any_touch(a, b, candidates);
}

std::optional<std::size_t> TrianglePairTest::find_touch(const TriangleBlocks& a,
                                                        const TriangleBlocks& b,
                                                        std::span<const Candidate> candidates) {
    return find_any_touch(a, b, candidates);
}

std::span<const Vec3> TrianglePairTest::shared_points(const Corners& a, const Corners& b) {
    return state_->points.points(a, b);
}

Vec3 TrianglePairTest::point_origin(const Corners& a) {
    return state_->points.origin(a);
}

const PairStatistics& TrianglePairTest::statistics() const {
    return state_->statistics;
}

} // namespace cd
