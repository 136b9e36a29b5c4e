#include "common/geometry/integer_triangle_pair.hpp"

namespace cd {

namespace {

struct Task {
    const PoseLattice& lattice;
    const Corners& a;
    const Corners& b;
    PoseLattice::Extent extent;
    const PlaneSides& of_a;
    const PlaneSides& of_b;
};

/// Decides with the first number of words that is enough.
template <std::size_t n, std::size_t... more>
std::optional<PairClass> decide(const Task& task) {
    if (task.extent.bits <= wide_int::bits_max(n)) {
        const LatticeCorners<n> corners = task.lattice.corners<n>(task.a, task.b, task.extent);
        IntegerSigns<n> signs(corners, task.of_a, task.of_b);
        return decide_pair(signs);
    }
    if constexpr (sizeof...(more) > 0) {
        return decide<more...>(task);
    }
    return std::nullopt;
}

} // namespace

std::optional<IntegerTrianglePair::Decision> IntegerTrianglePair::classify(const Corners& a,
                                                                           const Corners& b,
                                                                           const PlaneSides& of_a,
                                                                           const PlaneSides& of_b) {
    if (!lattice_) {
        lattice_ = std::make_unique<PoseLattice>(poses_);
    }
    if (!lattice_->fits()) {
        return std::nullopt;
    }
    const Task task{*lattice_, a, b, lattice_->extent_of(a, b), of_a, of_b};
    const auto kind = decide<1, 2, 3, 4, 6, 8, 16>(task);
    if (!kind) {
        return std::nullopt;
    }
    const bool is_short = task.extent.bits <= wide_int::bits_max(1) && lattice_->is_unrotated();
    return Decision{*kind, is_short ? PairStage::Lattice : PairStage::WideInteger};
}

} // namespace cd
