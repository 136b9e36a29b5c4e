#include "common/geometry/integer_triangle_pair.hpp"

#include "common/geometry/plain_poses.hpp"

namespace cd {

namespace {

struct Task {
    const Corners& a;
    const Corners& b;
    const PlaneSides& of_a;
    const PlaneSides& of_b;
};

template <std::size_t n>
PairClass decide(const LatticeCorners<n>& corners, const Task& task) {
    IntegerSigns<n> signs(corners, task.of_a, task.of_b);
    return decide_pair(signs);
}

/// Decides with the first number of words that is enough.
template <std::size_t n, std::size_t... more>
std::optional<PairClass>
decide(const PoseLattice& lattice, const PoseLattice::Extent& extent, const Task& task) {
    if (extent.bits <= wide_int::bits_max(n)) {
        return decide(lattice.corners<n>(task.a, task.b, extent), task);
    }
    if constexpr (sizeof...(more) > 0) {
        return decide<more...>(lattice, extent, task);
    }
    return std::nullopt;
}

} // namespace

IntegerTrianglePair::IntegerTrianglePair(const PosePair& poses, PairStage first)
    : poses_(plain_poses(poses)) {
    if (first <= PairStage::Lattice && permutes_axes(poses_.a) && permutes_axes(poses_.b)) {
        short_lattice_.emplace(poses_);
    }
}

std::optional<PairClass> IntegerTrianglePair::classify_short(const Corners& a,
                                                             const Corners& b) const {
    if (short_lattice_) {
        if (const auto corners = short_lattice_->corners<1>(a, b)) {
            return decide(*corners, {a, b, unknown_sides, unknown_sides});
        }
    }
    return std::nullopt;
}

std::optional<PairClass> IntegerTrianglePair::classify(const Corners& a,
                                                       const Corners& b,
                                                       const PlaneSides& of_a,
                                                       const PlaneSides& of_b) {
    const Task task{a, b, of_a, of_b};
    if (short_lattice_) {
        if (const auto corners = short_lattice_->corners<2>(a, b)) {
            return decide(*corners, task);
        }
    }
    if (!lattice_) {
        lattice_ = std::make_unique<PoseLattice>(poses_);
    }
    if (!lattice_->fits()) {
        return std::nullopt;
    }
    const PoseLattice::Extent extent = lattice_->extent_of(a, b);
    return decide<1, 2, 3, 4, 5, 6, 8, 16>(*lattice_, extent, task);
}

} // namespace cd
