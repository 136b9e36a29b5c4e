#include "common/geometry/triangle_pair.hpp"

#include "common/geometry/double_double_triangle_pair.hpp"
#include "common/geometry/double_triangle_pair.hpp"
#include "common/geometry/exact_triangle_pair.hpp"
#include "common/geometry/float_triangle_pair.hpp"
#include "common/geometry/integer_triangle_pair.hpp"
#include "common/geometry/shared_points.hpp"
#include "common/geometry/triangle_blocks.hpp"

#include <algorithm>
#include <numeric>
#include <optional>

namespace cd {

namespace {

Corners corners_of(const TriangleSpan& triangles, std::uint32_t place) {
    return triangles.corners(place);
}

Corners corners_of(const TriangleBlocks& triangles, std::uint32_t place) {
    return triangles.corners_at(place);
}

} // namespace

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

struct TrianglePairTest::State {
    PosePair poses;
    FloatTrianglePair in_float;
    DoubleTrianglePair in_double;
    IntegerTrianglePair in_integers;
    std::optional<DoubleDoubleTrianglePair> in_double_double; ///< Made when it is first needed.
    std::unique_ptr<const ExactTrianglePair> exact;           ///< Likewise.
    SharedPoints points;
    PairStage first;
    PairStatistics statistics;
    std::vector<FloatVerdict> verdicts; ///< Of the last call's candidates, as are the kinds.
    std::vector<PairClass> kinds;

    State(const PosePair& given, PairStage first_stage)
        : poses(given),
          in_float(given),
          in_double(given),
          in_integers(given, first_stage),
          points(given),
          first(first_stage) {}

    /// What floats prove of each candidate, counted; nothing if they are to be passed over.
    template <class Triangles>
    std::span<const FloatVerdict>
    float_verdicts(const Triangles& a, const Triangles& b, std::span<const Candidate> candidates) {
        verdicts.assign(candidates.size(), FloatVerdict::Unknown);
        if (first <= PairStage::Float) {
            in_float.classify(a, b, candidates, verdicts);
            const auto unknown =
                std::count(verdicts.begin(), verdicts.end(), FloatVerdict::Unknown);
            statistics[PairStage::Float] += verdicts.size() - static_cast<std::size_t>(unknown);
        }
        return verdicts;
    }

    [[nodiscard]] PairClass
    classify_past_double(const Corners& a, const Corners& b, const KnownSigns& known);
};

TrianglePairTest::TrianglePairTest(const PosePair& poses, PairStage first)
    : state_(std::make_unique<State>(poses, first)) {}
TrianglePairTest::TrianglePairTest(TrianglePairTest&&) noexcept = default;
TrianglePairTest& TrianglePairTest::operator=(TrianglePairTest&&) noexcept = default;
TrianglePairTest::~TrianglePairTest() = default;

PairClass TrianglePairTest::classify(const Corners& a, const Corners& b) {
    State& s = *state_;
    if (s.first <= PairStage::Lattice) {
        if (const auto decided = s.in_integers.classify_short(a, b)) {
            ++s.statistics[PairStage::Lattice];
            return *decided;
        }
    }
    if (s.first <= PairStage::Double) {
        const DoubleSigns in_double = s.in_double.signs(a, b);
        ProvenSigns proven(in_double);
        const PairClass kind = decide_pair(proven);
        if (proven.are_enough()) {
            ++s.statistics[PairStage::Double];
            return kind;
        }
        return s.classify_past_double(a, b, {&in_double, proven.known_of_a(), proven.known_of_b()});
    }
    return s.classify_past_double(a, b, {});
}

PairClass TrianglePairTest::State::classify_past_double(const Corners& a,
                                                        const Corners& b,
                                                        const KnownSigns& known) {
    // Bodies that are not rotated against each other are cheap for integers.
    if (first <= PairStage::DoubleDouble && in_integers.stage() == PairStage::WideInteger) {
        if (!in_double_double) {
            in_double_double.emplace(poses);
        }
        if (const auto decided = in_double_double->classify(a, b, known)) {
            ++statistics[PairStage::DoubleDouble];
            return *decided;
        }
    }
    if (first <= PairStage::WideInteger) {
        if (const auto decided = in_integers.classify(a, b, known.of_a, known.of_b)) {
            ++statistics[in_integers.stage()];
            return *decided;
        }
    }
    ++statistics[PairStage::Arbitrary];
    if (!exact) {
        exact = std::make_unique<ExactTrianglePair>(poses);
    }
    return exact->classify(a, b);
}

template <class Triangles>
std::span<const PairClass> TrianglePairTest::classify_all(const Triangles& a,
                                                          const Triangles& b,
                                                          std::span<const Candidate> candidates) {
    const std::span<const FloatVerdict> verdicts = state_->float_verdicts(a, b, candidates);
    std::vector<PairClass>& kinds = state_->kinds;
    kinds.resize(candidates.size());
    // Without a branch: no processor foresees which candidates touch.
    std::transform(verdicts.begin(), verdicts.end(), kinds.begin(), [](FloatVerdict verdict) {
        return verdict == FloatVerdict::Proper ? PairClass::Proper : PairClass::Separate;
    });
    const auto end = verdicts.end();
    for (auto at = verdicts.begin(); (at = std::find(at, end, FloatVerdict::Unknown)) != end;
         ++at) {
        const auto i = static_cast<std::size_t>(at - verdicts.begin());
        kinds[i] = classify(corners_of(a, candidates[i].a), corners_of(b, candidates[i].b));
    }
    return kinds;
}

template <class Triangles>
bool TrianglePairTest::any_of_touch(const Triangles& a,
                                    const Triangles& b,
                                    std::span<const Candidate> candidates) {
    const std::span<const FloatVerdict> verdicts = state_->float_verdicts(a, b, candidates);
    if (std::find(verdicts.begin(), verdicts.end(), FloatVerdict::Proper) != verdicts.end()) {
        return true;
    }
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        if (verdicts[i] == FloatVerdict::Unknown &&
            classify(corners_of(a, candidates[i].a), corners_of(b, candidates[i].b)) !=
                PairClass::Separate) {
            return true;
        }
    }
    return false;
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

bool TrianglePairTest::any_touch(const TriangleSpan& a,
                                 const TriangleSpan& b,
                                 std::span<const Candidate> candidates) {
    return any_of_touch(a, b, candidates);
}

bool TrianglePairTest::any_touch(const TriangleBlocks& a,
                                 const TriangleBlocks& b,
                                 std::span<const Candidate> candidates) {
    return any_of_touch(a, b, candidates);
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
