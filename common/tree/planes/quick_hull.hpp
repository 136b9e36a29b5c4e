// Chooses points by an incremental convex hull.
#pragma once

#include "common/geometry/types.hpp"
#include "common/tree/planes/float_point.hpp"
#include "common/tree/planes/hull_surface.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace cd {

/// Chooses few of many points, and bounds how far each other point is from the hull of those: the
/// quickhull algorithm (Barber, Dobkin, Huhdanpaa, ACM TOMS 22(4), 1996), stopped early. Each point
/// that may be outside the hull waits in the list of one facet; the one that is farthest above its
/// facet is the next corner. Points in a plane get a fourth corner that is no point.
///
/// Rounding may make the surface wrong. Bounds are right in any case: each is the `distance_bound`
/// of at most four chosen points.
class QuickHull {
  public:
    /// Points within `tolerance` above their facet are inside. `radius` bounds the distance of all
    /// points from the origin; at least one point.
    QuickHull(std::span<const FloatPoint> points, double tolerance, double radius);

    /// Chooses points until there are `count_max`, at least 4, or none waits. Called once.
    void grow(std::size_t count_max);

    /// Indices of the chosen points, each once.
    [[nodiscard]] const std::vector<std::uint32_t>& chosen() const { return chosen_; }
    /// Upper bounds on the distance from the hull of the chosen points, by the index of a point; 0
    /// for chosen ones. After `grow`.
    [[nodiscard]] std::span<const double> bounds() const { return bounds_; }

  private:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    /// Points that wait above a facet.
    struct Outside {
        std::uint32_t first = none;
        std::uint32_t farthest = none;
    };

    [[nodiscard]] bool start();
    [[nodiscard]] bool start_surface(const std::array<Vec3, 3>& corners, double size);
    void choose(std::uint32_t point);
    [[nodiscard]] std::uint32_t highest_facet() const;
    [[nodiscard]] bool wait(std::uint32_t point);
    void settle(std::uint32_t point, std::uint32_t removed);
    void share_out(std::uint32_t removed);
    void set_aside(std::uint32_t facet);
    void bound_by(std::uint32_t point, std::span<const Vec3> corners);
    void bound_by_facet(std::uint32_t point, std::uint32_t facet, bool with_newest);
    void bound_waiting();

    std::vector<Vec3> places_; ///< Of the points, less the first one.
    std::vector<double> bounds_;
    std::vector<std::uint32_t> next_; ///< The next point in a list.
    std::vector<std::uint32_t> chosen_;
    std::vector<Outside> outside_; ///< By facet.
    std::vector<double> heights_;  ///< By facet: of its farthest point; 0 if its list is empty.
    HullSurface surface_;
    double tolerance_;
    double radius_;
    std::uint32_t unreal_ = none; ///< The corner that is no point.
};

} // namespace cd
