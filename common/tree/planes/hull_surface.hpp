// The surface of a convex hull that grows point by point.
#pragma once

#include "common/geometry/types.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// A triangle of the surface.
struct HullFacet {
    Vec3 normal = Vec3::Zero(); ///< Outwards, of length 1.
    double offset = 0;
    std::array<std::uint32_t, 3> corners{};    ///< Counter-clockwise, seen from outside.
    std::array<std::uint32_t, 3> neighbours{}; ///< Across the edge from corner i to the next one.
    std::uint32_t step = 0;                    ///< When `is_visible` was set.
    bool is_visible = false;                   ///< From the point added in that step.

    /// Returns the signed distance from the facet's plane; positive outside.
    [[nodiscard]] double height(const Vec3& at) const { return normal.dot(at) - offset; }
};

/// A closed surface of triangles, convex but for rounding. A new corner replaces the facets that it
/// sees by a cone (Barber, Dobkin, Huhdanpaa, ACM TOMS 22(4), 1996). Facets and corners are
/// numbered; numbers of removed facets are used again.
class HullSurface {
  public:
    /// Begins with a tetrahedron; `size` bounds the distances between all corners. Corner 3 is
    /// below the plane of the others, which are counter-clockwise from above. Returns false, and
    /// has no facets, if a facet has no area.
    [[nodiscard]] bool start(const std::array<Vec3, 4>& corners, double size);

    /// Adds a corner above a facet. Returns false, and changes nothing, if rounding lets it see
    /// facets that do not make one patch, or if a facet has no area.
    [[nodiscard]] bool add(const Vec3& at, std::uint32_t above);

    [[nodiscard]] const HullFacet& facet(std::uint32_t number) const { return facets_[number]; }
    /// One more than the largest number of a facet.
    [[nodiscard]] std::size_t facet_count() const { return facets_.size(); }
    [[nodiscard]] const Vec3& corner(std::uint32_t number) const { return corners_[number]; }
    [[nodiscard]] std::uint32_t corner_count() const {
        return static_cast<std::uint32_t>(corners_.size());
    }

    /// Numbers of the facets that the last corner added.
    [[nodiscard]] std::span<const std::uint32_t> added() const { return added_; }
    /// Numbers of the facets that the last corner removed; readable until the next one.
    [[nodiscard]] std::span<const std::uint32_t> removed() const { return removed_; }

  private:
    /// An edge between a visible facet and one that is not.
    struct Rim {
        std::uint32_t from;
        std::uint32_t to;
        std::uint32_t outer; ///< The facet that is not visible.
    };

    [[nodiscard]] std::uint32_t make_facet(const std::array<std::uint32_t, 3>& corners);
    [[nodiscard]] bool fit_plane(HullFacet& facet) const;
    void see(const Vec3& at, std::uint32_t first);
    [[nodiscard]] bool is_visible(const Vec3& at, std::uint32_t facet);
    [[nodiscard]] bool sort_rim();
    [[nodiscard]] bool make_cone();
    void join_cone();

    std::vector<Vec3> corners_;
    std::vector<HullFacet> facets_;
    std::vector<std::uint32_t> free_; ///< Numbers of facets that are not in use.
    std::vector<std::uint32_t> added_;
    std::vector<std::uint32_t> removed_;
    std::vector<Rim> rim_;
    std::vector<std::uint32_t> starts_; ///< By corner: index in `rim_` of the edge from there.
    std::uint32_t step_ = 0;
    double slack_ = 0; ///< A facet is visible from farther above its plane.
};

} // namespace cd
