#include "common/tree/planes/quick_hull.hpp"

#include "common/tree/planes/simplex.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace cd {

namespace {

/// The depth of the corner that is no point, as a multiple of the points' size. Facets to it are
/// nearly perpendicular to the plane of the points.
constexpr double unreal_depth = 4;

/// Returns the index of the greatest value; the first one of equals.
template <class Value>
std::uint32_t greatest(std::size_t count, const Value& value) {
    std::uint32_t best = 0;
    double most = value(0);
    for (std::uint32_t i = 1; i < count; ++i) {
        const double now = value(i);
        best = now > most ? i : best;
        most = std::max(most, now);
    }
    return best;
}

} // namespace

QuickHull::QuickHull(std::span<const FloatPoint> points, double tolerance, double radius)
    : bounds_(points.size(), std::numeric_limits<double>::infinity()),
      next_(points.size(), none),
      tolerance_(tolerance),
      radius_(radius) {
    places_.reserve(points.size());
    for (const FloatPoint& point : points) {
        places_.emplace_back(vector_of(point) - vector_of(points[0]));
    }
}

void QuickHull::choose(std::uint32_t point) {
    chosen_.push_back(point);
    bounds_[point] = 0;
}

/// Chooses the first corners. Returns false if they have no volume.
bool QuickHull::start() {
    const std::size_t count = places_.size();
    std::array<std::uint32_t, 2> ends{};
    Vec3 along = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
        const auto high = greatest(count, [&](std::uint32_t i) { return places_[i][k]; });
        const auto low = greatest(count, [&](std::uint32_t i) { return -places_[i][k]; });
        const Vec3 between = places_[high] - places_[low];
        if (between[k] > along.cwiseAbs().maxCoeff()) {
            ends = {low, high};
            along = between;
        }
    }
    choose(ends[0]);
    const double size = 2 * along.cwiseAbs().maxCoeff(); // Of the diagonal, at most.
    if (size == 0) {
        return false;
    }
    choose(ends[1]);
    const Vec3 from = places_[ends[0]];
    along.normalize();
    const auto aside = [&](std::uint32_t i) { return along.cross(places_[i] - from).norm(); };
    const std::uint32_t third = greatest(count, aside);
    if (!(aside(third) > tolerance_)) {
        return false;
    }
    choose(third);
    return start_surface({from, places_[ends[1]], places_[third]}, size);
}

bool QuickHull::start_surface(const std::array<Vec3, 3>& corners, double size) {
    const auto [a, b, c] = corners;
    const Vec3 normal = (b - a).cross(c - a).normalized();
    const auto height = [&](std::uint32_t i) { return normal.dot(places_[i] - a); };
    const std::uint32_t fourth =
        greatest(places_.size(), [&](std::uint32_t i) { return std::abs(height(i)); });
    if (std::abs(height(fourth)) > tolerance_) {
        choose(fourth);
        const bool is_above = height(fourth) > 0;
        return surface_.start({a, is_above ? c : b, is_above ? b : c, places_[fourth]}, size);
    }
    unreal_ = 3;
    const Vec3 below = (a + b + c) / 3 - unreal_depth * size * normal;
    return surface_.start({a, b, c, below}, (1 + unreal_depth) * size);
}

/// Returns the facet with the point that is farthest above its facet, or `none`.
std::uint32_t QuickHull::highest_facet() const {
    const std::uint32_t facet =
        greatest(heights_.size(), [&](std::uint32_t i) { return heights_[i]; });
    return heights_[facet] > 0 ? facet : none;
}

/// Lets a point wait above the added facet that it is farthest from. Returns false if it is inside.
bool QuickHull::wait(std::uint32_t point) {
    double most = tolerance_;
    std::uint32_t above = none;
    for (const std::uint32_t facet : surface_.added()) {
        const double height = surface_.facet(facet).height(places_[point]);
        above = height > most ? facet : above;
        most = std::max(most, height);
    }
    if (above == none) {
        return false;
    }
    next_[point] = std::exchange(outside_[above].first, point);
    if (most > heights_[above]) {
        heights_[above] = most;
        outside_[above].farthest = point;
    }
    return true;
}

void QuickHull::bound_by(std::uint32_t point, std::span<const Vec3> corners) {
    std::array<Vec3, 4> apart;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        apart[i] = corners[i] - places_[point];
    }
    const NearestOfSimplex nearest = nearest_of_simplex(apart, corners.size());
    bounds_[point] = std::min(bounds_[point], distance_bound(nearest, radius_));
}

/// Bounds a point's distance by the real corners of a facet, and by the newest corner if wanted.
void QuickHull::bound_by_facet(std::uint32_t point, std::uint32_t facet, bool with_newest) {
    std::array<Vec3, 4> corners;
    std::size_t count = 0;
    for (const std::uint32_t corner : surface_.facet(facet).corners) {
        if (corner != unreal_) {
            corners[count++] = surface_.corner(corner);
        }
    }
    if (with_newest) {
        corners[count++] = surface_.corner(surface_.corner_count() - 1);
    }
    bound_by(point, {corners.data(), count});
}

/// Bounds the distance of a point that waited above a removed facet and is inside the new surface:
/// between the newest corner and some removed facet.
void QuickHull::settle(std::uint32_t point, std::uint32_t removed) {
    bound_by_facet(point, removed, true);
    for (std::size_t i = 0; bounds_[point] > tolerance_ && i < surface_.removed().size(); ++i) {
        bound_by_facet(point, surface_.removed()[i], true);
    }
}

/// Moves the points that wait above a removed facet to the added ones.
void QuickHull::share_out(std::uint32_t removed) {
    std::uint32_t next = none;
    for (std::uint32_t point = outside_[removed].first; point != none; point = next) {
        next = next_[point];
        if (point != chosen_.back() && !wait(point)) {
            settle(point, removed);
        }
    }
    outside_[removed] = {};
    heights_[removed] = 0;
}

/// Gives up the farthest point above a facet.
void QuickHull::set_aside(std::uint32_t facet) {
    const std::uint32_t point = outside_[facet].farthest;
    bound_by_facet(point, facet, false);
    std::uint32_t* link = &outside_[facet].first;
    while (*link != point) {
        link = &next_[*link];
    }
    *link = next_[point];
    heights_[facet] = 0;
    for (std::uint32_t i = outside_[facet].first; i != none; i = next_[i]) {
        const double height = surface_.facet(facet).height(places_[i]);
        if (height > heights_[facet]) {
            heights_[facet] = height;
            outside_[facet].farthest = i;
        }
    }
}

void QuickHull::bound_waiting() {
    for (std::uint32_t facet = 0; facet < outside_.size(); ++facet) {
        for (std::uint32_t i = outside_[facet].first; i != none; i = next_[i]) {
            bound_by_facet(i, facet, false);
        }
    }
}

void QuickHull::grow(std::size_t count_max) {
    const bool has_surface = start();
    std::vector<Vec3> first;
    for (const std::uint32_t number : chosen_) {
        first.push_back(places_[number]);
    }
    outside_.resize(4);
    heights_.resize(4);
    for (std::uint32_t i = 0; i < places_.size(); ++i) {
        if (bounds_[i] > 0 && !(has_surface && wait(i))) {
            bound_by(i, first);
        }
    }
    while (chosen_.size() < count_max) {
        const std::uint32_t facet = highest_facet();
        if (facet == none) {
            return;
        }
        const std::uint32_t point = outside_[facet].farthest;
        if (!surface_.add(places_[point], facet)) {
            set_aside(facet);
            continue;
        }
        choose(point);
        outside_.resize(surface_.facet_count());
        heights_.resize(surface_.facet_count());
        for (const std::uint32_t removed : surface_.removed()) {
            share_out(removed);
        }
    }
    bound_waiting();
}

} // namespace cd
