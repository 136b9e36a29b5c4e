#include "common/geometry/triangle_pair.hpp"

#include "common/geometry/double_triangle_pair.hpp"
#include "common/geometry/exact_triangle_pair.hpp"
#include "common/geometry/shared_points.hpp"

namespace cd {

PairStatistics& PairStatistics::operator+=(const PairStatistics& other) {
    by_double += other.by_double;
    by_exact += other.by_exact;
    return *this;
}

struct TrianglePairTest::State {
    Mat3 rotation_a;
    Mat3 rotation_b;
    Vec3 translation_a;
    Vec3 offset; ///< tb - ta, rounded once.
    DoubleTrianglePair in_double;
    ExactTrianglePair exact;
    PairStatistics statistics;

    explicit State(const PosePair& poses)
        : rotation_a(poses.a.rotation()),
          rotation_b(poses.b.rotation()),
          translation_a(poses.a.translation()),
          offset(poses.b.translation() - poses.a.translation()),
          in_double(poses),
          exact(poses) {}
};

TrianglePairTest::TrianglePairTest(const PosePair& poses)
    : state_(std::make_unique<State>(poses)) {}
TrianglePairTest::TrianglePairTest(TrianglePairTest&&) noexcept = default;
TrianglePairTest& TrianglePairTest::operator=(TrianglePairTest&&) noexcept = default;
TrianglePairTest::~TrianglePairTest() = default;

bool TrianglePairTest::touches(const Corners& a, const Corners& b) {
    return classify(a, b) != PairClass::Separate;
}

PairClass TrianglePairTest::classify(const Corners& a, const Corners& b) {
    if (const auto decided = state_->in_double.classify(a, b)) {
        ++state_->statistics.by_double;
        return *decided;
    }
    ++state_->statistics.by_exact;
    return state_->exact.classify(a, b);
}

std::vector<Vec3>
TrianglePairTest::shared_points(const Corners& a, const Corners& b, PairClass kind) {
    const State& s = *state_;
    const Vec3 from_a0_to_b0 = (s.rotation_b * b[0] - s.rotation_a * a[0]) + s.offset;
    Corners local_a;
    Corners local_b;
    for (std::size_t i = 0; i < 3; ++i) {
        local_a[i] = s.rotation_a * (a[i] - a[0]);
        local_b[i] = s.rotation_b * (b[i] - b[0]) + from_a0_to_b0;
    }
    return approximate_shared_points(local_a, local_b, kind);
}

Vec3 TrianglePairTest::point_origin(const Corners& a) const {
    return state_->rotation_a * a[0] + state_->translation_a;
}

const PairStatistics& TrianglePairTest::statistics() const {
    return state_->statistics;
}

} // namespace cd
