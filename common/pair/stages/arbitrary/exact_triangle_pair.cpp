#include "common/pair/stages/arbitrary/exact_triangle_pair.hpp"

#include "common/pair/numbers/exact_lattice.hpp"
#include "common/pair/pair_decision.hpp"

#include <array>
#include <cstddef>

namespace cd {

namespace {

using Vec = ExactVec;

Vec minus(const Vec& l, const Vec& r) {
    return {l[0] - r[0], l[1] - r[1], l[2] - r[2]};
}

/// Returns the sign of det(a, b, c).
int determinant_sign(const Vec& a, const Vec& b, const Vec& c) {
    const ExactInt value = (a[1] * b[2] - a[2] * b[1]) * c[0] + (a[2] * b[0] - a[0] * b[2]) * c[1] +
                           (a[0] * b[1] - a[1] * b[0]) * c[2];
    return value.sign();
}

/// Models CornerSigns.
class ExactSigns {
  public:
    explicit ExactSigns(const std::array<Vec, 6>& corners) : corners_(corners) {}

    [[nodiscard]] PlaneSides sides_of_a() const {
        return {volume(3, 4, 5, 0), volume(3, 4, 5, 1), volume(3, 4, 5, 2)};
    }
    [[nodiscard]] PlaneSides sides_of_b() const {
        return {volume(0, 1, 2, 3), volume(0, 1, 2, 4), volume(0, 1, 2, 5)};
    }
    [[nodiscard]] int
    edge_side(std::size_t i, std::size_t i_to, std::size_t j, std::size_t j_to) const {
        return volume(i, i_to, j, j_to);
    }
    [[nodiscard]] int turn(std::size_t i, std::size_t j, std::size_t k, std::size_t axis) const {
        const Vec along = minus(corners_[j], corners_[i]);
        const Vec aside = minus(corners_[k], corners_[i]);
        const std::size_t x = (axis + 1) % 3;
        const std::size_t y = (axis + 2) % 3;
        const ExactInt value = along[x] * aside[y] - along[y] * aside[x];
        return value.sign();
    }
    [[nodiscard]] int difference(std::size_t i, std::size_t j, std::size_t axis) const {
        const ExactInt value = corners_[i][axis] - corners_[j][axis];
        return value.sign();
    }

  private:
    [[nodiscard]] int volume(std::size_t i, std::size_t j, std::size_t k, std::size_t l) const {
        return determinant_sign(minus(corners_[j], corners_[i]),
                                minus(corners_[k], corners_[i]),
                                minus(corners_[l], corners_[i]));
    }

    const std::array<Vec, 6>& corners_;
};

} // namespace

struct ExactTrianglePair::State {
    ExactPose a;
    ExactPose b;
};

ExactTrianglePair::ExactTrianglePair(const PosePair& poses)
    : state_(std::make_unique<State>(State{to_exact(poses.a), to_exact(poses.b)})) {}
ExactTrianglePair::ExactTrianglePair(ExactTrianglePair&&) noexcept = default;
ExactTrianglePair& ExactTrianglePair::operator=(ExactTrianglePair&&) noexcept = default;
ExactTrianglePair::~ExactTrianglePair() = default;

PairClass ExactTrianglePair::classify(const Corners& a, const Corners& b) const {
    const ExactLattice lattice = exact_lattice(state_->a, a, state_->b, b, Vec3::Zero());
    ExactSigns signs(lattice.corners);
    return decide_pair(signs);
}

} // namespace cd
