#include "common/job/distance_looks.hpp"

#include "common/geometry/reach.hpp"
#include "common/tree/box_test.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace cd {

namespace {

const ObbNode& box_of(const TreeTop& top, RootIndex root) {
    return top.nodes[top.root_nodes[root]];
}

Vec3 center_of(const ObbNode& box) {
    return {box.center[0], box.center[1], box.center[2]};
}

double radius_of(const ObbNode& box) {
    return Vec3(double{box.half[0]}, double{box.half[1]}, double{box.half[2]}).norm();
}

/// Returns about how far apart the spheres around two boxes are; negative if they overlap.
double apart(const ObbNode& a, const ObbNode& b, const RelativePose& b_to_a) {
    const Vec3 center_b = b_to_a.rotation * center_of(b) + b_to_a.translation;
    const double apart = (center_b - center_of(a)).norm() - radius_of(a) - radius_of(b);
    return std::isnan(apart) ? 0 : apart;
}

} // namespace

bool looks_twice(const Query& query, std::span<const RootPair> pairs) {
    return query.question == Question::Distance && pairs.size() > first_look_pairs;
}

std::vector<RootPair> first_look(const TreeTop& a,
                                 const TreeTop& b,
                                 const PosePair& poses,
                                 std::span<const RootPair> pairs) {
    const RelativePose b_to_a = relative_pose(poses);
    std::vector<std::pair<double, RootPair>> ranked;
    ranked.reserve(pairs.size());
    for (const RootPair& pair : pairs) {
        ranked.emplace_back(apart(box_of(a, pair.a), box_of(b, pair.b), b_to_a), pair);
    }
    const std::size_t count = std::min(first_look_pairs, ranked.size());
    const auto end = ranked.begin() + static_cast<std::ptrdiff_t>(count);
    std::partial_sort(ranked.begin(), end, ranked.end());
    std::vector<RootPair> nearest;
    std::transform(ranked.begin(), end, std::back_inserter(nearest), [](const auto& one) {
        return one.second;
    });
    return nearest;
}

std::vector<RootPair> second_look(const TreeTop& a,
                                  const TreeTop& b,
                                  const PosePair& poses,
                                  std::vector<RootPair> pairs,
                                  std::optional<double> found) {
    if (!found) {
        return pairs;
    }
    // A distance that is a little larger than the one found may still round to it.
    const double reach =
        body_reach(poses, std::nextafter(*found, std::numeric_limits<double>::infinity()));
    const BoxTest boxes(relative_pose(poses));
    std::erase_if(pairs, [&](const RootPair& pair) {
        const PosedBox of_b = boxes.pose(box_of(b, pair.b));
        return boxes.least_distance(box_of(a, pair.a), of_b) > reach;
    });
    return pairs;
}

} // namespace cd
