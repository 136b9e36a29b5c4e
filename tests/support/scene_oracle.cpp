#include "tests/support/scene_oracle.hpp"

#include "tests/support/exact_solid.hpp"
#include "tests/support/oracle.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <span>
#include <utility>

namespace cd::tests {

namespace {

/// The triangle's bounds, in the triangle's own numbers.
struct ExactBox {
    std::array<const Integer*, 3> low;
    std::array<const Integer*, 3> high;

    explicit ExactBox(const ExactTriangle& t) {
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = high[k] = &t[0][k];
            for (const ExactPoint& corner : t) {
                low[k] = corner[k] < *low[k] ? &corner[k] : low[k];
                high[k] = corner[k] > *high[k] ? &corner[k] : high[k];
            }
        }
    }

    [[nodiscard]] bool overlaps(const ExactBox& other) const {
        for (std::size_t k = 0; k < 3; ++k) {
            if (*low[k] > *other.high[k] || *other.low[k] > *high[k]) {
                return false;
            }
        }
        return true;
    }
};

std::vector<std::uint32_t> pieces_of(const Mesh& mesh) {
    std::vector<std::uint32_t> leader(mesh.vertices().size());
    std::iota(leader.begin(), leader.end(), 0u);
    const auto find = [&](std::uint32_t v) {
        while (leader[v] != v) {
            v = leader[v] = leader[leader[v]];
        }
        return v;
    };
    for (const Triangle& t : mesh.triangles()) {
        leader[find(t[1])] = find(t[0]);
        leader[find(t[2])] = find(t[0]);
    }
    std::map<std::uint32_t, std::uint32_t> first;
    for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
        first.emplace(find(mesh.triangles()[i][0]), i);
    }
    std::vector<std::uint32_t> pieces;
    for (const auto& [piece, triangle] : first) {
        pieces.push_back(triangle);
    }
    return pieces;
}

/// Returns the mean of points, which lies in the relative interior of their hull.
WeightedPoint mean(std::span<const WeightedPoint> points) {
    WeightedPoint result;
    for (const WeightedPoint& point : points) {
        result.weight *= point.weight;
    }
    for (const WeightedPoint& point : points) {
        const Integer share = result.weight / point.weight;
        for (std::size_t k = 0; k < 3; ++k) {
            result.p[k] += point.p[k] * share;
        }
    }
    result.weight *= static_cast<unsigned long>(points.size());
    return result;
}

bool equal(const WeightedPoint& l, const WeightedPoint& r) {
    for (std::size_t k = 0; k < 3; ++k) {
        if (l.p[k] * r.weight != r.p[k] * l.weight) {
            return false;
        }
    }
    return true;
}

bool any_piece_inside(const std::vector<ExactTriangle>& inner,
                      const std::vector<std::uint32_t>& pieces,
                      ExactSolid& outer) {
    return std::any_of(pieces.begin(), pieces.end(), [&](std::uint32_t triangle) {
        return outer.place({inner[triangle][0], 1}) == PointPlace::Inside;
    });
}

/// True if both solids lie on one side of the triangles at a point inside both of them.
bool solids_on_one_side(const WeightedPoint& point, ExactSolid& a, ExactSolid& b) {
    for (std::size_t direction = 0;; ++direction) {
        const auto in_a = a.is_solid_towards(point, direction);
        const auto in_b = in_a ? b.is_solid_towards(point, direction) : std::nullopt;
        if (in_a && in_b) {
            return *in_a == *in_b;
        }
    }
}

/// True if a point inside the triangle lies strictly in the solid. `shared` holds the corners of
/// the triangle's intersection with the solid's surface. The surface may split the triangle into
/// polygons whose corners are in `shared` or the triangle's own. Each polygon consists of triangles
/// between them, so one of these triangles' centres lies in each polygon.
bool has_point_inside(std::vector<WeightedPoint> shared,
                      const ExactTriangle& triangle,
                      ExactSolid& solid) {
    std::vector<WeightedPoint> corners;
    for (const ExactPoint& corner : triangle) {
        shared.push_back({corner, 1});
    }
    for (WeightedPoint& point : shared) {
        if (std::none_of(corners.begin(), corners.end(), [&](const WeightedPoint& other) {
                return equal(point, other);
            })) {
            corners.push_back(std::move(point));
        }
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
        for (std::size_t j = i + 1; j < corners.size(); ++j) {
            for (std::size_t k = j + 1; k < corners.size(); ++k) {
                const std::array three{corners[i], corners[j], corners[k]};
                if (solid.place(mean(three)) == PointPlace::Inside) {
                    return true;
                }
            }
        }
    }
    return false;
}

using SharedByTriangle = std::map<std::uint32_t, std::vector<WeightedPoint>>;

bool any_triangle_inside(const SharedByTriangle& shared,
                         const std::vector<ExactTriangle>& triangles,
                         ExactSolid& solid) {
    return std::any_of(shared.begin(), shared.end(), [&](const auto& entry) {
        return has_point_inside(entry.second, triangles[entry.first], solid);
    });
}

} // namespace

SceneOracle::SceneOracle(const Mesh& a, const Mesh& b, const PosePair& poses)
    : pieces_a_(pieces_of(a)), pieces_b_(pieces_of(b)) {
    const ExactWorld world = exact_world(a.vertices(), b.vertices(), poses);
    a_ = triangles_of(a, world.a);
    b_ = triangles_of(b, world.b);
    const std::vector<ExactBox> boxes_a(a_.begin(), a_.end());
    const std::vector<ExactBox> boxes_b(b_.begin(), b_.end());
    for (std::uint32_t i = 0; i < a_.size(); ++i) {
        for (std::uint32_t j = 0; j < b_.size(); ++j) {
            if (!boxes_a[i].overlaps(boxes_b[j])) {
                continue;
            }
            const PairClass kind = oracle_class(a_[i], b_[j]);
            if (kind != PairClass::Separate) {
                pairs_.push_back({i, j, kind});
            }
        }
    }
}

ScenarioClass SceneOracle::scenario_class(bool closed) const {
    const bool crosses = std::any_of(pairs_.begin(), pairs_.end(), [](const ContactPair& pair) {
        return pair.kind == PairClass::Proper;
    });
    if (crosses) {
        return ScenarioClass::Cross;
    }
    if (!closed) {
        return pairs_.empty() ? ScenarioClass::Separate : ScenarioClass::Touch;
    }
    if (!pairs_.empty()) {
        return interiors_overlap() ? ScenarioClass::Cross : ScenarioClass::Touch;
    }
    ExactSolid a(a_);
    ExactSolid b(b_);
    const bool inside = any_piece_inside(a_, pieces_a_, b) || any_piece_inside(b_, pieces_b_, a);
    return inside ? ScenarioClass::Inside : ScenarioClass::Separate;
}

bool SceneOracle::interiors_overlap() const {
    ExactSolid a(a_);
    ExactSolid b(b_);
    SharedByTriangle shared_of_a;
    SharedByTriangle shared_of_b;
    for (const ContactPair& pair : pairs_) {
        const std::vector<WeightedPoint> shared = shared_corners(a_[pair.a], b_[pair.b]);
        if (pair.kind == PairClass::Coplanar && solids_on_one_side(mean(shared), a, b)) {
            return true;
        }
        for (const WeightedPoint& point : shared) {
            shared_of_a[pair.a].push_back(point);
            shared_of_b[pair.b].push_back(point);
        }
    }
    return any_triangle_inside(shared_of_a, a_, b) || any_triangle_inside(shared_of_b, b_, a);
}

} // namespace cd::tests
