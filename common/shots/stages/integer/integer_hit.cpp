#include "common/shots/stages/integer/integer_hit.hpp"

#include "common/pair/numbers/wide_int.hpp"

namespace cd {

namespace {

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

std::array<int, 2> IntegerHitSigns::sides() const {
    return std::visit(
        [](const auto& corners) {
            // The segment's last two corners are one.
            const PlaneSides sides =
                IntegerSigns(corners).sides({unknown_sign, unknown_sign, 0}, 0, 3);
            return std::array<int, 2>{sides[0], sides[1]};
        },
        corners_);
}

int IntegerHitSigns::edge(std::size_t i) const {
    return std::visit(
        [&](const auto& corners) { return IntegerSigns(corners).edge_side(3, 4, i, (i + 1) % 3); },
        corners_);
}

int IntegerHitSigns::tie(std::size_t i, std::size_t axis) const {
    using wide_int::difference;
    const std::size_t x = (axis + 1) % 3;
    const std::size_t y = (axis + 2) % 3;
    const std::size_t to = (i + 1) % 3;
    return std::visit(
        [&](const auto& c) {
            return wide_int::sign(wide_int::determinant(difference(c[4][x], c[3][x]),
                                                        difference(c[4][y], c[3][y]),
                                                        difference(c[to][x], c[i][x]),
                                                        difference(c[to][y], c[i][y])));
        },
        corners_);
}

std::optional<IntegerHitSigns> IntegerHit::place(const Corners& a, const Segment& line) const {
    if (!lattice_.fits()) {
        return std::nullopt;
    }
    const Corners b = line.corners();
    const PoseLattice::Extent extent = lattice_.extent_of(a, b);
    std::optional<IntegerHitSigns> signs(std::in_place);
    return place_with<2, 4, 6, 16>(lattice_, extent, a, b, signs->corners_) ? signs : std::nullopt;
}

} // namespace cd
