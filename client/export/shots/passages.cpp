#include "client/export/shots/passages.hpp"

#include "common/geometry/closed_parts.hpp"
#include "common/shots/line_hit.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cstddef>
#include <span>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace cd {

namespace {

/// Returns the places of the hits that cross by line, and of each line in their exact order, which
/// depth and rank tell; at one point those that leave come first.
std::vector<std::size_t> crossings_along_lines(const ScenarioResult& result) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < result.hits.size(); ++i) {
        if ((result.hits[i].flags & hit_flag::crosses) != 0) {
            order.push_back(i);
        }
    }
    const auto key = [&](std::size_t i) {
        const PairHit& hit = result.hits[i];
        const bool enters = (hit.flags & hit_flag::back) == 0;
        return std::tuple(result.pairs[i].b, hit.depth, hit.rank, enters, result.pairs[i].a);
    };
    std::ranges::sort(order, {}, key);
    return order;
}

/// Returns points of the world in the coordinates of a posed body, rounded.
Corners in_coordinates_of(const Pose& pose, Corners points) {
    const Mat3 back = pose.rotation().inverse();
    for (Vec3& point : points) {
        point = back * (point - pose.translation());
    }
    return points;
}

/// Returns a box with room for the roundings of `in_coordinates_of`.
Aabb grown(Aabb box, const Corners& points) {
    constexpr double slack = 1.0 / (1 << 30);
    double largest = box.min.cwiseAbs().cwiseMax(box.max.cwiseAbs()).maxCoeff();
    for (const Vec3& point : points) {
        largest = std::max(largest, point.cwiseAbs().maxCoeff());
    }
    box.min.array() -= slack * largest;
    box.max.array() += slack * largest;
    return box;
}

} // namespace

PassageFinder::PassageFinder(const Mesh& mesh, std::shared_ptr<const Mesh> lines)
    : parts_(mesh),
      are_closed_(closed_parts(mesh, parts_.by_runs().runs)),
      boxes_(parts_.count()),
      lines_(std::move(lines)) {
    for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
        for (const Vec3& corner : mesh.corners(i)) {
            boxes_[parts_.part_of(i)].add(corner);
        }
    }
}

bool PassageFinder::starts_and_ends_outside(std::uint32_t line,
                                            std::uint32_t part,
                                            const std::optional<Pose>& pose) const {
    if (lines_ == nullptr) {
        return true;
    }
    Aabb box = boxes_[part];
    Corners ends = lines_->corners(line);
    if (pose) {
        ends = in_coordinates_of(*pose, ends);
        box = grown(box, ends);
    }
    return std::ranges::none_of(ends, [&](const Vec3& end) {
        return (end.array() >= box.min.array()).all() && (end.array() <= box.max.array()).all();
    });
}

std::shared_ptr<const PassageFinder>
make_finder(const Mesh& a, const std::shared_ptr<const Mesh>& lines, const ShotViews& views) {
    const bool is_grid = views.cell_area() > 0;
    return std::make_shared<const PassageFinder>(a, is_grid ? nullptr : lines);
}

std::vector<Passage> PassageFinder::passages(const ScenarioResult& result,
                                             const std::optional<Pose>& pose) const {
    std::vector<Passage> passages;
    std::unordered_map<std::uint32_t, std::size_t> begun; // By part, of the line at hand.
    for (const std::size_t i : crossings_along_lines(result)) {
        const ContactPair& pair = result.pairs[i];
        if (!passages.empty() && passages.back().line != pair.b) {
            begun.clear();
        }
        const std::uint32_t part = parts_.part_of(pair.a);
        const Crossing crossing{pair.a, result.hits[i].depth};
        if (const auto found = begun.find(part); found != begun.end()) {
            passages[found->second].out = crossing;
            begun.erase(found);
            continue;
        }
        if (are_closed_[part] && !result.is_cut() && starts_and_ends_outside(pair.b, part, pose)) {
            begun.emplace(part, passages.size());
        }
        passages.push_back({pair.b, part, crossing, std::nullopt});
    }
    return passages;
}

} // namespace cd
