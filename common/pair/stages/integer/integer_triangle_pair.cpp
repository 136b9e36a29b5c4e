#include "common/pair/stages/integer/integer_triangle_pair.hpp"

#include "common/core/check.hpp"
#include "common/pair/poses/plain_poses.hpp"

#include <utility>

namespace cd {

namespace {

/// Returns `use(signs)` with the IntegerSigns of the corners, which must be set.
template <class Variant, class Use>
auto with_signs(const Variant& corners, const Use& use) {
    using Result = decltype(use(std::declval<IntegerSigns<1>>()));
    return std::visit(
        [&]<class Made>(const Made& made) -> Result {
            if constexpr (std::is_same_v<Made, std::monostate>) {
                CD_CHECK(!"corners are placed");
                return {};
            } else {
                return use(IntegerSigns(made));
            }
        },
        corners);
}

/// Stores the corners in the smallest sufficient number of words; returns false if none suffices.
template <std::size_t n, std::size_t... more, class Variant>
bool place_with(const PoseLattice& lattice,
                const PoseLattice::Extent& extent,
                const Corners& a,
                const Corners& b,
                Variant& corners) {
    if (extent.bits <= wide_int::bits_max(n)) {
        lattice.place(a, b, extent, corners.template emplace<LatticeCorners<n>>());
        return true;
    }
    if constexpr (sizeof...(more) > 0) {
        return place_with<more...>(lattice, extent, a, b, corners);
    }
    return false;
}

} // namespace

PlaneSides IntegerCorners::sides(PlaneSides known, std::size_t plane, std::size_t corners) const {
    return with_signs(corners_,
                      [&](const auto& signs) { return signs.sides(known, plane, corners); });
}

int IntegerCorners::edge_side(std::size_t i,
                              std::size_t i_to,
                              std::size_t j,
                              std::size_t j_to) const {
    return with_signs(corners_,
                      [&](const auto& signs) { return signs.edge_side(i, i_to, j, j_to); });
}

int IntegerCorners::turn(std::size_t i, std::size_t j, std::size_t k, std::size_t axis) const {
    return with_signs(corners_, [&](const auto& signs) { return signs.turn(i, j, k, axis); });
}

int IntegerCorners::difference(std::size_t i, std::size_t j, std::size_t axis) const {
    return with_signs(corners_, [&](const auto& signs) { return signs.difference(i, j, axis); });
}

IntegerTrianglePair::IntegerTrianglePair(const PosePair& poses, PairStage first) : poses_(poses) {
    if (first <= PairStage::Lattice && permutes_axes(poses_.a) && permutes_axes(poses_.b)) {
        short_lattice_.emplace(poses_);
    }
}

std::optional<PairClass> IntegerTrianglePair::classify_short(const Corners& a,
                                                             const Corners& b) const {
    LatticeCorners<1> corners;
    if (!short_lattice_ || !short_lattice_->place(a, b, corners)) {
        return std::nullopt;
    }
    const IntegerSigns signs(corners);
    return decide_pair(signs);
}

bool IntegerTrianglePair::place(const Corners& a, const Corners& b, IntegerCorners& placed) {
    auto& corners = placed.corners_;
    if (short_lattice_) {
        // The caller has tried one word already, by `classify_short`.
        if (short_lattice_->place(a, b, corners.emplace<LatticeCorners<2>>())) {
            return true;
        }
    }
    if (!lattice_) {
        lattice_ = std::make_unique<PoseLattice>(poses_);
    }
    return lattice_->fits() &&
           place_with<1, 2, 3, 4, 5, 6, 8, 16>(*lattice_, lattice_->extent_of(a, b), a, b, corners);
}

} // namespace cd
