#include "tests/support/exact_solid.hpp"

#include "common/core/check.hpp"

#include <random>

namespace cd::tests {

namespace {

constexpr std::size_t directions_max = 64;

ExactPoint ray_direction(std::size_t number) {
    std::mt19937_64 random(number);
    const auto entry = [&] { return Integer(static_cast<long>(random() >> 44) - (1L << 19)); };
    ExactPoint direction;
    for (Integer& part : direction) {
        part = entry();
    }
    return direction;
}

} // namespace

const std::vector<ExactSolid::Target>& ExactSolid::targets(std::size_t direction) {
    CD_CHECK(direction < directions_max);
    while (targets_.size() <= direction) {
        const ExactPoint d = ray_direction(targets_.size());
        std::vector<Target>& made = targets_.emplace_back();
        for (const ExactTriangle& t : surface_) {
            Target target;
            target.normal = normal_of(t);
            if (is_zero(target.normal)) {
                continue;
            }
            target.offset = dot(target.normal, t[0]);
            target.along = sgn(dot(target.normal, d));
            for (std::size_t i = 0; i < 3; ++i) {
                const ExactPoint& next = t[(i + 1) % 3];
                target.edge_normals[i] = cross(minus(next, t[i]), d);
                target.edge_offsets[i] = dot(cross(t[i], next), d);
            }
            made.push_back(std::move(target));
        }
    }
    return targets_[direction];
}

std::optional<ExactSolid::Count> ExactSolid::count(const WeightedPoint& point,
                                                   std::size_t direction) {
    Count result;
    for (const Target& t : targets(direction)) {
        const int ahead = cmp(t.offset * point.weight, dot(t.normal, point.p));
        if (t.along == 0) {
            if (ahead == 0) {
                return std::nullopt; // The ray lies in the plane.
            }
            continue;
        }
        if (ahead * t.along < 0) {
            continue; // The crossing is behind the origin.
        }
        // The side of each edge on which the ray passes: the sign of d.((v - p) x (w - p)), which
        // equals d.(v x w) - p.((w - v) x d).
        int left = 0;
        int right = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const int side = cmp(t.edge_offsets[i] * point.weight, dot(t.edge_normals[i], point.p));
            left += side > 0 ? 1 : 0;
            right += side < 0 ? 1 : 0;
        }
        if (left != 0 && right != 0) {
            continue; // The ray misses the triangle.
        }
        if (ahead == 0) {
            result.on_surface = true;
        } else if (left + right < 3) {
            return std::nullopt; // The ray meets an edge or a corner.
        } else {
            result.is_odd = !result.is_odd;
        }
    }
    return result;
}

PointPlace ExactSolid::place(const WeightedPoint& point) {
    for (std::size_t direction = 0;; ++direction) {
        if (const auto counted = count(point, direction)) {
            if (counted->on_surface) {
                return PointPlace::OnSurface;
            }
            return counted->is_odd ? PointPlace::Inside : PointPlace::Outside;
        }
    }
}

std::optional<bool> ExactSolid::is_solid_towards(const WeightedPoint& point,
                                                 std::size_t direction) {
    const auto counted = count(point, direction);
    return counted ? std::optional(counted->is_odd) : std::nullopt;
}

} // namespace cd::tests
