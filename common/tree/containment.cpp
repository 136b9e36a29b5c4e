#include "common/tree/containment.hpp"

#include "common/core/check.hpp"
#include "common/tree/box_test.hpp"

#include <Eigen/Geometry>
#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace cd {

namespace {

constexpr double unit_roundoff = 0x1p-53;

// ---- Exact numbers, for what double cannot tell ----------------------------------------------

using Rational = boost::multiprecision::cpp_rational;
using ExactVec = std::array<Rational, 3>;
using ExactMat = std::array<Rational, 9>; ///< Row-major.

ExactVec exact(const Vec3& v) {
    return {Rational(v.x()), Rational(v.y()), Rational(v.z())};
}

ExactVec difference(const ExactVec& left, const ExactVec& right) {
    return {left[0] - right[0], left[1] - right[1], left[2] - right[2]};
}

ExactVec cross(const ExactVec& left, const ExactVec& right) {
    return {left[1] * right[2] - left[2] * right[1],
            left[2] * right[0] - left[0] * right[2],
            left[0] * right[1] - left[1] * right[0]};
}

Rational dot(const ExactVec& left, const ExactVec& right) {
    return left[0] * right[0] + left[1] * right[1] + left[2] * right[2];
}

ExactVec product(const ExactMat& m, const ExactVec& v) {
    ExactVec result;
    for (std::size_t i = 0; i < 3; ++i) {
        result[i] = m[3 * i] * v[0] + m[3 * i + 1] * v[1] + m[3 * i + 2] * v[2];
    }
    return result;
}

/// The linear part of a pose as NUMERICS section 1 has it: the matrix as given, or M(q) / q.q.
ExactMat exact_rotation(const Pose& pose) {
    ExactMat m;
    if (pose.kind() == Pose::Kind::Matrix) {
        for (std::size_t i = 0; i < 9; ++i) {
            m[i] = Rational(pose.matrix()(static_cast<int>(i / 3), static_cast<int>(i % 3)));
        }
        return m;
    }
    const Rational w(pose.quaternion().w);
    const Rational x(pose.quaternion().x);
    const Rational y(pose.quaternion().y);
    const Rational z(pose.quaternion().z);
    const Rational n = w * w + x * x + y * y + z * z;
    m = {w * w + x * x - y * y - z * z,
         2 * (x * y - w * z),
         2 * (x * z + w * y),
         2 * (x * y + w * z),
         w * w - x * x + y * y - z * z,
         2 * (y * z - w * x),
         2 * (x * z - w * y),
         2 * (y * z + w * x),
         w * w - x * x - y * y + z * z};
    for (Rational& entry : m) {
        entry /= n;
    }
    return m;
}

/// Nothing for a matrix that flattens space.
std::optional<ExactMat> inverse(const ExactMat& m) {
    const ExactVec row0{m[0], m[1], m[2]};
    const ExactVec row1{m[3], m[4], m[5]};
    const ExactVec row2{m[6], m[7], m[8]};
    const std::array<ExactVec, 3> columns{cross(row1, row2), cross(row2, row0), cross(row0, row1)};
    const Rational determinant = dot(row0, columns[0]);
    if (determinant == 0) {
        return std::nullopt;
    }
    ExactMat result;
    for (std::size_t i = 0; i < 9; ++i) {
        result[i] = columns[i % 3][i / 3] / determinant;
    }
    return result;
}

/// Inner's coordinates in outer's, exactly. Made when first needed, which is seldom. The outer pose
/// has an inverse.
class ExactMap {
  public:
    ExactMap(const Pose& outer, const Pose& inner) : outer_(outer), inner_(inner) {}

    [[nodiscard]] ExactVec apply(const Vec3& point) {
        if (!terms_) {
            const auto outer_inverse = inverse(exact_rotation(outer_));
            CD_CHECK(outer_inverse.has_value());
            terms_ = Terms{exact_rotation(inner_),
                           *outer_inverse,
                           difference(exact(inner_.translation()), exact(outer_.translation()))};
        }
        ExactVec world = product(terms_->inner_rotation, exact(point));
        for (std::size_t i = 0; i < 3; ++i) {
            world[i] += terms_->offset[i];
        }
        return product(terms_->outer_inverse, world);
    }

  private:
    struct Terms {
        ExactMat inner_rotation;
        ExactMat outer_inverse;
        ExactVec offset; ///< Between the translations, in the world.
    };

    const Pose& outer_;
    const Pose& inner_;
    std::optional<Terms> terms_;
};

// ---- The point -------------------------------------------------------------------------------

/// A corner of `inner` in the coordinates of `outer`: rounded with a bound, and exactly if need be.
class Point {
  public:
    Point(const RelativePose& inner_to_outer, ExactMap& map, const Vec3& corner)
        : map_(map), corner_(corner) {
        rounded_ = inner_to_outer.rotation * corner + inner_to_outer.translation;
        const double size = corner.cwiseAbs().sum();
        const double largest = inner_to_outer.rotation.cwiseAbs().maxCoeff();
        // Three products and three sums; twice what first order says.
        error_ = 1.01 * (inner_to_outer.rotation_error * size + inner_to_outer.translation_error) +
                 8 * unit_roundoff *
                     (largest * size + inner_to_outer.translation.cwiseAbs().maxCoeff()) +
                 0x1p-1000;
    }

    [[nodiscard]] const Vec3& rounded() const { return rounded_; }
    /// Bounds the error of each component of `rounded`.
    [[nodiscard]] double error() const { return error_; }

    [[nodiscard]] const ExactVec& value() {
        if (!value_) {
            value_ = map_.apply(corner_);
        }
        return *value_;
    }

  private:
    ExactMap& map_;
    Vec3 corner_;
    Vec3 rounded_;
    double error_ = 0;
    std::optional<ExactVec> value_;
};

// ---- A ray -----------------------------------------------------------------------------------

/// The direction of the i-th attempt, on the curve (1, t, t^2), of which a plane holds two
/// directions at most. Exact in double; t runs over distinct multiples of 2^-16 in [0, 1), then in
/// [1, 2), and so on.
Vec3 ray_direction(std::uint64_t attempt) {
    const std::uint64_t place = (attempt * 40503 + 26177) % 65536; // 40503 is odd: a permutation.
    const double t = static_cast<double>(attempt / 65536) + static_cast<double>(place) / 65536.0;
    return {1, t, t * t};
}

int sign_of(double value) {
    return value > 0 ? 1 : value < 0 ? -1 : 0;
}

/// The sign of a value that errs by at most `error`; nothing when that leaves it open.
std::optional<int> proven_sign(double value, double error) {
    // Finite intermediate results are part of the bound; NaN and infinity decide nothing.
    return std::isfinite(value) && std::abs(value) > error ? std::optional(sign_of(value))
                                                           : std::nullopt;
}

/// The corners of a triangle of `outer` as seen from the point.
class SeenTriangle {
  public:
    SeenTriangle(const Corners& corners, Point& point) : corners_(corners), point_(point) {
        for (std::size_t i = 0; i < 3; ++i) {
            seen_[i] = corners[i] - point.rounded();
            size_[i] = seen_[i].cwiseAbs().maxCoeff();
        }
    }

    /// The sign of det(direction, corner i, corner j): on which side of the edge the line passes.
    [[nodiscard]] int edge_side(const Vec3& direction, std::size_t i, std::size_t j) {
        // Each minor is at most 2 size_i size_j. The differences, two products, a difference, a
        // product and two sums round: 8 u to first order. The point's error moves each minor by at
        // most 2 error (size_i + size_j + error).
        const double reach = direction.cwiseAbs().sum();
        const double error =
            reach * (24 * unit_roundoff * size_[i] * size_[j] +
                     3 * point_.error() * (size_[i] + size_[j] + point_.error()) + 0x1p-1000);
        const double value = direction.dot(seen_[i].cross(seen_[j]));
        if (const auto sign = proven_sign(value, error)) {
            return *sign;
        }
        const Rational determinant = dot(exact(direction), cross(exact_seen(i), exact_seen(j)));
        return determinant.sign();
    }

    /// The sign of det(corner 0, corner 1, corner 2): on which side of its plane the point lies.
    [[nodiscard]] int plane_side() {
        const double pairs = size_[0] * size_[1] + size_[1] * size_[2] + size_[2] * size_[0];
        const double sum = size_[0] + size_[1] + size_[2] + point_.error();
        // As above, with at most 6 size_0 size_1 size_2 in all.
        const double error = 96 * unit_roundoff * size_[0] * size_[1] * size_[2] +
                             8 * point_.error() * (pairs + point_.error() * sum) +
                             0x1p-1000 * (1 + sum);
        const double value = seen_[2].dot(seen_[0].cross(seen_[1]));
        if (const auto sign = proven_sign(value, error)) {
            return *sign;
        }
        const Rational determinant = dot(exact_seen(2), cross(exact_seen(0), exact_seen(1)));
        return determinant.sign();
    }

    /// True when the corners lie on one line, exactly.
    [[nodiscard]] bool is_flat() const {
        const ExactVec origin = exact(corners_[0]);
        const ExactVec normal =
            cross(difference(exact(corners_[1]), origin), difference(exact(corners_[2]), origin));
        return normal[0] == 0 && normal[1] == 0 && normal[2] == 0;
    }

  private:
    [[nodiscard]] ExactVec exact_seen(std::size_t i) {
        return difference(exact(corners_[i]), point_.value());
    }

    const Corners& corners_;
    Point& point_;
    std::array<Vec3, 3> seen_;
    std::array<double, 3> size_{};
};

enum class Crossing : std::uint8_t {
    None,
    Once,
    Unclear,   ///< Through an edge or a corner, or along the plane: ask with another direction.
    OnSurface, ///< The point lies on the triangle.
};

/// Whether the ray from the point meets the triangle.
Crossing crossing(SeenTriangle triangle, const Vec3& direction) {
    const std::array<int, 3> sides{triangle.edge_side(direction, 0, 1),
                                   triangle.edge_side(direction, 1, 2),
                                   triangle.edge_side(direction, 2, 0)};
    const auto [least, greatest] = std::minmax_element(sides.begin(), sides.end());
    if (*least < 0 && *greatest > 0) {
        return Crossing::None; // The whole line passes by.
    }
    if (*least == 0 && *greatest == 0) {
        // The line lies in the triangle's plane, or the triangle has no area and bounds nothing.
        return triangle.is_flat() ? Crossing::None : Crossing::Unclear;
    }
    // The line meets the closed triangle in one point. The sum of the three determinants is
    // direction . normal, so their common sign tells in which direction it lies.
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

/// Whether a ray can meet boxes, with a margin for all that rounds.
class BoxesOnRay {
  public:
    BoxesOnRay(const Point& point, const Vec3& direction, const ObbNode& root)
        : start_(point.rounded()), direction_(direction) {
        // Only the stretch of the ray within the outermost box matters. There, no number below is
        // greater than `scale`, and each errs by a few u of it; 2^-40 leaves room for all.
        double reach = start_.cwiseAbs().maxCoeff();
        for (std::size_t i = 0; i < 3; ++i) {
            reach += std::abs(root.center[i]) + static_cast<double>(root.half[i]);
        }
        const double scale = 16 * reach * direction.cwiseAbs().maxCoeff();
        margin_ = 0x1p-40 * scale + 4 * point.error();
    }

    /// False only if the start lies outside the box.
    [[nodiscard]] bool may_start_in(const ObbNode& box) const {
        for (std::size_t i = 0; i < 3; ++i) {
            if (std::abs(row(box, i).dot(from_center(box))) > half(box, i)) {
                return false;
            }
        }
        return true;
    }

    /// False only if no point of the ray lies in the box: its three slabs are left and entered in
    /// turn. What overflowed does not reject.
    [[nodiscard]] bool may_meet(const ObbNode& box) const {
        double enter = 0;
        double leave = std::numeric_limits<double>::infinity();
        const Vec3 from = from_center(box);
        for (std::size_t i = 0; i < 3; ++i) {
            const double offset = row(box, i).dot(from);
            const double speed = row(box, i).dot(direction_);
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
    [[nodiscard]] static Vec3 row(const ObbNode& box, std::size_t i) {
        return {static_cast<double>(box.axes[3 * i]),
                static_cast<double>(box.axes[3 * i + 1]),
                static_cast<double>(box.axes[3 * i + 2])};
    }
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

/// As in the topology: those that this rule leaves out are not needed to close the surface.
bool has_area(const Corners& corners) {
    const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    return normal != Vec3::Zero();
}

/// What one ray says.
enum class Verdict : std::uint8_t { Outside, Inside, OnSurface, Unclear };

Verdict cast_ray(const ObbTree& outer, Point& point, const Vec3& direction) {
    const TreeView view = outer.view();
    const BoxesOnRay boxes(point, direction, view.nodes[0]);
    if (!boxes.may_start_in(view.nodes[0])) {
        return Verdict::Outside;
    }
    bool is_odd = false;
    std::vector<std::uint32_t> waiting{0};
    while (!waiting.empty()) {
        const std::uint32_t place = waiting.back();
        waiting.pop_back();
        const ObbNode& node = view.nodes[place];
        if (!boxes.may_meet(node)) {
            continue;
        }
        if (!node.is_leaf()) {
            waiting.push_back(node.right);
            waiting.push_back(place + 1);
            continue;
        }
        for (std::uint32_t i = node.triangles_begin; i < node.triangles_end; ++i) {
            const Triangle& triangle = view.triangles[i];
            const Corners corners{
                view.vertices[triangle[0]], view.vertices[triangle[1]], view.vertices[triangle[2]]};
            if (!has_area(corners)) {
                continue;
            }
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
    return is_odd ? Verdict::Inside : Verdict::Outside;
}

/// True when the point lies strictly inside `outer`.
bool is_inside(const ObbTree& outer, Point& point) {
    // Of a triangle that the point is not on, its plane and the planes through the point and an
    // edge hold the unclear directions: 4 planes, 8 directions. (Where the point lies on an edge's
    // line there is no such plane, but then any direction off the triangle's plane is clear.)
    const std::uint64_t attempts = 8 * std::uint64_t{outer.mesh().triangles().size()} + 1;
    for (std::uint64_t attempt = 0; attempt < attempts; ++attempt) {
        const Verdict verdict = cast_ray(outer, point, ray_direction(attempt));
        if (verdict != Verdict::Unclear) {
            return verdict == Verdict::Inside;
        }
    }
    CD_CHECK(false);
    return false;
}

} // namespace

bool contains_component(const ObbTree& outer,
                        const Pose& outer_pose,
                        const ObbTree& inner,
                        const Pose& inner_pose) {
    const RelativePose inner_to_outer = relative_pose({outer_pose, inner_pose});
    if (!BoxTest(inner_to_outer).may_overlap(outer.nodes()[0], inner.nodes()[0])) {
        return false;
    }
    // A bounded error is a proof that the outer pose has an inverse.
    if (!std::isfinite(inner_to_outer.rotation_error) && !inverse(exact_rotation(outer_pose))) {
        return false; // Nothing is strictly inside a body without volume.
    }
    ExactMap map(outer_pose, inner_pose);
    const auto& components = inner.topology().component_triangles;
    return std::any_of(components.begin(), components.end(), [&](std::uint32_t triangle) {
        Point point(inner_to_outer, map, inner.mesh().corners(triangle)[0]);
        return is_inside(outer, point);
    });
}

} // namespace cd
