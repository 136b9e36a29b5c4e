#include "common/solid/triangle_in_solid.hpp"

#include "common/solid/triangle_cells.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace cd {

namespace {

/// Converts a point from the frame's coordinates to the outer body's.
SolidPoint to_solid_point(const std::array<Rational, 3>& in_frame, const ExactFrame& frame) {
    const Rational scale = to_rational(frame.scale());
    Vec3 rounded;
    for (std::size_t i = 0; i < 3; ++i) {
        const Rational coordinate = in_frame[i] / scale;
        rounded[static_cast<Eigen::Index>(i)] = coordinate.convert_to<double>();
    }
    // The conversion rounds to the nearest double, or nearly so.
    const double error = 0x1p-50 * rounded.cwiseAbs().maxCoeff() + 0x1p-1000;
    return {rounded, error, [in_frame, &frame] {
                const ExactInt x(denominator(in_frame[0]));
                const ExactInt y(denominator(in_frame[1]));
                const ExactInt z(denominator(in_frame[2]));
                const ExactInt product = x * y * z;
                return ExactPoint{{Dyadic{ExactInt(numerator(in_frame[0])) * y * z, 0},
                                   Dyadic{ExactInt(numerator(in_frame[1])) * z * x, 0},
                                   Dyadic{ExactInt(numerator(in_frame[2])) * x * y, 0}},
                                  Dyadic{product, 0} * frame.scale()};
            }};
}

std::array<Rational, 3> to_rational(const DyadicVec& v) {
    return {to_rational(v[0]), to_rational(v[1]), to_rational(v[2])};
}

std::array<double, 3> key(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

/// Records which corners of an outer triangle lie beyond which edges of an inner triangle, as far
/// as doubles prove it.
class CornerSides {
  public:
    CornerSides(const PosedTriangle& inner, const Corners& outer) {
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                is_beyond_[i][k] = inner.proven_edge_side(k, outer[i]).value_or(1) < 0;
            }
        }
    }

    /// Returns true when the segment from corner i to corner j provably lies beyond one edge of the
    /// inner triangle; with i = j, when corner i does.
    [[nodiscard]] bool pass_by(std::size_t i, std::size_t j) const {
        for (std::size_t k = 0; k < 3; ++k) {
            if (is_beyond_[i][k] && is_beyond_[j][k]) {
                return true;
            }
        }
        return false;
    }

  private:
    std::array<std::array<bool, 3>, 3>
        is_beyond_{}; ///< [i][k] is true if corner i is beyond edge k.
};

/// Returns true when no point of a segment in the triangle's plane lies in the triangle's interior:
/// the line of an edge, or that of the segment, separates them.
bool passes_by(PosedTriangle& triangle, const Vec3& from, const Vec3& to) {
    for (std::size_t k = 0; k < 3; ++k) {
        if (triangle.edge_side(k, from) <= 0 && triangle.edge_side(k, to) <= 0) {
            return true;
        }
    }
    if (from == to) {
        return false;
    }
    const std::array<int, 3> sides{triangle.line_side(from, to, 0),
                                   triangle.line_side(from, to, 1),
                                   triangle.line_side(from, to, 2)};
    const auto [least, greatest] = std::minmax_element(sides.begin(), sides.end());
    return *least >= 0 || *greatest <= 0;
}

/// Projects points of a triangle's plane along the axis `drop`, and back, exactly.
class Projection {
  public:
    explicit Projection(PosedTriangle& triangle) : drop_(triangle.drop()) {
        const auto& c = triangle.exact_corners();
        normal_ = to_rational(cross(c[1] - c[0], c[2] - c[0]));
        for (std::size_t i = 0; i < 3; ++i) {
            height_ += normal_[i] * to_rational(c[0][i]);
        }
    }

    [[nodiscard]] PlanePoint down(const DyadicVec& point) const {
        return {to_rational(point[first()]), to_rational(point[second()])};
    }

    [[nodiscard]] std::array<Rational, 3> up(const PlanePoint& point) const {
        std::array<Rational, 3> result;
        result[first()] = point[0];
        result[second()] = point[1];
        result[drop_] =
            (height_ - normal_[first()] * point[0] - normal_[second()] * point[1]) / normal_[drop_];
        return result;
    }

  private:
    [[nodiscard]] std::size_t first() const { return (drop_ + 1) % 3; }
    [[nodiscard]] std::size_t second() const { return (drop_ + 2) % 3; }

    std::size_t drop_;
    std::array<Rational, 3> normal_;
    Rational height_; ///< normal . x for each point x of the plane.
};

/// Returns the two ends of a flat triangle; its third corner lies between them.
std::array<DyadicVec, 2> ends_of(const std::array<DyadicVec, 3>& corners) {
    std::array<DyadicVec, 3> sorted = corners;
    std::sort(sorted.begin(), sorted.end(), [](const DyadicVec& l, const DyadicVec& r) {
        for (std::size_t i = 0; i < 3; ++i) {
            if (const int sign = sign_of(l[i] - r[i]); sign != 0) {
                return sign < 0;
            }
        }
        return false;
    });
    return {sorted[0], sorted[2]};
}

/// Adds the parameter at which a linear function changes its sign, if it does. The function is
/// `from` at parameter 0 and `to` at 1.
void add_change(const Dyadic& from, const Dyadic& to, std::vector<Rational>& parameters) {
    if (sign_of(from) * sign_of(to) < 0) {
        parameters.push_back(to_rational(from) / to_rational(from - to));
    }
}

/// Adds the parameters (0 to 1) at which the segment crosses the triangle's plane or, if the
/// segment lies in that plane, the lines of the triangle's edges.
void add_crossings(const std::array<DyadicVec, 2>& ends,
                   const std::array<DyadicVec, 3>& triangle,
                   std::vector<Rational>& parameters) {
    const DyadicVec normal = cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
    const Dyadic from = dot(normal, ends[0] - triangle[0]);
    const Dyadic to = dot(normal, ends[1] - triangle[0]);
    add_change(from, to, parameters);
    if (sign_of(from) != 0 || sign_of(to) != 0) {
        return;
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const DyadicVec across = cross(triangle[(k + 1) % 3] - triangle[k], normal);
        add_change(
            dot(across, ends[0] - triangle[k]), dot(across, ends[1] - triangle[k]), parameters);
    }
}

} // namespace

TriangleInSolid::TriangleInSolid(const ObbTree& outer,
                                 const Pose& outer_pose,
                                 const ObbTree& inner,
                                 const Pose& inner_pose)
    : outer_(outer),
      inner_(inner),
      frame_(outer_pose, inner_pose),
      inner_to_outer_(relative_pose({outer_pose, inner_pose})),
      solid_(outer) {}

bool TriangleInSolid::reaches_inside(std::uint32_t triangle,
                                     std::span<const OuterContact> contacts) {
    if (!frame_.has_inverse()) {
        return false;
    }
    PosedTriangle inner(frame_, inner_to_outer_, inner_.mesh().corners(triangle));
    if (inner.is_flat()) {
        return any_piece_inside(inner, contacts);
    }
    if (const auto side = open_side(inner, contacts)) {
        // Moved slightly to that side, the triangle is clear of the outer surface. So is the path
        // back to each of its points off the surface: one point decides for all of these points.
        SolidPoint centroid = inner.centroid();
        const auto side_of = [&](const Vec3& direction) { return -inner.forward(direction); };
        if (!solid_.is_inside_beside(centroid, side_of, *side, ids_of(contacts))) {
            return false;
        }
    }
    find_edges(inner, contacts);
    if (!edges_.empty()) {
        return any_cell_inside(inner);
    }
    const bool is_covered =
        std::any_of(contacts.begin(), contacts.end(), [](const OuterContact& contact) {
            return contact.kind == PairClass::Coplanar;
        });
    if (is_covered) {
        return false; // The coplanar triangles cover this one completely; otherwise an edge of
                      // theirs would cross its interior.
    }
    SolidPoint centroid = inner.centroid();
    return solid_.locate(centroid) == Location::Inside;
}

std::span<const std::uint32_t> TriangleInSolid::ids_of(std::span<const OuterContact> contacts) {
    ids_.clear();
    for (const OuterContact& contact : contacts) {
        ids_.push_back(contact.triangle);
    }
    return ids_;
}

int TriangleInSolid::plane_side(PosedTriangle& inner, std::uint32_t outer_vertex) {
    const Vec3& vertex = outer_.mesh().vertices()[outer_vertex];
    if (const auto sign = inner.proven_plane_side(vertex)) {
        return *sign;
    }
    const auto [entry, is_new] = plane_sides_.try_emplace(outer_vertex, 0);
    if (is_new) {
        entry->second = inner.plane_side(vertex);
    }
    return entry->second;
}

/// Returns a side of the triangle's plane, as `plane_side` defines it, on which no contact has any
/// points, or nothing where both sides have some.
std::optional<int> TriangleInSolid::open_side(PosedTriangle& inner,
                                              std::span<const OuterContact> contacts) {
    plane_sides_.clear();
    for (const OuterContact& contact : contacts) {
        if (contact.kind == PairClass::Coplanar) {
            for (const std::uint32_t vertex : outer_.mesh().triangles()[contact.triangle]) {
                plane_sides_.emplace(vertex, 0);
            }
        }
    }
    bool is_any_below = false;
    bool is_any_above = false;
    for (const OuterContact& contact : contacts) {
        if (contact.kind == PairClass::Coplanar) {
            continue;
        }
        for (const std::uint32_t vertex : outer_.mesh().triangles()[contact.triangle]) {
            const int side = plane_side(inner, vertex);
            is_any_below = is_any_below || side < 0;
            is_any_above = is_any_above || side > 0;
        }
        if (is_any_below && is_any_above) {
            return std::nullopt;
        }
    }
    return is_any_below ? 1 : -1;
}

void TriangleInSolid::add_edge(const Vec3& from, const Vec3& to, int winding) {
    const bool is_forward = key(from) <= key(to);
    edges_.push_back({is_forward ? from : to, is_forward ? to : from, winding});
}

void TriangleInSolid::add_touching(PosedTriangle& inner, std::uint32_t outer_triangle) {
    const Corners outer = outer_.mesh().corners(outer_triangle);
    const CornerSides sides(inner, outer);
    const auto is_in_plane = [&](std::size_t i) {
        return plane_side(inner, outer_.mesh().triangles()[outer_triangle][i]) == 0;
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t next = (i + 1) % 3;
        if (!sides.pass_by(i, next) && is_in_plane(i) && is_in_plane(next)) {
            add_edge(outer[i], outer[next], 0);
        }
        if (!sides.pass_by(i, i) && is_in_plane(i)) {
            add_edge(outer[i], outer[i], 0);
        }
    }
}

void TriangleInSolid::find_edges(PosedTriangle& inner, std::span<const OuterContact> contacts) {
    edges_.clear();
    for (const OuterContact& contact : contacts) {
        if (contact.kind != PairClass::Coplanar) {
            add_touching(inner, contact.triangle);
            continue;
        }
        const Corners corners = outer_.mesh().corners(contact.triangle);
        const int winding = inner.winding(corners);
        const CornerSides sides(inner, corners);
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t next = (i + 1) % 3;
            if (!sides.pass_by(i, next)) {
                add_edge(corners[i], corners[next], winding);
            }
        }
    }
    keep_boundary_edges();
    std::erase_if(edges_, [&](const Edge& edge) { return passes_by(inner, edge.from, edge.to); });
    // Corners come last: most of them are ends of edges, and then divide no cell.
    std::stable_partition(
        edges_.begin(), edges_.end(), [](const Edge& edge) { return edge.from != edge.to; });
}

void TriangleInSolid::keep_boundary_edges() {
    const auto ends = [](const Edge& edge) { return std::pair(key(edge.from), key(edge.to)); };
    std::sort(edges_.begin(), edges_.end(), [&](const Edge& l, const Edge& r) {
        return ends(l) != ends(r) ? ends(l) < ends(r) : l.winding < r.winding;
    });
    std::size_t kept = 0;
    for (std::size_t begin = 0; begin < edges_.size();) {
        std::size_t end = begin + 1;
        while (end < edges_.size() && ends(edges_[end]) == ends(edges_[begin])) {
            ++end;
        }
        // Two coplanar triangles of equal winding lie on both sides of their common edge, so the
        // area that they cover continues across the edge.
        const bool is_within = end - begin == 2 && edges_[begin].winding != 0 &&
                               edges_[begin].winding == edges_[begin + 1].winding;
        if (!is_within) {
            edges_[kept] = edges_[begin];
            ++kept;
        }
        begin = end;
    }
    edges_.resize(kept);
}

bool TriangleInSolid::any_cell_inside(PosedTriangle& inner) {
    const Projection projection(inner);
    const auto& corners = inner.exact_corners();
    std::vector<PlaneCut> cuts;
    cuts.reserve(edges_.size());
    for (const Edge& edge : edges_) {
        cuts.push_back({projection.down(frame_.of_outer(edge.from)),
                        projection.down(frame_.of_outer(edge.to))});
    }
    const std::array<PlanePoint, 3> triangle{
        projection.down(corners[0]), projection.down(corners[1]), projection.down(corners[2])};
    return any_cell_centre(triangle, cuts, [&](const PlanePoint& centre) {
        SolidPoint point = to_solid_point(projection.up(centre), frame_);
        return solid_.locate(point) == Location::Inside;
    });
}

bool TriangleInSolid::any_piece_inside(PosedTriangle& inner,
                                       std::span<const OuterContact> contacts) {
    const std::array<DyadicVec, 2> ends = ends_of(inner.exact_corners());
    std::vector<Rational> parameters;
    for (const OuterContact& contact : contacts) {
        const Corners corners = outer_.mesh().corners(contact.triangle);
        add_crossings(
            ends,
            {frame_.of_outer(corners[0]), frame_.of_outer(corners[1]), frame_.of_outer(corners[2])},
            parameters);
    }
    const std::array<Rational, 3> from = to_rational(ends[0]);
    const std::array<Rational, 3> along = to_rational(ends[1] - ends[0]);
    return any_piece_centre(std::move(parameters), [&](const Rational& parameter) {
        SolidPoint point = to_solid_point({from[0] + parameter * along[0],
                                           from[1] + parameter * along[1],
                                           from[2] + parameter * along[2]},
                                          frame_);
        return solid_.locate(point) == Location::Inside;
    });
}

} // namespace cd
