#include "common/tree/planes/hull_surface.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cd {

namespace {

/// Rounding moves the plane of a facet that is not thin by less than this share of the size.
constexpr double slack_share = 0x1p-44;

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

} // namespace

bool HullSurface::start(const std::array<Vec3, 4>& corners, double size) {
    constexpr std::array<std::array<std::uint32_t, 3>, 4> first{
        {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}};
    constexpr std::array<std::array<std::uint32_t, 3>, 4> neighbours{
        {{1, 2, 3}, {3, 2, 0}, {1, 3, 0}, {2, 1, 0}}};
    slack_ = slack_share * size;
    corners_.assign(corners.begin(), corners.end());
    starts_.assign(4, none);
    for (std::size_t i = 0; i < 4; ++i) {
        HullFacet& facet = facets_.emplace_back();
        facet.corners = first[i];
        facet.neighbours = neighbours[i];
        added_.push_back(static_cast<std::uint32_t>(i));
    }
    return std::ranges::all_of(facets_, [&](HullFacet& facet) { return fit_plane(facet); });
}

bool HullSurface::fit_plane(HullFacet& facet) const {
    const Vec3& a = corners_[facet.corners[0]];
    const Vec3 across = (corners_[facet.corners[1]] - a).cross(corners_[facet.corners[2]] - a);
    const double length = across.norm();
    facet.normal = across / length;
    facet.offset = facet.normal.dot(a);
    return length > 0 && std::isfinite(length);
}

bool HullSurface::is_visible(const Vec3& at, std::uint32_t facet) {
    HullFacet& now = facets_[facet];
    if (now.step != step_) {
        now.step = step_;
        now.is_visible = now.height(at) > slack_;
    }
    return now.is_visible;
}

/// Finds the visible facets around a first one, and the edges around them.
void HullSurface::see(const Vec3& at, std::uint32_t first) {
    ++step_;
    rim_.clear();
    removed_.assign(1, first);
    facets_[first].step = step_;
    facets_[first].is_visible = true;
    for (std::size_t i = 0; i < removed_.size(); ++i) {
        const HullFacet& facet = facets_[removed_[i]];
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t next = facet.neighbours[k];
            const bool is_known = facets_[next].step == step_;
            if (!is_visible(at, next)) {
                rim_.push_back({facet.corners[k], facet.corners[(k + 1) % 3], next});
            } else if (!is_known) {
                removed_.push_back(next);
            }
        }
    }
}

/// Orders the edges around the visible facets. Returns false if they are not one cycle that passes
/// each corner at most once.
bool HullSurface::sort_rim() {
    std::ranges::fill(starts_, none);
    for (std::uint32_t i = 0; i < rim_.size(); ++i) {
        if (std::exchange(starts_[rim_[i].from], i) != none) {
            return false;
        }
    }
    for (std::uint32_t i = 1; i < rim_.size(); ++i) {
        const std::uint32_t next = starts_[rim_[i - 1].to];
        if (next == none || next < i) {
            return false;
        }
        std::swap(rim_[i], rim_[next]);
        starts_[rim_[next].from] = next;
        starts_[rim_[i].from] = i;
    }
    return rim_.size() >= 3 && rim_.back().to == rim_.front().from;
}

std::uint32_t HullSurface::make_facet(const std::array<std::uint32_t, 3>& corners) {
    if (free_.empty()) {
        free_.push_back(static_cast<std::uint32_t>(facets_.size()));
        facets_.emplace_back();
    }
    const std::uint32_t number = free_.back();
    free_.pop_back();
    facets_[number].corners = corners;
    return number;
}

/// Makes facets between the rim and the last corner. Returns false if one has no area.
bool HullSurface::make_cone() {
    added_.clear();
    bool has_area = true;
    for (const Rim& edge : rim_) {
        const std::uint32_t number = make_facet({edge.from, edge.to, corner_count() - 1});
        added_.push_back(number);
        has_area = has_area && fit_plane(facets_[number]);
    }
    return has_area;
}

/// Makes the facets of the cone neighbours of each other and of those around them.
void HullSurface::join_cone() {
    const std::size_t count = rim_.size();
    for (std::size_t i = 0; i < count; ++i) {
        HullFacet& outer = facets_[rim_[i].outer];
        facets_[added_[i]].neighbours = {
            rim_[i].outer, added_[(i + 1) % count], added_[(i + count - 1) % count]};
        // The outer facet has the edge the other way round.
        const auto at = std::ranges::find(outer.corners, rim_[i].to) - outer.corners.begin();
        outer.neighbours[static_cast<std::size_t>(at)] = added_[i];
    }
}

bool HullSurface::add(const Vec3& at, std::uint32_t above) {
    free_.insert(free_.end(), removed_.begin(), removed_.end());
    see(at, above);
    if (!sort_rim()) {
        removed_.clear();
        return false;
    }
    corners_.push_back(at);
    starts_.push_back(none);
    if (!make_cone()) {
        free_.insert(free_.end(), added_.begin(), added_.end());
        added_.clear();
        removed_.clear();
        corners_.pop_back();
        starts_.pop_back();
        return false;
    }
    join_cone();
    return true;
}

} // namespace cd
