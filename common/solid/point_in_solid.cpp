#include "common/solid/point_in_solid.hpp"

#include "common/core/check.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <iterator>
#include <limits>

namespace cd {

namespace {

constexpr double unit_roundoff = 0x1p-53;

/// Returns the direction of ray number `attempt`: a point of the curve (1, t, t^2). A plane through
/// the origin contains at most two of its points. Exact in double; t runs over distinct multiples
/// of 2^-16 in [0, 1), then in [1, 2), and so on.
Vec3 ray_direction(std::uint64_t attempt) {
    const std::uint64_t step =
        (attempt * 40503 + 26177) % 65536; // 40503 is odd, so this is a permutation.
    const double t = static_cast<double>(attempt / 65536) + static_cast<double>(step) / 65536.0;
    return {1, t, t * t};
}

/// A triangle of the solid as seen from a point: its corners relative to the point.
class SeenTriangle {
  public:
    SeenTriangle(const Corners& corners, SolidPoint& point) : corners_(corners), point_(point) {
        for (std::size_t i = 0; i < 3; ++i) {
            seen_[i] = corners[i] - point.rounded();
            size_[i] = seen_[i].cwiseAbs().maxCoeff();
        }
    }

    /// Returns the sign of det(direction, corner i, corner j): on which side of the edge between
    /// these corners the ray's line passes.
    [[nodiscard]] int edge_side(const Vec3& direction, std::size_t i, std::size_t j) {
        // Each minor is at most 2 size_i size_j. The differences, two products, a difference, a
        // product and two sums round: 8 u to first order. The point's error moves each minor by at
        // most 2 error (size_i + size_j + error).
        const double reach = direction.cwiseAbs().sum();
        const double error =
            reach * (24 * unit_roundoff * size_[i] * size_[j] +
                     3 * point_.error() * (size_[i] + size_[j] + point_.error()) + 0x1p-1000);
        if (const auto sign = proven_sign(direction.dot(seen_[i].cross(seen_[j])), error)) {
            return *sign;
        }
        return sign_of(dot(to_dyadic(direction), cross(exact_seen(i), exact_seen(j))));
    }

    /// Returns the sign of det(corner 0, corner 1, corner 2): on which side of the triangle's plane
    /// the point lies.
    [[nodiscard]] int plane_side() {
        if (const auto sign = proven_volume_sign(seen_, point_.error())) {
            return *sign;
        }
        return sign_of(dot(exact_seen(2), cross(exact_seen(0), exact_seen(1))));
    }

    /// Returns true when the corners lie on one line, exactly.
    [[nodiscard]] bool is_flat() const {
        const DyadicVec origin = to_dyadic(corners_[0]);
        return is_zero(cross(to_dyadic(corners_[1]) - origin, to_dyadic(corners_[2]) - origin));
    }

  private:
    /// Returns corner i relative to the point, times the point's weight, which is positive.
    [[nodiscard]] DyadicVec exact_seen(std::size_t i) {
        const ExactPoint& point = point_.exact();
        return point.weight * to_dyadic(corners_[i]) - point.value;
    }

    const Corners& corners_;
    SolidPoint& point_;
    std::array<Vec3, 3> seen_;
    std::array<double, 3> size_{};
};

enum class Crossing : std::uint8_t {
    None,
    Once,
    Unclear,   ///< The ray meets an edge, a corner or the plane: another direction is needed.
    OnSurface, ///< The point lies on the triangle.
};

/// Decides whether the ray from the point meets the triangle.
Crossing crossing(SeenTriangle triangle, const Vec3& direction) {
    const std::array<int, 3> sides{triangle.edge_side(direction, 0, 1),
                                   triangle.edge_side(direction, 1, 2),
                                   triangle.edge_side(direction, 2, 0)};
    const auto [least, greatest] = std::minmax_element(sides.begin(), sides.end());
    if (*least < 0 && *greatest > 0) {
        return Crossing::None; // The whole line misses the triangle.
    }
    if (*least == 0 && *greatest == 0) {
        // The line lies in the triangle's plane, or the triangle has no area and bounds nothing.
        return triangle.is_flat() ? Crossing::None : Crossing::Unclear;
    }
    // The line meets the closed triangle in one point. The sum of the three determinants is
    // direction . normal, so their common sign is the sign of that product. The plane lies ahead of
    // the ray's start if `plane_side` has this sign.
    const int forward = *least < 0 ? -1 : 1;
    const int side = triangle.plane_side();
    if (side == 0) {
        return Crossing::OnSurface;
    }
    if (side != forward) {
        return Crossing::None;
    }
    return *least == 0 || *greatest == 0 ? Crossing::Unclear : Crossing::Once;
}

Vec3 axis_of(const ObbNode& box, std::size_t i) {
    return {static_cast<double>(box.axes[3 * i]),
            static_cast<double>(box.axes[3 * i + 1]),
            static_cast<double>(box.axes[3 * i + 2])};
}

/// Tests a ray against boxes, with a margin for all roundings.
class BoxesOnRay {
  public:
    BoxesOnRay(const SolidPoint& point, const Vec3& direction, const ObbNode& root)
        : start_(point.rounded()), direction_(direction) {
        // Only the part of the ray within the outermost box matters. There, no number below is
        // greater than `scale`, and each errs by a few 2^-53 of it; 2^-40 is a sufficient margin.
        double reach = start_.cwiseAbs().maxCoeff();
        for (std::size_t i = 0; i < 3; ++i) {
            reach += std::abs(root.center[i]) + static_cast<double>(root.half[i]);
        }
        const double scale = 16 * reach * direction.cwiseAbs().maxCoeff();
        margin_ = 0x1p-40 * scale + 4 * point.error();
    }

    /// Returns false only if the start lies outside the box.
    [[nodiscard]] bool may_start_in(const ObbNode& box) const {
        for (std::size_t i = 0; i < 3; ++i) {
            if (std::abs(axis_of(box, i).dot(from_center(box))) > half(box, i)) {
                return false;
            }
        }
        return true;
    }

    /// Returns false only if no point of the ray lies in the box (slab test). Overflow does not
    /// reject.
    [[nodiscard]] bool may_meet(const ObbNode& box) const {
        double enter = 0;
        double leave = std::numeric_limits<double>::infinity();
        const Vec3 from = from_center(box);
        for (std::size_t i = 0; i < 3; ++i) {
            const double offset = axis_of(box, i).dot(from);
            const double speed = axis_of(box, i).dot(direction_);
            const double reach = half(box, i);
            if (speed == 0) {
                if (std::abs(offset) > reach) {
                    return false;
                }
                continue;
            }
            const double one = (-reach - offset) / speed;
            const double other = (reach - offset) / speed;
            if (std::isnan(one) || std::isnan(other)) {
                continue;
            }
            enter = std::max(enter, std::min(one, other));
            leave = std::min(leave, std::max(one, other));
            if (enter > leave) {
                return false;
            }
        }
        return true;
    }

  private:
    [[nodiscard]] Vec3 from_center(const ObbNode& box) const {
        return start_ - Vec3(box.center[0], box.center[1], box.center[2]);
    }
    [[nodiscard]] double half(const ObbNode& box, std::size_t i) const {
        return static_cast<double>(box.half[i]) * (1 + 0x1p-40) + margin_;
    }

    Vec3 start_;
    Vec3 direction_;
    double margin_ = 0;
};

bool has(std::span<const IdRange> ranges, std::uint32_t id) {
    const auto after = std::ranges::upper_bound(ranges, id, {}, &IdRange::begin);
    return after != ranges.begin() && id < std::prev(after)->end;
}

Vec3 centroid_of(const Corners& corners) {
    return (corners[0] + corners[1] + corners[2]) / 3;
}

/// Returns the sign of normal . direction, where the winding orients the normal.
int forward_of(const Corners& corners, const Vec3& direction) {
    const Vec3 edge_1 = corners[1] - corners[0];
    const Vec3 edge_2 = corners[2] - corners[0];
    // The bound is that of `SeenTriangle::edge_side` for a point without error.
    const double error =
        direction.cwiseAbs().sum() *
        (24 * unit_roundoff * edge_1.cwiseAbs().maxCoeff() * edge_2.cwiseAbs().maxCoeff() +
         0x1p-1000);
    if (const auto sign = proven_sign(direction.dot(edge_1.cross(edge_2)), error)) {
        return *sign;
    }
    const DyadicVec origin = to_dyadic(corners[0]);
    return sign_of(dot(to_dyadic(direction),
                       cross(to_dyadic(corners[1]) - origin, to_dyadic(corners[2]) - origin)));
}

SolidPoint centroid_point(const Corners& corners) {
    double size = 0;
    for (const Vec3& corner : corners) {
        size = std::max(size, corner.cwiseAbs().maxCoeff());
    }
    // Two sums and a quotient round.
    return {centroid_of(corners), 8 * unit_roundoff * size + 0x1p-1000, [&corners] {
                return ExactPoint{to_dyadic(corners[0]) + to_dyadic(corners[1]) +
                                      to_dyadic(corners[2]),
                                  Dyadic{3, 0}};
            }};
}

} // namespace

const ExactPoint& SolidPoint::exact() {
    if (!exact_) {
        exact_ = make_exact_();
    }
    return *exact_;
}

SolidTest::Verdict SolidTest::cast_ray(SolidPoint& point,
                                       const Vec3& direction,
                                       std::span<const IdRange> passed_over) {
    const TreeView view = solid_.view();
    const BoxesOnRay boxes(point, direction, view.nodes[0]);
    if (!boxes.may_start_in(view.nodes[0])) {
        return Verdict::Even;
    }
    bool is_odd = false;
    waiting_.assign(1, 0);
    while (!waiting_.empty()) {
        const std::uint32_t index = waiting_.back();
        waiting_.pop_back();
        const ObbNode& node = view.nodes[index];
        ++statistics_.ray_box_tests;
        if (!boxes.may_meet(node)) {
            continue;
        }
        if (!node.is_leaf()) {
            waiting_.push_back(node.right);
            waiting_.push_back(index + 1);
            continue;
        }
        for (std::uint32_t i = node.triangles_begin; i < node.triangles_end; ++i) {
            if (has(passed_over, view.triangle_ids[i])) {
                continue;
            }
            const Triangle& triangle = view.triangles[i];
            const Corners corners{
                view.vertices[triangle[0]], view.vertices[triangle[1]], view.vertices[triangle[2]]};
            ++statistics_.ray_triangle_tests;
            const Crossing found = crossing(SeenTriangle(corners, point), direction);
            if (found == Crossing::OnSurface) {
                return Verdict::OnSurface;
            }
            if (found == Crossing::Unclear) {
                return Verdict::Unclear;
            }
            is_odd = is_odd != (found == Crossing::Once);
        }
    }
    return is_odd ? Verdict::Odd : Verdict::Even;
}

/// Bounds the number of directions to try. For each triangle that the point is not on, a direction
/// is unclear only in the triangle's plane and in the planes through the point and an edge: 4
/// planes, so 8 directions. (Where the point lies on an edge's line, that edge has no plane, but
/// any direction off the triangle's plane is clear.) `is_inside_beside` excludes one more plane, so
/// 2 more directions.
std::uint64_t SolidTest::attempts_max() const {
    return 8 * std::uint64_t{solid_.mesh().triangles().size()} + 3;
}

/// Returns a direction towards the nearest face of the solid's box, so that the ray meets few
/// boxes. The direction is oblique to avoid edges parallel to the box's axes. Returns nothing if
/// the point lies outside the box.
std::optional<Vec3> SolidTest::shortest_way_out(const SolidPoint& point) const {
    const ObbNode& box = solid_.view().nodes[0];
    const Vec3 center(box.center[0], box.center[1], box.center[2]);
    const Vec3 from_center = point.rounded() - center;
    // Each number below errs by a few 2^-53 of this scale.
    const double scale = point.rounded().cwiseAbs().maxCoeff() + center.cwiseAbs().maxCoeff();
    const double margin = 0x1p-40 * scale + 4 * point.error();
    std::size_t nearest = 0;
    double offset = 0;
    double least_room = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
        const double along = axis_of(box, i).dot(from_center);
        const double room = static_cast<double>(box.half[i]) - std::abs(along);
        if (room < -margin) {
            return std::nullopt;
        }
        if (room < least_room) {
            nearest = i;
            offset = along;
            least_room = room;
        }
    }
    const Vec3 out = offset < 0 ? Vec3(-axis_of(box, nearest)) : axis_of(box, nearest);
    return out + 0x1p-4 * axis_of(box, (nearest + 1) % 3) +
           0x1.8p-6 * axis_of(box, (nearest + 2) % 3);
}

Location SolidTest::locate(SolidPoint& point, std::span<const IdRange> left_out) {
    ++statistics_.points;
    const std::optional<Vec3> way_out = shortest_way_out(point);
    if (!way_out) {
        return Location::Outside;
    }
    Verdict verdict = cast_ray(point, *way_out, left_out);
    for (std::uint64_t i = 0; verdict == Verdict::Unclear; ++i) {
        CD_CHECK(i < attempts_max());
        verdict = cast_ray(point, ray_direction(i), left_out);
    }
    statistics_.by_exact += point.needed_exact() ? 1u : 0u;
    return verdict == Verdict::OnSurface ? Location::OnSurface
           : verdict == Verdict::Odd     ? Location::Inside
                                         : Location::Outside;
}

bool SolidTest::is_inside_beside(SolidPoint& point,
                                 const std::function<int(const Vec3& direction)>& side_of,
                                 int side,
                                 std::span<const std::uint32_t> passed_over) {
    ++statistics_.points;
    passed_over_.clear();
    for (const std::uint32_t id : passed_over) {
        passed_over_.push_back({id, id + 1});
    }
    Verdict verdict = Verdict::Unclear;
    for (std::uint64_t i = 0; verdict == Verdict::Unclear; ++i) {
        CD_CHECK(i < attempts_max());
        const Vec3 direction = ray_direction(i);
        const int leads_to = side_of(direction);
        if (leads_to != 0) {
            verdict =
                cast_ray(point, leads_to == side ? direction : Vec3(-direction), passed_over_);
        }
    }
    statistics_.by_exact += point.needed_exact() ? 1u : 0u;
    return verdict != Verdict::Even;
}

int SolidTest::solid_side(std::uint32_t triangle) {
    ++statistics_.points;
    const Corners corners = solid_.mesh().corners(triangle);
    SolidPoint point = centroid_point(corners);
    const IdRange itself{triangle, triangle + 1};
    Verdict verdict = Verdict::Unclear;
    for (std::uint64_t i = 0; verdict == Verdict::Unclear; ++i) {
        CD_CHECK(i < attempts_max());
        const Vec3 direction = ray_direction(i);
        // The ray follows the normal: with the usual winding this leaves the solid.
        if (const int forward = forward_of(corners, direction); forward != 0) {
            verdict = cast_ray(point, forward * direction, {&itself, 1});
        }
    }
    statistics_.by_exact += point.needed_exact() ? 1u : 0u;
    // The ray starts on the triangle, which is passed over. If the ray crosses the others an odd
    // number of times, the solid is on the normal's side; if an even number, on the other side.
    return verdict == Verdict::OnSurface ? 0 : verdict == Verdict::Odd ? 1 : -1;
}

} // namespace cd
