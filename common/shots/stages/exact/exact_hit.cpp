#include "common/shots/stages/exact/exact_hit.hpp"

#include "common/pair/numbers/exact_lattice.hpp"
#include "common/pair/numbers/exact_vectors.hpp"
#include "common/shots/hit_decision.hpp"

#include <array>
#include <cstddef>
#include <utility>

namespace cd {

namespace {

using exact_vectors::cross;
using exact_vectors::dot;
using exact_vectors::minus;

constexpr std::size_t next(std::size_t corner) {
    return (corner + 1) % 3;
}

bool is_zero(const ExactVec& v) {
    return v[0] == 0 && v[1] == 0 && v[2] == 0;
}

/// A triangle and a segment from p, in one unit.
struct Placed {
    std::array<ExactVec, 3> corners;
    std::array<ExactVec, 3> edges; ///< From corner i to the next.
    ExactVec normal;
    ExactVec p;
    ExactVec along; ///< From p to the segment's other end.

    explicit Placed(const ExactLattice& lattice)
        : corners{lattice.corners[0], lattice.corners[1], lattice.corners[2]},
          p(lattice.corners[3]),
          along(minus(lattice.corners[4], p)) {
        for (std::size_t i = 0; i < 3; ++i) {
            edges[i] = minus(corners[next(i)], corners[i]);
        }
        normal = cross(edges[0], edges[1]);
    }

    [[nodiscard]] ExactInt side_p() const { return dot(normal, minus(p, corners[0])); }
    [[nodiscard]] ExactInt side_q() const { return side_p() + dot(normal, along); }
};

/// Models HitSigns.
class ExactHitSigns {
  public:
    explicit ExactHitSigns(const Placed& placed) : placed_(placed) {}

    [[nodiscard]] std::array<int, 2> sides() const {
        return {placed_.side_p().sign(), placed_.side_q().sign()};
    }
    [[nodiscard]] int edge(std::size_t i) const {
        const ExactVec from = minus(placed_.corners[i], placed_.p);
        return dot(cross(placed_.along, from), placed_.edges[i]).sign();
    }
    [[nodiscard]] int tie(std::size_t i, std::size_t axis) const {
        return cross(placed_.along, placed_.edges[i])[axis].sign();
    }

  private:
    const Placed& placed_;
};

/// Tests whether the point p / w is on an edge, which may be a point.
bool is_on_edge(const Placed& on, std::size_t edge, const ExactVec& p, const ExactInt& w) {
    const ExactVec& from = on.corners[edge];
    const ExactVec& along = on.edges[edge];
    const ExactVec apart{p[0] - w * from[0], p[1] - w * from[1], p[2] - w * from[2]};
    const ExactInt place = dot(apart, along);
    return is_zero(along)
               ? is_zero(apart)
               : is_zero(cross(apart, along)) && place >= 0 && place <= w * dot(along, along);
}

/// Tests whether p, which lies in the plane of the triangle if that has area, is in the triangle.
bool contains_p(const Placed& on) {
    bool is_left = !is_zero(on.normal);
    bool is_on_any = false;
    for (std::size_t i = 0; i < 3; ++i) {
        const ExactVec turn = cross(on.edges[i], minus(on.p, on.corners[i]));
        is_left = is_left && dot(on.normal, turn) >= 0;
        is_on_any = is_on_any || is_on_edge(on, i, on.p, 1);
    }
    return is_left || is_on_any;
}

/// Keeps the least share of those offered that is on the segment.
class LeastShare {
  public:
    void offer(ExactShare share) {
        if (share.n >= 0 && share.n <= share.d && (!least_ || share.compare(*least_) < 0)) {
            least_ = std::move(share);
        }
    }
    [[nodiscard]] std::optional<ExactShare> least() && { return std::move(least_); }

  private:
    std::optional<ExactShare> least_;
};

/// Offers the share of a corner that is on the segment's line; the segment is not a point.
void offer_corner(LeastShare& shares, const Placed& on, std::size_t corner) {
    const ExactVec apart = minus(on.corners[corner], on.p);
    if (is_zero(cross(apart, on.along))) {
        shares.offer({dot(apart, on.along), dot(on.along, on.along)});
    }
}

/// Offers the share at which the segment meets an edge that is not parallel to it.
void offer_crossing(LeastShare& shares, const Placed& on, std::size_t edge) {
    const ExactVec apart = minus(on.corners[edge], on.p);
    const ExactVec normal = cross(on.along, on.edges[edge]);
    const ExactInt square = dot(normal, normal);
    if (square == 0 || dot(apart, normal) != 0) {
        return;
    }
    const ExactInt of_edge = dot(cross(apart, on.along), normal);
    if (of_edge >= 0 && of_edge <= square) {
        shares.offer({dot(cross(apart, on.edges[edge]), normal), square});
    }
}

/// Returns the least share of a segment in the plane of a triangle, or of a segment and a triangle
/// without area. The first shared point is p or on an edge.
std::optional<ExactShare> first_in_plane(const Placed& on) {
    if (contains_p(on)) {
        return ExactShare{0, 1};
    }
    LeastShare shares;
    if (!is_zero(on.along)) {
        for (std::size_t i = 0; i < 3; ++i) {
            offer_corner(shares, on, i);
            offer_crossing(shares, on, i);
        }
    }
    return std::move(shares).least();
}

/// Returns the flags of a shared point in the plane.
std::uint8_t flags_in_plane(const Placed& on, const ExactShare& share) {
    ExactVec point;
    for (std::size_t k = 0; k < 3; ++k) {
        point[k] = on.p[k] * share.d + on.along[k] * share.n;
    }
    std::uint8_t flags = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const ExactVec& c = on.corners[i];
        if (point[0] == c[0] * share.d && point[1] == c[1] * share.d &&
            point[2] == c[2] * share.d) {
            return hit_flag::corner;
        }
        flags |= is_on_edge(on, i, point, share.d) ? hit_flag::edge : 0;
    }
    return flags;
}

ExactShare share_through(const Placed& on) {
    ExactInt n = on.side_p();
    ExactInt d = -dot(on.normal, on.along);
    if (d < 0) {
        n = -n;
        d = -d;
    }
    return {n, d};
}

} // namespace

ExactHit::ExactHit(const PosePair& poses)
    : poses_(poses), a_(to_exact(poses.a)), b_(to_exact(poses.b)) {}

std::optional<ExactHit::Found> ExactHit::find(const Corners& a, const Segment& line) const {
    // Coordinates relative to a point near the triangle are short.
    const Vec3 corner = poses_.a.apply(a[0]);
    const Vec3 origin = corner.allFinite() ? corner : Vec3::Zero();
    const Placed placed(exact_lattice(a_, a, b_, line.corners(), origin));
    ExactHitSigns signs(placed);
    const HitDecision decision = decide_hit(signs);
    if (decision.how == HitDecision::How::Through) {
        return Found{decision.flags, share_through(placed)};
    }
    if (decision.how == HitDecision::How::InPlane) {
        if (auto share = first_in_plane(placed)) {
            const std::uint8_t flags = flags_in_plane(placed, *share);
            return Found{flags, *std::move(share)};
        }
    }
    return std::nullopt;
}

double rounded_depth(const ExactShare& share, double length) {
    const Dyadic scale = to_dyadic(length);
    return nearest_double(share.n * scale.mantissa, share.d, scale.exponent);
}

} // namespace cd
